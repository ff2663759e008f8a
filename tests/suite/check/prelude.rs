//! Each function of a reader's own prelude is asked, and the first that is wrong is told.

use common::rtweekend::*;
use laws::Trial;
use laws::prelude::Prelude;
use laws::trial::Outcome;

#[test]
fn each_function_that_is_wrong_is_told() {
    let turned = |v: Vec3| Vec3::new(v.x, v.y, -v.z);
    let mul = |t, v| turned(t * v);
    let add = |u: Vec3, v: Vec3| u + turned(v);
    let neg = |v: Vec3| -turned(v);
    let sub = |u: Vec3, v: Vec3| v - u;
    let dot = |u: Vec3, v| u.dot(turned(v));
    let length_squared = |v: Vec3| v.length();
    let length = |v: Vec3| v.length_squared();
    let normalize = |v: Vec3| v;
    let ray = |origin, direction| Ray::new(direction, origin);
    let at = |ray: Ray, t| t * ray.direction;
    let wrong = [
        ("mul", Prelude { mul: &mul, ..RIGHT }),
        ("add", Prelude { add: &add, ..RIGHT }),
        ("neg", Prelude { neg: &neg, ..RIGHT }),
        ("sub", Prelude { sub: &sub, ..RIGHT }),
        ("dot", Prelude { dot: &dot, ..RIGHT }),
        (
            "length_squared",
            Prelude {
                length_squared: &length_squared,
                ..RIGHT
            },
        ),
        (
            "length",
            Prelude {
                length: &length,
                ..RIGHT
            },
        ),
        (
            "normalize",
            Prelude {
                normalize: &normalize,
                ..RIGHT
            },
        ),
        ("ray", Prelude { ray: &ray, ..RIGHT }),
        ("at", Prelude { at: &at, ..RIGHT }),
    ];
    assert!(ask(&RIGHT).is_ok());
    for (function, prelude) in wrong {
        assert_told(function, ask(&prelude));
    }
}

#[test]
fn what_stands_on_a_wrong_function_is_not_blamed() {
    let dot = |u: Vec3, v: Vec3| u.x * v.x + u.y * v.y + u.z * u.z;
    let without_z = |v: Vec3| v.x * v.x + v.y * v.y;
    let prelude = Prelude {
        dot: &dot,
        length_squared: &without_z,
        ..RIGHT
    };
    assert_told("dot", ask(&prelude));
}

#[test]
fn what_is_not_written_yet_is_not_asked() {
    let unwritten = Prelude {
        neg: &|_| panic!("not yet implemented"),
        ..RIGHT
    };
    assert!(ask(&unwritten).is_ok());
    let wrong = Prelude {
        at: &|ray, _| ray.origin,
        ..unwritten
    };
    assert_told("at", ask(&wrong));
}

fn ask(prelude: &Prelude) -> Outcome {
    Trial::default().prelude(&|asked| asked.put_to(prelude))
}

fn assert_told(function: &str, outcome: Outcome) {
    let report = outcome.expect_err("a law is broken");
    let asked = format!("(prelude().{function})(");
    assert!(report.test.contains(&asked), "{function}:\n{report}");
}

const RIGHT: Prelude = Prelude {
    mul: &|t, v| t * v,
    add: &|u, v| u + v,
    neg: &|v| -v,
    sub: &|u, v| u - v,
    dot: &|u, v| u.dot(v),
    length_squared: &|v| v.length_squared(),
    length: &|v| v.length(),
    normalize: &|v| v.normalize(),
    ray: &|origin, direction| Ray::new(origin, direction),
    at: &|ray, t| ray.at(t),
};
