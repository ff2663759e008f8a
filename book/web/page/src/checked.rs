//! What the page *Check your picture* asks: bytes in; words, pixels and numbers out.
//!
//! The verdict and its words are those of [`check`], as in the command. Here they only
//! become HTML.

use std::iter;

use check::answer::{Answer, Attempt, Commands, Pictures};
use check::context::Context;
use check::html::{HostPage, below, escaped, headline};
use check::reading::{self, Cause, MOST_PIXELS, Reading};
use check::report::difference_picture;
use check::sentences;
use check::task::Task;
use check::verdict::Verdict;
use check::{guess, judge, judge_guessed};
use slips::{Chapter, Edition, PROBES, Probe, Slip};

use crate::rgba;

/// What a reader says of a picture.
#[derive(Clone, Debug, Default)]
pub struct CheckRequest {
    /// What its file is called.
    pub name: String,
    /// The chapter, or it is guessed.
    pub chapter: Option<Chapter>,
    /// The probe that was made.
    pub probe: Option<Probe>,
    /// The only edition that will do.
    pub edition: Option<Edition>,
}

/// A picture, and what is said of it.
pub struct CheckResponse {
    /// A line of facts for the script, with tabs between them; the verdict on a line; and
    /// below it the rest, as HTML.
    pub text: String,
    /// The pictures, if there is one to see.
    pictures: Option<Pictures>,
    /// The reader's numbers, and the programs beside which they are shown.
    traced: Option<Traced>,
}

/// What the numbers of a pixel are asked of.
struct Traced {
    reading: Reading,
    /// The scene by the edition that the picture is judged by.
    task: Task,
    /// The mistake that draws the picture, if one is known.
    mistake: Option<Vec<&'static Slip>>,
}

impl CheckRequest {
    /// The name of a file, and places in the lists of [`choices`], counted from 1: 0 says
    /// nothing. Between them are zero bytes.
    pub fn read(text: &str) -> Self {
        let mut fields = text.split('\0');
        let name = fields.next().unwrap_or_default().to_owned();
        let mut place = || fields.next()?.parse::<usize>().ok()?.checked_sub(1);
        Self {
            name,
            chapter: place().and_then(|it| Chapter::OF_THE_BOOK.get(it).copied()),
            probe: place().and_then(|it| PROBES.get(it).copied()),
            edition: place().and_then(|it| Edition::ALL.get(it).copied()),
        }
    }

    /// The scene that is asked for. A probe for which the chapter has no room is none.
    fn task(&self, reading: Option<&Reading>) -> Task {
        let plain = match (self.chapter, reading) {
            (None, Some(reading)) => guess::task(reading),
            (chapter, _) => Task::new(chapter.unwrap_or(Chapter::BuildTest), None)
                .expect("every chapter can be drawn without a probe"),
        };
        let probed = self.probe.and_then(|probe| plain.with_probe(probe));
        let task = probed.unwrap_or(plain);
        self.edition.map_or(task, |edition| task.only_by(edition))
    }
}

/// Returns what the script can offer, a line each: which list, what it is called, and what it is.
pub fn choices() -> String {
    let chapters = Chapter::OF_THE_BOOK.map(|it| format!("chapter\t{}\t{0}", it.name()));
    let probes = PROBES.map(|it| format!("probe\t{}\t{0}", it.name));
    let editions = Edition::ALL.map(|it| format!("edition\t{}\t{it}", it.name()));
    [&chapters[..], &probes, &editions].concat().join("\n")
}

/// Judges the bytes of a file.
pub fn answer(request: CheckRequest, bytes: &[u8]) -> CheckResponse {
    match reading::read(bytes) {
        Ok(reading) => judged(request, reading, None),
        Err(cause) => refused(request, cause),
    }
}

/// Returns what is said of a file that is too large to be read.
pub fn too_large(request: CheckRequest) -> CheckResponse {
    refused(request, Cause::too_large())
}

/// Judges what a browser shows of a file that only it can read: four bytes a pixel. `why`
/// are the first bytes of the file. Where the format loses levels in ways of its own, only a
/// right picture is judged: what differs may be the file's fault.
pub fn decoded(
    request: CheckRequest,
    why: &[u8],
    width: u32,
    height: u32,
    rgba: &[u8],
) -> CheckResponse {
    let Err(cause) = reading::read(why) else {
        return too_large(request);
    };
    let count = u64::from(width) * u64::from(height);
    if count > MOST_PIXELS || count * 4 != rgba.len() as u64 {
        return refused(request, cause);
    }
    let (pixels, _) = rgba.as_chunks::<4>();
    let levels = |&[r, g, b, _]: &[u8; 4]| [r, g, b].map(i16::from);
    let reading = Reading {
        width,
        height,
        pixels: pixels.iter().map(levels).collect(),
        encoding: None,
    };
    judged(request, reading, Some(cause))
}

/// `foreign` says why only the browser can read the file.
fn judged(request: CheckRequest, reading: Reading, foreign: Option<Cause>) -> CheckResponse {
    let context = Context::default();
    let wanted = request.task(Some(&reading));
    let is_guessed = request.chapter.is_none();
    let (task, verdict) = if is_guessed {
        judge_guessed(&wanted, &reading, 0, &context)
    } else {
        (wanted, judge(&wanted, &reading, 0, &context))
    };
    let loses_levels = |it: &Cause| {
        ["JPEG", "WebP"]
            .iter()
            .any(|kind| it.problem.contains(kind))
    };
    if let Some(cause) = foreign.as_ref().filter(|it| loses_levels(it))
        && !matches!(verdict, Verdict::Right(_))
    {
        return refused(request, cause.clone());
    }
    let facts = facts(&task, &verdict, &reading);
    let mistakes = verdict.finding().and_then(|it| it.mistakes.as_ref());
    let mistake = mistakes.map(|it| it.all[0].clone());
    let judged_by = match &verdict {
        Verdict::Right(right) => right.task,
        other => other.finding().map_or(task, |finding| finding.task),
    };
    let attempt = Attempt {
        task,
        is_guessed,
        name: request.name,
        encoding: reading.encoding.clone(),
        context: &context,
        laws: None,
        commands: Commands::of_pictures(task),
    };
    let answer = attempt.answer(verdict);
    CheckResponse {
        text: laid_out(&facts, &answer) + &foreign.map_or(String::new(), |it| read_by_browser(&it)),
        traced: Some(Traced {
            task: judged_by.fitting(reading.width, reading.height),
            reading,
            mistake,
        }),
        pictures: answer.pictures,
    }
}

fn refused(request: CheckRequest, cause: Cause) -> CheckResponse {
    let answer = sentences::refused(&request.name, "not a picture", &cause);
    CheckResponse {
        text: laid_out(&["", "", cause.name, "", "0"].join("\t"), &answer),
        traced: None,
        pictures: None,
    }
}

/// The facts that the script asks for: chapter, probe, cause, the size with the first pixel that
/// differs, and how many differ.
fn facts(task: &Task, verdict: &Verdict, reading: &Reading) -> String {
    let difference = verdict.finding().and_then(|it| it.difference.as_ref());
    let (column, row) = difference.map_or((0, 0), |it| it.first);
    let facts = [
        task.chapter.name(),
        task.probe.map_or("", |probe| probe.name),
        verdict.cause().map_or("", |cause| cause.name),
        &format!("{} {} {column} {row}", reading.width, reading.height),
        &difference.map_or(0, |it| it.count).to_string(),
    ];
    facts.join("\t")
}

/// The facts in the first line, the verdict in the second, since it is announced before the rest
/// is read, and the rest below.
fn laid_out(facts: &str, answer: &Answer) -> String {
    let (headline, below) = (
        headline(&answer.headline),
        below(answer, HostPage::CheckPage),
    );
    format!("{facts}\n{headline}\n{below}")
}

/// Said below a picture that `check` can't read.
fn read_by_browser(cause: &Cause) -> String {
    format!(
        "<p>Your browser has read this file: {}. It was judged as what the browser shows.</p>",
        escaped(&cause.problem)
    )
}

impl CheckResponse {
    /// The right picture, the reader's, or the difference, as a canvas has them: four bytes
    /// a pixel. Nothing if there is none.
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

    /// The numbers of a pixel, a line each: what it is, as it should be, and if a mistake is
    /// known, as that has it; and in the last line the reader's levels.
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
        let lines = slips::side_by_side(&traced.collect::<Vec<_>>());
        format!("{lines}\nyours\t{r} {g} {b}")
    }
}
