//! Mutation operators: a slip is a known mistake, as edits of the chapters' texts, and what there
//! is to say of it.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::{LazyLock, Mutex, PoisonError};

use crate::chapter::Chapter;
use crate::edit::Edit;
use crate::edition::Edition;
use crate::probes::PROBES;
use crate::program::{ChapterProgram, files, source};
use crate::reader_language::{ReaderLanguage, in_cpp, in_python};
use crate::wrong_picture::kept;

/// The slips that the picture of a chapter hides at the book's width, and what probes show them:
/// drawn once, since that takes longer than a reader waits.
const HIDDEN: &str = include_str!("../tests/pictures/snapshots/pictures__hidden.snap");

/// A mistake that readers make: a paragraph of `catalogue.txt`, where the fields are told.
///
/// In which chapters it can be made, the texts of these say: wherever its edits stand.
#[derive(Clone, Debug, Default)]
pub struct Slip {
    /// What it is called, on the command line and in tables. It never changes. Empty where
    /// only laws look for it.
    pub name: &'static str,
    /// The page of the book and its heading that tell how it is right, as the end of an
    /// address: `half_b_sphere#two-observations`.
    pub page: &'static str,
    /// What the mistake does to the picture, and why.
    pub why: &'static str,
    pub(super) edits: Vec<Edit>,
    pub(super) reported: &'static str,
    pub(super) only_in: &'static str,
    pub(super) equivalent: &'static str,
    pub(super) law: &'static str,
    /// The whole line in each of these, if it can't be made of the chapter's.
    pub(super) rust: Option<Edit>,
    pub(super) cpp: Option<Edit>,
    pub(super) python: Option<Edit>,
    pub(super) older: Option<Edit>,
}

/// What there is to say of a slip.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SlipText {
    /// What the code probably says.
    pub wrong: Cow<'static, str>,
    /// What it should say.
    pub right: Cow<'static, str>,
    /// Why, and what the mistake does to the picture.
    pub why: &'static str,
}

/// Why neither picture nor probe shows a slip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unseen {
    /// It draws the same picture; the sentence proves it.
    Equivalent(&'static str),
    /// It needs a ray that no camera here casts; the sentence is the law that
    /// a test puts to [`ChapterProgram::hit_sphere`], [`ChapterProgram::record`] or a ray.
    OnlyByLaw(&'static str),
}

impl Slip {
    /// Returns what there is to say of it to someone who made it in that chapter.
    pub fn words(&self, language: ReaderLanguage, chapter: Chapter) -> SlipText {
        let Edit { right, wrong } = self.line(language, chapter);
        SlipText {
            wrong,
            right,
            why: self.why,
        }
    }

    /// Returns the line in which the slip is made, right and wrong, in the reader's language.
    fn line(&self, language: ReaderLanguage, chapter: Chapter) -> Edit {
        let edition = language.edition();
        let own = match language {
            _ if edition != Edition::V4 && self.older.is_some() => &self.older,
            ReaderLanguage::Rust => &self.rust,
            ReaderLanguage::Cpp(_) => &self.cpp,
            ReaderLanguage::Python(_) => &self.python,
        };
        let of_chapter = || {
            let statement = self.statement(chapter, edition);
            let statement = statement.or_else(|| self.statement(chapter, Edition::V4));
            self.rust.clone().or(statement).unwrap_or_default()
        };
        let made =
            |line: Edit, to: &dyn Fn(&str) -> String| Edit::new(to(&line.right), to(&line.wrong));
        let translated = || match language {
            ReaderLanguage::Rust => of_chapter(),
            ReaderLanguage::Cpp(_) => made(of_chapter(), &|line| in_cpp(line, chapter)),
            ReaderLanguage::Python(_) => {
                made(self.line(ReaderLanguage::Cpp(edition), chapter), &in_python)
            }
        };
        match own {
            Some(line) if line.right.is_empty() => {
                Edit::new(translated().right, line.wrong.clone())
            }
            Some(line) if matches!(language, ReaderLanguage::Python(_)) => {
                made(line.clone(), &in_python)
            }
            Some(line) => line.clone(),
            None => translated(),
        }
    }

    /// Finds the statement in an edition's text of the chapter in which the slip is made, on one
    /// line.
    fn statement(&self, chapter: Chapter, edition: Edition) -> Option<Edit> {
        /// By the slip's name and its reason, since not all have a name.
        type Known = BTreeMap<(&'static str, &'static str, Chapter, Edition), Option<Edit>>;
        static KNOWN: LazyLock<Mutex<Known>> = LazyLock::new(Mutex::default);
        let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        let statement = || edition.program(chapter).statement_with(&self.edits);
        let key = (self.name, self.why, chapter, edition);
        known.entry(key).or_insert_with(statement).clone()
    }

    /// Returns true if that language lets it be made: not all take a number for a truth, or -1.0
    /// for a miss.
    pub fn is_possible_in_language(&self, language: ReaderLanguage) -> bool {
        let language = match language {
            ReaderLanguage::Rust => "Rust",
            ReaderLanguage::Cpp(_) => "C++",
            ReaderLanguage::Python(_) => "Python",
        };
        self.only_in.is_empty() || self.only_in.split(", ").any(|it| it == language)
    }

    /// Returns true if editions before version 4 have another line for it.
    pub fn has_older_line(&self, chapter: Chapter) -> bool {
        let [older, own] =
            [Edition::V3, Edition::V4].map(|it| self.line(ReaderLanguage::Cpp(it), chapter));
        older != own
    }

    /// Returns true if it is a line of another edition in a program of this one.
    pub fn is_of_another_edition(&self, chapter: Chapter) -> bool {
        let line = |edition| self.line(ReaderLanguage::Cpp(edition), chapter);
        let [older, own] = [Edition::V3, Edition::V4].map(line);
        older.right == own.wrong
    }

    /// Counts the people who have reported that they made it.
    pub fn reports(&self) -> usize {
        self.reported
            .split(", ")
            .filter(|it| !it.is_empty())
            .count()
    }

    /// Returns the edits by which it is made in texts of the chapters.
    pub fn edits(&self) -> &[Edit] {
        &self.edits
    }

    /// Returns the edit by which it is made in the chapter's text, if that is one.
    pub fn only_edit(&self, chapter: Chapter) -> Option<&Edit> {
        let program = ChapterProgram::right(chapter);
        let mut standing = self.edits.iter().filter(|edit| program.has(edit));
        standing.next().filter(|_| standing.next().is_none())
    }

    /// Returns true if it can be made in the chapter's program.
    pub fn is_possible_in(&self, chapter: Chapter) -> bool {
        self.statement(chapter, Edition::V4).is_some()
    }

    /// Returns the chapters in which it can be made.
    pub fn chapters(&self) -> impl Iterator<Item = Chapter> {
        let chapters = Chapter::OF_THE_BOOK.into_iter();
        chapters.filter(|&chapter| self.is_possible_in(chapter))
    }

    /// Finds the file of this workspace that has the line right.
    pub fn source(&self) -> Option<String> {
        let chapter = self.chapters().next()?;
        let mut files = files(chapter).into_iter();
        let file = files.find(|it| self.stands_in(&it.text))?;
        Some(source(chapter, &file.name))
    }

    fn stands_in(&self, text: &str) -> bool {
        self.edits.iter().any(|edit| edit.stands_in(text))
    }

    /// Returns the program of someone who made this slip in that chapter.
    ///
    /// # Panics
    /// If it can't be made there.
    pub fn program(&self, chapter: Chapter) -> ChapterProgram {
        let name = self.name;
        assert!(
            self.is_possible_in(chapter),
            "{name} can't be made in {chapter:?}"
        );
        self.applied_to(&ChapterProgram::right(chapter))
    }

    /// Returns the program with this slip in it, if it can be made there.
    pub fn applied_to(&self, program: &ChapterProgram) -> ChapterProgram {
        let made = program.with_any(&self.edits);
        made.unwrap_or_else(|| program.clone())
    }

    /// Returns why nothing shows the slip in that chapter, or `None` if something does.
    pub fn why_unseen_in(&self, chapter: Chapter) -> Option<Unseen> {
        let is_seen = !self.revealing_probes(chapter)?.is_empty();
        (!is_seen).then_some(if self.law.is_empty() {
            Unseen::Equivalent(self.equivalent)
        } else {
            Unseen::OnlyByLaw(self.law)
        })
    }

    /// Returns the probes that show the slip in that chapter, or `None` if its own picture does.
    pub fn revealing_probes(&self, chapter: Chapter) -> Option<Vec<&'static str>> {
        let mut rows = kept(HIDDEN).map(str::split_whitespace);
        rows.find_map(|mut row| {
            let is_it = row.next() == Some(chapter.name()) && row.next() == Some(self.name);
            is_it.then(|| row.collect())
        })
    }

    /// Returns the first probe that shows the slip where a chapter's picture hides it.
    pub fn first_revealing_probe(&self) -> Option<&'static str> {
        let hidden = self
            .chapters()
            .filter_map(|it| self.revealing_probes(it))
            .flatten();
        let hidden: Vec<&str> = hidden.collect();
        let mut probes = PROBES.iter().map(|probe| probe.name);
        probes.find(|name| hidden.contains(name))
    }

    /// The page and its heading apart.
    pub fn page_and_heading(&self) -> (&'static str, &'static str) {
        self.page.split_once('#').unwrap_or((self.page, ""))
    }

    /// The page and its heading, as seen from another page.
    pub fn address(&self) -> String {
        self.page.replace('#', ".html#")
    }

    /// The page and its heading in words, where it can't be opened.
    pub fn page_in_words(&self) -> String {
        let (page, heading) = self.page_and_heading();
        format!("\"{}\", page {page} of the book", heading.replace('-', " "))
    }

    /// Returns true if its line is one of those that a reader of that chapter types.
    pub fn is_typed_in(&self, chapter: Chapter) -> bool {
        let mut files = chapter.files().iter();
        // A kind of number is no line.
        let is_line = self.edits.iter().all(|edit| !edit.is_precision());
        is_line && files.any(|(_, text)| self.stands_in(text))
    }
}
