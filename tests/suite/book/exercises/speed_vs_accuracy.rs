//! Answers to the exercises of chapter 6.

use common::rtweekend::*;
use speed_vs_accuracy::{half_b, half_b_q};

/// q, and the two roots that come from it, nearer first.
fn by_q(a: f64, h: f64, c: f64) -> [f64; 3] {
    let q = h + (h * h - a * c).sqrt().copysign(h);
    [q, c / q, q / a]
}

#[test]
fn the_ball_of_chapter_3_has_its_roots_at_a_half_and_at_three_halves() {
    assert_eq!(by_q(1.0, 1.0, 0.75), [1.5, 0.5, 1.5]);

    let ray = Ray::new(Point3::ZERO, Vec3::NEG_Z);
    let t = half_b_q(Point3::NEG_Z, 0.5, &ray, 0.0, f64::INFINITY);
    assert_eq!(t, Some(0.5));
}

/// How many of 1024 spheres of radius 1 `half_b` loses that are 10^`k` away, each
/// looked at straight.
fn lost(k: i32) -> usize {
    let is_lost =
        |(center, ray): &(Point3, Ray)| half_b(*center, 1.0, ray, 0.0, f64::INFINITY).is_none();
    straight_ahead(k).filter(is_lost).count()
}

/// Of how many of them c is |oc|² − 2, as if the square of the radius were 2.
fn counted_double(k: i32) -> usize {
    let squares = straight_ahead(k).map(|(center, _)| center.length_squared());
    squares
        .filter(|squared| squared - 1.0 == squared - 2.0)
        .count()
}

/// The centers of these spheres, and the rays.
fn straight_ahead(k: i32) -> impl Iterator<Item = (Point3, Ray)> {
    let directions = (0..1024).map(|n| Vec3::new(f64::from(n % 32), f64::from(n / 32), -32.0));
    directions.map(move |direction| {
        let center = direction * (10f64.powi(k) / direction.length());
        (center, Ray::new(Point3::ZERO, direction))
    })
}

#[test]
fn a_fifth_is_lost_at_ten_to_the_eighth_and_a_third_beyond() {
    for k in 1..=7 {
        assert_eq!(lost(k), 0, "at 10^{k}");
    }
    assert_eq!(lost(8), 201);
    assert_eq!(counted_double(8), 379);
    for k in 9..=40 {
        assert!((256..=352).contains(&lost(k)), "at 10^{k}");
    }
}

/// The relative errors of c, as it is and as a product, for a ray that starts
/// less than 1 above a sphere. All numbers are whole, so c is known.
fn errors_of_c([x, y, z]: [u32; 3]) -> Option<[f64; 2]> {
    let squared = [x, y, z]
        .iter()
        .map(|&n| u128::from(n).pow(2))
        .sum::<u128>();
    let radius = squared.isqrt();
    let c = (squared - radius.pow(2)) as f64;

    let oc = Vec3::new(x.into(), y.into(), z.into());
    let r = radius as f64;
    let as_it_is = oc.length_squared() - r * r;
    let factored = (oc.length() - r) * (oc.length() + r);
    (c > 0.0).then(|| [as_it_is, factored].map(|found| (found / c - 1.0).abs()))
}

/// The average errors of c over a thousand starts, some 10⁹ from the center.
fn average_errors() -> [f64; 2] {
    let starts = (0..1000).map(|n| [2_000_000_000 + 7919 * n, 1_000_000_000 + 104_729 * n, n]);
    let errors: Vec<[f64; 2]> = starts.filter_map(errors_of_c).collect();
    [0, 1].map(|k| errors.iter().map(|pair| pair[k]).sum::<f64>() / errors.len() as f64)
}

#[test]
fn a_product_is_twice_as_far_off_c_as_a_difference() {
    let [as_it_is, factored] = average_errors();
    assert!(
        (1.9..2.0).contains(&(factored / as_it_is)),
        "{as_it_is} and {factored}"
    );
    assert!(factored > 1e8 * f64::EPSILON, "{factored}");
}
