//! Pictures that say little: many mistakes draw only sky, or one color everywhere, or one
//! wherever a sphere is.

use ::slips::{Output, Program, Room};

use super::{Evidence, Explanation, Hypothesis, estimate, spread};
use crate::bits::{Pixel, commonest};
use crate::judge::is_same;
use crate::reading::Reading;

/// One mistake in four leaves one of a few such pictures. So a slip that draws one too is
/// told only if no more speaks against it than that nobody has seen its line.
const NAME: f64 = 10.0;
/// Bits of a color that is neither gray nor black or brightest in each component.
const COLOR: f64 = 24.0;

/// What is said of them.
pub(crate) const MANY: &str = "Many mistakes draw this picture, so it says little.";

/// How many pixels choose the edition.
const LOOK: u32 = 300;

/// The picture as one of these, by the edition whose sky comes nearest.
pub(crate) fn poor(evidence: &Evidence, rights: &[Hypothesis]) -> Vec<Explanation> {
    let reading = evidence.reading;
    let is_own =
        |it: &&Hypothesis| it.scene.step().is_none() && is_same(&it.scene, &evidence.scene);
    let off = |it: &&Hypothesis| -> f64 {
        let sky = sky(it, reading.width);
        let places = spread(LOOK, reading.pixels.len() as u32);
        let bits = places.map(|n| estimate(it.pixel(&sky, n), reading.pixels[n as usize]));
        bits.sum()
    };
    let own = rights.iter().filter(is_own);
    let nearest = own.min_by(|one, other| off(one).total_cmp(&off(other)));
    let Some((it, right)) = nearest.and_then(|it| Some((it, it.drawn(reading)?))) else {
        return Vec::new();
    };
    let poor = |drawn: &[Pixel], bits: f64| Explanation {
        name: it.name + NAME + bits,
        seen: Some(MANY.to_owned()),
        ..it.explaining(reading, drawn)
    };
    let everywhere = vec![true; reading.pixels.len()];
    let (plain, bits) = painted(&reading.pixels, &everywhere, reading);
    let mut all = vec![poor(&plain, bits)];
    if it.scene.chapter.room() != Room::None {
        let sky = it.before(&sky(it, reading.width));
        let is_hit: Vec<bool> = sky.iter().zip(&right).map(|(sky, it)| sky != it).collect();
        let (spheres, bits) = painted(&sky, &is_hit, reading);
        all.extend([poor(&sky, 0.0), poor(&spheres, bits)]);
    }
    // Who leaves many pixels has drawn something else.
    all.retain(|it| it.left.is_one_by_one);
    all
}

/// The scene without its spheres.
fn sky(right: &Hypothesis, width: u32) -> Output {
    let program = Program {
        world: &[],
        ..right.scene.program(&[])
    };
    program.run(width)
}

/// The picture with the commonest color in some places, and what it costs to tell that.
fn painted(drawn: &[Pixel], is_painted: &[bool], reading: &Reading) -> (Vec<Pixel>, f64) {
    let places = reading.pixels.iter().zip(is_painted);
    let color = commonest(places.filter(|(_, is)| **is).map(|(pixel, _)| *pixel));
    let [red, green, blue] = color;
    let is_gray = red == green && green == blue;
    let is_simple = is_gray || color.iter().all(|level| matches!(level, 0 | 255));
    let pixels = drawn.iter().zip(is_painted);
    let painted = pixels.map(|(&pixel, is_painted)| if *is_painted { color } else { pixel });
    (painted.collect(), if is_simple { 0.0 } else { COLOR })
}
