//! Mutation operators: a slip is a known mistake, as a change of the right program, and
//! what there is to say of it.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::str::SplitWhitespace;
use std::sync::{LazyLock, Mutex, PoisonError};

use crate::chapter::Chapter;
use crate::edit::Edit;
use crate::edition::Edition;
use crate::letters::{Letters, in_chapter, in_cpp, in_python};
use crate::probes::PROBES;
use crate::program::{Program, files, source};
use crate::sight::kept;

/// The slips that the picture of a chapter hides at the book's width, and what probes show them:
/// drawn once, since that takes longer than a reader waits.
const HIDDEN: &str = include_str!("../tests/pictures/snapshots/pictures__hidden.snap");

/// A mistake that readers make, as an edit of the right line.
///
/// In which chapters it can be made, the texts of these say: wherever its line stands.
#[derive(Clone, Copy, Debug)]
pub struct Slip {
    /// What it is called, on the command line and in tables. It never changes. Empty where
    /// only laws look for it.
    pub name: &'static str,
    /// The page of the book and its heading that tell how it is right, as the end of an
    /// address: `half_b_sphere#two-observations`.
    pub page: &'static str,
    /// The right line in our Rust, as chapter 3 has it.
    pub(super) rust: &'static str,
    /// The line from a later chapter on, if that has another.
    pub(super) later: Option<(Chapter, &'static str)>,
    /// A part of the line, and what is typed in its place: `right→wrong`. The first whose
    /// part is in the line counts; no part is the whole line.
    pub(super) edits: &'static [&'static str],
    /// The edits of the texts, where a single one of this line is not all: those that stand in
    /// a text are made.
    pub(super) more: &'static [&'static str],
    /// The line in version 4 until then, if it can't be made of our Rust.
    pub(super) cpp: &'static str,
    /// The line in Python, if it can't be made of the book's.
    pub(super) python: &'static str,
    /// The line in editions before version 4, if it is another.
    pub(super) older: &'static str,
    /// What the mistake does to the picture, and why.
    pub(super) why: &'static str,
    /// The languages that let it be made: not all take a number for a truth, or -1.0 for a
    /// miss.
    pub(super) made_in: fn(Letters) -> bool,
    /// Who made it: issues of `RayTracing/raytracing.github.io`, or of another repository
    /// if that is named. Few people report a slip.
    pub(super) reported: &'static [&'static str],
    /// In which chapters neither picture nor probe shows it.
    pub(super) unseen_in: &'static [Chapter],
    /// Why nothing shows it there, or nothing but the law.
    pub(super) equivalent: &'static str,
    /// The law that shows it there.
    pub(super) law: &'static str,
}

/// What there is to say of a slip.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Words {
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
    /// a test puts to [`Program::hit_sphere`], [`Program::record`] or a ray.
    OnlyByLaw(&'static str),
}

/// A slip that changes nothing yet, and of which nothing is said.
pub(super) const SLIP: Slip = Slip {
    name: "",
    page: "",
    rust: "",
    later: None,
    edits: &[],
    more: &[],
    cpp: "",
    python: "",
    older: "",
    why: "",
    made_in: |_| true,
    reported: &[],
    unseen_in: &[],
    equivalent: "",
    law: "",
};

impl Slip {
    /// What there is to say of it to someone who made it in that chapter.
    pub fn words(&self, letters: Letters, chapter: Chapter) -> Words {
        let lines = self.lines(letters, chapter).unwrap_or_default();
        let [wrong, right] = lines.map(Cow::Owned);
        Words {
            wrong,
            right,
            why: self.why,
        }
    }

    /// The wrong line and the right one.
    fn lines(&self, letters: Letters, chapter: Chapter) -> Option<[String; 2]> {
        let later = self.later.filter(|(since, _)| *since <= chapter);
        let rust = later.map_or(self.rust, |(_, line)| line);
        let translated = |to: fn(&str, Chapter) -> String| {
            let both = self.edited(rust)?;
            Some(both.map(|line| to(&line, chapter)))
        };
        let is_older = letters.edition() != Edition::V4 && self.has_older_words();
        let own = match letters {
            Letters::Rust => translated(in_chapter)
                .filter(|[_, right]| stands_in(chapter, right))
                .or_else(|| self.edited(rust)),
            Letters::Python(_) if is_older => None,
            Letters::Python(_) => self.edited(self.python),
            Letters::Book(_) if is_older => self.edited(self.older),
            Letters::Book(_) if later.is_some() => translated(in_cpp),
            Letters::Book(_) => None,
        };
        own.or_else(|| match letters {
            Letters::Rust => self.lines(Letters::Book(Edition::V4), chapter),
            Letters::Python(edition) => {
                let both = self.lines(Letters::Book(edition), chapter)?;
                Some(both.map(|line| in_python(&line)))
            }
            Letters::Book(_) => self.edited(self.cpp).or_else(|| translated(in_cpp)),
        })
    }

    /// The line as it is mistyped, and as it is, if there is one that can be.
    fn edited(&self, line: &str) -> Option<[String; 2]> {
        let mut edits = self.edits.iter().filter_map(|edit| edit.split_once('→'));
        let (part, other) = edits.find(|(part, _)| line.contains(part))?;
        let part = if part.is_empty() { line } else { part };
        (!line.is_empty()).then(|| [line.replacen(part, other, 1), line.to_owned()])
    }

    /// The same, labeled, as every report shows it.
    pub fn rows(
        &self,
        letters: Letters,
        chapter: Chapter,
    ) -> [(&'static str, Cow<'static, str>); 3] {
        let Words { wrong, right, why } = self.words(letters, chapter);
        [
            ("probably", wrong),
            ("should be", right),
            ("why", why.into()),
        ]
    }

    /// Whether that language lets it be made.
    pub fn can_be_made_in(&self, letters: Letters) -> bool {
        (self.made_in)(letters)
    }

    /// Whether editions before version 4 have another line for it.
    pub fn has_older_words(&self) -> bool {
        !self.older.is_empty()
    }

    /// Whether it is a line of another edition in a program of this one.
    pub fn is_of_another_edition(&self, chapter: Chapter) -> bool {
        let line = |edition| self.lines(Letters::Book(edition), chapter);
        let [older, own] = [Edition::V3, Edition::V4].map(line);
        self.has_older_words() && older.map(|it| it[1].clone()) == own.map(|it| it[0].clone())
    }

    /// How many people have reported that they made it.
    pub fn reports(&self) -> usize {
        self.reported.len()
    }

    /// The edits by which it is made in the chapter's text.
    pub fn edits(&self, chapter: Chapter) -> Vec<Edit> {
        if !self.more.is_empty() {
            return self.more.iter().map(|it| Edit::written(it)).collect();
        }
        let lines = self.lines(Letters::Rust, chapter).into_iter();
        // The program prints numbers that are no bytes, too.
        let printed = |line: String| line.replace(" as u8", " as i32");
        let lines = lines.map(|both| both.map(printed));
        lines
            .map(|[wrong, right]| Edit::new(right, wrong))
            .collect()
    }

    /// The edit by which it is made in the chapter's text, if that is one.
    pub fn only_edit(&self, chapter: Chapter) -> Option<Edit> {
        let program = Program::right(chapter);
        let edits = self.edits(chapter).into_iter();
        let mut standing = edits.filter(|edit| program.has(edit));
        standing.next().filter(|_| standing.next().is_none())
    }

    /// Whether its line stands in the chapter's program.
    pub fn is_in(&self, chapter: Chapter) -> bool {
        /// By the slip's name and its reason, since not all have a name.
        type Known = BTreeMap<(&'static str, &'static str, Chapter), bool>;
        static KNOWN: LazyLock<Mutex<Known>> = LazyLock::new(Mutex::default);
        let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        let stands = || {
            let program = Program::right(chapter);
            self.edits(chapter).iter().any(|edit| program.has(edit))
        };
        *known
            .entry((self.name, self.why, chapter))
            .or_insert_with(stands)
    }

    /// The chapters in which it can be made.
    pub fn chapters(&self) -> impl Iterator<Item = Chapter> {
        let chapters = Chapter::OF_THE_BOOK.into_iter();
        chapters.filter(|&chapter| self.is_in(chapter))
    }

    /// The file of this workspace that has the line right.
    pub fn source(&self) -> Option<String> {
        let chapter = self.chapters().next()?;
        let edits = self.edits(chapter);
        let mut files = files(chapter).into_iter();
        let has_it = |(_, text): &(String, String)| edits.iter().any(|it| it.stands_in(text));
        let (name, _) = files.find(has_it)?;
        Some(source(chapter, &name))
    }

    /// The program of someone who made this slip in that chapter.
    pub fn program(&self, chapter: Chapter) -> Program {
        assert!(
            self.is_in(chapter),
            "{} can't be made in {chapter:?}",
            self.name
        );
        self.put_to(&Program::right(chapter))
    }

    /// The same program with this slip in it, if its line stands there.
    pub fn put_to(&self, program: &Program) -> Program {
        let made = program.with_any(&self.edits(program.chapter));
        made.unwrap_or_else(|| program.clone())
    }

    /// Why nothing shows the slip in that chapter, or `None` if something does.
    pub fn unseen_in(&self, chapter: Chapter) -> Option<Unseen> {
        let why = if self.law.is_empty() {
            Unseen::Equivalent(self.equivalent)
        } else {
            Unseen::OnlyByLaw(self.law)
        };
        self.unseen_in.contains(&chapter).then_some(why)
    }

    /// The probes that show the slip in that chapter, or `None` if its own picture does.
    pub fn hidden_in(&self, chapter: Chapter) -> Option<Vec<&'static str>> {
        let mut rows = kept(HIDDEN).map(str::split_whitespace);
        let is_it = |row: &mut SplitWhitespace<'static>| {
            row.next() == Some(chapter.name()) && row.next() == Some(self.name)
        };
        let probes = rows.find_map(|mut row| is_it(&mut row).then_some(row))?;
        Some(probes.collect())
    }

    /// The first probe that shows the slip where a chapter's picture hides it.
    pub fn shown_by(&self) -> Option<&'static str> {
        let hidden: Vec<_> = self
            .chapters()
            .filter_map(|it| self.hidden_in(it))
            .collect();
        let mut probes = PROBES.iter().map(|probe| probe.name);
        probes.find(|name| hidden.iter().any(|probes| probes.contains(name)))
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

    /// Whether its line is one of those that a reader of that chapter types.
    pub fn is_typed_in(&self, chapter: Chapter) -> bool {
        // A kind of number is no line.
        let mut edits = self.edits(chapter);
        edits.retain(|edit| !edit.is_precision());
        let mut files = chapter.files().iter();
        files.any(|(_, text)| edits.iter().any(|it| it.stands_in(text)))
    }
}

/// Whether that line stands in the chapter's program.
fn stands_in(chapter: Chapter, line: &str) -> bool {
    Program::right(chapter).has(&Edit::new(line.to_owned(), ""))
}
