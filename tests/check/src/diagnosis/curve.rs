//! Tone curves: levels that all went through the same function, as gamma correction
//! does it.

use super::antialiasing::Around;
use super::candidates::spread;
use super::scene::Scene;
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
}

/// How many pixels the curve is taken from.
const LOOK: u32 = 3000;
/// So many different levels make a curve.
const LEVELS: usize = 24;
/// The same level may become levels that are no farther from the one in the middle.
const SAME: i16 = 2;

impl Curve {
    /// The curve between the scene's right picture and this one, if there is one that is
    /// more than a rounding.
    pub(super) fn of(scene: &Scene, reading: &Reading) -> Option<Self> {
        let mut becomes: Vec<Vec<i16>> = vec![Vec::new(); 256];
        let program = scene.program(&[]);
        let camera = program.camera(reading.width);
        for n in spread(LOOK, reading.pixels.len() as u32) {
            let around = Around::of(&program, &camera, n);
            // Along edges a level may be any.
            if !around.is_edge() {
                for (level, found) in around.middle().into_iter().zip(reading.pixels[n as usize]) {
                    becomes[level as usize].push(found);
                }
            }
        }
        let curve: Vec<(i16, i16)> = (0..)
            .zip(&mut becomes)
            .filter_map(|(level, found)| Some((level, middle(found)?)))
            .collect();
        let is_one = is_rising(&curve) && are_the_same(&becomes, &curve) && !is_straight(&curve);
        is_one.then(|| Self {
            power: power(&curve),
            levels: filled(&curve),
            known: curve.iter().map(|(level, _)| *level).collect(),
        })
    }

    /// Some of the levels that the picture has, with what became of them.
    pub fn examples(&self) -> impl Iterator<Item = (i16, i16)> {
        let at = [1, 2, 3].map(|quarter| self.known[quarter * (self.known.len() - 1) / 4]);
        at.into_iter().map(|level| (level, self.apply(level)))
    }

    /// A pixel as it is, or as the curve makes it of `right`, if a rounding before the curve
    /// is all that lies between the two.
    pub(super) fn settled(&self, right: [i16; 3], found: [i16; 3]) -> [i16; 3] {
        let is_near = |c: usize| {
            let range = self.apply(right[c] - 1)..=self.apply(right[c] + 1);
            range.contains(&found[c])
        };
        match (0..3).all(is_near) {
            true => right.map(|level| self.apply(level)),
            false => found,
        }
    }

    /// What became of a level.
    pub fn apply(&self, level: i16) -> i16 {
        self.levels[level.clamp(0, 255) as usize]
    }
}

/// Sorts them, and returns the one in the middle.
fn middle(found: &mut [i16]) -> Option<i16> {
    found.sort_unstable();
    found.get(found.len() / 2).copied()
}

/// Whether almost all of what each level has become is the same, or what its neighbors
/// have become: where the curve is steep, a rounding before it makes much of a difference.
fn are_the_same(becomes: &[Vec<i16>], curve: &[(i16, i16)]) -> bool {
    let (mut all, mut off) = (0, 0);
    for (n, &(level, _)) in curve.iter().enumerate() {
        let low = curve[n.saturating_sub(1)].1 - SAME;
        let high = curve[(n + 1).min(curve.len() - 1)].1 + SAME;
        let found = &becomes[level as usize];
        all += found.len();
        off += found
            .iter()
            .filter(|found| !(low..=high).contains(found))
            .count();
    }
    50 * off <= all
}

/// Whether more light stays more light, over a range that is worth the name.
fn is_rising(curve: &[(i16, i16)]) -> bool {
    let rises = curve.windows(2).all(|pair| pair[1].1 >= pair[0].1 - 1);
    let (Some(first), Some(last)) = (curve.first(), curve.last()) else {
        return false;
    };
    let mut found: Vec<i16> = curve.iter().map(|point| point.1).collect();
    found.dedup();
    found.len() >= LEVELS && rises && 4 * (last.1 - first.1) >= last.0 - first.0
}

/// Whether nearly all levels stayed what they were, but for what rounding and several rays
/// do.
fn is_straight(curve: &[(i16, i16)]) -> bool {
    let moved = |point: &&(i16, i16)| (point.0 - point.1).abs() > 2 * SAME;
    10 * curve.iter().filter(moved).count() <= curve.len()
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

/// The power that components were raised to, if they were and it is well away from 1.
fn power(curve: &[(i16, i16)]) -> Option<f64> {
    let component = |level: i16| (f64::from(level) + 0.5) / 256.0;
    let usable = curve.iter().filter(|point| (16..240).contains(&point.0));
    let mut powers: Vec<f64> = usable
        .map(|&(level, found)| component(found).ln() / component(level).ln())
        .collect();
    powers.sort_by(f64::total_cmp);
    let power = *powers.get(powers.len() / 2)?;
    let raised = |level: i16| 256.0 * component(level).powf(power);
    let is_near = |&(level, found): &(i16, i16)| (raised(level) - f64::from(found)).abs() <= 3.5;
    let mut usable = curve.iter().filter(|point| (16..240).contains(&point.0));
    ((power - 1.0).abs() > 0.1 && usable.all(is_near)).then_some(power)
}
