//! What the page *Check your picture* calls, compiled to WebAssembly: bytes in; words,
//! pixels and numbers out.
//!
//! The verdict and its words are those of [`check`], as in the command. Here they only
//! become HTML. `.ci/live` builds the module that the page loads.

#[cfg(target_family = "wasm")]
mod exports;
mod html;

use std::iter;

use check::answer::Judged;
use check::guess;
use check::known::Known;
use check::reading::{self, Cause, MOST_PIXELS, Reading};
use check::report::difference_picture;
use check::scene::Scene;
use check::verdict::{self, Check};
use common::rtweekend::Picture;
use slips::{Chapter, Edition, PROBES};

/// What a reader says of a picture: places in the lists of [`choices`], the first of which
/// says nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Asked {
    /// A chapter of the book, counted from 1; 0 lets it be guessed.
    pub chapter: usize,
    /// A probe, counted from 1.
    pub probe: usize,
    /// An edition, counted from 1.
    pub edition: usize,
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

/// What the script can offer, a line each: which list, what it is called, and what it is.
pub fn choices() -> String {
    let chapters = Chapter::OF_THE_BOOK.into_iter();
    let chapters = chapters.map(|it| ("chapter", it.name(), it.shows().to_owned()));
    let probes = PROBES
        .iter()
        .map(|it| ("probe", it.name, it.shows.to_owned()));
    let editions = Edition::ALL.into_iter();
    let editions = editions.map(|it| ("edition", it.name(), it.to_string()));
    let all = chapters.chain(probes).chain(editions);
    let lines: Vec<String> = all
        .map(|(list, name, what)| format!("{list}\t{name}\t{what}"))
        .collect();
    lines.join("\n")
}

/// Judges the bytes of a file of that name.
pub fn answer(name: &str, bytes: &[u8], asked: Asked) -> Answered {
    match reading::read(bytes) {
        Ok(reading) => judged(name, reading, asked, None),
        Err(cause) => refused(name, cause, asked),
    }
}

/// What is said of a file that is too large to be read.
pub fn too_large(name: &str, asked: Asked) -> Answered {
    refused(name, Cause::too_large(), asked)
}

/// Judges what a browser shows of a file that only it can read: four bytes a pixel. `why`
/// are the first bytes of the file. Where levels were lost, and nobody can say how, it is
/// not judged: what differs may be the file's fault.
pub fn decoded(
    name: &str,
    why: &[u8],
    (width, height): (u32, u32),
    rgba: &[u8],
    asked: Asked,
) -> Answered {
    let Err(cause) = reading::read(why) else {
        return refused(name, Cause::too_large(), asked);
    };
    let size = u64::from(width) * u64::from(height);
    if size > MOST_PIXELS || size * 4 != rgba.len() as u64 {
        return refused(name, cause, asked);
    }
    let (pixels, _) = rgba.as_chunks::<4>();
    let levels = |&[r, g, b, _]: &[u8; 4]| [r, g, b].map(i16::from);
    let reading = Reading {
        width,
        height,
        pixels: pixels.iter().map(levels).collect(),
        encoding: None,
    };
    judged(name, reading, asked, Some(cause))
}

fn judged(name: &str, reading: Reading, asked: Asked, foreign: Option<Cause>) -> Answered {
    let known = Known::default();
    let asked_for = scene(asked, Some(&reading));
    let (scene, check) = match asked.chapter {
        0 => verdict::judge_guessed(&asked_for, &reading, 0, &known),
        _ => (asked_for, verdict::judge(&asked_for, &reading, 0, &known)),
    };
    if let Some(cause) = foreign.clone()
        && is_lossy(&cause)
        && !matches!(check, Check::Right(_))
    {
        return refused(name, cause, asked);
    }
    let right = match &check {
        Check::Right(right) => Some(right.scene.right(reading.width, reading.height)),
        _ => None,
    };
    let judged = Judged {
        scene,
        is_guessed: asked.chapter == 0,
        name: name.to_owned(),
        encoding: reading.encoding.clone(),
        known,
        check,
    };
    let decoded = foreign.map(|cause| html::decoded(&cause));
    Answered {
        text: html::answer(&judged, &reading) + &decoded.unwrap_or_default(),
        judged,
        reading: Some(reading),
        right,
    }
}

fn refused(name: &str, cause: Cause, asked: Asked) -> Answered {
    let check = Check::NotAPicture {
        cause,
        finding: None,
    };
    let judged = Judged {
        scene: scene(asked, None),
        is_guessed: false,
        name: name.to_owned(),
        encoding: None,
        known: Known::default(),
        check,
    };
    Answered {
        text: html::refusal(&judged),
        judged,
        reading: None,
        right: None,
    }
}

/// Whether the format changes levels.
fn is_lossy(cause: &Cause) -> bool {
    ["JPEG", "WebP"].iter().any(|it| cause.problem.contains(it))
}

/// The scene that is asked for. A probe for which the chapter has no room is none.
fn scene(asked: Asked, reading: Option<&Reading>) -> Scene {
    let one = |place: usize| place.checked_sub(1);
    let chapter = one(asked.chapter).and_then(|it| Chapter::OF_THE_BOOK.get(it).copied());
    let probe = one(asked.probe).and_then(|it| PROBES.get(it).copied());
    let edition = one(asked.edition).and_then(|it| Edition::ALL.get(it).copied());
    let of = |chapter| Scene::new(chapter, probe).or_else(|| Scene::new(chapter, None));
    let guessed = |reading| {
        let guessed = guess::scene(reading);
        probe
            .and_then(|probe| guessed.with_probe(probe))
            .unwrap_or(guessed)
    };
    let scene = match (chapter, reading) {
        (None, Some(reading)) => guessed(reading),
        (chapter, _) => {
            of(chapter.unwrap_or(Chapter::BuildTest)).expect("without a probe it is a scene")
        }
    };
    edition.map_or(scene, |edition| scene.only_by(edition))
}

/// The scene by the edition that the picture is judged by.
fn shown(judged: &Judged) -> Scene {
    match (&judged.check, judged.check.finding()) {
        (Check::Right(right), _) => right.scene,
        (_, finding) => finding.map_or(judged.scene, |finding| finding.scene),
    }
}

impl Answered {
    /// The right picture, the reader's, or the difference, as a canvas has them: four bytes
    /// a pixel. Nothing if there is none.
    pub fn rgba(&self, which: usize) -> Vec<u8> {
        let picture = match (which, self.right(), &self.reading) {
            (1, _, Some(reading)) => Some(reading.picture()),
            (2, Some(right), Some(reading)) => difference_picture(right, &reading.picture()),
            (0, Some(right), _) => return opaque(right),
            _ => None,
        };
        picture.as_ref().map_or(Vec::new(), opaque)
    }

    fn right(&self) -> Option<&Picture> {
        let finding = self.judged.check.finding();
        self.right
            .as_ref()
            .or(finding.map(|finding| &finding.right))
    }

    /// The numbers of a pixel, a line each: what it is, as it should be, and if a mistake is
    /// known, as that has it; and in the last line the reader's levels.
    pub fn inspect(&self, column: u32, row: u32) -> String {
        let (Some(reading), Some(_)) = (&self.reading, self.right()) else {
            return String::new();
        };
        let (width, height) = (reading.width, reading.height);
        let finding = self.judged.check.finding();
        let at = (row * width + column) as usize;
        let [r, g, b] = reading.pixels.get(at).copied().unwrap_or_default();
        let yours = format!("yours\t{r} {g} {b}");
        let scene = shown(&self.judged).fitting(width, height);
        let mistakes = finding.and_then(|finding| finding.mistakes.as_ref());
        let mistake = mistakes.map(|mistakes| &mistakes.all[0][..]);
        let traced = iter::once(&[][..]).chain(mistake).map(|slips| {
            let program = scene.program(slips);
            program.traced(width, column, row).rows(scene.chapter)
        });
        let lines = slips::side_by_side(&traced.collect::<Vec<_>>());
        format!("{lines}\n{yours}")
    }
}

fn opaque(picture: &Picture) -> Vec<u8> {
    let (pixels, _) = picture.rgb().as_chunks();
    let opaque = |&[r, g, b]: &[u8; 3]| [r, g, b, u8::MAX];
    pixels.iter().flat_map(opaque).collect()
}
