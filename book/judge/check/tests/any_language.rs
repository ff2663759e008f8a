//! A function in any language: how its lines are read, and what is a manner and no mistake.

use check::any_language::{Function, Manner, NoAnswer, Told, tried};
use common::rtweekend::*;
use laws::{Case, Complaint, Trial, WithInterval};

type Solve = fn(&WithInterval) -> Option<f64>;

fn told(function: Function, solve: Solve) -> Told {
    let answer = |asked: &WithInterval| match (solve(asked), function) {
        (None, _) => "miss".to_owned(),
        (Some(_), Function::Decision) => "hit".to_owned(),
        (Some(t), _) => format!("{t:?}"),
    };
    tried(&Trial::default(), function, &|asked| {
        let hit = function.read(asked, &answer(asked), false);
        hit.expect("it is an answer")
    })
}

/// The roots of the book, if the discriminant is as it should be.
fn roots(case: &Case, meets: fn(&f64) -> bool) -> Option<[f64; 2]> {
    let sqrtd = Some(case.discriminant()).filter(meets)?.sqrt();
    Some([(case.h() - sqrtd) / case.a(), (case.h() + sqrtd) / case.a()])
}

fn version_4(asked: &WithInterval) -> Option<f64> {
    let WithInterval { case, t_min, t_max } = *asked;
    let roots = roots(&case, |d| *d >= 0.0)?;
    roots.into_iter().find(|&root| t_min < root && root < t_max)
}

fn version_3(asked: &WithInterval) -> Option<f64> {
    let WithInterval { case, t_min, t_max } = *asked;
    let roots = roots(&case, |d| *d >= 0.0)?;
    roots
        .into_iter()
        .find(|&root| !(root < t_min || t_max < root))
}

fn version_1(asked: &WithInterval) -> Option<f64> {
    Some(roots(&asked.case, |d| *d > 0.0)?[0])
}

fn in_front(asked: &WithInterval) -> Option<f64> {
    let roots = roots(&asked.case, |d| *d >= 0.0)?;
    roots.into_iter().find(|&t| t >= 0.0)
}

fn in_front_from_outside(asked: &WithInterval) -> Option<f64> {
    version_4(asked).filter(|&t| t >= 0.0)
}

#[test]
fn a_function_of_another_edition_is_right_but_for_its_manner() {
    let table: [(Function, Solve, &[Manner]); 9] = [
        (Function::Decision, version_4, &[]),
        (Function::Root, version_4, &[]),
        (Function::Record, version_4, &[]),
        (Function::Record, version_3, &[Manner::EndsCount]),
        (Function::Root, version_1, &[Manner::TangentsMiss]),
        (Function::Decision, version_1, &[Manner::TangentsMiss]),
        (Function::Root, in_front, &[Manner::NothingBehind]),
        (Function::Decision, in_front, &[Manner::NothingBehind]),
        (
            Function::Root,
            in_front_from_outside,
            &[Manner::NothingBehind],
        ),
    ];
    for (at, (function, solve, manners)) in table.into_iter().enumerate() {
        let Told {
            outcome,
            manners: found,
            ..
        } = told(function, solve);
        laws::holds(outcome);
        assert_eq!(found, manners, "row {at}");
    }
}

#[test]
fn a_mistake_is_no_manner() {
    let mistakes: [(Function, Solve); 5] = [
        // `t or "miss"` in Python.
        (Function::Root, |asked| {
            version_4(asked).filter(|&t| t != 0.0)
        }),
        // A manner does not hide the mistake behind it.
        (Function::Root, |asked| in_front(asked).map(|t| 1.001 * t)),
        (Function::Record, |asked| {
            version_3(asked).map(|t| t + 0.001)
        }),
        (Function::Record, in_front),
        (Function::Record, |asked| {
            version_4(&WithInterval {
                t_min: 0.001,
                ..*asked
            })
        }),
    ];
    let laws = mistakes.map(|(function, solve)| match told(function, solve).outcome {
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
            the_range,
        ]
    );
}

#[test]
fn the_books_word_for_a_miss_is_one_unless_it_is_the_root() {
    let said = |z, function: Function| {
        let ray = Ray::new(Vec3::ZERO, Vec3::NEG_Z);
        let case = Case::new(Vec3::new(0.0, 0.0, z), 1.0, ray);
        let hit = function.read(&WithInterval::on_the_line(case), "-1", true);
        hit.map(|hit| hit.map(|hit| hit.t))
    };
    assert_eq!(said(0.0, Function::Root), Ok(Some(-1.0)));
    assert_eq!(said(-3.0, Function::Root), Ok(None));
    assert_eq!(said(-3.0, Function::Record), Ok(Some(-1.0)));
}

#[test]
fn a_decimal_comma_is_told_from_other_nonsense() {
    let ray = Ray::new(Vec3::ZERO, Vec3::NEG_Z);
    let asked = WithInterval::on_the_line(Case::new(Vec3::ZERO, 1.0, ray));
    let why = |line| Function::Root.read(&asked, line, false).err();
    assert_eq!(why("0,5"), Some(NoAnswer::DecimalComma));
    assert_eq!(why("None"), Some(NoAnswer::Other));
    assert_eq!(why("0.5"), None);
}
