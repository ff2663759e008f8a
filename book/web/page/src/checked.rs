//! The judge behind the page *Check your picture*: bytes in; words, pixels and numbers out.
//!
//! [`check`] judges the picture and words the verdict, as it does for the command. This module
//! turns them into HTML.

use std::iter;

use check::answer::{Answer, Pictures};
use check::attempt::Attempt;
use check::context::Context;
use check::html::{HostPage, details, headline};
use check::reading::{self, Cause, Reading};
use check::sentences;
use check::task::Task;
use check::verdict::Verdict;
use check::{guess, judge, judge_guessed};
use difference::difference_picture;
use slips::{Chapter, PROBES, Probe, Slip};

use crate::rgba;

/// All that a reader says of a picture when handing it in to be checked.
#[derive(Clone, Debug, Default)]
pub struct CheckRequest {
    /// The name of the picture's file, which sentences of the answer repeat.
    pub name: String,
    /// The chapter that the picture is said to be of, or `None` if it is to be guessed.
    pub chapter: Option<Chapter>,
    /// The [`Probe`] that the reader drew: a small change of the chapter's scene that shows what
    /// its own picture hides. `None` for the chapter's own scene.
    pub probe: Option<Probe>,
}

/// The verdict on a picture file, with all that the page shows of it: words, and pixels to compare.
pub struct CheckResponse {
    /// Three parts, each on a new line: facts for the script, separated by tabs (chapter, probe,
    /// `width height column row` with the first wrong pixel, and the number of wrong pixels); the
    /// headline; all the rest. The last two are HTML.
    pub text: String,
    /// The right picture and the reader's of the same size, or `None` if the answer compares none.
    pictures: Option<Pictures>,
    /// The reader's levels and the programs whose numbers are shown for a pixel, or `None` if the
    /// file could not be judged.
    traced: Option<Traced>,
}

/// The picture and the programs that [`CheckResponse::inspect`] compares at a pixel.
struct Traced {
    reading: Reading,
    /// The scene of the right picture, by the version that the reader's picture was compared with.
    task: Task,
    /// The slips that draw the reader's picture, or `None` if no known ones do.
    mistake: Option<Vec<&'static Slip>>,
}

impl CheckRequest {
    /// Reads a request from three fields with zero bytes between them: the name of the file, and the
    /// indices of chapter and probe in the lists of [`choices`], counted from 1. A field
    /// that is 0, missing, too large or no number stands for no choice.
    pub fn read(text: &str) -> Self {
        let mut fields = text.split('\0');
        let name = fields.next().unwrap_or_default().to_owned();
        let mut place = || fields.next()?.parse::<usize>().ok()?.checked_sub(1);
        Self {
            name,
            chapter: place().and_then(|it| Chapter::OF_THE_BOOK.get(it).copied()),
            probe: place().and_then(|it| PROBES.get(it).copied()),
        }
    }

    /// Returns the task of the request; the chapter is guessed from `reading` if the request names
    /// none. A probe for which the chapter has no room is left out.
    fn task(&self, reading: Option<&Reading>) -> Task {
        let plain = match (self.chapter, reading) {
            (None, Some(reading)) => guess::guess_task(reading),
            (chapter, _) => Task::of(chapter.unwrap_or(Chapter::BuildTest)),
        };
        let probed = self
            .probe
            .and_then(|probe| Task::new(plain.chapter, Some(probe)));
        probed.unwrap_or(plain)
    }

    /// Judges the bytes of a picture file, as the command `check` does. A file that is no picture
    /// gets a response that says why. A probe for which the chapter has no room is ignored.
    pub fn answer(self, bytes: &[u8]) -> CheckResponse {
        match reading::read(bytes) {
            Ok(reading) => self.judged(reading),
            Err(cause) => self.refused(cause),
        }
    }

    /// Returns the response to a file that is too large to be read: words that refuse it, and no
    /// pixels.
    pub fn too_large(self) -> CheckResponse {
        self.refused(Cause::too_large())
    }

    /// Judges a picture that has been read.
    fn judged(self, reading: Reading) -> CheckResponse {
        let context = Context::default();
        let wanted = self.task(Some(&reading));
        let is_guessed = self.chapter.is_none();
        let (task, verdict) = if is_guessed {
            judge_guessed(&wanted, &reading, 0, &context)
        } else {
            (wanted, judge(&wanted, &reading, 0, &context))
        };
        let facts = facts(&task, &verdict, &reading);
        let mistakes = verdict.finding().map_or(Vec::new(), |it| it.mistakes());
        let mistake = mistakes.first().map(|it| it.to_vec());
        let judged_by = verdict.finding().map_or(task, |finding| finding.task);
        let attempt = Attempt {
            is_guessed,
            name: self.name,
            flaw: reading.flaw.clone(),
            ..Attempt::new(task, &context)
        };
        let answer = attempt.answer(verdict);
        CheckResponse {
            text: laid_out(&facts, &answer),
            traced: Some(Traced {
                task: judged_by.fitting(reading.width, reading.height),
                reading,
                mistake,
            }),
            pictures: answer.pictures,
        }
    }

    /// Returns the response to a file that cannot be judged, for this cause.
    fn refused(self, cause: Cause) -> CheckResponse {
        let answer = sentences::refused(&self.name, "not a picture", &cause);
        CheckResponse {
            text: laid_out(&["", "", "", "0"].join("\t"), &answer),
            traced: None,
            pictures: None,
        }
    }
}

/// Returns the options of the page's form as plain text, one per line, with tabs between the list's
/// name (`chapter` or `probe`), the option's value, and the words that are shown.
pub fn choices() -> String {
    let chapters = Chapter::OF_THE_BOOK.map(|it| format!("chapter\t{}\t{0}", it.name()));
    let probes = PROBES.map(|it| format!("probe\t{}\t{0}", it.name));
    [&chapters[..], &probes].concat().join("\n")
}

/// Writes the facts for the script: chapter, probe, the size with the first pixel that differs, and
/// the number of pixels that differ.
fn facts(task: &Task, verdict: &Verdict, reading: &Reading) -> String {
    let difference = verdict.finding().and_then(|it| it.difference.as_ref());
    let [column, row] = difference.map_or([0, 0], |it| it.first);
    let facts = [
        task.chapter.name(),
        task.probe.map_or("", |probe| probe.name),
        &format!("{} {} {column} {row}", reading.width, reading.height),
        &difference.map_or(0, |it| it.count).to_string(),
    ];
    facts.join("\t")
}

/// Puts the facts on the first line, the headline on the second, since the page announces it before
/// the rest is read, and the rest below.
fn laid_out(facts: &str, answer: &Answer) -> String {
    let (headline, details) = (
        headline(&answer.headline),
        details(answer, HostPage::CheckPage),
    );
    format!("{facts}\n{headline}\n{details}")
}

impl CheckResponse {
    /// Returns a picture's pixels for a canvas, four bytes each (red, green, blue, 255), row by row
    /// from the top. `which` is 0 for the right picture, 1 for the reader's, 2 for their
    /// difference. Returns no bytes if there is no such picture.
    pub fn rgba(&self, which: usize) -> Vec<u8> {
        match (&self.pictures, which) {
            (Some(it), 0) => rgba(&it.right),
            (Some(it), 1) => rgba(&it.yours),
            (Some(it), _) => {
                let difference = difference_picture(&it.right, &it.yours);
                difference.as_ref().map_or(Vec::new(), rgba)
            }
            (None, 1) => {
                let yours = self.traced.as_ref().map(|it| it.reading.picture());
                yours.as_ref().map_or(Vec::new(), rgba)
            }
            (None, _) => Vec::new(),
        }
    }

    /// Returns the numbers from which a pixel's color comes, one per line, at `column` and `row` of
    /// the picture, from 0 at the top left: name, right value and, if a known mistake draws the
    /// picture, the value with that mistake, with tabs between. The last line is `yours` and the
    /// reader's levels, 0–255. Returns an empty text if the response has no right picture to
    /// compare with.
    pub fn inspect(&self, column: u32, row: u32) -> String {
        let (Some(it), Some(_)) = (&self.traced, &self.pictures) else {
            return String::new();
        };
        let at = (row * it.reading.width + column) as usize;
        let [r, g, b] = it.reading.pixels.get(at).copied().unwrap_or_default();
        let traced = iter::once(&[][..])
            .chain(it.mistake.as_deref())
            .map(|slips| {
                it.task
                    .program(slips)
                    .run(it.reading.width)
                    .trace(at as u32)
            });
        let lines = slips::trace_table(&traced.collect::<Vec<_>>());
        format!("{lines}\nyours\t{r} {g} {b}")
    }
}
