//! Tone curves: levels that all went through the same function, as gamma correction
//! does it.

use std::ops::Range;

use super::antialiased::{EDGE, contrast};
use super::{But, Conversion, Evidence, Explanation, Hypothesis};
use crate::bits::Pixel;
use crate::reading::Reading;

/// A curve that levels went through.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// What became of each level.
    levels: Vec<i16>,
    /// The levels that the right picture has.
    known: Vec<i16>,
    /// The power that it is near, if components were raised to one.
    pub power: Option<f64>,
    /// The power that was typed then, and by what components were multiplied after it.
    raised: Option<[f64; 2]>,
}

/// That there is a curve.
const NAME: f64 = 6.0;
/// What each level has become, beside what the one before it has.
const POINT: f64 = 3.0;
/// Two points make a line; so many different levels make a curve.
const MANY: usize = 12;
/// Levels that tell of a power.
const USABLE: Range<i16> = 16..240;
/// Powers that components are raised to.
const POWERS: [f64; 4] = [0.5, 1.0 / 2.2, 2.0, 2.2];
/// Levels of a whole component.
const LEVELS: f64 = 255.999;

/// The program's picture on the curve that fits, if there is one.
pub(crate) fn on_a_curve(
    evidence: &Evidence,
    hypothesis: &Hypothesis,
    drawn: &[Pixel],
) -> Option<Explanation> {
    if hypothesis.conversion != Conversion::Clamped {
        return None;
    }
    let curve = Curve::between(drawn, evidence.reading)?;
    let drawn: Vec<Pixel> = drawn.iter().map(|pixel| curve.of_pixel(*pixel)).collect();
    let mut explanation = hypothesis.explaining(evidence.reading, &drawn);
    explanation.name += curve.name();
    explanation.but.push(But::Curve(curve));
    Some(explanation)
}

impl Curve {
    /// The curve between two pictures: what most pixels of each level have become, but at edges,
    /// where they may be mixed.
    fn between(drawn: &[Pixel], reading: &Reading) -> Option<Self> {
        let mut becomes = vec![[0_u32; 256]; 256];
        let contrast = contrast(drawn, reading.width as usize);
        let pairs = drawn.iter().zip(&reading.pixels).zip(contrast);
        for ((drawn, found), _) in pairs.filter(|(_, contrast)| *contrast <= EDGE) {
            for (level, found) in drawn.iter().zip(found) {
                becomes[*level as usize][*found as usize] += 1;
            }
        }
        let points = (0..).zip(&becomes);
        let curve: Vec<(i16, i16)> = points
            .filter_map(|(level, found)| Some((level, middle(found)?)))
            .collect();
        let rises = curve.windows(2).all(|pair| pair[1].1 >= pair[0].1 - 1);
        let mut found: Vec<i16> = curve.iter().map(|point| point.1).collect();
        found.dedup();
        let power = power(&curve);
        let bent = curve
            .iter()
            .filter(|(level, found)| level.abs_diff(*found) > 1);
        let is_bent = 2 * bent.count() > curve.len();
        (is_bent && rises && found.len() >= MANY).then(|| Self {
            power,
            raised: power.and_then(|power| raised(&curve, power)),
            levels: filled(&curve),
            known: curve.iter().map(|(level, _)| *level).collect(),
        })
    }

    /// Bits that tell it: a power with two digits, or each point.
    pub(super) fn name(&self) -> f64 {
        match self.power {
            Some(_) => 3.0 * NAME,
            None => NAME + POINT * self.known.len() as f64,
        }
    }

    /// Some of the levels that the picture has, with what became of them.
    pub fn examples(&self) -> impl Iterator<Item = (i16, i16)> {
        let at = [1, 2, 3].map(|quarter| self.known[quarter * (self.known.len() - 1) / 4]);
        at.into_iter().map(|level| (level, self.apply(level)))
    }

    /// What became of a level.
    pub fn apply(&self, level: i16) -> i16 {
        self.levels[level.clamp(0, 255) as usize]
    }

    pub(super) fn of_pixel(&self, pixel: Pixel) -> Pixel {
        pixel.map(|level| self.apply(level))
    }

    /// What became of a component of the mean of several rays, which had a fraction of a level.
    pub(super) fn of_component(&self, component: f64) -> i16 {
        let raised = self.raised.map(|[power, factor]| {
            let raised = factor * component.max(0.0).powf(power);
            raised.min(255.0)
        });
        raised.unwrap_or_else(|| self.at(LEVELS * component)) as i16
    }

    /// What became of a component between levels, with the fraction that was cut off.
    pub(super) fn at(&self, level: f64) -> f64 {
        let at = (level - 0.5).clamp(0.0, 255.0);
        let [below, above] = [at.floor(), at.ceil()].map(|at| f64::from(self.apply(at as i16)));
        below + (at - at.floor()) * (above - below) + 0.5
    }
}

/// The level in the middle of all that one has become.
fn middle(found: &[u32; 256]) -> Option<i16> {
    let all: u32 = found.iter().sum();
    let mut sum = 0;
    let middle = found.iter().position(|count| {
        sum += count;
        2 * sum > all
    });
    middle.map(|level| level as i16)
}

/// All 256 levels, those between two that are known in a straight line.
fn filled(curve: &[(i16, i16)]) -> Vec<i16> {
    let between = |level: i16| {
        let at = curve.partition_point(|point| point.0 < level);
        let (before, after) = (curve[at.saturating_sub(1)], curve[at.min(curve.len() - 1)]);
        let way = f64::from(after.0 - before.0);
        let part = if way > 0.0 {
            f64::from(level - before.0) / way
        } else {
            0.0
        };
        let found = f64::from(before.1) + part.clamp(0.0, 1.0) * f64::from(after.1 - before.1);
        found.round() as i16
    };
    (0..256).map(between).collect()
}

fn component(level: i16) -> f64 {
    (f64::from(level) + 0.5) / 256.0
}

/// The power that people type near one, and 255 or the book's factor, whichever is nearer.
fn raised(curve: &[(i16, i16)], power: f64) -> Option<[f64; 2]> {
    let power = POWERS.into_iter().find(|it| (it - power).abs() < 0.02)?;
    let usable = curve.iter().filter(|point| USABLE.contains(&point.0));
    let factors =
        usable.map(|&(level, found)| (f64::from(found) + 0.5) / component(level).powf(power));
    let mut factors: Vec<f64> = factors.collect();
    factors.sort_by(f64::total_cmp);
    let factor = *factors.get(factors.len() / 2)?;
    let is_the_books = factor > 0.5 * (255.0 + LEVELS);
    Some([power, if is_the_books { LEVELS } else { 255.0 }])
}

/// The power that components were raised to, if they were and it is well away from 1.
fn power(curve: &[(i16, i16)]) -> Option<f64> {
    let usable = curve.iter().filter(|point| USABLE.contains(&point.0));
    let mut powers: Vec<f64> = usable
        .map(|&(level, found)| component(found).ln() / component(level).ln())
        .collect();
    powers.sort_by(f64::total_cmp);
    let power = *powers.get(powers.len() / 2)?;
    let raised = |level: i16| 256.0 * component(level).powf(power);
    let is_near = |&(level, found): &(i16, i16)| (raised(level) - f64::from(found)).abs() <= 3.5;
    let mut usable = curve.iter().filter(|point| USABLE.contains(&point.0));
    ((power - 1.0).abs() > 0.1 && usable.all(is_near)).then_some(power)
}
