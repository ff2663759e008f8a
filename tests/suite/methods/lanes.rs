//! In SIMD lanes, a method answers to the bit as it does alone, whatever the other lanes
//! of the block are asked.

use laws::IntervalCase;
use laws::strategies::samples;
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;
use speed_vs_accuracy::{
    BLOCK, Case, Method, certified_in_lanes, compensated, cross_q, half_b, half_b_q, in_lanes,
};

use crate::hostile::hostile;
use crate::question;

#[test]
fn the_certified_methods_answer_in_lanes_as_they_do_alone() {
    let ranges = [
        (0.0, f64::INFINITY),
        (-0.0, 1.0),
        (0.001, 1.0),
        (f64::NEG_INFINITY, -0.0),
        (1.0, 0.0),
        (0.0, f64::NAN),
    ];
    for cases in blocks() {
        for (t_min, t_max) in ranges {
            certified(&cases, t_min, t_max).expect("alike");
        }
    }
}

/// Fails unless the certified methods answer the question in each lane as they do alone.
pub(crate) fn answers_as_alone(asked: &IntervalCase) -> TestCaseResult {
    let IntervalCase { case, t_min, t_max } = *asked;
    certified(&[question(&case); BLOCK], t_min, t_max)
}

fn certified(cases: &[Case; BLOCK], t_min: f64, t_max: f64) -> TestCaseResult {
    let mut answers = [[0.0; BLOCK]; 2];
    certified_in_lanes::<false>(&mut answers[0], |k| cases[k], t_min, t_max);
    certified_in_lanes::<true>(&mut answers[1], |k| cases[k], t_min, t_max);
    for (k, case) in cases.iter().enumerate() {
        let alone = [Method::CERTIFIED_HIT, Method::CERTIFIED_T]
            .map(|method| case.put_to(&method, t_min, t_max));
        let found = answers.map(|row| (row[k] < f64::INFINITY).then_some(row[k]));
        prop_assert_eq!(found, alone, "{}, {} to {}", case, t_min, t_max);
    }
    Ok(())
}

/// Rounding is the same in every version that the compiler makes of the loop.
#[test]
fn the_plain_methods_answer_in_lanes_as_they_do_alone() {
    for cases in blocks() {
        macro_rules! assert_alike {
            ($($solve:ident)*) => {$(
                let answer = |k: usize| {
                    let Case { center, radius, ray } = &cases[k];
                    $solve(*center, *radius, ray, 0.0, f64::INFINITY).unwrap_or(f64::INFINITY)
                };
                let mut answers = [0.0; BLOCK];
                in_lanes(&mut answers, answer);
                assert_eq!(answers, std::array::from_fn(answer));
            )*};
        }
        assert_alike!(half_b half_b_q cross_q compensated);
        let mut answers = [0.0; BLOCK];
        let answer = |k: usize| {
            let found = cases[k].put_to(&Method::HALF_B_F32, 0.0, f64::INFINITY);
            found.unwrap_or(f64::INFINITY)
        };
        in_lanes(&mut answers, answer);
        assert_eq!(answers, std::array::from_fn(answer));
    }
}

fn blocks() -> Vec<[Case; BLOCK]> {
    let cases: Vec<Case> = samples(&hostile(), 6400).iter().map(question).collect();
    cases.as_chunks().0.to_vec()
}
