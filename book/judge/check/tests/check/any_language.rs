//! Functions in any language: the parsing of their lines, and manners that are no mistakes.

use check::any_language::{FunctionKind, FunctionVerdict, Manner, NoAnswer, try_laws};
use common::rtweekend::*;
use laws::{Case, Complaint, IntervalCase, Trial};

type Solve = fn(&IntervalCase) -> Option<f64>;

fn verdict(function: FunctionKind, solve: Solve) -> FunctionVerdict {
    let answer = |asked: &IntervalCase| match (solve(asked), function) {
        (None, _) => "miss".to_owned(),
        (Some(_), FunctionKind::Decision) => "hit".to_owned(),
        (Some(t), _) => format!("{t:?}"),
    };
    try_laws(&Trial::default(), function, &|asked| {
        let hit = function.parse_answer(asked, &answer(asked), false);
        hit.expect("it is an answer")
    })
}

/// Solves the quadratic as the book does, if `meets` holds for the discriminant.
fn roots(case: &Case, meets: fn(&f64) -> bool) -> Option<[f64; 2]> {
    let (a, h) = (case.a(), case.h());
    let c = (case.center - case.ray.origin).length_squared() - case.radius * case.radius;
    let sqrtd = Some(h * h - a * c).filter(meets)?.sqrt();
    Some([(h - sqrtd) / a, (h + sqrtd) / a])
}

fn version_4(asked: &IntervalCase) -> Option<f64> {
    let IntervalCase { case, t_min, t_max } = *asked;
    let roots = roots(&case, |d| *d >= 0.0)?;
    roots.into_iter().find(|&root| t_min < root && root < t_max)
}

fn version_3(asked: &IntervalCase) -> Option<f64> {
    let IntervalCase { case, t_min, t_max } = *asked;
    let roots = roots(&case, |d| *d >= 0.0)?;
    roots
        .into_iter()
        .find(|&root| !(root < t_min || t_max < root))
}

fn version_1(asked: &IntervalCase) -> Option<f64> {
    Some(roots(&asked.case, |d| *d > 0.0)?[0])
}

fn in_front(asked: &IntervalCase) -> Option<f64> {
    let roots = roots(&asked.case, |d| *d >= 0.0)?;
    roots.into_iter().find(|&t| t >= 0.0)
}

fn in_front_from_outside(asked: &IntervalCase) -> Option<f64> {
    version_4(asked).filter(|&t| t >= 0.0)
}

#[test]
fn a_function_of_another_edition_is_right_but_for_its_manner() {
    let table: [(FunctionKind, Solve, &[Manner]); 9] = [
        (FunctionKind::Decision, version_4, &[]),
        (FunctionKind::Root, version_4, &[]),
        (FunctionKind::Record, version_4, &[]),
        (FunctionKind::Record, version_3, &[Manner::EndsCount]),
        (FunctionKind::Root, version_1, &[Manner::TangentsMiss]),
        (FunctionKind::Decision, version_1, &[Manner::TangentsMiss]),
        (FunctionKind::Root, in_front, &[Manner::NothingBehind]),
        (FunctionKind::Decision, in_front, &[Manner::NothingBehind]),
        (
            FunctionKind::Root,
            in_front_from_outside,
            &[Manner::NothingBehind],
        ),
    ];
    for (at, (function, solve, manners)) in table.into_iter().enumerate() {
        let FunctionVerdict {
            outcome,
            manners: found,
            ..
        } = verdict(function, solve);
        laws::holds(outcome);
        assert_eq!(found, manners, "row {at}");
    }
}

#[test]
fn a_mistake_is_no_manner() {
    let mistakes: [(FunctionKind, Solve); 5] = [
        // `t or "miss"` in Python.
        (FunctionKind::Root, |asked| {
            version_4(asked).filter(|&t| t != 0.0)
        }),
        // A manner does not hide the mistake behind it.
        (FunctionKind::Root, |asked| {
            in_front(asked).map(|t| 1.001 * t)
        }),
        (FunctionKind::Record, |asked| {
            version_3(asked).map(|t| t + 0.001)
        }),
        (FunctionKind::Record, in_front),
        (FunctionKind::Record, |asked| {
            version_4(&IntervalCase {
                t_min: 0.001,
                ..*asked
            })
        }),
    ];
    let laws = mistakes.map(|(function, solve)| match verdict(function, solve).outcome {
        Err(Complaint::Broken(report)) => report.broken.law.into_owned(),
        outcome => format!("{outcome:?}"),
    });
    let the_range = "a hit lies inside the open interval (t_min, t_max)";
    assert_eq!(
        laws,
        [
            "the line hits the sphere exactly when the discriminant is not negative",
            "the point at t lies on the sphere",
            "the point at t lies on the sphere",
            the_range,
            "the nearest root in the open interval (t_min, t_max) is returned",
        ]
    );
}

#[test]
fn the_books_word_for_a_miss_is_one_unless_it_is_the_root() {
    let said = |z, function: FunctionKind| {
        let ray = Ray::new(Vec3::ZERO, Vec3::NEG_Z);
        let case = Case::new(Vec3::new(0.0, 0.0, z), 1.0, ray);
        let hit = function.parse_answer(&IntervalCase::unbounded(case), "-1", true);
        hit.map(|hit| hit.map(|hit| hit.t))
    };
    assert_eq!(said(0.0, FunctionKind::Root), Ok(Some(-1.0)));
    assert_eq!(said(-3.0, FunctionKind::Root), Ok(None));
    assert_eq!(said(-3.0, FunctionKind::Record), Ok(Some(-1.0)));
}

#[test]
fn a_decimal_comma_is_told_from_other_nonsense() {
    let ray = Ray::new(Vec3::ZERO, Vec3::NEG_Z);
    let asked = IntervalCase::unbounded(Case::new(Vec3::ZERO, 1.0, ray));
    let why = |line| FunctionKind::Root.parse_answer(&asked, line, false).err();
    assert_eq!(why("0,5"), Some(NoAnswer::DecimalComma));
    assert_eq!(why("None"), Some(NoAnswer::Other));
    assert_eq!(why("0.5"), None);
}
