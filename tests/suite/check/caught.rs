//! Each slip is caught: by the book's picture, by a probe, or by a law.

mod tables;

use std::fs;
use std::path::Path;

use check::comparison::Comparison;
use common::rtweekend::*;
use laws::Trial;
use laws::list::World;
use laws::record::Hit;
use laws::report::Report;
use laws::trial::Outcome as Tried;
use slips::Chapter;
use slips::{self, Ball, PROBES, Probe, Program, Slip, Unseen};

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
    for chapter in Chapter::OF_THE_BOOK {
        if let Err(report) = tried(&Program::right(chapter)) {
            panic!("{chapter:?} breaks a law:\n{report}");
        }
    }
}

/// What happens to a slip in a chapter.
struct Outcome {
    slip: &'static Slip,
    chapter: Chapter,
    /// What the book's picture shows, and then each probe's.
    verdicts: Vec<(Option<Probe>, Shown)>,
    /// The first law that the slip breaks, and what is said about it.
    report: Option<Box<Report>>,
}

fn outcomes() -> Vec<Outcome> {
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
                report: tried(&program).err(),
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
        let complaint = match (seen, self.report.is_some(), unseen) {
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
        let report = self.report.as_ref();
        report.is_some_and(|report| report.broken.law == law)
    }

    fn has_a_named_law(&self) -> bool {
        self.report.is_none() || tables::TESTS.iter().any(|(law, ..)| self.breaks(law))
    }
}

/// What the laws are tried on: enough to see a mistake, not to prove anything.
const TRIAL: Trial = Trial { cases: 60 };

/// Puts the program under the laws that its chapter is old enough for.
pub(crate) fn tried(program: &Program) -> Tried {
    if program.chapter == Chapter::BuildTest {
        return Ok(());
    }
    try_rays(program)?;
    try_intersection(program)?;
    if program.chapter == Chapter::HittableList {
        try_record(program)?;
        try_list(program)?;
    }
    Ok(())
}

fn try_rays(program: &Program) -> Tried {
    TRIAL.at(&|ray, t| (program.at)(program, ray, t))?;
    TRIAL.unit_vector(&program.unit)?;
    TRIAL.height(&|width| program.camera(width).image_height)?;
    // The height is right, so it is that of the size that is asked for.
    TRIAL.pixel_ray(&|[width, _], [i, j]| (program.ray)(program, &program.camera(width), i, j))?;
    TRIAL.dot(&program.dot)
}

pub(crate) fn try_intersection(program: &Program) -> Tried {
    let hit = |center, radius, ray: &Ray| program.hit_sphere(center, radius, ray);
    match program.chapter {
        Chapter::BuildTest | Chapter::Gradient => Ok(()),
        Chapter::RedSphere => {
            TRIAL.decision(&|center, radius, ray: &Ray| hit(center, radius, ray).is_some())
        }
        Chapter::HittableList => {
            TRIAL.nearest_in_range(&|center, radius, ray: &Ray, t_min, t_max| {
                program.hit(Ball { center, radius }, ray, t_min, t_max)
            })
        }
        _ => TRIAL.nearer_root(&hit),
    }
}

fn try_record(program: &Program) -> Tried {
    TRIAL.record(&|center, radius, ray: &Ray, t_min, t_max| {
        let ball = Ball { center, radius };
        let t = program.hit(ball, ray, t_min, t_max)?;
        let point = (program.at)(program, ray, t);
        let outward = (program.outward)(program, point, ball);
        Some(Hit {
            t,
            normal: (program.face)(program, ray.direction, outward),
            front_face: (program.dot)(ray.direction, outward) < 0.0,
        })
    })
}

fn try_list(program: &Program) -> Tried {
    TRIAL.list(&|world: &World| {
        let balls = world.spheres.iter();
        let balls: Vec<Ball> = balls
            .map(|&(center, radius)| Ball { center, radius })
            .collect();
        let program = Program {
            // A program's world is static. These are few and small.
            world: Vec::leak(balls),
            t_min: world.t_min,
            t_max: world.t_max,
            ..*program
        };
        (program.search)(&program, &world.ray).map(|(t, _)| t)
    })
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
