//! Which of several spheres is hit first: `certified_nearest` against the oracle.

use common::rtweekend::*;
use laws::Case;
use laws::config;
use laws::list::World;
use laws::oracle::{ExactCase, ExactRoot};
use proptest::prelude::*;
use speed_vs_accuracy::{certified_nearest, certified_t, exact};

use crate::methods::neighbors;

proptest! {
    #![proptest_config(ProptestConfig { cases: config().cases.max(12_000), ..config() })]

    /// The sphere with the least root in the range is found, the first of the list where
    /// roots are equal, and `t` is within an ulp of it. A root that no `f64` reaches becomes
    /// the largest one. `PROPTEST_CASES` says how many worlds, and `PROPTEST_RNG_SEED` which.
    #[test]
    fn the_first_of_several_spheres_is_found_for_every_input(world in neighbors::hostile()) {
        let exacts: Vec<Option<ExactCase>> = cases(&world).map(|it| ExactCase::of_finite(&it)).collect();
        let World { spheres, ray, t_min, t_max } = &world;
        let found = certified_nearest(spheres, ray, *t_min, *t_max);
        let expected = first_root(&exacts, &world);
        let first = found.map(|(index, _)| index);
        prop_assert_eq!(first, expected.map(|(index, _)| index));
        if let (Some((_, t)), Some((_, root))) = (found, expected) {
            let is_beyond = root.rounded().is_infinite() && t.abs() == f64::MAX;
            prop_assert!(root.error_in_ulps(t) <= 1.0 || is_beyond, "{t:?}");
            prop_assert!(*t_min < t && t < *t_max, "{t:?}");
        }
    }
}

fn cases(world: &World) -> impl Iterator<Item = Case> {
    world.spheres.iter().map(|&(center, radius)| Case {
        center,
        radius,
        ray: world.ray,
    })
}

fn first_root<'a>(
    exacts: &'a [Option<ExactCase>],
    world: &World,
) -> Option<(usize, ExactRoot<'a>)> {
    // Between two neighbors there is no number to return.
    if world.t_min.next_up() >= world.t_max {
        return None;
    }
    let roots = exacts.iter().enumerate().filter_map(|(index, exact)| {
        let root = exact.as_ref()?.nearest_root_in(world.t_min, world.t_max)?;
        Some((index, root))
    });
    roots.reduce(|first, other| if other.1 < first.1 { other } else { first })
}

/// Both roots are near 1/3, below which there is an `f64` that is nearer to it than any
/// other. The second root lies between the two, so a loop that keeps the closest `t` so far
/// passes it over.
#[test]
fn two_roots_are_told_apart_that_are_rounded_to_one_number() {
    let spheres = [(2.0 * Vec3::X, 1.0), (1.125 * Vec3::X, 0.125_f64.next_up())];
    let ray = Ray::new(Point3::ZERO, 3.0 * Vec3::X);
    let alone = |(center, radius)| exact(center, radius, &ray, 0.0, f64::INFINITY);
    assert_eq!(spheres.map(alone), [Some(1.0 / 3.0); 2]);
    let first = certified_nearest(&spheres, &ray, 0.0, f64::INFINITY);
    assert_eq!(first, Some((1, 1.0 / 3.0)));
}

/// Of two roots between the same two numbers, the lesser one is rounded up and the greater
/// one down, because it is a ten-thousandth of an ulp too far from half-way.
#[test]
fn the_lesser_of_two_roots_is_found_where_it_has_the_greater_t() {
    let big = (
        Point3::new(0.07688209193353152, -1.0859567782698512, 0.6731175085429627),
        1.2798046955732145,
    );
    let small = (
        Point3::new(
            -0.00030394264611705566,
            -0.005981926899212193,
            -0.009228904321220591,
        ),
        2.68542947910665e-06,
    );
    let ray = Ray::new(
        Point3::ZERO,
        Vec3::new(
            -0.027625613032401977,
            -0.543702569602914,
            -0.8388231883488751,
        ),
    );
    let alone = |(center, radius)| certified_t(center, radius, &ray, 0.0, f64::INFINITY);
    assert!(alone(small) < alone(big));
    for spheres in [[big, small], [small, big]] {
        let first = certified_nearest(&spheres, &ray, 0.0, f64::INFINITY);
        assert_eq!(first.map(|(first, _)| spheres[first]), Some(big));
    }
}

#[test]
fn the_first_of_equal_spheres_counts_and_what_is_no_number_is_missed() {
    let sphere = (Point3::new(0.0, 0.0, -1.0), 0.5);
    let lost = (Point3::new(0.0, 0.0, f64::NAN), 0.5);
    let endless = (sphere.0, f64::INFINITY);
    let ray = Ray::new(Point3::ZERO, Vec3::NEG_Z);
    let first = |spheres: &[_], t_max| certified_nearest(spheres, &ray, 0.0, t_max);
    let hollow = (sphere.0, -0.5);
    assert_eq!(first(&[sphere, sphere, hollow], 1.0), Some((0, 0.5)));
    assert_eq!(first(&[lost, endless, hollow, sphere], 1.0), Some((2, 0.5)));
    assert_eq!(first(&[sphere], f64::NAN), None);
    assert_eq!(first(&[sphere], 0.5), None, "the end is left out");
    assert_eq!(first(&[], 1.0), None);
}
