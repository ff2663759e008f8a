//! Silhouettes: pictures that have the sky of a scene, or its sky and its outlines, and other
//! colors of all that is hit.
//!
//! Those with no color, or with one, say little: many mistakes draw them. Those with many
//! colors are drawn by materials, which come in later chapters.

use ::slips::{Chapter, Program, Room, World};

use super::antialiased::WITH_SAMPLES;
use super::{Evidence, Explanation, Hypothesis, Places, Seen, estimate, mark, spread};
use crate::bits::{Frequencies, Left, Pixel, class, commonest, distance, told};
use crate::judge::{GRAIN, is_same};
use crate::reading::Reading;

/// One mistake in four leaves one of a few such pictures. So a slip that draws one too is
/// told only if no more speaks against it than that nobody has seen its line.
const LITTLE: f64 = 10.0;
/// Bits of a color that is neither gray nor black or brightest in each component.
const COLOR: f64 = 24.0;
/// One picture in a thousand that a reader of these chapters judges is a later one's.
const SHADED: f64 = 10.0;
/// One pixel in so many is many: sky where something should be hit, or none where it should be.
const MANY: usize = 24;
/// Levels within which most of what is hit has no other colors.
const SAME: u16 = 8;
/// About what a pixel costs of whose color nothing is known.
const HIT: f64 = 12.0;
/// How many pixels choose the edition, and of these one in so many may be off in a picture that says
/// little.
const LOOK: u32 = 300;
const FEW: usize = 8;

/// The picture as one of these, by the edition whose sky comes nearest.
pub(crate) fn silhouettes(evidence: &Evidence, rights: &[Hypothesis]) -> Vec<Explanation> {
    let reading = evidence.reading;
    let is_own =
        |it: &&Hypothesis| it.scene.step().is_none() && is_same(&it.scene, &evidence.scene);
    let skies = rights.iter().filter(is_own).flat_map(Sky::all);
    let off = |sky: &Sky| -> f64 {
        let output = sky.program.run(reading.width);
        let places = spread(LOOK, reading.pixels.len() as u32);
        let off = |n| estimate(sky.it.pixel(&output, n), reading.pixels[n as usize]);
        places.map(off).sum()
    };
    let nearest = skies
        .map(|sky| (off(&sky), sky))
        .min_by(|(one, _), (other, _)| one.total_cmp(other));
    let Some((_, sky)) = nearest else {
        return Vec::new();
    };
    let Some(right) = sky.it.drawn(reading) else {
        return Vec::new();
    };
    let everywhere = vec![true; reading.pixels.len()];
    let (plain, bits) = painted(&reading.pixels, &everywhere, reading);
    let mut all: Vec<Explanation> = sky.little(reading, &plain, bits).into_iter().collect();
    let mut shaded = None;
    if sky.it.scene.chapter.room() != Room::None {
        let empty = Sky::of(sky.it).drawn(reading);
        let is_hit: Vec<bool> = empty
            .iter()
            .zip(&right)
            .map(|(sky, it)| sky != it)
            .collect();
        let (spheres, bits) = painted(&empty, &is_hit, reading);
        all.extend(sky.little(reading, &empty, 0.0));
        let hit = spheres.iter().zip(&is_hit).find(|(_, is_hit)| **is_hit);
        let is_gray = hit.is_none_or(|([red, green, blue], _)| red == green && green == blue);
        // A sphere of one color in another one is the reader's own.
        if is_gray || sky.it.scene.chapter != Chapter::RedSphere {
            all.extend(sky.little(reading, &spheres, bits));
        }
        let hits = right.iter().zip(&reading.pixels).zip(&is_hit);
        let hits = hits.filter(|(_, is_hit)| **is_hit);
        let offs: Vec<u16> = hits.map(|((it, found), _)| distance(*it, *found)).collect();
        let same = offs.iter().filter(|off| **off <= SAME).count();
        shaded = (2 * same <= offs.len()).then(|| sky.shaded(reading, &is_hit));
    }
    all.extend(shaded.flatten());
    all
}

/// About how long the scene's sky and outlines are as an explanation, from some places;
/// `None` of a scene without spheres.
pub(crate) fn outlined(right: &Hypothesis, reading: &Reading, places: &Places) -> Option<f64> {
    if right.scene.chapter.room() == Room::None {
        return None;
    }
    let outline = right.output(reading)?;
    let empty = Sky::of(right).program.run(reading.width);
    let length = |sky: Sky| {
        let output = sky.program.run(reading.width);
        let bits = places.iter().map(|(n, pixels)| {
            let is_hit = right.pixel(&outline, n) != right.pixel(&empty, n);
            let drawn = right.pixel(&output, n);
            let found = reading.pixels[n as usize];
            pixels
                * match is_hit {
                    true => HIT,
                    false => estimate(drawn, found),
                }
        });
        right.name + SHADED + bits.sum::<f64>()
    };
    Sky::all(right).map(length).into_iter().reduce(f64::min)
}

/// A scene without its spheres.
struct Sky<'a> {
    it: &'a Hypothesis,
    program: Program,
    is_corrected: bool,
}

/// How later chapters scale a component, since version 3.
const CORRECTED: fn(f64) -> i32 = |mean| WITH_SAMPLES(mean.max(0.0).sqrt());

impl<'a> Sky<'a> {
    fn of(it: &'a Hypothesis) -> Self {
        Self {
            it,
            program: Program {
                world: World::of(&[]),
                ..it.scene.program(&[])
            },
            is_corrected: false,
        }
    }

    /// As the chapter scales its components, and as later ones do.
    fn all(it: &'a Hypothesis) -> [Self; 3] {
        let own = Self::of(it);
        let scaled = |level, is_corrected| Self {
            program: Program {
                level,
                ..own.program
            },
            is_corrected,
            ..own
        };
        [
            scaled(own.program.level, false),
            scaled(WITH_SAMPLES, false),
            scaled(CORRECTED, true),
        ]
    }

    fn drawn(&self, reading: &Reading) -> Vec<Pixel> {
        self.it.before(&self.program.run(reading.width))
    }

    /// That the picture says little, beside so many bits of its color. Who leaves many pixels has
    /// drawn something else.
    fn little(&self, reading: &Reading, drawn: &[Pixel], bits: f64) -> Option<Explanation> {
        let is_off = |n: &u32| drawn[*n as usize] != reading.pixels[*n as usize];
        let off = spread(LOOK, drawn.len() as u32).filter(is_off).count();
        let explained = (FEW * off <= LOOK as usize).then(|| self.it.explaining(reading, drawn))?;
        explained.left.is_one_by_one.then_some(Explanation {
            name: self.it.name + LITTLE + bits,
            seen: Some(Seen::Little),
            ..explained
        })
    }

    /// That nothing is known of what is hit, nor of what lies beside it, which may be a mixture.
    /// `None` if sky or outlines are others.
    fn shaded(&self, reading: &Reading, is_hit: &[bool]) -> Option<Explanation> {
        let (drawn, width) = (self.drawn(reading), reading.width as usize);
        let is_near = |n: usize| {
            let rows = [n.checked_sub(width), Some(n), Some(n + width)]
                .into_iter()
                .flatten();
            let mut near = rows
                .flat_map(|n| [n.checked_sub(1), Some(n), Some(n + 1)])
                .flatten();
            near.any(|n| is_hit.get(n) == Some(&true))
        };
        let is_near: Vec<bool> = (0..drawn.len()).map(is_near).collect();
        let all = 0..drawn.len();
        let (near, sky): (Vec<usize>, Vec<usize>) = all.partition(|&n| is_near[n]);
        let is_sky = |n: &&usize| is_hit[**n] && drawn[**n] == reading.pixels[**n];
        let missed = near.iter().filter(is_sky).count();
        let (mut code, mut off, mut far) = (Frequencies::of_noise(), 0, 0);
        for n in sky {
            let (drawn, found) = (drawn[n], reading.pixels[n]);
            for c in 0..3 {
                code.add(c, class(drawn[c], 0), found[c].saturating_sub(drawn[c]));
            }
            off += usize::from(drawn != found);
            far += usize::from(distance(drawn, found) > 1);
        }
        if MANY * (missed + far) > near.len() {
            return None;
        }
        let bits = told(reading, |n| is_near[n]);
        let left = Left {
            bits: code.bits() + bits,
            off,
            far,
            is_both_ways: false,
            is_one_by_one: false,
            part: None,
        };
        Some(Explanation {
            name: self.it.name + SHADED,
            seen: Some(Seen::Shaded {
                is_corrected: self.is_corrected,
                is_grainy: bits > GRAIN * near.len() as f64,
            }),
            ..self.it.leaving(left, mark(&drawn))
        })
    }
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
