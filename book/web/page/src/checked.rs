//! What the page *Check your picture* asks: bytes in; words, pixels and numbers out.
//!
//! The verdict and its words are those of [`check`], as in the command. Here they only
//! become HTML.

use std::iter;

use check::answer::Judged;
use check::guess;
use check::known::Known;
use check::reading::{self, Cause, MOST_PIXELS, Reading};
use check::report::difference_picture;
use check::scene::Scene;
use check::verdict::{self, Check};
use common::rtweekend::Picture;
use slips::{Chapter, Edition, PROBES, Probe};

use crate::{html, rgba};

/// What a reader says of a picture.
#[derive(Clone, Debug, Default)]
pub struct Question {
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
pub struct Answered {
    /// A line of facts for the script, with tabs between them; the verdict on a line; and
    /// below it the rest, as HTML.
    pub text: String,
    judged: Judged<'static>,
    /// The reader's picture, if there is one.
    reading: Option<Reading>,
    /// The right one, where the verdict has none.
    right: Option<Picture>,
}

impl Question {
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
    fn scene(&self, reading: Option<&Reading>) -> Scene {
        let plain = match (self.chapter, reading) {
            (None, Some(reading)) => guess::scene(reading),
            (chapter, _) => Scene::new(chapter.unwrap_or(Chapter::BuildTest), None)
                .expect("without a probe it is a scene"),
        };
        let probed = self.probe.and_then(|probe| plain.with_probe(probe));
        let scene = probed.unwrap_or(plain);
        self.edition.map_or(scene, |edition| scene.only_by(edition))
    }
}

/// What the script can offer, a line each: which list, what it is called, and what it is.
pub fn choices() -> String {
    let chapters = Chapter::OF_THE_BOOK.map(|it| format!("chapter\t{}\t{0}", it.name()));
    let probes = PROBES.map(|it| format!("probe\t{}\t{0}", it.name));
    let editions = Edition::ALL.map(|it| format!("edition\t{}\t{it}", it.name()));
    [&chapters[..], &probes, &editions].concat().join("\n")
}

/// Judges the bytes of a file.
pub fn answer(question: Question, bytes: &[u8]) -> Answered {
    match reading::read(bytes) {
        Ok(reading) => judged(question, reading, None),
        Err(cause) => refused(question, cause),
    }
}

/// What is said of a file that is too large to be read.
pub fn too_large(question: Question) -> Answered {
    refused(question, Cause::too_large())
}

/// Judges what a browser shows of a file that only it can read: four bytes a pixel. `why`
/// are the first bytes of the file. Where the format loses levels in ways of its own, only a
/// right picture is judged: what differs may be the file's fault.
pub fn decoded(question: Question, why: &[u8], size: (u32, u32), rgba: &[u8]) -> Answered {
    let Err(cause) = reading::read(why) else {
        return too_large(question);
    };
    let (width, height) = size;
    let count = u64::from(width) * u64::from(height);
    if count > MOST_PIXELS || count * 4 != rgba.len() as u64 {
        return refused(question, cause);
    }
    let (pixels, _) = rgba.as_chunks::<4>();
    let levels = |&[r, g, b, _]: &[u8; 4]| [r, g, b].map(i16::from);
    let reading = Reading {
        width,
        height,
        pixels: pixels.iter().map(levels).collect(),
        encoding: None,
    };
    judged(question, reading, Some(cause))
}

/// `foreign` says why only the browser can read the file.
fn judged(question: Question, reading: Reading, foreign: Option<Cause>) -> Answered {
    let known = Known::default();
    let wanted = question.scene(Some(&reading));
    let (scene, check) = if question.chapter.is_none() {
        verdict::judge_guessed(&wanted, &reading, 0, &known)
    } else {
        (wanted, verdict::judge(&wanted, &reading, 0, &known))
    };
    let right = match &check {
        Check::Right(right) => Some(right.scene.right(reading.width, reading.height)),
        _ => None,
    };
    if let Some(cause) = &foreign
        && right.is_none()
        && ["JPEG", "WebP"].iter().any(|it| cause.problem.contains(it))
    {
        return refused(question, cause.clone());
    }
    let judged = Judged {
        scene,
        is_guessed: question.chapter.is_none(),
        name: question.name,
        encoding: reading.encoding.clone(),
        known,
        check,
    };
    Answered {
        text: html::answer(&judged, Some(&reading)) + &foreign.map_or(String::new(), html::foreign),
        judged,
        reading: Some(reading),
        right,
    }
}

fn refused(question: Question, cause: Cause) -> Answered {
    let judged = Judged {
        scene: question.scene(None),
        is_guessed: false,
        name: question.name,
        encoding: None,
        known: Known::default(),
        check: Check::NotAPicture {
            cause,
            finding: None,
        },
    };
    Answered {
        text: html::answer(&judged, None),
        judged,
        reading: None,
        right: None,
    }
}

/// The scene by the edition that the picture is judged by.
fn scene_by_edition(judged: &Judged) -> Scene {
    match (&judged.check, judged.check.finding()) {
        (Check::Right(right), _) => right.scene,
        (_, finding) => finding.map_or(judged.scene, |finding| finding.scene),
    }
}

impl Answered {
    /// The right picture, the reader's, or the difference, as a canvas has them: four bytes
    /// a pixel. Nothing if there is none.
    pub fn rgba(&self, which: usize) -> Vec<u8> {
        let yours = || self.reading.as_ref().map(Reading::picture);
        let picture = match (which, self.right()) {
            (0, Some(right)) => return rgba(right),
            (1, _) => yours(),
            (_, Some(right)) => yours().and_then(|yours| difference_picture(right, &yours)),
            (_, None) => None,
        };
        picture.as_ref().map_or(Vec::new(), rgba)
    }

    fn right(&self) -> Option<&Picture> {
        let finding = self.judged.check.finding();
        let right = finding.map(|finding| &finding.right);
        self.right.as_ref().or(right)
    }

    /// The numbers of a pixel, a line each: what it is, as it should be, and if a mistake is
    /// known, as that has it; and in the last line the reader's levels.
    pub fn inspect(&self, column: u32, row: u32) -> String {
        let (Some(reading), Some(_)) = (&self.reading, self.right()) else {
            return String::new();
        };
        let (width, height) = (reading.width, reading.height);
        let at = (row * width + column) as usize;
        let [r, g, b] = reading.pixels.get(at).copied().unwrap_or_default();
        let finding = self.judged.check.finding();
        let mistakes = finding.and_then(|finding| finding.mistakes.as_ref());
        let mistake = mistakes.map(|mistakes| &mistakes.all[0][..]);
        let scene = scene_by_edition(&self.judged).fitting(width, height);
        let traced = iter::once(&[][..])
            .chain(mistake)
            .map(|slips| scene.program(slips).run(width).traced(at as u32));
        let lines = slips::side_by_side(&traced.collect::<Vec<_>>());
        format!("{lines}\nyours\t{r} {g} {b}")
    }
}
