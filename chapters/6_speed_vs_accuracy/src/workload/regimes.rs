//! The workload: six situations, here called *regimes*, in which every method is
//! tried.
//!
//! The cases are random, and the same on every machine: only operations that
//! round alike everywhere make them, + − × ÷ and √. Each is made for one of two
//! precisions, because the hard places of `f32` lie elsewhere than those of
//! `f64`, and all its numbers are numbers of that precision.

use common::rtweekend::*;

use super::case::Case;
use crate::precision::Precision;

/// A *regime*: a generator of random questions about rays and spheres in one situation, such as
/// small spheres far away. A level k tells how hard they are.
#[derive(Clone, Copy, Debug)]
pub struct Regime {
    /// The name of the regime in tables, one word, such as `telescope`.
    pub name: &'static str,
    /// What the rays do, in a few words, such as "a small sphere far away".
    pub shows: &'static str,
    /// The least and the greatest level k, in `f64` and in `f32`.
    levels: [(i32, i32); 2],
    case: fn(&mut Random, level: i32) -> Case,
}

/// All six regimes, that of the book's picture first: the order of tables and charts.
pub const REGIMES: [Regime; 6] = [
    Regime::BOOK,
    Regime::TELESCOPE,
    // With a radius of 10ᵏ, up to that of an Earth and beyond.
    Regime::new(
        ["ground", "above a huge ground"],
        [(2, 9), (2, 6)],
        |random, level| {
            let height = random.between(0.01, 10.0);
            above(random, power_of_ten(level), height)
        },
    ),
    // The line passes the center at (1 ± 10⁻ᵏ) radii.
    Regime::new(
        ["grazing", "rays near a tangent"],
        [(1, 15), (1, 7)],
        grazing,
    ),
    // Of a sphere with a radius of 10ᵏ.
    Regime::new(
        ["shadows", "rays that leave a surface"],
        [(0, 9), (0, 4)],
        shadows,
    ),
    // (1 − 10⁻ᵏ) radii from the center.
    Regime::new(
        ["inside", "from inside a sphere"],
        [(0, 12), (0, 5)],
        inside,
    ),
];

impl Regime {
    /// The regime `book`: rays of the book's own picture; its only level is 0.
    pub const BOOK: Self = Self::new(["book", "the book’s rays"], [(0, 0); 2], |random, _| {
        book(random)
    });

    /// The regime `telescope`: small spheres, with a ray that starts 10ᵏ radii away at level k.
    pub const TELESCOPE: Self = Self::new(
        ["telescope", "a small sphere far away"],
        [(1, 15), (1, 6)],
        telescope,
    );

    const fn new(
        [name, shows]: [&'static str; 2],
        levels: [(i32, i32); 2],
        case: fn(&mut Random, level: i32) -> Case,
    ) -> Self {
        Self {
            name,
            shows,
            levels,
            case,
        }
    }

    /// Makes `count` random cases, each of a random level k of those that make sense in `precision`,
    /// in numbers that `precision` can hold. The same `seed` gives the same cases.
    pub fn cases(&self, precision: Precision, seed: u64, count: usize) -> Vec<Case> {
        let (mildest, hardest) = self.levels[precision as usize];
        let mut random = Random::new(seed);
        let mut case = || {
            let span = hardest - mildest + 1;
            let level = mildest + random.below(span.unsigned_abs()).cast_signed();
            (self.case)(&mut random, level).rounded(precision)
        };
        (0..count).map(|_| case()).collect()
    }
}

/// The two spheres of the book, center and radius of each: first the ball, then the ground.
pub const SPHERES: [(Point3, f64); 2] = [
    (Point3::new(0.0, 0.0, -1.0), 0.5),
    (Point3::new(0.0, -100.5, -1.0), 100.0),
];

/// Makes the case of a random pixel of the book's picture, 3840 pixels wide, and one of its
/// spheres.
fn book(random: &mut Random) -> Case {
    let camera = Camera::new(3840);
    let ray = camera.ray(
        random.below(camera.image_width),
        random.below(camera.image_height),
    );
    let (center, radius) = SPHERES[random.below(2) as usize];
    Case::new(center, radius, ray)
}

/// Makes a ray from 3 radii away, along a line that just meets the sphere or just
/// misses.
fn grazing(random: &mut Random, level: i32) -> Case {
    let miss_by = 1.0 + random.sign() / power_of_ten(level);
    aimed(random, 3.0, miss_by)
}

/// Makes a ray at a point that is within 1.2 radii of the center of a far sphere.
fn telescope(random: &mut Random, level: i32) -> Case {
    let miss_by = random.between(0.0, 1.2);
    aimed(random, power_of_ten(level), miss_by)
}

/// Makes a ray from a point of the surface, as exactly as its coordinates can be
/// on it, in the direction that the book's matte surfaces scatter: normal + unit
/// vector.
fn shadows(random: &mut Random, level: i32) -> Case {
    let (center, radius) = sphere(random, power_of_ten(level));
    let normal = random.direction();
    let ray = Ray::new(center + radius * normal, normal + random.direction());
    Case::new(center, radius, ray)
}

/// Makes a ray in any direction, from this height above a sphere, which may be on any side of the
/// eye: straight below it, |oc| would be a coordinate, and exact. A negative height is a depth.
pub fn above(random: &mut Random, radius: f64, height: f64) -> Case {
    let eye = Point3::new(0.25, 1.5, -0.75);
    let center = eye + (radius + height) * random.direction();
    Case::new(center, radius, Ray::new(eye, random.direction()))
}

/// Makes a ray in any direction, from the center or from a little below the
/// surface.
fn inside(random: &mut Random, level: i32) -> Case {
    let size = random.between(0.5, 2.0);
    let (center, radius) = sphere(random, size);
    let depth = 1.0 - 1.0 / power_of_ten(level);
    let origin = center + radius * depth * random.direction();
    let ray = Ray::new(origin, random.direction());
    Case::new(center, radius, ray)
}

/// Makes a ray that starts `away` radii before a sphere of ordinary size, and
/// whose line passes the center at `miss_by` radii.
pub fn aimed(random: &mut Random, away: f64, miss_by: f64) -> Case {
    let size = random.between(0.5, 2.0);
    let (center, radius) = sphere(random, size);
    let forward = random.direction();
    let sideways = forward.cross(random.direction()).normalize();
    let closest = center + radius * miss_by * sideways;
    let length = random.between(0.5, 2.0);
    let ray = Ray::new(closest - radius * away * forward, length * forward);
    Case::new(center, radius, ray)
}

/// Makes a sphere within a few radii of the origin.
fn sphere(random: &mut Random, radius: f64) -> (Point3, f64) {
    let mut coordinate = || radius * random.between(-2.0, 2.0);
    let center = Point3::new(coordinate(), coordinate(), coordinate());
    (center, radius)
}

/// Computes 10 to a power from 0 to 22, which an `f64` holds exactly.
fn power_of_ten(exponent: i32) -> f64 {
    (0..exponent).fold(1.0, |power, _| 10.0 * power)
}

/// A generator of random numbers that are the same on every machine.
///
/// Source: SplitMix64 of Steele, Lea and Flood, "Fast splittable pseudorandom number generators"
/// (2014).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Starts the sequence that belongs to `seed`: equal seeds give equal numbers.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Returns the next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Returns a random integer from 0 to `end` − 1, all equally likely up to 2⁻³²; 0 if `end` is 0.
    pub fn below(&mut self, end: u32) -> u32 {
        ((u64::from(end) * (self.bits() >> 32)) >> 32) as u32
    }

    /// Returns a random number from `low` to `high`, all equally likely.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        let share = (self.bits() >> 11) as f64 / (1_u64 << 53) as f64;
        low + (high - low) * share
    }

    /// Returns 1 or −1 at random.
    pub fn sign(&mut self) -> f64 {
        if self.below(2) == 0 { 1.0 } else { -1.0 }
    }

    /// Returns a unit vector in a random direction, all equally likely: that of a point in a ball.
    pub fn direction(&mut self) -> Vec3 {
        loop {
            let [x, y, z] = [(); 3].map(|()| self.between(-1.0, 1.0));
            let point = Vec3::new(x, y, z);
            let square = point.length_squared();
            // Near the center few digits would say where the point is.
            if (0.01..=1.0).contains(&square) {
                return point / square.sqrt();
            }
        }
    }
}
