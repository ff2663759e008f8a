//! The witnesses of chapter 6: for each error bound, the case that comes closest to it of
//! all that a search has found. A bound that is made smaller than its witness allows
//! gives a wrong answer here. Bounds of size need no search: what lies on either side of
//! them is asked.

use common::rtweekend::*;
use figures::records::Tightness;
use figures::table::Table;
use laws::{Case, WithInterval};
use speed_vs_accuracy::{Stage, certified_hit, certified_t, exact, stage_of_hit};

use crate::methods::is_certified;

#[test]
fn the_certified_methods_answer_each_of_them_rightly() {
    let recorded = include_str!("../../../book/notes/measured/tightness.csv");
    let recorded = Table::<Tightness>::read(recorded).expect("the file is well-formed");
    let mut wrong = String::new();
    for row in &recorded.rows {
        let asked = asked(row);
        if let Err(failure) = is_certified(&asked) {
            wrong += &format!("{}:\n{failure}\n{asked}\n\n", row.bound);
        }
    }
    assert!(wrong.is_empty(), "bounds that are too small\n\n{wrong}");
}

fn asked(row: &Tightness) -> WithInterval {
    let numbers = row.witness.split(' ').map(|number| number.parse());
    let numbers: Result<Vec<f64>, _> = numbers.collect();
    let numbers = numbers.ok().and_then(|numbers| numbers.try_into().ok());
    WithInterval {
        case: Case::from_numbers(numbers.expect("ten numbers")),
        t_min: row.t_min,
        t_max: row.t_max,
    }
}

/// A tiny sphere, straight ahead and far away. If lengths had 126 digits, three squares
/// would have 256, of which one is the sign.
#[test]
fn lengths_fit_into_a_fixed_width_up_to_a_factor_of_2_to_67() {
    for exponent in 50..=110 {
        let far = Point3::splat((2.0 - f64::EPSILON) * f64::exp2(f64::from(exponent)));
        let case = Case {
            center: far,
            radius: 1.0,
            ray: Ray::new(-far, Vec3::ONE),
        };
        let fits = exponent <= 67;
        assert_eq!(
            stage_that_answers(case, 0.0),
            fixed_width_if(fits),
            "{case}"
        );
    }
}

/// The least root there is in integers of 120 digits, and ends of the range next to it.
/// If lengths and direction could be 2⁸⁰⁰ apart, the lower half of the root would be lost.
#[test]
fn units_of_length_and_direction_fit_up_to_2_to_700() {
    for unit in -1050..=1050 {
        let length = f64::exp2(f64::from(unit / 2));
        let direction = f64::exp2(f64::from(unit / 2 - unit));
        let (most, least) = (f64::exp2(119.0), f64::exp2(52.0));
        let case = Case {
            center: length * Point3::new(most, least, 0.0),
            radius: length * most,
            ray: Ray::new(
                length * Point3::new(0.0, least + 1.0, 0.0),
                direction * Vec3::new(1.1 * most, least, 0.0),
            ),
        };
        let root = exact(case.center, case.radius, &case.ray, 0.0, f64::INFINITY);
        let root = root.expect("the ray goes by less than a radius from the center");
        let fits = i32::abs(unit) <= 700;
        for t_min in [root.next_down(), root, root.next_up()] {
            let stage = stage_that_answers(case, t_min);
            assert_eq!(stage, fixed_width_if(fits), "{case}, t_min = {t_min:?}");
        }
    }
}

/// Both methods must say what the integers say.
fn stage_that_answers(case: Case, t_min: f64) -> Stage {
    let Case {
        center,
        radius,
        ray,
    } = case;
    let t = exact(center, radius, &ray, t_min, f64::INFINITY);
    for method in [certified_hit, certified_t] {
        let found = method(center, radius, &ray, t_min, f64::INFINITY);
        assert_eq!(found, t, "{case}, t_min = {t_min:?}");
    }
    stage_of_hit(center, radius, &ray, t_min, f64::INFINITY)
}

fn fixed_width_if(fits: bool) -> Stage {
    if fits {
        Stage::FixedWidth
    } else {
        Stage::Exact
    }
}
