//! Mutation operators: known mistakes, here called slips, as edits of the judge's texts of the
//! chapters, each with its explanation.

use std::collections::BTreeMap;
use std::sync::{LazyLock, Mutex, PoisonError};

use crate::chapter::Chapter;
use crate::code::ChapterCode;
use crate::edit::Edit;
use crate::probes::PROBES;
use crate::program::ChapterProgram;

/// A line for each chapter and slip where the wrong picture equals the right one at the book's
/// width: both names, then those of the probes that show the slip. A test draws them all, which
/// takes longer than a reader waits.
const HIDDEN: &str = include_str!("../tests/pictures/snapshots/pictures__hidden.snap");

/// A known mistake of readers: the edits of the judge's texts that make it, and its explanation. A
/// paragraph of `catalogue.txt`, whose first lines explain the fields.
///
/// The mistake can be made in every chapter that has the right code of one of the edits.
#[derive(Clone, Debug, Default)]
pub struct Slip {
    /// The name of the slip on the command line and in tables, `minus-h`; it never changes. Empty
    /// for a slip that is not shown there, one of [`unnamed`](crate::unnamed).
    pub name: &'static str,
    /// The page of this workspace's book, and the heading there, that explain the right code, as
    /// the end of an address: `half_b_sphere#two-observations`.
    pub page: &'static str,
    /// A sentence about the effect of the slip on the picture, and its reason.
    pub why: &'static str,
    /// The version by which it is no mistake, in words: `by version 3 of the book`. Empty for a
    /// mistake.
    pub right: &'static str,
    /// The edits, right to wrong; one or more of them occur in each chapter that has the line.
    pub(super) edits: Vec<Edit>,
    /// The issues that report the slip, with `, ` between them.
    pub(super) reported: &'static str,
    /// The languages that let the slip be made, with `, ` between them; empty if Rust does, too.
    pub(super) only_in: &'static str,
    /// The proof that no picture shows the slip, or empty.
    pub(super) equivalent: &'static str,
    /// The law that shows the slip where no picture does, or empty.
    pub(super) law: &'static str,
    /// The line in Rust, where the statement that the edits change does not show it.
    pub(super) rust: ChapterLines,
    /// The line in C++, where it is not that in Rust.
    pub(super) cpp: ChapterLines,
}

/// A line of code, right and wrong, by the chapters that have it.
#[derive(Clone, Debug, Default)]
pub(super) struct ChapterLines(Vec<(usize, Edit)>);

/// The languages in which the line of a slip is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Languages {
    /// The book's C++ and Rust, to a reader whose language is not known.
    #[default]
    Both,
    /// Only Rust, to a reader who types the chapters as they are here.
    Rust,
}

/// The reason why a [`Slip`] (known mistake) changes neither the picture of a chapter nor that of a
/// [`Probe`](crate::Probe), a changed scene: no scene shows it, or only a law does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unseen {
    /// The program with the slip draws the right pictures for any scene. The text proves this.
    Equivalent(&'static str),
    /// Only a ray that no camera of these chapters casts shows the slip. The text is the law that
    /// the slip breaks.
    OnlyByLaw(&'static str),
}

impl ChapterLines {
    /// Adds a line of the catalogue: `label` is `C++`, or `C++ 4` for chapter 4 and those after it.
    pub(super) fn add(&mut self, label: &str, line: &'static str) {
        let first = label.split_once(' ').map_or("0", |it| it.1);
        let first = first
            .parse()
            .expect("a line begins with the number of a chapter");
        self.0.push((first, Edit::parse(line)));
    }

    /// Returns the line of a chapter; `None` if the catalogue has none.
    fn of(&self, chapter: Chapter) -> Option<&Edit> {
        let mut lines = self.0.iter().rev();
        lines.find(|it| it.0 <= chapter as usize).map(|it| &it.1)
    }
}

impl Slip {
    /// Returns the line of the slip, wrong and right, in a chapter: in the C++ of the book's version
    /// 4 and in Rust, or in one of them where both are the same or only Rust is asked for.
    ///
    /// # Panics
    /// If the slip can't be made in the chapter.
    pub fn lines_in(&self, languages: Languages, chapter: Chapter) -> Vec<Edit> {
        let made = || self.statement(chapter).expect("the slip can be made there");
        let rust = self.rust.of(chapter).cloned().unwrap_or_else(made);
        let cpp = self
            .cpp
            .of(chapter)
            .filter(|_| languages == Languages::Both);
        cpp.cloned().into_iter().chain([rust]).collect()
    }

    /// Finds the statement that the slip changes in a chapter, right and wrong, each on one line.
    fn statement(&self, chapter: Chapter) -> Option<Edit> {
        /// Statements that were found, by the slip's name and reason, since some have no name.
        type Known = BTreeMap<(&'static str, &'static str, Chapter), Option<Edit>>;
        static KNOWN: LazyLock<Mutex<Known>> = LazyLock::new(Mutex::default);
        let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        let statement = || ChapterProgram::right(chapter).statement_with(&self.edits);
        let key = (self.name, self.why, chapter);
        known.entry(key).or_insert_with(statement).clone()
    }

    /// Returns true if Rust lets the slip be made. It accepts no number as a condition, for
    /// instance, as C++ does.
    pub fn is_possible_in_rust(&self) -> bool {
        self.only_in.is_empty()
    }

    /// Returns the number of issues in which people report that they made the slip; 0 if none is
    /// known.
    pub fn report_count(&self) -> usize {
        self.reported
            .split(", ")
            .filter(|it| !it.is_empty())
            .count()
    }

    /// Returns the edits of the judge's texts that make the slip. In one chapter only those can be
    /// made whose right code occurs in its text.
    pub fn edits(&self) -> &[Edit] {
        &self.edits
    }

    /// Returns true if the slip can be made in the program of a chapter.
    ///
    /// # Panics
    /// If the chapter is not one of [`Chapter::OF_THE_BOOK`].
    pub fn is_possible_in(&self, chapter: Chapter) -> bool {
        self.statement(chapter).is_some()
    }

    /// Lists the chapters of the book, 0 to 5, in which the slip can be made, in reading order.
    pub fn chapters(&self) -> impl Iterator<Item = Chapter> {
        let chapters = Chapter::OF_THE_BOOK.into_iter();
        chapters.filter(|&chapter| self.is_possible_in(chapter))
    }

    /// Returns true if the right code of one of the edits occurs in a text.
    fn stands_in(&self, text: &str) -> bool {
        self.edits.iter().any(|edit| edit.stands_in(text))
    }

    /// Returns the program of a chapter with this slip and no other.
    ///
    /// # Panics
    /// If the slip can't be made in the chapter.
    pub fn program(&self, chapter: Chapter) -> ChapterProgram {
        let name = self.name;
        assert!(
            self.is_possible_in(chapter),
            "{name} can't be made in {chapter:?}"
        );
        self.applied_to(&ChapterProgram::right(chapter))
    }

    /// Returns a program with this slip made in it, besides mistakes that it already has; the
    /// program as it is if the slip can't be made there.
    pub fn applied_to(&self, program: &ChapterProgram) -> ChapterProgram {
        let made = program.with_any(&self.edits);
        made.unwrap_or_else(|| program.clone())
    }

    /// Returns the reason why no picture shows the slip in a chapter; `None` if the chapter's
    /// picture or a probe (a changed scene) shows it, or if it can't be made in the chapter.
    pub fn why_unseen_in(&self, chapter: Chapter) -> Option<Unseen> {
        let is_seen = !self.revealing_probes(chapter)?.is_empty();
        (!is_seen).then_some(if self.law.is_empty() {
            Unseen::Equivalent(self.equivalent)
        } else {
            Unseen::OnlyByLaw(self.law)
        })
    }

    /// Returns the names of the probes (changed scenes) that show the slip in a chapter whose own
    /// picture hides it, in the order of [`PROBES`]; empty if no probe does. `None` if the
    /// chapter's picture shows the slip, or if the slip can't be made in the chapter.
    pub fn revealing_probes(&self, chapter: Chapter) -> Option<Vec<&'static str>> {
        // Below the header that insta writes between lines of dashes.
        let rows = HIDDEN.splitn(3, "---\n").nth(2).unwrap_or_default();
        let mut rows = rows.lines().map(str::split_whitespace);
        rows.find_map(|mut row| {
            let is_it = row.next() == Some(chapter.name()) && row.next() == Some(self.name);
            is_it.then(|| row.collect())
        })
    }

    /// Returns the name of the first of [`PROBES`] that shows the slip in at least one chapter whose
    /// own picture hides it; `None` if there is none.
    pub fn first_revealing_probe(&self) -> Option<&'static str> {
        let hidden = self
            .chapters()
            .filter_map(|it| self.revealing_probes(it))
            .flatten();
        let hidden: Vec<&str> = hidden.collect();
        let mut probes = PROBES.iter().map(|probe| probe.name);
        probes.find(|name| hidden.contains(name))
    }

    /// Splits [`page`](Self::page) at its `#`: the name of the page, `half_b_sphere`, and the
    /// heading, `two-observations`, which is empty if there is none.
    pub fn page_and_heading(&self) -> (&'static str, &'static str) {
        self.page.split_once('#').unwrap_or((self.page, ""))
    }

    /// Returns [`page`](Self::page) as a link from another page of the book:
    /// `half_b_sphere.html#two-observations`.
    pub fn page_link(&self) -> String {
        self.page.replace('#', ".html#")
    }

    /// Returns [`page`](Self::page) in words, for a terminal: `"two observations", page
    /// half_b_sphere of the book`.
    pub fn page_in_words(&self) -> String {
        let (page, heading) = self.page_and_heading();
        format!("\"{}\", page {page} of the book", heading.replace('-', " "))
    }

    /// Returns true if the right code of the slip occurs in a file that a reader of a chapter
    /// types. False for a slip that changes the precision of all numbers.
    pub fn is_typed_in(&self, chapter: Chapter) -> bool {
        let mut files = chapter.files().iter();
        // The precision of all numbers is no line.
        let is_line = self.edits.iter().all(|edit| !edit.is_precision());
        is_line && files.any(|file| self.stands_in(file.text))
    }
}
