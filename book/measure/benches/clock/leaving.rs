//! Ray-origin offsetting: what each way to leave a surface costs, together with the test of
//! the ray that has left.

use std::hint::black_box;

use common::rtweekend::*;
use measure::contest::{Group, Runner};
use measure::cost::throughput;
use speed_vs_accuracy::{
    Case, Departure, LEAVINGS, Precision, Regime, after_t_min, at_once, half_b, integer_offset,
    optix_offset, pbrt_offset, proven_offset,
};

use crate::one_by_one::{CASES, SEED};

/// All ways to leave, each in the finest precision that it is made for; the first does
/// nothing but the test.
pub(crate) fn group() -> Group {
    let runner = LEAVINGS.iter().map(|leaving| {
        let precision = leaving.precisions[0];
        let cases = Regime::NEAR_SURFACE.cases(precision, SEED, CASES);
        let key = ["leaving", leaving.name, Regime::NEAR_SURFACE.name];
        let run = run(leaving.name, cases, precision);
        Runner::new(key, precision, CASES, CASES, run)
    });
    Group(runner.collect())
}

/// A loop for each, as for the methods: a call by a pointer would be charged for.
fn run(name: &str, cases: Vec<Case>, precision: Precision) -> Box<dyn FnMut()> {
    match name {
        "at_once" => Box::new(departures(cases, precision, at_once)),
        "after_t_min" => Box::new(departures(cases, precision, after_t_min)),
        "integer_offset" => Box::new(departures(cases, precision, integer_offset)),
        "optix_offset" => Box::new(departures(cases, precision, optix_offset)),
        "pbrt_offset" => Box::new(departures(cases, precision, pbrt_offset)),
        "proven_offset" => Box::new(departures(cases, precision, proven_offset)),
        other => panic!("name {other} in the list of loops"),
    }
}

fn departures(
    cases: Vec<Case>,
    precision: Precision,
    leave: impl Fn(Point3, f64, Point3, Vec3, Precision) -> Option<Departure>,
) -> impl FnMut() {
    let precision = black_box(precision);
    throughput(cases.len(), move |n| {
        let Case {
            center,
            radius,
            ray,
        } = cases[n];
        let Departure { ray, t_min } = leave(center, radius, ray.origin, ray.direction, precision)?;
        half_b(center, radius, &ray, t_min, f64::INFINITY)
    })
}
