//! Latency: which of several spheres is first, for one ray after the other.

use std::hint::black_box;

use common::rtweekend::*;
use speed_vs_accuracy::{Case, Precision, Random, certified_nearest, half_b};

use crate::one_by_one;
use measure::contest::{Group, Runner};

/// How many spheres are many: enough that most of them are not hit.
const MANY: u32 = 64;

/// The loop of chapter 5 and the certified one, on the book’s two spheres and on many.
pub(crate) fn groups() -> Vec<Group> {
    let cases = one_by_one::book_rays(Precision::Double, |_| true);
    let sphere = |case: &Case| (case.center, case.radius);
    let two = [sphere(&cases[0]), sphere(&cases[cases.len() - 1])];
    let rays: Vec<Ray> = cases.iter().map(|case| case.ray).collect();
    vec![
        group("book", &two, &rays),
        group("many", &many_spheres(), &rays_at_many()),
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

/// Rays of the book's camera at this cube, as many as one round takes in some milliseconds.
fn rays_at_many() -> Vec<Ray> {
    let camera = Camera::with_size(64, 64);
    let mut random = Random::new(2);
    let mut pixel = || 16 + random.below(32);
    (0..64).map(|_| camera.ray(pixel(), pixel())).collect()
}

fn group(place: &str, spheres: &[(Point3, f64)], rays: &[Ray]) -> Group {
    let certified = |spheres: &[_], ray: &_| certified_nearest(spheres, ray, 0.0, f64::INFINITY);
    Group(vec![
        runner("half_b", place, spheres, rays, by_half_b),
        runner("certified_nearest", place, spheres, rays, certified),
    ])
}

fn runner(
    name: &str,
    place: &str,
    spheres: &[(Point3, f64)],
    rays: &[Ray],
    nearest: impl Fn(&[(Point3, f64)], &Ray) -> Option<(usize, f64)> + 'static,
) -> Runner {
    let (spheres, rays) = (spheres.to_vec(), rays.to_vec());
    let (n, work) = (spheres.len(), rays.len());
    let key = ["nearest", name, place];
    Runner::new(key, Precision::Double, n, work, move || {
        for ray in &rays {
            black_box(nearest(black_box(&spheres), black_box(ray)));
        }
    })
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
