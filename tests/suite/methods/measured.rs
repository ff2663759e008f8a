//! What chapter 6 measures without a clock: the same numbers on every machine.
//!
//! Some are found again in a moment, and are snapshots. The others are of millions of
//! questions: here a few of them are asked again, which notices that they were asked
//! of other methods than there are now. And what the pages say of these numbers is
//! compared with them.

use figures::records::{Accuracy, Level, Race, Timing, Worst, WrongPixels};
use figures::table::{Record, Table};
use insta::internals::SnapshotContents;
use insta::{Comparator, Snapshot, assert_binary_snapshot};
use measure::spread::Spread;
use measure::{accuracy, scenes, worst};
use speed_vs_accuracy::{Case, METHODS, Precision, REGIMES, Regime, Stage, stage_of_hit};

/// The book shows these files, so they stand where the book finds them.
const MEASURED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes/measured");

/// Pixels in a row: enough to see a difference in every scene that has one.
const WIDTH: u32 = 128;

/// Any seed would do; this one was the first.
const SEED: u64 = 1;

mod the_snapshot_holds {
    use super::*;

    /// Where the times are recorded anew, this follows.
    #[test]
    fn scenes_and_least() {
        let table = scenes::table(WIDTH);
        let timings = include_str!("../../../book/notes/measured/timings.csv");
        let timings = Table::<Timing>::read(timings).expect("the file is well-formed");
        assert_measured("least", &scenes::least(&table, &timings));
        assert_measured("scenes", &table);
    }

    #[test]
    fn worst() {
        assert_measured("worst", &worst::table());
    }
}

mod a_part_of_the_questions_asked_again {
    use super::*;

    /// How many of a million, or of the pixels of a picture.
    const CASES: usize = 2000;

    #[test]
    fn has_the_answers_and_the_errors_that_were_recorded() {
        let again = accuracy::table(CASES, CASES, SEED).rows;
        let recorded = recorded();
        assert_eq!(recorded.len(), again.len(), "rows of {}", Accuracy::FILE);
        for (old, new) in recorded.iter().zip(&again) {
            let row = format!("{}/{}/{}", old.regime, old.precision.name(), old.method);
            assert_same_answers(&row, [old.answers, new.answers]);
            assert_eq!((&old.regime, &old.method), (&new.regime, &new.method));
            // What misses nearly all that it should hit leaves no median of a part.
            if old.wrong_per_million < 4e5 {
                assert_near(&row, [old.median_ulps, new.median_ulps]);
                assert_near(&row, [old.surface_median_radii, new.surface_median_radii]);
            }
            // A part has no error that all have not. What is written has three digits.
            let [all, part] = [old.largest_ulps, new.largest_ulps];
            assert!(
                part <= all.map(|ulps| 1.01 * ulps),
                "{row}: {part:?} of {all:?}"
            );
            // Three standard deviations, of what is not rarer than one in a thousand.
            let wrong = [old, new].map(|row| row.wrong_per_million / 1e6);
            let allowed = 3.0 * (wrong[0].max(1e-3) / CASES as f64).sqrt();
            assert!((wrong[0] - wrong[1]).abs() < allowed, "{row}: {wrong:?}");
        }
    }

    #[test]
    fn has_them_at_each_distance_and_each_closeness_too() {
        let again = accuracy::sweeps(400, SEED).rows;
        let recorded = levels();
        assert_eq!(recorded.len(), again.len(), "rows of {}", Level::FILE);
        for (old, new) in recorded.iter().zip(&again) {
            let row = format!("{} {} {}", old.regime, old.level, old.method);
            assert_same_answers(&row, [old.answers, new.answers]);
            // Where decisions are made by chance, medians are too.
            if old.wrong_per_million < 1e5 {
                assert_near(&row, [old.median_ulps, new.median_ulps]);
            }
        }
    }

    fn assert_same_answers(row: &str, [recorded, now]: [u64; 2]) {
        assert_eq!(
            recorded, now,
            "{row} answers otherwise than when it was measured. If that was meant:\n\
             cargo bench -p measure --bench accuracy -- --record"
        );
    }

    /// Medians of a part and of all are within a factor of two.
    fn assert_near(row: &str, medians: [Option<f64>; 2]) {
        let [Some(all), Some(part)] = medians else {
            panic!("{row} has no median: {medians:?}");
        };
        assert!(
            (0.5 * all..=2.0 * all).contains(&part),
            "{row}: {part} of {all}"
        );
    }
}

/// What chapter 6 says in words. The numbers beside the words are taken from the files
/// when the book is woven.
mod the_words {
    use super::*;

    /// Every pixel was asked about both spheres, and every other situation a million
    /// times.
    #[test]
    fn all_pixels_and_a_million_are_so_many() {
        for row in recorded() {
            let expected = match &row.regime[..] {
                "book" => 2 * 3840 * 2160,
                "book_ball" | "book_ground" => 3840 * 2160,
                _ => 1_000_000,
            };
            assert_eq!(row.cases, expected, "{}", row.regime);
        }
        assert_eq!(of("book_ball", "exact").hits, 1_221_412);
        assert_eq!(of("book_ground", "exact").hits, 3_606_026);
    }

    #[test]
    fn q_improves_the_bulk_of_the_digits_on_the_ground_but_not_the_worst_pixel() {
        let [plain, q] = ["half_b", "half_b_q"].map(|method| of("book_ground", method));
        assert!(p999(&q) < p999(&plain) / 10.0);
        assert!(q.median_ulps < plain.median_ulps.map(|ulps| ulps / 10.0));
        assert_eq!(q.largest_ulps, plain.largest_ulps);
        let [plain, q] = ["half_b", "half_b_q"].map(|method| of("book_ball", method));
        assert!((0.8..1.25).contains(&(p999(&q) / p999(&plain))));
        assert_eq!(q.largest_ulps, plain.largest_ulps);
    }

    /// 24u·M outgrows r², and 6u·|oc|·r does.
    #[test]
    fn the_distances_at_which_bounds_outgrow_the_radius() {
        let of_half_b = |u: f64| (1.0 / (24.0 * u)).sqrt();
        let of_cross_q = |u: f64| 1.0 / (6.0 * u);
        let double = f64::EPSILON / 2.0;
        let single = f64::from(f32::EPSILON) / 2.0;
        assert_eq!((of_half_b(double) / 1e6).round(), 19.0, "twenty million");
        assert_eq!(
            (of_cross_q(double) / 1e14).round(),
            15.0,
            "more than a quadrillion"
        );
        assert_eq!((of_half_b(single) / 10.0).round(), 84.0);
        assert_eq!((of_cross_q(single) / 1e5).round(), 28.0);
    }

    /// D is off by u·M, which grows with the square of the distance, or by u·|oc|·r.
    #[test]
    fn half_b_errs_a_hundred_times_and_the_cross_product_ten_times_as_often_at_ten_times_the_distance()
     {
        let levels = levels();
        let growth = |method: &str, from: i32| {
            let [near, far] = [from, from + 1].map(|level| {
                let is_wanted = |row: &&Level| {
                    (&*row.regime, &*row.method, row.level) == ("far", method, level)
                };
                levels
                    .iter()
                    .find(is_wanted)
                    .map(|row| row.wrong_per_million)
                    .expect("a row")
            });
            far / near
        };
        assert!((80.0..125.0).contains(&growth("half_b", 6)));
        for method in ["cross_q", "haines"] {
            for level in [13, 14] {
                let growth = growth(method, level);
                assert!(
                    (8.0..14.0).contains(&growth),
                    "{method} at {level}: {growth}"
                );
            }
        }
    }

    #[test]
    fn half_b_loses_a_digit_with_each_factor_of_ten_until_it_guesses() {
        let levels = levels();
        let median = |level: i32| {
            let mut rows = levels.iter();
            let row = rows
                .find(|row| (&*row.regime, &*row.method, row.level) == ("far", "half_b", level));
            row.and_then(|row| row.median_ulps).expect("it hits")
        };
        for level in 1..7 {
            let factor = median(level + 1) / median(level);
            assert!((9.0..11.0).contains(&factor), "{factor} at {level}");
        }
    }

    /// Most questions about far spheres are not settled by the filter.
    #[test]
    fn most_far_questions_are_hard_and_most_of_the_book_easy() {
        let hard = |regime: Regime| {
            let cases = regime.cases(Precision::Double, SEED, 2000);
            crate::stability::share(&cases, |case| {
                let Case {
                    center,
                    radius,
                    ray,
                } = *case;
                stage_of_hit(center, radius, &ray, 0.0, f64::INFINITY) != Stage::Filter
            })
        };
        assert!(hard(Regime::FAR) > 0.5, "{}", hard(Regime::FAR));
        assert!(hard(Regime::BOOK) < 0.01, "{}", hard(Regime::BOOK));
    }

    /// `many.md`: the batch takes three fifths of the time of the `Vec`, and a tree is the
    /// quicker one from four spheres on, or from two beside the boxed list.
    #[test]
    fn many_spheres_take_as_long_as_is_said() {
        let file = include_str!("../../../book/notes/measured/timings.csv");
        let rows = Table::<Timing>::read(file)
            .expect("the file is well-formed")
            .rows;
        let of = |name: &str, n: usize| {
            let mut rows = rows.iter().filter(|row| row.what == "growth");
            let row = rows.find(|row| row.name == name && row.n == n);
            row.map(|row| row.median_ns).expect("it was measured")
        };
        let sizes = (6..=16).map(|k| 1 << k);
        let shares = sizes.map(|n| of("batch", n) / of("vec", n)).collect();
        let share = Spread::of(shares).median;
        assert!((0.25..0.42).contains(&share), "about a third: {share}");
        for list in ["vec", "boxed_list"] {
            assert!(of("bvh", 2) > of(list, 2) && of("bvh", 8) < of(list, 8));
        }
    }

    /// `speed.md`: most of the C++ program's time is printing, and in tracing alone the
    /// two are near to each other.
    #[test]
    fn most_of_the_time_of_the_rival_is_printing() {
        let file = include_str!("../../../book/notes/speed/heats.csv");
        let rows = Table::<Race>::read(file)
            .expect("the file is well-formed")
            .rows;
        let of = |to: &str, chapter: &str| {
            let mut rows = rows
                .iter()
                .filter(|row| (row.width, &*row.to) == (3840, to));
            let row = rows.find(|row| row.chapter == chapter);
            row.cloned().expect("it was measured")
        };
        for chapter in [
            "gradient",
            "red_sphere",
            "normals",
            "half_b_sphere",
            "hittable_list",
        ] {
            let [all, traced] = ["nowhere", "traced"].map(|to| of(to, chapter));
            let printing = 1.0 - traced.cpp_median_ms / all.cpp_median_ms;
            assert!(printing > 0.6, "{chapter}: {printing}");
            assert!(
                (0.5..2.0).contains(&traced.ratio()),
                "{chapter}: {}",
                traced.ratio()
            );
        }
        let [list, ball] = ["hittable_list", "half_b_sphere"].map(|of_it| of("traced", of_it));
        let factor = list.rust_median_ms / ball.rust_median_ms;
        assert!((1.6..2.5).contains(&factor), "about twice: {factor}");
    }

    #[test]
    fn q_is_never_worse_than_half_b_by_more_than_a_little() {
        for regime in REGIMES {
            let [plain, q] = ["half_b", "half_b_q"].map(|method| of(regime.name, method));
            assert!(
                q.wrong_per_million <= 1.01 * plain.wrong_per_million,
                "{}",
                regime.name
            );
            assert!(p999(&q) <= 1.25 * p999(&plain), "{}", regime.name);
        }
    }

    #[test]
    fn q_changes_no_wrong_pixel_of_the_seven_scenes_but_where_spheres_meet() {
        let scenes = include_str!("../../../book/notes/measured/scenes.snap.csv");
        let rows = Table::<WrongPixels>::read(scenes)
            .expect("the file is well-formed")
            .rows;
        let of = |method: &str| -> Vec<(String, usize)> {
            let rows = rows.iter().filter(|row| row.method == method);
            rows.map(|row| (row.scene.clone(), row.wrong)).collect()
        };
        let (plain, q) = (of("half_b"), of("half_b_q"));
        assert_eq!(plain.len(), 7);
        let right = plain.iter().filter(|(_, wrong)| *wrong == 0).count();
        assert_eq!(right, 4, "as many of the seven are right without it");
        assert_eq!(plain[..6], q[..6]);
        assert!(plain[6].0 == "neighbors" && plain[6].1 > q[6].1 && q[6].1 > 0);
        // Other last digits of t move the specks of a shadow, and take none away.
        let in_single = of("half_b_f32").into_iter().zip(of("half_b_q_f32"));
        for ((scene, without), (_, with)) in in_single {
            assert!(with >= without, "{scene}: {with} instead of {without}");
        }
    }

    /// Roots that are rounded once are no better there than roots within an ulp.
    #[test]
    fn no_method_has_digits_enough_where_spheres_meet() {
        let scenes = include_str!("../../../book/notes/measured/scenes.snap.csv");
        let rows = Table::<WrongPixels>::read(scenes)
            .expect("the file is well-formed")
            .rows;
        let of = |method: &str| {
            let is_wanted =
                |row: &&WrongPixels| (&*row.scene, &*row.method) == ("neighbors", method);
            rows.iter().find(is_wanted).expect("it was measured").wrong
        };
        let in_scene = rows.iter().filter(|row| row.scene == "neighbors");
        assert_eq!(in_scene.map(|row| row.wrong).min(), Some(of("certified_t")));
        assert!(of("certified_t") > 100 && of("exact") >= of("certified_t"));
    }

    #[test]
    fn the_stable_discriminants_are_worse_on_the_books_own_ground() {
        let half_b = p999(&of("book_ground", "half_b"));
        for method in ["haines", "haines_q", "cross_q"] {
            let found = of("book_ground", method);
            assert!(p999(&found) > 4.0 * half_b, "{method}");
            assert!(found.largest_ulps > Some(10_000.0), "{method}");
        }
    }

    /// The rule counts every rounding as if it were the largest, and says too much where
    /// c happens to be exact.
    #[test]
    fn the_worst_pixels_are_those_that_are_shown_and_the_error_over_the_slope_says_why() {
        let file = include_str!("../../../book/notes/measured/worst.snap.csv");
        for row in Table::<Worst>::read(file)
            .expect("the file is well-formed")
            .rows
        {
            let all = of(&format!("book_{}", row.sphere), &row.method);
            assert_eq!(all.largest_ulps, Some(row.ulps), "{row:?}");
            assert!(row.ulps < row.rule_ulps, "{row:?}");
            let nearly_so = row.ulps > row.rule_ulps / 2.0;
            assert_eq!(
                nearly_so,
                row.sphere == "ball" || row.method == "cross_q",
                "{row:?}"
            );
        }
    }

    /// `cross_q_f32` confuses two pixels at the horizon, at 3840.
    #[test]
    fn no_method_but_one_decides_wrongly_in_the_book() {
        for method in METHODS {
            let wrong = of("book_ground", method.name).wrong_per_million;
            let expected = if method.name == "cross_q_f32" {
                0.241
            } else {
                0.0
            };
            assert_eq!(wrong, expected, "{}", method.name);
            assert_eq!(of("book_ball", method.name).wrong_per_million, 0.0);
        }
    }

    #[test]
    fn near_a_tangent_half_a_digit_is_lost_with_each_factor_of_ten() {
        let levels = levels();
        let median = |method: &str, level: i32| {
            let is_wanted = |row: &&Level| {
                (&*row.regime, &*row.method, row.level) == ("grazing", method, level)
            };
            let row = levels.iter().find(is_wanted).expect("a row");
            row.median_ulps.expect("it hits")
        };
        for method in ["half_b", "half_b_q", "haines", "cross_q"] {
            let factor = median(method, 13) / median(method, 3);
            assert!((0.9e5..1.1e5).contains(&factor), "{method}: {factor}");
        }
        for method in ["haines", "cross_q"] {
            let digits = (p999(&of("grazing", "half_b")) / p999(&of("grazing", method))).log10();
            assert!((0.8..1.0).contains(&digits), "nearly one digit: {digits}");
        }
    }

    #[test]
    fn very_large_and_very_small_numbers_are_too_much_for_all_but_one_in_plain_f64() {
        for method in METHODS {
            let is_safe = method.any_exponent;
            let wrong = of("exponents", method.name).wrong_per_million;
            assert!(
                if is_safe { wrong == 0.0 } else { wrong > 3e4 },
                "{}",
                method.name
            );
        }
        let safe = METHODS.iter().filter(|method| method.any_exponent);
        let names: Vec<&str> = safe.map(|method| method.name).collect();
        let right = [
            "scaled_q",
            "certified_hit",
            "certified_t",
            "exact",
            "widened_half_b_q_f32",
            "certified_f32",
        ];
        assert_eq!(names, right);
    }

    /// An accurate discriminant of the wrong quadratic.
    #[test]
    fn kahan_barely_helps() {
        let [plain, kahan] = ["half_b_q", "kahan_q"].map(|method| p999(&of("grazing", method)));
        assert!((0.5..1.0).contains(&(kahan / plain)));
        let [plain, kahan] = ["half_b_q", "kahan_q"].map(|method| of("far", method));
        assert!(kahan.wrong_per_million > plain.wrong_per_million);
    }

    /// Far away `half_b` and its like guess; near a surface all but `adaptive_q` do, about
    /// one time in five.
    #[test]
    fn who_decides_wrongly_where() {
        for method in ["full_b", "half_b", "half_b_q", "kahan_q", "scaled_q"] {
            assert!(of("far", method).wrong_per_million > 1e5, "{method}");
        }
        for method in ["haines", "haines_q", "cross_q", "adaptive_q"] {
            assert!(of("far", method).wrong_per_million < 2e3, "{method}");
        }
        for method in [
            "full_b", "half_b", "half_b_q", "haines", "kahan_q", "cross_q",
        ] {
            let wrong = of("near_surface", method).wrong_per_million;
            assert!((1e6 / 6.5..1e6 / 4.5).contains(&wrong), "{method}: {wrong}");
        }
        assert_eq!(of("near_surface", "adaptive_q").wrong_per_million, 0.0);
    }

    /// The digits of t are gone, because t is near 0; the hit points are in place.
    #[test]
    fn a_hit_point_near_the_surface_is_no_farther_off_for_want_of_digits() {
        for regime in ["near_surface", "ground"] {
            for method in ["half_b", "half_b_q", "cross_q", "adaptive_q"] {
                let found = of(regime, method);
                assert!(
                    found.surface_largest_radii < Some(2e-15),
                    "{method} {found:?}"
                );
            }
            let digits_are_lost = p999(&of(regime, "half_b_q")) > 1e8;
            assert!(digits_are_lost && p999(&of(regime, "adaptive_q")) < 1e3);
        }
    }

    #[test]
    fn the_certified_and_the_exact_never_decide_wrongly_and_t_is_within_an_ulp() {
        for regime in REGIMES {
            for method in ["certified_hit", "certified_t", "exact"] {
                assert_eq!(of(regime.name, method).wrong_per_million, 0.0, "{method}");
            }
            assert!(of(regime.name, "certified_t").largest_ulps <= Some(0.8));
            assert!(of(regime.name, "exact").largest_ulps <= Some(0.5));
        }
    }

    fn of(regime: &str, method: &str) -> Accuracy {
        let mut rows = recorded().into_iter();
        let row = rows.find(|row| row.regime == regime && row.method == method);
        row.unwrap_or_else(|| panic!("{method} in {regime}"))
    }

    fn p999(row: &Accuracy) -> f64 {
        row.p999_ulps.expect("it hits")
    }
}

fn levels() -> Vec<Level> {
    let file = include_str!("../../../book/notes/measured/sweeps.csv");
    Table::read(file).expect("the file is well-formed").rows
}

fn recorded() -> Vec<Accuracy> {
    let file = include_str!("../../../book/notes/measured/accuracy.csv");
    Table::read(file).expect("the file is well-formed").rows
}

/// Compares what was measured with the snapshot of that name.
fn assert_measured<Row: Record>(name: &str, table: &Table<Row>) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(MEASURED);
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_comparator(Box::new(SameLines));
    settings.bind(|| assert_binary_snapshot!(&format!("{name}.csv"), table.text().into_bytes()));
}

/// Compares two tables line by line, and shows the lines that differ.
#[derive(Clone)]
struct SameLines;

impl Comparator for SameLines {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        let (Some(expected), Some(actual)) = (text_of(reference), text_of(test)) else {
            println!("The .csv file of a snapshot is missing: restore it, or accept a new one.");
            return false;
        };
        if expected == actual {
            return true;
        }
        let name = test.snapshot_name().unwrap_or("table");
        println!(
            "\n`{name}` is not its snapshot. These lines differ, as they were and as they are:"
        );
        for (old, new) in expected.lines().zip(actual.lines()) {
            if old != new {
                println!("- {old}\n+ {new}");
            }
        }
        let [old, new] = [&expected, &actual].map(|text| text.lines().count());
        if old != new {
            println!("{old} lines before, {new} lines now");
        }
        println!(
            "If a method was meant to change: INSTA_UPDATE=always cargo test the_snapshot_holds::{name}\n\
             (in PowerShell, first $env:INSTA_UPDATE = 'always')\n"
        );
        false
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

fn text_of(snapshot: &Snapshot) -> Option<String> {
    match snapshot.contents() {
        // Git may write the lines of a text in the manner of the system.
        SnapshotContents::Binary(Some(file)) => {
            Some(String::from_utf8_lossy(file).replace("\r\n", "\n"))
        }
        _ => None,
    }
}
