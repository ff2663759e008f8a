//! Each slip is caught: by the book's picture, by a probe, or by a law.

mod tables;

use std::fs;
use std::path::Path;

use check::Chapter;
use check::comparison::Comparison;
use check::slips::{self, Ball, PROBES, Probe, Program, Slip, Unseen};
use common::rtweekend::*;
use laws::verdict::{Broken, Verdict};
use laws::{Case, WithInterval};
use laws::{intervals, nearer_root, ray_and_camera, record, runner, strategies};

/// The book shows the tables, so they stand where the book finds them.
const NOTES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes/slips");

#[test]
fn every_slip_is_caught_and_the_tables_say_by_what() {
    let outcomes = outcomes();
    let complaints: String = outcomes.iter().filter_map(Outcome::complaint).collect();
    assert!(complaints.is_empty(), "\n{complaints}");
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(NOTES);
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        insta::assert_snapshot!("caught", tables::in_full(&outcomes));
        insta::assert_snapshot!("caught_by", tables::at_a_glance(&outcomes));
    });
}

#[test]
fn every_law_has_the_test_that_is_named() {
    for (law, file, test) in tables::TESTS {
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
        let source = fs::read_to_string(source).expect("the file is there");
        assert!(source.contains(test), "{law}: {file} has no test {test}");
    }
}

#[test]
fn a_program_without_a_slip_breaks_no_law() {
    let samples = Samples::new();
    for chapter in Chapter::OF_THE_BOOK {
        if let Some(broken) = samples.broken_law(&Program::right(chapter)) {
            panic!("{chapter:?} breaks a law:\n{broken}");
        }
    }
}

/// What happens to a slip in a chapter.
struct Outcome {
    slip: &'static Slip,
    chapter: Chapter,
    /// What the book's picture shows, and then each probe's.
    verdicts: Vec<(Option<Probe>, Shown)>,
    /// The first law that the slip breaks.
    broken: Option<Broken>,
}

fn outcomes() -> Vec<Outcome> {
    let samples = Samples::new();
    let mut outcomes = Vec::new();
    for chapter in Chapter::OF_THE_BOOK {
        let exams = exams(chapter);
        for slip in slips::all().filter(|slip| slip.chapters.contains(&chapter)) {
            let program = slip.program(chapter);
            let verdict = |exam: &Exam| (exam.probe, exam.judge(program));
            outcomes.push(Outcome {
                slip,
                chapter,
                verdicts: exams.iter().map(verdict).collect(),
                broken: samples.broken_law(&program),
            });
        }
    }
    outcomes
}

impl Outcome {
    fn complaint(&self) -> Option<String> {
        let mut verdicts = self.verdicts.iter();
        let seen = verdicts.any(|(_, verdict)| *verdict != Shown::Same);
        let unseen = self.slip.unseen_in(self.chapter);
        let complaint = match (seen, self.broken.is_some(), unseen) {
            (false, _, None) => "is in no picture: add a probe, or say why nothing can show it",
            (true, _, Some(_)) => "is in a picture, but the catalogue says that none shows it",
            (_, false, Some(Unseen::OnlyByLaw(_))) => "breaks no law, but the catalogue says so",
            _ if !self.has_a_named_law() => "breaks a law whose test is not named in tables.rs",
            _ => return None,
        };
        Some(format!(
            "{} in {:?} {complaint}\n",
            self.slip.name, self.chapter
        ))
    }

    fn breaks(&self, law: &str) -> bool {
        self.broken.as_ref().is_some_and(|broken| broken.law == law)
    }

    fn has_a_named_law(&self) -> bool {
        self.broken.is_none() || tables::TESTS.iter().any(|(law, ..)| self.breaks(law))
    }
}

/// What the laws are tried on: enough to see a mistake, not to prove anything.
struct Samples {
    cases: Vec<Case>,
    asked: Vec<WithInterval>,
}

impl Samples {
    fn new() -> Self {
        // The last one has both ends at a root: nothing lies between them.
        let between_its_roots = WithInterval {
            case: Case {
                center: Vec3::NEG_Z,
                radius: 0.5,
                ray: Ray::new(Point3::ZERO, Vec3::NEG_Z),
            },
            t_min: 0.5,
            t_max: 1.5,
        };
        let mut cases = runner::samples(&strategies::anywhere(), 60);
        cases.extend(runner::samples(&strategies::tangents(), 10));
        let mut asked = runner::samples(&strategies::with_interval(strategies::anywhere()), 60);
        asked.push(between_its_roots);
        Self { cases, asked }
    }

    /// The first law that the program breaks, of those that its chapter is old
    /// enough for.
    fn broken_law(&self, program: &Program) -> Option<Broken> {
        self.mapping(program)
            .and_then(|()| self.nearer_root(program))
            .and_then(|()| self.range(program))
            .and_then(|()| self.normal(program))
            .err()
    }

    fn mapping(&self, program: &Program) -> Verdict {
        if program.chapter == Chapter::BuildTest {
            return Ok(());
        }
        ray_and_camera::dot_multiplies_equal_letters(&program.dot, [[1, 2, 3], [5, 7, 11]])?;
        ray_and_camera::the_point_at_t_is_t_directions_from_the_origin(&|ray, t| {
            (program.at)(program, ray, t)
        })?;
        ray_and_camera::the_height_is_rounded_down_and_at_least_one(&|width| {
            program.camera(width).image_height
        })?;
        let camera = program.camera(100);
        let ray = |_, [i, j]: [u32; 2]| (program.ray)(&camera, i, j);
        let size = [camera.image_width, camera.image_height];
        ray_and_camera::the_ray_of_a_pixel_goes_through_its_center(&ray, size, [60, 20])
    }

    fn nearer_root(&self, program: &Program) -> Verdict {
        let solve = |center, radius, ray: &Ray| program.hit_sphere(center, radius, ray);
        let laws: &[nearer_root::Law] = match program.chapter {
            Chapter::BuildTest | Chapter::Gradient => &[],
            // Chapter 2 has no root, but it has to decide, on tangents too.
            Chapter::RedSphere => &[
                nearer_root::a_ray_aimed_at_the_sphere_hits_and_one_aimed_past_it_misses,
                nearer_root::the_line_hits_exactly_when_there_is_a_root,
                nearer_root::a_tangent_is_a_hit,
            ],
            _ => &nearer_root::NEARER_ROOT,
        };
        laws.iter()
            .flat_map(|law| self.cases.iter().map(|case| law(&solve, case)))
            .collect()
    }

    fn range(&self, program: &Program) -> Verdict {
        if program.chapter != Chapter::HittableList {
            return Ok(());
        }
        let solve = |center, radius, ray: &Ray, t_min, t_max| {
            program.hit(Ball { center, radius }, ray, t_min, t_max)
        };
        let laws = intervals::NEAREST_IN_RANGE.iter();
        laws.flat_map(|law| self.asked.iter().map(|asked| law(&solve, asked)))
            .collect()
    }

    fn normal(&self, program: &Program) -> Verdict {
        if program.chapter < Chapter::Normals {
            return Ok(());
        }
        for case in self.cases.iter().filter(|case| case.radius > 0.0) {
            let Case {
                center,
                radius,
                ray,
            } = *case;
            let Some(t) = program.hit_sphere(center, radius, &ray) else {
                continue;
            };
            let point = (program.at)(program, &ray, t);
            let outward = (program.outward)(program, point, Ball { center, radius });
            record::the_normal_is_a_unit_vector(case, outward)?;
            if program.chapter == Chapter::HittableList {
                let normal = (program.face)(program, ray.direction, outward);
                record::the_normal_points_against_the_ray(case, normal)?;
                let front_face = (program.dot)(ray.direction, outward) < 0.0;
                record::the_front_face_is_where_the_ray_enters(case, true, front_face)?;
            }
        }
        Ok(())
    }
}

/// A picture that is compared: the book's, or a probe's.
struct Exam {
    probe: Option<Probe>,
    width: u32,
    right: Picture,
}

#[derive(PartialEq)]
enum Shown {
    Same,
    Size,
    /// The share of pixels that differ, and the largest difference in levels.
    Pixels(f64, u8),
}

/// The exams that the chapter has spheres for, the book's picture first.
fn exams(chapter: Chapter) -> Vec<Exam> {
    let right = Program::right(chapter);
    let book = Exam {
        probe: None,
        width: chapter.book_width(),
        right: right.run(chapter.book_width()).picture(),
    };
    let probes = PROBES.into_iter().filter_map(|probe| {
        Some(Exam {
            probe: Some(probe),
            width: probe.width,
            right: probe.put_to(right)?.run(probe.width).picture(),
        })
    });
    std::iter::once(book).chain(probes).collect()
}

impl Exam {
    fn judge(&self, program: Program) -> Shown {
        let program = match self.probe {
            None => program,
            Some(probe) => probe
                .put_to(program)
                .expect("a slip leaves room for spheres"),
        };
        let wrong = program.run(self.width).picture();
        match Comparison::of(&self.right, &wrong) {
            Comparison::Equal => Shown::Same,
            Comparison::Size(..) => Shown::Size,
            Comparison::Pixels(difference) => Shown::Pixels(
                difference.count as f64 / difference.total as f64,
                difference.levels,
            ),
        }
    }
}
