//! Observations about colors that are off in the same way everywhere.

use slips::Chapter;

use super::side_by_side::SideBySide;

impl SideBySide<'_> {
    /// Notes that all pixels are gray.
    pub(super) fn gray(&self) -> Option<String> {
        let mut pixels = self.reading.pixels.iter();
        let is_gray = pixels.all(|[red, green, blue]| red == green && green == blue);
        let said = "The picture has no color: red, green and blue are equal in each pixel.";
        is_gray.then(|| said.to_owned())
    }

    /// Notes components that are off in the same way everywhere: a sentence about the sky, and one
    /// about the spheres. Empty if the picture is gray.
    pub(super) fn tints(&self) -> Vec<String> {
        if self.gray().is_some() {
            return Vec::new();
        }
        let (spheres, sky): (Vec<u32>, Vec<u32>) =
            self.places.iter().partition(|&&n| self.is_hit(n));
        let background = match self.task.chapter {
            Chapter::BuildTest => "the picture",
            _ => "the sky",
        };
        let of_place = |(name, places): (&str, Vec<u32>)| {
            let tint = |channel| self.tint(&places, channel);
            let tints = ["red", "green", "blue"].into_iter().enumerate();
            let tints = tints.filter_map(|(n, color)| Some((color, tint(n)?)));
            let tints: Vec<(&str, String)> = tints.collect();
            let said = match &tints[..] {
                [] => return None,
                [(_, red), (_, green), (_, blue)] if red == green && green == blue => {
                    format!("each component is {red}")
                }
                all => {
                    let all = all.iter().map(|(color, tint)| format!("{color} is {tint}"));
                    all.collect::<Vec<_>>().join("; ")
                }
            };
            Some(format!("In {name}, {said}."))
        };
        let places = [(background, sky), ("what should be spheres", spheres)];
        places.into_iter().filter_map(of_place).collect()
    }

    /// Says how a component, 0 to 2 for red to blue, differs in all of these pixels: by a sum, by a
    /// factor, as a constant, or as 255 minus the right level. `None` if it is right, or differs in
    /// no such way.
    fn tint(&self, places: &[u32], channel: usize) -> Option<String> {
        let pair = |&n: &u32| [self.expected(n), self.found(n)].map(|it| f64::from(it[channel]));
        let pairs: Vec<[f64; 2]> = places.iter().map(pair).collect();
        let everywhere = |law: &dyn Fn(f64) -> f64| {
            let off = |&&[expected, found]: &&[f64; 2]| (law(expected) - found).abs() > 1.5;
            100 * pairs.iter().filter(off).count() <= pairs.len()
        };
        let &[expected, found] = pairs.get(pairs.len() / 2)?;
        if everywhere(&|expected| expected) {
            return None;
        }
        // What was cut off may have been anything.
        if found >= f64::from(i16::MAX) {
            return None;
        }
        if everywhere(&|_| found) {
            return Some(format!("{found} everywhere"));
        }
        let by = found - expected;
        if by.abs() > 1.0 && everywhere(&|expected| expected + by) {
            return Some(format!("{by:+} levels off everywhere"));
        }
        if everywhere(&|expected| 255.0 - expected) {
            return Some("255 minus what it should be".to_owned());
        }
        let sum = |at: usize| pairs.iter().map(|pair| pair[at]).sum::<f64>();
        let factor = sum(1) / sum(0);
        ((factor - 1.0).abs() >= 0.005 && sum(0) > 0.0 && everywhere(&|expected| factor * expected))
            .then(|| format!("{factor:.2} times what it should be"))
    }
}
