//! Colors that are off in the same way everywhere.

use super::view::View;

impl View<'_> {
    /// Red, green and blue in another order.
    pub(super) fn channels(&self) -> Option<String> {
        const ORDERS: [[usize; 3]; 5] = [[2, 1, 0], [1, 0, 2], [0, 2, 1], [1, 2, 0], [2, 0, 1]];
        const NAMES: [&str; 3] = ["red", "green", "blue"];
        let order = ORDERS
            .into_iter()
            .find(|order| self.shows(|n| order.map(|channel| self.expected(n)[channel])))?;
        let [red, green, blue] = order.map(|channel| NAMES[channel]);
        Some(format!(
            "Its red is what {red} should be, its green what {green}, its blue what {blue} should be."
        ))
    }

    pub(super) fn gray(&self) -> Option<String> {
        let gray = self
            .reading
            .pixels
            .iter()
            .all(|[red, green, blue]| red == green && green == blue);
        gray.then(|| "It has no color: red, green and blue are equal in each pixel.".to_owned())
    }

    /// Between which two colors the sky blends, if it does.
    pub(super) fn sky(&self) -> Option<String> {
        let program = self.program();
        let camera = program.camera(self.reading.width);
        let weight = |n: u32| {
            let ray = camera.ray(n % self.reading.width, n / self.reading.width);
            (program.blend)(&program, ray.direction)
        };
        let sky: Vec<u32> = self
            .places
            .iter()
            .copied()
            .filter(|&n| !self.is_hit(n))
            .collect();
        let weights: Vec<f64> = sky.iter().map(|&n| weight(n)).collect();
        let (mut below, mut above) = ([0.0; 3], [0.0; 3]);
        for (channel, (below, above)) in below.iter_mut().zip(&mut above).enumerate() {
            let levels: Vec<f64> = sky.iter().map(|&n| self.found(n)[channel].into()).collect();
            let (white, slope) = line(&weights, &levels)?;
            // The fraction was cut off, which takes half a level on the average.
            let is_near =
                |(weight, level): (&f64, &f64)| (white + slope * weight - level).abs() <= 1.5;
            if !weights.iter().zip(&levels).all(is_near) {
                return None;
            }
            *below = (white + 0.5) / 255.999;
            *above = (white + slope + 0.5) / 255.999;
        }
        let is_right = |end: [f64; 3], right: [f64; 3]| {
            end.into_iter()
                .zip(right)
                .all(|(end, right)| (end - right).abs() < 0.01)
        };
        if is_right(below, [1.0; 3]) && is_right(above, [0.5, 0.7, 1.0]) {
            return None;
        }
        let ([r0, g0, b0], [r1, g1, b1]) = (below, above);
        Some(format!(
            "The sky blends from ({r0:.2}, {g0:.2}, {b0:.2}) below to ({r1:.2}, {g1:.2}, {b1:.2}) above, instead of (1, 1, 1) and (0.5, 0.7, 1)."
        ))
    }

    /// Every component raised to the same power, as gamma correction does.
    pub(super) fn power(&self) -> Option<String> {
        let part = |level: i16| (f64::from(level) + 0.5) / 256.0;
        let components = |n: u32| self.expected(n).into_iter().zip(self.found(n));
        let powers = self
            .places
            .iter()
            .flat_map(|&n| components(n))
            .filter(|(expected, _)| (32..224).contains(expected));
        let mut powers: Vec<f64> = powers
            .map(|(expected, found)| part(found).ln() / part(expected).ln())
            .collect();
        powers.sort_by(f64::total_cmp);
        let power = *powers.get(powers.len() / 2)?;
        let raised = |level: i16| (256.0 * part(level).powf(power)) as i16;
        // A power changes the steps between levels, so one more may be lost.
        let off = |n: &&u32| {
            components(**n).any(|(expected, found)| raised(expected).abs_diff(found) > 3)
        };
        let is_everywhere = 100 * self.places.iter().filter(off).count() <= self.places.len();
        (is_everywhere && (power - 1.0).abs() > 0.02).then(|| {
            format!("Every component is raised to the power {power:.2}, as gamma correction does.")
        })
    }

    /// Components that are off in the same way everywhere, for sky and spheres.
    pub(super) fn tints(&self) -> Vec<String> {
        let (spheres, sky): (Vec<u32>, Vec<u32>) =
            self.places.iter().partition(|&&n| self.is_hit(n));
        let mut tints = Vec::new();
        for (name, places) in [("the sky", sky), ("what is hit", spheres)] {
            for (channel, color) in ["red", "green", "blue"].into_iter().enumerate() {
                tints.extend(
                    self.tint(&places, channel)
                        .map(|tint| format!("In {name}, {color} is {tint}.")),
                );
            }
        }
        tints
    }

    fn tint(&self, places: &[u32], channel: usize) -> Option<String> {
        let pairs: Vec<(f64, f64)> = places
            .iter()
            .map(|&n| {
                (
                    f64::from(self.expected(n)[channel]),
                    f64::from(self.found(n)[channel]),
                )
            })
            .collect();
        let everywhere = |law: &dyn Fn(f64) -> f64| {
            let off = |&&(expected, found): &&(f64, f64)| (law(expected) - found).abs() > 1.5;
            100 * pairs.iter().filter(off).count() <= pairs.len()
        };
        let &(expected, found) = pairs.get(pairs.len() / 2)?;
        if everywhere(&|expected| expected) {
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
        let sums = pairs
            .iter()
            .fold((0.0, 0.0), |sums, pair| (sums.0 + pair.0, sums.1 + pair.1));
        let factor = sums.1 / sums.0;
        (sums.0 > 0.0 && everywhere(&|expected| factor * expected))
            .then(|| format!("{factor:.2} times what it should be"))
    }
}

/// The line through points by least squares: its height at 0, and its slope.
fn line(x: &[f64], y: &[f64]) -> Option<(f64, f64)> {
    let count = x.len() as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
    let (middle, height) = (mean(x), mean(y));
    let spread: f64 = x.iter().map(|x| (x - middle) * (x - middle)).sum();
    let together: f64 = x
        .iter()
        .zip(y)
        .map(|(x, y)| (x - middle) * (y - height))
        .sum();
    let slope = together / spread;
    (spread > 0.0).then_some((height - slope * middle, slope))
}
