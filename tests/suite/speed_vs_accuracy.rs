//! What chapter 6 is measured with: the questions, the batches, the maps, and the
//! file of timings.

use figures::records::Timing;
use figures::table::Table;
use laws::oracle::Exact;
use speed_vs_accuracy::batch::{self, BLOCK, Block};
use speed_vs_accuracy::{
    Case, METHODS, Precision, REGIMES, Regime, SCENES, failure_map, find, find_regime, half_b,
    half_b_f32,
};

mod questions {
    use super::*;

    /// Numbers made by addition, division and roots are the same everywhere; so
    /// is this sum of their bits.
    #[test]
    fn are_the_same_on_every_machine() {
        let sums = REGIMES.map(|regime| {
            let questions = regime.questions(Precision::Double, 1, 100);
            let bits = questions.iter().flat_map(numbers).map(f64::to_bits);
            (regime.name, bits.fold(0, u64::wrapping_add) % 1_000_000)
        });
        insta::assert_debug_snapshot!(sums);
    }

    #[test]
    fn for_single_precision_are_made_of_its_numbers() {
        for regime in REGIMES {
            for question in regime.questions(Precision::Single, 3, 200) {
                assert_eq!(question, question.rounded(Precision::Single));
                assert!(numbers(&question).iter().all(|number| number.is_finite()));
            }
        }
    }

    #[test]
    fn of_a_level_are_as_near_a_tangent_as_it_says() {
        let grazing = find_regime("grazing").expect("it is a regime");
        for level in [3, 6, 9, 12] {
            let expected = 0.1 * f64::powi(10.0, -level);
            for question in grazing.questions_at(level, Precision::Double, 1, 50) {
                let margin = exact(&question).discriminant_margin().abs();
                assert!(
                    (expected..5.0 * expected).contains(&margin),
                    "{margin} at {level}"
                );
            }
        }
    }

    #[test]
    fn of_other_seeds_are_others() {
        for regime in REGIMES {
            let [one, other] = [1, 2].map(|seed| regime.questions(Precision::Double, seed, 9));
            assert_ne!(one, other);
        }
    }
}

mod a_batch {
    use super::*;

    /// One begins behind the ray, and two between the roots of many.
    const RANGES: [[f64; 2]; 4] = [[0.0, f64::INFINITY], [-1.0, 2.0], [1e-3, 1.5], [1.0, 4.0]];

    /// Blocks that the sign tells all of, and blocks that must be done again.
    #[test]
    fn of_rays_answers_as_the_method_does_one_by_one_to_the_bit() {
        for (range, regime) in everywhere() {
            let questions = regime.questions(Precision::Double, 5, 2 * BLOCK);
            let rays = [0, BLOCK]
                .map(|first| Block::from_fn(|k| batch::numbers(&questions[first + k].ray)));
            for &Case { center, radius, .. } in questions.iter().step_by(16) {
                let mut ts = [[0.0; BLOCK]; 2];
                batch::half_b((center, radius), &rays, range, &mut ts);
                for (t, question) in ts.as_flattened().iter().zip(&questions) {
                    let alone = half_b(center, radius, &question.ray, range[0], range[1]);
                    let expected = alone.unwrap_or(f64::INFINITY);
                    assert_eq!(t.to_bits(), expected.to_bits(), "{question:?}");
                }
            }
        }
    }

    #[test]
    fn of_rays_in_single_precision_does_so_too() {
        for (range, regime) in everywhere() {
            let range = range.map(|end| end as f32);
            let questions = regime.questions(Precision::Single, 6, BLOCK);
            let numbers = |k: usize| batch::numbers(&questions[k].ray).map(|number| number as f32);
            let rays = [Block::from_fn(numbers)];
            for question in questions.iter().step_by(8) {
                let (center, radius) = (question.center.as_vec3(), question.radius as f32);
                let mut ts = [[0.0; BLOCK]];
                batch::half_b_f32((center, radius), &rays, range, &mut ts);
                for (t, question) in ts[0].iter().zip(&questions) {
                    let ray = question.single_ray();
                    let alone = half_b_f32(center, radius, &ray, range[0], range[1]);
                    let expected = alone.unwrap_or(f32::INFINITY);
                    assert_eq!(t.to_bits(), expected.to_bits(), "{question:?}");
                }
            }
        }
    }

    #[test]
    fn of_spheres_finds_the_nearest_root_of_all_to_the_bit() {
        for (range, regime) in everywhere() {
            let questions = regime.questions(Precision::Double, 7, 2 * BLOCK);
            let sphere = |question: &Case| {
                let [x, y, z] = question.center.to_array();
                [x, y, z, question.radius]
            };
            let spheres = [0, BLOCK].map(|first| Block::from_fn(|k| sphere(&questions[first + k])));
            for Case { ray, .. } in questions.iter().step_by(8) {
                let root = |question: &Case| {
                    half_b(question.center, question.radius, ray, range[0], range[1])
                };
                let roots = questions.iter().filter_map(root);
                let expected = roots.fold(f64::INFINITY, f64::min);
                let found = batch::nearest(&spheres, ray, range);
                assert_eq!(found.to_bits(), expected.to_bits());
            }
        }
    }

    fn everywhere() -> impl Iterator<Item = ([f64; 2], Regime)> {
        let in_all_regimes = |range| REGIMES.map(|regime| (range, regime));
        RANGES.into_iter().flat_map(in_all_regimes)
    }
}

mod a_map_of_neighboring_rays {
    use super::*;

    #[test]
    fn shows_wrong_decisions_of_half_b_and_none_of_the_certified() {
        let wrong = |name| {
            let method = find(name).expect("it is a method");
            let map = failure_map(&method, 32);
            map.wrong.iter().filter(|wrong| **wrong).count()
        };
        for name in ["certified_hit", "certified_t", "exact"] {
            assert_eq!(wrong(name), 0, "{name}");
        }
        for name in ["full_b", "half_b", "half_b_q", "half_b_f32"] {
            assert!(wrong(name) > 30, "{name}: {} of 1024", wrong(name));
        }
    }

    #[test]
    fn has_hits_above_the_tangent_and_misses_below_it() {
        let method = find("exact").expect("it is a method");
        let map = failure_map(&method, 16);
        let hit = |column: usize, row: usize| map.hits[row * 16 + column];
        assert!(hit(0, 0), "the upper left");
        assert!(!hit(15, 15), "the lower right");
        assert!(hit(8, 8), "the tangent itself is a hit");
        assert!(hit(8, 7) && !hit(8, 9), "its neighbors above and below");
    }
}

mod a_scene {
    use super::*;

    #[test]
    fn is_drawn_rightly_by_the_certified_methods() {
        for scene in SCENES {
            let right = scene.right_picture(Precision::Double, 48);
            for name in ["certified_hit", "certified_t"] {
                let method = find(name).expect("it is a method");
                let name = scene.name;
                assert!(scene.picture(method, 48).rgb() == right.rgb(), "{name}");
            }
        }
    }

    #[test]
    fn of_the_book_is_the_picture_of_chapter_5() {
        let half_b = find("half_b").expect("it is a method");
        let [book, ..] = SCENES;
        assert_eq!(book.picture(half_b, 100), hittable_list::picture(100));
    }
}

mod timings {
    use super::*;

    const RECORDED: &str = include_str!("../../book/notes/measured/timings.csv");

    #[test]
    fn are_recorded_as_they_are_written() {
        assert_eq!(recorded().text(), RECORDED);
    }

    #[test]
    fn are_recorded_of_every_method_in_every_regime() {
        let timings = recorded();
        for method in METHODS {
            for place in REGIMES
                .map(|regime| regime.name)
                .into_iter()
                .chain(["all_hits"])
            {
                assert!(
                    timings.find("method", method.name, place).is_some(),
                    "{} in {place} is missing: cargo bench -p measure --bench clock -- --record",
                    method.name
                );
            }
        }
    }

    fn recorded() -> Table<Timing> {
        Table::read(RECORDED).expect("the file is well-formed")
    }
}

fn numbers(question: &Case) -> [f64; 10] {
    let Case {
        center,
        radius,
        ray,
    } = *question;
    let ([cx, cy, cz], [ox, oy, oz]) = (center.to_array(), ray.origin.to_array());
    let [dx, dy, dz] = ray.direction.to_array();
    [cx, cy, cz, radius, ox, oy, oz, dx, dy, dz]
}

fn exact(question: &Case) -> Exact {
    Exact::new(question.center, question.radius, &question.ray).expect("finite numbers")
}
