//! Throughput: which of several spheres is first.

use std::hint::black_box;

use common::rtweekend::*;
use measure::contest::{Group, Runner};
use measure::cost::throughput;
use speed_vs_accuracy::{Precision, Random, certified_nearest, half_b};

use crate::one_by_one::{SPHERES, camera};

/// How many spheres are many: enough that most of them are not hit.
const MANY: u32 = 64;

/// The loop of chapter 5 and the certified one, on the book’s two spheres and on many.
pub(crate) fn groups() -> Vec<Group> {
    let pixels = |k: u32| [k % 64 * 400 / 64, k / 64 * 225 / 64];
    let book = (0..4096).map(pixels).collect();
    let mut random = Random::new(2);
    let mut pixel = || 16 + random.below(32);
    let at_many = (0..64).map(|_| [pixel(), pixel()]).collect();
    vec![
        group("book", &SPHERES, camera(), book),
        group("many", &many_spheres(), Camera::with_size(64, 64), at_many),
    ]
}

/// Spheres at random in a cube, so large that most rays hit one.
fn many_spheres() -> Vec<(Point3, f64)> {
    let mut random = Random::new(1);
    let sphere = |_| {
        let mut coordinate = || random.between(-0.5, 0.5);
        let center = Point3::new(coordinate(), coordinate(), coordinate() - 2.0);
        (center, 0.3 / f64::from(MANY).cbrt())
    };
    (0..MANY).map(sphere).collect()
}

fn group(place: &str, spheres: &[(Point3, f64)], camera: Camera, pixels: Vec<[u32; 2]>) -> Group {
    let certified = |spheres: &[_], ray: &_| certified_nearest(spheres, ray, 0.0, f64::INFINITY);
    let pixels = &pixels;
    Group(vec![
        runner("half_b", place, spheres, camera, pixels, by_half_b),
        runner(
            "certified_nearest",
            place,
            spheres,
            camera,
            pixels,
            certified,
        ),
    ])
}

fn runner(
    name: &str,
    place: &str,
    spheres: &[(Point3, f64)],
    camera: Camera,
    pixels: &[[u32; 2]],
    nearest: impl Fn(&[(Point3, f64)], &Ray) -> Option<(usize, f64)> + 'static,
) -> Runner {
    let (spheres, pixels) = (spheres.to_vec(), pixels.to_vec());
    let (n, work) = (spheres.len(), pixels.len());
    let key = ["nearest", name, place];
    let run = throughput(work, move |number| {
        let [i, j] = pixels[number];
        nearest(black_box(&spheres), &camera.ray(i, j))
    });
    Runner::new(key, Precision::Double, n, work, run)
}

fn by_half_b(spheres: &[(Point3, f64)], ray: &Ray) -> Option<(usize, f64)> {
    let mut nearest = None;
    let mut closest_so_far = f64::INFINITY;
    for (index, &(center, radius)) in spheres.iter().enumerate() {
        if let Some(t) = half_b(center, radius, ray, 0.0, closest_so_far) {
            closest_so_far = t;
            nearest = Some((index, t));
        }
    }
    nearest
}
