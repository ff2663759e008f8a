//! Verified repair: the smallest edit with which a reader's program is right.
//!
//! A mistake is a difference between the chapter's text and the reader's, and it is named if
//! putting it right was tried: nothing is said here that did not draw the picture.

mod chapter;
mod edit;
mod foreign;
mod functions;
mod generic;
mod goal;
mod letters;
mod search;
mod spelling;
mod tree;

use std::cell::Cell;
use std::ops::Range;

use slips::Chapter;

use crate::reading::Reading;
use crate::scene::Scene;
use crate::sources::{Line, Sources};
use functions::{Files, Function, functions, with};
use goal::{Goal, program};
use search::{Found, Search};
use tree::squeezed;

/// What makes a program right, tried.
#[derive(Clone, Debug)]
pub struct Repair {
    /// What is to be changed.
    pub changes: Vec<Change>,
    /// The reader's files with all of it.
    pub(crate) files: Files,
    /// Whether the picture was right before.
    pub(crate) is_hidden: bool,
}

/// A place in the reader's files, and what is right there.
#[derive(Clone, Debug)]
pub struct Change {
    /// The reader's line.
    pub yours: Line,
    /// What should be there.
    pub right: Right,
}

/// What is right in a place.
#[derive(Clone, Debug)]
pub enum Right {
    /// This instead.
    Line(String),
    /// This above or below.
    More(&'static str, String),
    /// Nothing.
    Nothing,
    /// The whole function as it stands there.
    Function(Line),
    /// What the chapter has there, where the reader writes another language.
    InRust(String),
}

impl Repair {
    /// What makes a program right that draws this picture of the scene.
    pub(crate) fn of(scene: &Scene, reading: &Reading, sources: &Sources) -> Option<Self> {
        let files = sources.in_rust();
        if sources.is_empty() || files.is_empty() && scene.probe.is_some() {
            return None;
        }
        if files.is_empty() {
            let (chapter, files) = (scene.chapter, sources.files());
            return foreign::repair(chapter, &right_files(chapter), &files, reading);
        }
        let yours = program(&files).filter(|it| goal::draws(it, reading))?;
        let right = scene.right(reading.width, scene.height(reading.width));
        let is_hidden = right == reading.picture();
        let theirs = right_files(scene.chapter);
        let mut goal = Goal::new(scene.chapter, &right, reading);
        // Of another scene only the picture is known.
        if scene.probe.is_none() && !sources.have_a_prelude() {
            let chapter = &theirs[..scene.chapter.files().len()];
            goal = goal.asking(&program(chapter)?);
        }
        if is_hidden && goal.is_answered_by(&yours) {
            return None;
        }
        let search = Search {
            files: &files,
            yours: &functions(&files),
            chapter: &functions(&theirs),
            goal: &goal,
            tried: Cell::default(),
        };
        let found = search.find()?;
        Some(found.repair(&files, &theirs, is_hidden))
    }
}

/// What is right, by the files of this workspace: the chapter, its root first, the prelude, and
/// what the book prints.
fn right_files(chapter: Chapter) -> Files {
    let folder = format!("chapters/{}_{}", chapter as usize, chapter.name());
    let files = chapter.files().iter();
    let mut files: Files = files
        .map(|(name, text)| (format!("{folder}/{name}"), (*text).to_owned()))
        .collect();
    files.sort_by_key(|(name, _)| !name.ends_with("lib.rs"));
    let printed = match chapter {
        Chapter::Normals | Chapter::HalfBSphere => include_str!("book/normals.rs"),
        Chapter::HittableList => include_str!("book/hittable_list.rs"),
        _ => "",
    };
    let more = [
        (
            "common/src/color.rs",
            include_str!("../../../../common/src/color.rs"),
        ),
        (
            "common/src/ray.rs",
            include_str!("../../../../common/src/ray.rs"),
        ),
        (
            "common/src/camera.rs",
            include_str!("../../../../common/src/camera.rs"),
        ),
        ("the book", printed),
    ];
    files.extend(more.map(|(name, text)| (name.to_owned(), text.to_owned())));
    files
}

impl Found<'_> {
    fn repair(&self, files: &Files, theirs: &Files, is_hidden: bool) -> Repair {
        match self {
            Self::Edits(edits) => {
                let texts: Vec<(&Function, String)> = edits
                    .iter()
                    .map(|(function, edit)| (*function, edit.applied_to(&function.text)))
                    .collect();
                let texts: Vec<_> = texts
                    .iter()
                    .map(|(it, text)| (*it, text.as_str()))
                    .collect();
                let changes = edits.iter().flat_map(|(function, edit)| {
                    let start = function.at.start;
                    let parts = edit
                        .parts
                        .iter()
                        .map(|(at, new)| (at.start + start..at.end + start, new.as_str()));
                    changes(&files[function.file], parts.collect())
                });
                Repair {
                    changes: changes.collect(),
                    files: with(files, &texts),
                    is_hidden,
                }
            }
            Self::Functions(functions) => {
                let changes = functions.iter().map(|(yours, right)| {
                    let right = line(&theirs[right.file], right.at.start);
                    Change {
                        yours: line(&files[yours.file], yours.at.start),
                        right: Right::Function(right),
                    }
                });
                let texts: Vec<_> = functions
                    .iter()
                    .map(|(it, right)| (*it, &*right.text))
                    .collect();
                Repair {
                    changes: changes.collect(),
                    files: with(files, &texts),
                    is_hidden,
                }
            }
        }
    }
}

/// Each line that is changed, or several that are changed together.
fn changes(file: &(String, String), mut parts: Vec<(Range<usize>, &str)>) -> Vec<Change> {
    parts.sort_by_key(|(at, _)| at.start);
    let text = &file.1;
    let lines = |at: &Range<usize>| {
        let start = text[..at.start].rfind('\n').map_or(0, |it| it + 1);
        start
            ..text[at.end..]
                .find('\n')
                .map_or(text.len(), |it| at.end + it)
    };
    let of_a_line = parts.chunk_by(|(one, _), (other, _)| lines(one).end >= other.start);
    let changes = of_a_line.map(|parts| {
        let (first, last) = (&parts[0], &parts[parts.len() - 1]);
        let at = lines(&(first.0.start..last.0.end));
        let mut new = text[at.clone()].to_owned();
        for (place, with) in parts.iter().rev() {
            new.replace_range(place.start - at.start..place.end - at.start, with);
        }
        let new = squeezed(&new);
        let is_statement = first.0.is_empty() && first.1.trim().ends_with([';', '}']);
        let right = match is_statement {
            true if first.1.starts_with(' ') => Right::More("below", first.1.trim().to_owned()),
            true => Right::More("above", first.1.trim().to_owned()),
            false if new.is_empty() => Right::Nothing,
            false => Right::Line(new),
        };
        Change {
            yours: Line {
                text: squeezed(&text[at.clone()]),
                ..line(file, at.start)
            },
            right,
        }
    });
    changes.collect()
}

/// The line of a file.
fn line((name, text): &(String, String), at: usize) -> Line {
    let start = text[..at].rfind('\n').map_or(0, |it| it + 1);
    let end = text[at..].find('\n').map_or(text.len(), |it| at + it);
    Line {
        file: name.clone(),
        number: text[..at].matches('\n').count() + 1,
        text: text[start..end]
            .trim()
            .trim_end_matches('{')
            .trim_end()
            .to_owned(),
    }
}
