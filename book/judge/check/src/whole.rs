//! The whole verdict on a program that a reader types: its picture, the laws and the typed
//! lines come to one cause, and one thing to do next.

use common::rtweekend::Picture;
use laws::Report;
use slips::{Chapter, Edition, Probe, Slip, steps};

use crate::blind_spots;
use crate::known::Known;
use crate::names;
use crate::reading::Cause;
use crate::scene::Scene;
use crate::verdict::{self, Check, Finding, Right};

/// What a program has come to.
#[derive(Default)]
pub struct Verdict {
    /// Whether nothing is left to do here.
    pub is_right: bool,
    /// The reader's picture and the one that it should be, if there is one.
    pub pictures: Option<(Picture, Picture)>,
    /// What it is, in a line.
    pub headline: String,
    /// The first cause, or what is known of it.
    pub cause: Vec<Line>,
    /// What to do now.
    pub next: String,
    /// Slips whose pages tell how it is right.
    pub read: Vec<&'static Slip>,
    /// What came out right.
    pub done: Vec<String>,
}

/// A line below the headline.
pub enum Line {
    /// A label, and text that may be long.
    Labeled(String, String),
    /// As a compiler or a program has printed it.
    Printed(String),
}

/// Whether the laws hold for what a reader typed.
pub enum Laws {
    /// All of them do.
    Obeyed,
    /// One is broken.
    Broken(Box<Report>),
    /// One is broken by the reader's own prelude, on which all else stands.
    BrokenPrelude(Box<Report>),
    /// A function has a `todo!()` at this place.
    NotWritten(String),
    /// A function of the reader's own prelude has.
    UnwrittenPrelude(String),
    /// They were not tried to the end, or nothing is said of a law.
    Unknown(String),
    /// They are still being built.
    Coming,
}

/// What is known of a picture and the program behind it.
pub struct Evidence<'a> {
    /// What the picture should show.
    pub scene: &'a Scene,
    /// What is known besides.
    pub known: &'a Known<'a>,
    /// What the laws say of the reader's functions, where they can be asked.
    pub laws: Option<&'a Laws>,
    /// What judges a picture of the reader's about this chapter, or a probe of it.
    pub watch: &'a dyn Fn(Option<Probe>) -> String,
    /// What goes on to the next chapter.
    pub start: &'a dyn Fn(Chapter) -> String,
}

impl Verdict {
    /// A compiler has so many complaints, and this is the first.
    pub fn not_compiled(complaints: usize, first: Vec<Line>) -> Self {
        let more = match complaints {
            1 => String::new(),
            all => format!(" This is the first of {all}."),
        };
        Self {
            headline: format!("It does not compile.{more}"),
            cause: first,
            ..Self::default()
        }
    }

    /// Nothing has been written yet at this place of the program.
    pub fn not_written(chapter: Chapter, place: &str) -> Self {
        let first = steps::of(chapter).first();
        Self {
            headline: format!("Not written yet: todo!() at {place}."),
            next: first.map_or(String::new(), |step| step_says(0, step)),
            ..Self::default()
        }
    }

    fn and_obeys_the_laws(mut self, chapter: Chapter) -> Self {
        self.headline += " The laws hold. They ask your functions about rays of all kinds.";
        self.done.push(format!("{}: the laws hold", chapter.name()));
        self
    }
}

/// A line that somebody else has printed.
pub fn printed(text: &str) -> Vec<Line> {
    let visible = |line| Line::Printed(names::visible(line).into_owned());
    text.lines().map(visible).collect()
}

fn labeled(label: &str, text: String) -> Line {
    Line::Labeled(label.to_owned(), text)
}

fn step_says(at: usize, step: &steps::Step) -> String {
    format!("step {}: {}", at + 1, step.says)
}

/// What is done when a step of a chapter shows what it should.
pub fn step_is_done(chapter: Chapter, step: usize) -> String {
    format!("{}: step {step} shows what it should", chapter.name())
}

/// What is done when the picture of a chapter is right.
pub fn picture_is_right(chapter: Chapter) -> String {
    format!("{}: the picture is right, to the last bit", chapter.name())
}

impl Evidence<'_> {
    /// The verdict on what the program has printed.
    pub fn of_picture(&self, bytes: &[u8]) -> Verdict {
        self.of(verdict::check_knowing(self.scene, bytes, 0, self.known))
    }

    /// The verdict on a picture that was judged.
    pub fn of(&self, check: Check) -> Verdict {
        let verdict = self.of_picture_alone(check);
        match self.laws {
            Some(Laws::BrokenPrelude(report)) => Verdict {
                cause: law(report),
                next: "first that: what else is wrong may stand on it".to_owned(),
                ..verdict
            },
            _ => verdict,
        }
    }

    /// The verdict where the reader's own prelude is right, or there is none.
    fn of_picture_alone(&self, check: Check) -> Verdict {
        match check {
            Check::Right(right) => self.of_right_picture(&right),
            Check::Near(finding) => self.of_near_picture(finding),
            Check::Wrong(finding) => self.of_wrong_picture(finding),
            Check::Another { cause, .. } => Verdict {
                headline: sentence(&cause.problem),
                next: cause.fix.split_whitespace().collect::<Vec<_>>().join(" "),
                ..Verdict::default()
            },
            Check::WrongShape { cause, finding, .. } => {
                self.of_no_picture("wrong", &cause, finding)
            }
            Check::NotAPicture { cause, finding } => {
                self.of_no_picture("no picture", &cause, finding)
            }
        }
    }

    fn of_right_picture(&self, right: &Right) -> Verdict {
        let (scene, width, height) = (&right.scene, right.width, right.height);
        let chapter = self.scene.chapter;
        let verdict = Verdict {
            pictures: Some((scene.right(width, height), scene.right(width, height))),
            ..Verdict::default()
        };
        if scene.has_another_shape() {
            return Verdict {
                headline: format!("Right{}: {width} × {height}.", right.by()),
                next: (self.known.shape_given_by(scene, &right.shape_given_by))
                    .unwrap_or("if you chose the shape, nothing is wrong".to_owned()),
                ..verdict
            };
        }
        let (can_say, cause) = match self.laws {
            Some(Laws::Broken(report) | Laws::BrokenPrelude(report)) => (
                "a law is broken, which must hold for every ray",
                law(report),
            ),
            Some(Laws::NotWritten(place) | Laws::UnwrittenPrelude(place)) => {
                return Verdict {
                    headline: format!(
                        "The picture is right, but not all is written. {}",
                        todo_at(place)
                    ),
                    next: WRITE_IT.to_owned(),
                    ..verdict
                };
            }
            Some(Laws::Unknown(errors)) => ("the laws can't be tried", printed(errors)),
            Some(Laws::Coming) => {
                return Verdict {
                    headline: "The picture is right. The laws are still being built.".to_owned(),
                    next: "as soon as they are, they ask your functions".to_owned(),
                    ..verdict
                };
            }
            Some(Laws::Obeyed) | None => {
                let headline = format!(
                    "Right{}: all {width} × {height} pixels, to the last bit.",
                    Edition::said(&[scene.edition])
                );
                let verdict = Verdict {
                    is_right: true,
                    headline,
                    next: self.next_chapter(),
                    done: vec![match self.scene.probe {
                        Some(probe) => format!("{}, probe {}: right", chapter.name(), probe.name),
                        None => picture_is_right(chapter),
                    }],
                    ..verdict
                };
                let verdict = match self.laws {
                    Some(_) => verdict.and_obeys_the_laws(chapter),
                    None => verdict,
                };
                return self.with_next_probe(verdict, width);
            }
        };
        Verdict {
            headline: format!("The picture is right, but {can_say}."),
            cause,
            next: "cargo test, in the folder of your crate, shows more".to_owned(),
            ..verdict
        }
    }

    /// Right but for odd pixels, or as far as a step goes.
    fn of_near_picture(&self, finding: Finding) -> Verdict {
        let verdict = Verdict {
            headline: format!("Right, but {}.", finding.but()),
            cause: self.rows(&finding),
            next: "as the book has it, it can be compared to the last bit".to_owned(),
            ..Verdict::default()
        };
        let is_exact = finding.near.as_ref().is_some_and(|near| near.is_exact());
        let verdict = match (finding.scene.step().filter(|_| is_exact), self.laws) {
            (Some(step), _) => self.of_step(step, &finding),
            (None, Some(Laws::Broken(report))) if !finding.is_answered => Verdict {
                headline: "A law is broken, which must hold for every ray.".to_owned(),
                cause: [
                    vec![labeled("seen", format!("right, but {}", finding.but()))],
                    law(report),
                ]
                .into_iter()
                .flatten()
                .collect(),
                ..Verdict::default()
            },
            (None, _) => verdict,
        };
        Verdict {
            pictures: Some((finding.yours, finding.right)),
            ..verdict
        }
    }

    fn of_step(&self, step: usize, finding: &Finding) -> Verdict {
        let chapter = self.scene.chapter;
        let (steps, number) = (steps::of(chapter), step + 1);
        if let Some(Laws::Broken(report) | Laws::BrokenPrelude(report)) = self.laws
            && !finding.is_answered
        {
            return Verdict {
                headline: format!(
                    "The picture of step {number} is right, but a law is broken, which must hold for every ray."
                ),
                cause: law(report),
                ..Verdict::default()
            };
        }
        let all = steps.len();
        if let Some(Laws::UnwrittenPrelude(place)) = self.laws {
            return Verdict {
                headline: format!(
                    "Step {number} of {all} is right, but for the prelude. {}",
                    todo_at(place)
                ),
                next: WRITE_IT.to_owned(),
                ..Verdict::default()
            };
        }
        Verdict {
            headline: if self.known.steps[step] {
                format!("This is what step {number} of {all} shows, again.")
            } else {
                format!("Step {number} of {all} is right.")
            },
            next: step_says(number, &steps[number]),
            done: vec![step_is_done(chapter, number)],
            ..Verdict::default()
        }
    }

    /// Says which probe shows most of what can hide from the picture: but not what the reader
    /// can't have done, nor what would answer otherwise.
    fn with_next_probe(&self, verdict: Verdict, width: u32) -> Verdict {
        let chapter = self.scene.chapter;
        let may_be = |slip: &Slip| {
            self.known.can_be_made(slip, self.scene)
                && (self.known.answers).is_none_or(|unlike| unlike(&slip.program(chapter)).1 == 0)
        };
        let Some(next) = blind_spots::next(self.scene, width, may_be) else {
            return verdict;
        };
        let command = next.scene.probe.map_or(String::new(), |probe| {
            format!("; and then {}", (self.watch)(Some(probe)))
        });
        let change = next.change(self.known.letters) + &command;
        Verdict {
            cause: vec![labeled("probe", format!("{}: {change}", next.why()))],
            ..verdict
        }
    }

    fn next_chapter(&self) -> String {
        let mut chapters = Chapter::OF_THE_BOOK.into_iter();
        let next = chapters.find(|&it| it > self.scene.chapter);
        next.map_or("that was the last chapter to type".to_owned(), |next| {
            format!("{}: {}", next.name(), (self.start)(next))
        })
    }

    fn of_wrong_picture(&self, finding: Finding) -> Verdict {
        let mut cause = self.rows(&finding);
        let is_unknown = finding.mistakes.as_ref().is_none_or(|it| !it.is_in_text);
        match self.laws {
            _ if finding.repair.is_some() => {}
            Some(Laws::Broken(report)) if !finding.is_answered || is_unknown => {
                cause.extend(law(report));
            }
            Some(Laws::Obeyed) if is_unknown => cause.push(labeled(
                "the laws",
                "they hold: look at what calls the function, and what becomes of its answer"
                    .to_owned(),
            )),
            _ => {}
        }
        let total = finding.right.rgb().len() / 3;
        let with = match finding.scene.step() {
            Some(step) => format!(", compared with step {}", step + 1),
            None => String::new(),
        };
        let headline = match finding.difference.as_ref().map(|it| it.count) {
            None | Some(0) => {
                "The picture is right, but a law is broken, which must hold for every ray."
                    .to_owned()
            }
            Some(count) if finding.levels() == 1 => format!(
                "Right within one level, but for the last bit: {count} of {total} pixels{with}."
            ),
            Some(count) => format!("Wrong: {count} of {total} pixels{with}."),
        };
        Verdict {
            headline,
            cause,
            next: finding
                .next(self.known.letters, |probe| (self.watch)(Some(probe)))
                .unwrap_or_default(),
            read: finding.single().to_vec(),
            pictures: Some((finding.yours, finding.right)),
            ..Verdict::default()
        }
    }

    fn of_no_picture(
        &self,
        verdict: &str,
        cause: &Cause,
        finding: Option<Box<Finding>>,
    ) -> Verdict {
        Verdict {
            headline: format!("It is {verdict}: {}.", cause.problem),
            cause: finding.as_ref().map_or(Vec::new(), |it| self.rows(it)),
            next: cause.fix.clone(),
            pictures: finding.map(|finding| (finding.yours, finding.right)),
            ..Verdict::default()
        }
    }

    fn rows(&self, finding: &Finding) -> Vec<Line> {
        let rows = finding.rows(self.known).into_iter();
        rows.map(|(label, text)| labeled(label, text)).collect()
    }
}

/// The rows of a report on a broken law.
pub fn law(report: &Report) -> Vec<Line> {
    let rows = report.rows().into_iter();
    rows.map(|(label, text)| labeled(label, text.to_owned()))
        .collect()
}

/// Where a function waits to be written.
fn todo_at(place: &str) -> String {
    format!("There is a todo!() at {place}.")
}

/// What to do with a `todo!()` that no picture needs.
const WRITE_IT: &str = "write that as well: the laws ask for it, and a later picture needs it";

/// With a large letter, and a full stop.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters
        .next()
        .map_or(String::new(), |first| first.to_uppercase().to_string());
    format!("{first}{}.", letters.as_str())
}
