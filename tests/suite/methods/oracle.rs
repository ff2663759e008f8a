//! The oracle that judges every intersection, judged by numbers known beforehand and by
//! another library's roots. `methods.rs` compares it with the method `exact`, which shares
//! no code with it.

use std::cmp::Ordering;

use common::rtweekend::*;
use laws::Case;
use laws::oracle::{Exact, Root};

const X: Vec3 = Vec3::X;

fn exact(center: Point3, radius: f64, origin: Point3, direction: Vec3) -> Exact {
    Exact::of(&Case {
        center,
        radius,
        ray: Ray::new(origin, direction),
    })
}

/// A sphere on the x-axis and a ray along it. The roots are
/// (`center` − `origin` ∓ `radius`) / `direction`.
fn on_axis(center: f64, radius: f64, origin: f64, direction: f64) -> Exact {
    exact(center * X, radius, origin * X, direction * X)
}

fn rounded(exact: &Exact) -> [Option<f64>; 2] {
    [exact.nearer_root(), exact.farther_root()].map(|root| root.map(|root| root.rounded()))
}

fn nearer(exact: &Exact) -> Root<'_> {
    exact.nearer_root().expect("the line hits")
}

#[test]
fn a_pythagorean_tangent_is_a_hit_and_one_ulp_of_radius_decides() {
    let offset = Vec3::new(-7.0, 0.375, 1000.0);
    for (x, y, length) in [(3.0, 4.0, 5.0), (5.0, 12.0, 13.0), (8.0, 15.0, 17.0)] {
        let direction = Vec3::new(x, y, 0.0);
        let across = Vec3::new(-y, x, 0.0);
        for (t, k) in [(5.0, 1.0), (7.0, -0.5), (-3.0, 2.0), (0.0, 1.0)] {
            let center = offset + t * direction + k * across;
            let radius = f64::abs(k) * length;
            let at = |radius| exact(center, radius, offset, direction);

            let tangent = at(radius);
            assert_eq!(tangent.discriminant(), Ordering::Equal);
            assert_eq!(tangent.discriminant_margin(), 0.0);
            assert_eq!(rounded(&tangent), [Some(t); 2]);
            assert!(nearer(&tangent) == t && !nearer(&tangent).front_face());

            let wider = at(radius.next_up());
            assert_eq!(wider.discriminant(), Ordering::Greater);
            assert!(nearer(&wider) < t && wider.farther_root().unwrap() > t);
            assert!(nearer(&wider).front_face());
            assert!(!wider.farther_root().unwrap().front_face());

            let narrower = at(radius.next_down());
            assert_eq!(narrower.discriminant(), Ordering::Less);
            assert_eq!(rounded(&narrower), [None; 2]);
        }
    }
}

#[test]
fn the_side_of_the_origin_is_exact() {
    for radius in [1e-300, 0.1, 5.0, 1e300] {
        let side = |radius| on_axis(radius, radius, 0.0, 1.0).origin_side();
        assert_eq!(side(radius), Ordering::Equal);
        let side = |other| on_axis(radius, other, 0.0, 1.0).origin_side();
        assert_eq!(side(radius.next_up()), Ordering::Less);
        assert_eq!(side(radius.next_down()), Ordering::Greater);
    }
}

#[test]
fn a_root_half_way_between_two_numbers_rounds_to_the_even_one() {
    // 2^53 + 1 has 54 digits: no f64 has it, but the difference of two does.
    let big = 2_f64.powi(53);
    let [one, next, next_but_one] = [1.0, 1_f64.next_up(), 1_f64.next_up().next_up()];
    for scale in [1.0, 3.0] {
        let root = |odd: f64, radius, aside| {
            let center = Vec3::new(scale * big, aside, 0.0);
            rounded(&exact(center, radius, -scale * odd * X, scale * big * X))
        };
        assert_eq!(root(1.0, 0.0, 0.0), [Some(one); 2]);
        assert_eq!(root(3.0, 0.0, 0.0), [Some(next_but_one); 2]);
        // However little beside the tie, it is not a tie: by the square root of
        // 1 and of 3 least numbers, of which one is rational and one is not.
        for (radius, aside) in [(5e-324, 0.0), (1e-323, 5e-324)] {
            assert_eq!(root(1.0, radius, aside), [Some(one), Some(next)]);
            assert_eq!(root(3.0, radius, aside), [Some(next), Some(next_but_one)]);
        }
    }
    // Beside the tie by what the square root of 1 − 10^-400 lacks.
    let root = |aside| {
        nearer(&exact(
            Vec3::new(big + 2.0, aside, 0.0),
            1.0,
            Point3::ZERO,
            big * X,
        ))
        .rounded()
    };
    assert_eq!(root(0.0), one);
    assert_eq!(root(1e-200), next);
}

#[test]
fn a_root_rounds_as_ieee_says_at_either_end_of_the_range() {
    let least = 5e-324;
    let root =
        |center, origin, direction| nearer(&on_axis(center, 0.0, origin, direction)).rounded();
    assert_eq!(root(least, 0.0, 2.0), 0.0);
    assert_eq!(root(least, 0.0, 2_f64.next_down()), least);
    assert_eq!(root(3.0 * least, 0.0, 2.0), 2.0 * least);
    assert_eq!(
        root(f64::MIN_POSITIVE, 0.0, 1_f64.next_up()),
        f64::MIN_POSITIVE.next_down()
    );
    assert!(root(-least, 0.0, 1e300).is_sign_negative());
    assert!(root(0.0, 0.0, -1.0).is_sign_positive());

    // Half a unit of the last place above the largest number is the border.
    let half = 2_f64.powi(970);
    assert_eq!(root(f64::MAX, -half.next_down(), 1.0), f64::MAX);
    assert_eq!(root(f64::MAX, -half, 1.0), f64::INFINITY);
    assert_eq!(root(f64::MAX, half, -1.0), -f64::MAX + 2.0 * half);
    assert_eq!(root(f64::MAX, -half, -1.0), f64::NEG_INFINITY);
    assert_eq!(root(f64::MAX, 0.0, -least), f64::NEG_INFINITY);
}

#[test]
fn both_ends_of_the_interval_are_left_out() {
    let exact = on_axis(1.0, 0.5, 0.0, 1.0);
    let root = |t_min, t_max| {
        exact
            .nearest_root_in(t_min, t_max)
            .map(|root| root.rounded())
    };
    assert_eq!(root(0.0, 0.5), None);
    assert_eq!(root(0.0, 0.5_f64.next_up()), Some(0.5));
    assert_eq!(root(0.5_f64.next_down(), 9.0), Some(0.5));
    assert_eq!(root(0.5, 9.0), Some(1.5));
    assert_eq!(root(0.5, 1.5), None);
    assert_eq!(root(1.5_f64.next_down(), 1.5_f64.next_up()), Some(1.5));
    assert_eq!(root(1.5, 9.0), None);
    assert_eq!(root(f64::NEG_INFINITY, f64::INFINITY), Some(0.5));
    assert_eq!(root(f64::INFINITY, f64::INFINITY), None);
    assert_eq!(root(9.0, 0.0), None);
    assert_eq!(root(f64::NAN, 9.0), None);
    assert_eq!(root(0.0, f64::NAN), None);
}

#[test]
fn the_root_must_lie_in_the_interval_and_not_what_it_rounds_to() {
    // 1/3 rounds down and 5/3 rounds up.
    let [third, five_thirds] = [1.0 / 3.0, 5.0 / 3.0];
    let exact = on_axis(3.0, 2.0, 0.0, 3.0);
    let root = |t_min, t_max| {
        exact
            .nearest_root_in(t_min, t_max)
            .map(|root| root.rounded())
    };
    assert_eq!(rounded(&exact), [Some(third), Some(five_thirds)]);
    assert_eq!(root(third, 9.0), Some(third));
    assert_eq!(root(0.0, third), None);
    assert_eq!(root(1.0, five_thirds), Some(five_thirds));
    assert_eq!(root(five_thirds, 9.0), None);
    assert!(nearer(&exact) > third && nearer(&exact) < third.next_up());
}

#[test]
fn what_is_not_a_number_and_what_is_no_line_has_no_root() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..10 {
            let mut numbers = [1.0; 10];
            numbers[place] = bad;
            assert!(Exact::of_finite(&Case::from_numbers(numbers)).is_none());
        }
    }
    for radius in [0.5, 1.0, 2.0] {
        let still = on_axis(1.0, radius, 0.0, 0.0);
        assert_eq!(rounded(&still), [None; 2]);
        assert_eq!(still.discriminant(), Ordering::Equal);
        assert_eq!(still.discriminant_margin(), 0.0);
    }
    let nothing = on_axis(0.0, 0.0, 0.0, 1.0);
    assert_eq!(rounded(&nothing), [Some(0.0); 2]);
    assert_eq!(nothing.origin_margin(), 0.0);
}

#[test]
fn only_the_square_of_the_radius_counts() {
    assert_eq!(
        rounded(&on_axis(3.0, -1.0, 0.0, 1.0)),
        [Some(2.0), Some(4.0)]
    );
    assert_eq!(rounded(&on_axis(3.0, 0.0, 0.0, 1.0)), [Some(3.0); 2]);
}

#[test]
fn margins_are_quotients_rounded_to_nearest() {
    let margins = |center, radius| {
        let exact = exact(center, radius, Point3::ZERO, 3.0 * X);
        (exact.discriminant_margin(), exact.origin_margin())
    };
    // D / a = x² − oc·oc + r².
    assert_eq!(
        margins(Vec3::new(1.0, 1.0, 1.0), 2.0),
        (2.0 / 7.0, -1.0 / 7.0)
    );
    assert_eq!(
        margins(Vec3::new(1.0, 2.0, 2.0), 1.0),
        (-7.0 / 10.0, 8.0 / 10.0)
    );
    assert_eq!(margins(Point3::ZERO, 7.0), (1.0, -1.0));
    assert_eq!(margins(Vec3::Y, 0.0), (-1.0, 1.0));
    // 1/(2·10^600) is no f64.
    let huge = on_axis(1e300, 1e300, 5e-324, 1.0);
    assert_eq!(huge.origin_margin(), 0.0);
    assert_eq!(huge.origin_side(), Ordering::Less);
}

#[test]
fn errors_are_measured_in_the_last_place_of_the_root() {
    let third = on_axis(2.0, 1.0, 0.0, 3.0);
    let error = |t| nearer(&third).error_in_ulps(t);
    // 1/3 is 1/3 of a unit above the number below it, 0.0101…01 in binary.
    let t = 1.0 / 3.0;
    assert_near(error(t), 1.0 / 3.0);
    assert_near(error(t.next_up()), 2.0 / 3.0);
    assert_near(error(t.next_down()), 4.0 / 3.0);
    assert_near(error(0.0), 2_f64.powi(54) / 3.0);
    assert_near(error(-t), 2_f64.powi(55) / 3.0);
    assert_near(error(5e-324), 2_f64.powi(54) / 3.0);
    assert_near(error(1e200), 2_f64.powi(54) * 1e200);
    for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(error(t), f64::INFINITY);
    }
    // The root 1 + 2^-59 is 2^-7 units above 1, and so on.
    for k in [0, 7, 40, 60, 900] {
        let root = on_axis(2_f64.powi(52 + k), 0.0, -1.0, 2_f64.powi(52 + k));
        assert_eq!(nearer(&root).error_in_ulps(1.0), 2_f64.powi(-k));
        let below = on_axis(-2_f64.powi(52 + k), 0.0, -1.0, 2_f64.powi(52 + k));
        assert_eq!(
            nearer(&below).error_in_ulps(-1.0),
            2_f64.powi(1 - k).max(2.0 * 2_f64.powi(-k))
        );
    }
    // The exact root has no error, and the unit is never below the least f64.
    assert_eq!(nearer(&on_axis(1.0, 0.5, 0.0, 1.0)).error_in_ulps(0.5), 0.0);
    let zero = on_axis(1.0, 1.0, 0.0, 1.0);
    assert_eq!(nearer(&zero).error_in_ulps(0.0), 0.0);
    assert_eq!(nearer(&zero).error_in_ulps(-1.5e-323), 3.0);
    assert_eq!(
        nearer(&on_axis(5e-324, 0.0, 0.0, 4.0)).error_in_ulps(0.0),
        0.25
    );
    // 2·MAX is 2^54 − 2 units of the last place that a larger f64 would have.
    let beyond = on_axis(f64::MAX, 0.0, -f64::MAX, 1.0);
    assert_near(nearer(&beyond).error_in_ulps(f64::MAX), 2_f64.powi(52));
}

fn assert_near(error: f64, expected: f64) {
    assert!(
        (error - expected).abs() <= 1e-4 * expected,
        "{error} ulp instead of {expected}"
    );
}

#[test]
fn another_library_finds_the_same_roots() {
    let mut seen = 0;
    for line in include_str!("oracle_vectors.txt").lines() {
        if line.starts_with('#') {
            continue;
        }
        let words: Vec<&str> = line.split(' ').collect();
        let numbers: Vec<f64> = words.iter().flat_map(|word| word.parse()).collect();
        let Some((&numbers, roots)) = numbers.split_first_chunk() else {
            panic!("too few numbers: {line}");
        };
        let exact = Exact::of(&Case::from_numbers(numbers));
        let found: Vec<f64> = rounded(&exact).into_iter().flatten().collect();
        let bits = |roots: &[f64]| roots.iter().map(|t| t.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&found), bits(roots), "{line}");
        seen += 1;
    }
    assert_eq!(seen, 71);
}
