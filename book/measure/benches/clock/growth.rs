//! Scaling: the nearest hit among more and more spheres.

use std::error::Error;
use std::hint::black_box;
use std::rc::Rc;
use std::time::Duration;

use common::rtweekend::*;
use figures::records::Timing;
use glam::Vec3A;
use hittable_list::{Hittable, HittableList, Sphere};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::ray::{Ray as BoxRay, RayHit};
use speed_vs_accuracy::batch::{BLOCK, Block, nearest};
use speed_vs_accuracy::{Precision, Random};

use crate::one_by_one;
use measure::contest::{Group, Runner};

/// The largest number of spheres, as a power of two.
const LARGEST: u32 = 16;

/// Ways to keep spheres, in order of what they take to write.
const KEEPERS: [&str; 4] = ["boxed_list", "vec", "batch", "bvh"];

/// One group for each number of spheres; every second one if it must be quick.
///
/// # Errors
/// If two ways to keep spheres find different hits.
pub(crate) fn groups(quick: bool) -> Result<Vec<Group>, Box<dyn Error>> {
    let step = if quick { 2 } else { 1 };
    (0..=LARGEST)
        .step_by(step)
        .map(|power| group(1 << power))
        .collect()
}

/// From how many spheres on each way beats the first one.
pub(crate) fn crossovers(rows: &[Timing]) -> String {
    let growth: Vec<&Timing> = rows.iter().filter(|row| row.what == "growth").collect();
    let median = |name: &str, n| {
        let row = growth.iter().find(|row| row.name == name && row.n == n);
        row.map_or(f64::NAN, |row| row.median_ns)
    };
    let mut sizes: Vec<usize> = growth.iter().map(|row| row.n).collect();
    sizes.dedup();
    let mut text = String::new();
    for (faster, slower) in [
        ("vec", "boxed_list"),
        ("batch", "vec"),
        ("bvh", "vec"),
        ("bvh", "batch"),
    ] {
        // From there on always, so that a tie among few spheres does not count.
        let beats = |&&n: &&usize| median(faster, n) < median(slower, n);
        let from = sizes.iter().rev().take_while(beats).last();
        text += &match from {
            Some(n) => format!("{faster} is faster than {slower} from {n} spheres on\n"),
            None => format!("{faster} is never faster than {slower}\n"),
        };
    }
    text
}

fn group(count: usize) -> Result<Group, Box<dyn Error>> {
    let spheres = Rc::new(spheres(count));
    let rays = Rc::new(rays(count));
    let keepers = [
        boxed_list(&spheres),
        plain_vec(&spheres),
        batch(&spheres),
        bvh(&spheres),
    ];
    let mut runners = vec![one_by_one::reference()];
    let expected: Vec<Option<f64>> = rays.iter().map(&keepers[0]).collect();
    for (name, nearest) in KEEPERS.into_iter().zip(keepers) {
        let found: Vec<Option<f64>> = rays.iter().map(&nearest).collect();
        if found != expected {
            return Err(format!("{name} finds other hits among {count} spheres").into());
        }
        let rays = Rc::clone(&rays);
        let key = ["growth", name, ""];
        let work = rays.len();
        let run = move || {
            for ray in rays.iter() {
                black_box(nearest(black_box(ray)));
            }
        };
        runners.push(Runner::new(key, Precision::Double, count, work, run));
    }
    Ok(Group(runners))
}

/// Spheres at random in a cube, so large that most rays hit one.
pub(crate) fn spheres(count: usize) -> Vec<(Point3, f64)> {
    let mut random = Random::new(1);
    let side = (1..).find(|side| side * side * side >= count).unwrap_or(1) as f64;
    (0..count)
        .map(|_| {
            let mut coordinate = || random.between(-0.5, 0.5);
            let center = Point3::new(coordinate(), coordinate(), coordinate() - 2.0);
            (center, 0.3 / side)
        })
        .collect()
}

/// Rays of the book’s camera, fewer where each takes longer.
pub(crate) fn rays(count: usize) -> Vec<Ray> {
    let camera = Camera::with_size(64, 64);
    let mut random = Random::new(2);
    let mut pixel = || 16 + random.below(32);
    let rays = (1 << 20) / count.max(1 << 12) / 4;
    (0..rays).map(|_| camera.ray(pixel(), pixel())).collect()
}

type Nearest = Box<dyn Fn(&Ray) -> Option<f64>>;

/// The list of chapter 5.
fn boxed_list(spheres: &[(Point3, f64)]) -> Nearest {
    let mut list = HittableList::default();
    for &(center, radius) in spheres {
        list.add(Sphere::new(center, radius));
    }
    Box::new(move |ray| list.hit(ray, 0.0, f64::INFINITY).map(|hit| hit.t))
}

/// The same loop over spheres that lie side by side.
fn plain_vec(spheres: &[(Point3, f64)]) -> Nearest {
    let sphere = |&(center, radius): &(Point3, f64)| Sphere::new(center, radius);
    let spheres: Vec<Sphere> = spheres.iter().map(sphere).collect();
    Box::new(move |ray| {
        let mut nearest = None;
        let mut closest_so_far = f64::INFINITY;
        for sphere in &spheres {
            if let Some(hit) = sphere.hit(ray, 0.0, closest_so_far) {
                closest_so_far = hit.t;
                nearest = Some(hit.t);
            }
        }
        nearest
    })
}

/// Sixty-four spheres at a time. What is left of the last block is points
/// behind the ray.
fn batch(spheres: &[(Point3, f64)]) -> Nearest {
    let behind = (Point3::new(0.0, 0.0, 1e9), 0.0);
    let row = |&(center, radius): &(Point3, f64)| [center.x, center.y, center.z, radius];
    let blocks: Vec<Block<f64, 4>> = spheres
        .chunks(BLOCK)
        .map(|chunk| Block::from_fn(|k| row(chunk.get(k).unwrap_or(&behind))))
        .collect();
    Box::new(move |ray| {
        let t = nearest(&blocks, ray, [0.0, f64::INFINITY]);
        (t < f64::INFINITY).then_some(t)
    })
}

/// A hierarchy of boxes around spheres. Its boxes are in `f32`, so they are made
/// a little too large; the hit itself is found in `f64`.
fn bvh(spheres: &[(Point3, f64)]) -> Nearest {
    const ROOM: f32 = 1e-6;
    let bounds = |&(center, radius): &(Point3, f64)| {
        let [low, high] = [center - radius, center + radius].map(|corner| corner.as_vec3a());
        Aabb::new(low - ROOM, high + ROOM)
    };
    let boxes: Vec<Aabb> = spheres.iter().map(bounds).collect();
    let built = build_bvh2(
        &boxes,
        BvhBuildParams::medium_build(),
        &mut Duration::default(),
    );
    let place = |&index: &u32| {
        let (center, radius) = spheres[index as usize];
        Sphere::new(center, radius)
    };
    let spheres: Vec<Sphere> = built.primitive_indices.iter().map(place).collect();
    Box::new(move |ray| nearest_in(&built, &spheres, ray))
}

fn nearest_in(bvh: &Bvh2, spheres: &[Sphere], ray: &Ray) -> Option<f64> {
    let [origin, direction]: [Vec3A; 2] = [ray.origin, ray.direction].map(|v| v.as_vec3a());
    let mut nearest = None;
    let mut closest_so_far = f64::INFINITY;
    bvh.ray_traverse(
        BoxRay::new_inf(origin, direction),
        &mut RayHit::none(),
        |_, index| {
            match spheres[index].hit(ray, 0.0, closest_so_far) {
                Some(hit) => {
                    closest_so_far = hit.t;
                    nearest = Some(hit.t);
                    // Not nearer than the hit, or what lies just before it is skipped.
                    (hit.t as f32).next_up()
                }
                None => f32::INFINITY,
            }
        },
    );
    nearest
}
