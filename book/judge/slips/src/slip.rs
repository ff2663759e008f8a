//! Mutation operators: a slip is a known mistake, as a change of the right program, and
//! what there is to say of it.

use std::borrow::Cow;

use crate::chapter::Chapter;
use crate::edition::Edition;
use crate::letters::{Letters, in_chapter, in_cpp, in_python};
use crate::program::Program;

/// A mistake that readers make, as an edit of the right line.
///
/// What it draws comes from a step of the [`Program`] and not from the interpreted text: a
/// judge draws thousands of pairs of slips while a reader waits.
#[derive(Clone, Copy, Debug)]
pub struct Slip {
    /// What it is called, on the command line and in tables. It never changes. Empty where
    /// only laws look for it.
    pub name: &'static str,
    /// The chapters in which it can be made.
    pub chapters: &'static [Chapter],
    /// The page of the book and its heading that tell how it is right, as the end of an
    /// address: `half_b_sphere#two-observations`.
    pub page: &'static str,
    /// The file of this workspace that has the line right.
    pub source: &'static str,
    /// Of what program the line is a part.
    pub(super) part: Part,
    /// The right line in our Rust, as chapter 3 has it.
    pub(super) rust: &'static str,
    /// The line from a later chapter on, if that has another.
    pub(super) later: Option<(Chapter, &'static str)>,
    /// The line in version 4 until then, if it can't be made of our Rust.
    pub(super) cpp: &'static str,
    /// The line in Python, if it can't be made of the book's.
    pub(super) python: &'static str,
    /// The line in editions before version 4, if it is another.
    pub(super) older: &'static str,
    /// A part of the line, and what is typed in its place: `right→wrong`. The first whose
    /// part is in the line counts; no part is the whole line.
    pub(super) edits: &'static [&'static str],
    /// Whether it stands in a second line as well: to make it, both are mistyped.
    pub is_in_two_places: bool,
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
    /// Replaces the steps of a program.
    pub(super) alter: fn(&mut Program),
}

/// Of what program a line is a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// A chapter.
    Chapter,
    /// The camera's sizes, which earlier editions than 3.1 print as numbers.
    Sizes,
    /// What else all chapters share.
    Prelude,
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
    /// a test puts to [`Program::hit_sphere`], [`Program::hit`] or a ray.
    OnlyByLaw(&'static str),
}

/// A slip that changes nothing yet, and of which nothing is said.
pub(super) const SLIP: Slip = Slip {
    name: "",
    chapters: &[],
    page: "",
    source: "",
    part: Part::Chapter,
    rust: "",
    later: None,
    cpp: "",
    python: "",
    older: "",
    edits: &[],
    is_in_two_places: false,
    why: "",
    made_in: |_| true,
    reported: &[],
    unseen_in: &[],
    equivalent: "",
    law: "",
    alter: |_| {},
};

impl Slip {
    /// What there is to say of it to someone who made it in that chapter.
    pub fn words(&self, letters: Letters, chapter: Chapter) -> Words {
        let [wrong, right] = self.lines(letters, chapter).map(Cow::Owned);
        Words {
            wrong,
            right,
            why: self.why,
        }
    }

    /// The wrong line and the right one.
    fn lines(&self, letters: Letters, chapter: Chapter) -> [String; 2] {
        let later = self.later.filter(|(since, _)| *since <= chapter);
        let rust = later.map_or(self.rust, |(_, line)| line);
        let translated = |to: fn(&str, Chapter) -> String| {
            let both = self.edited(rust)?;
            Some(both.map(|line| to(&line, chapter)))
        };
        let is_older = letters.edition() != Edition::V4 && self.has_older_words();
        let own = match letters {
            Letters::Rust if self.part == Part::Chapter => translated(in_chapter),
            Letters::Rust => self.edited(rust),
            Letters::Python(_) if is_older => None,
            Letters::Python(_) => self.edited(self.python),
            Letters::Book(_) if is_older => self.edited(self.older),
            Letters::Book(_) if later.is_some() => translated(in_cpp),
            Letters::Book(_) => None,
        };
        own.unwrap_or_else(|| match letters {
            Letters::Rust => self.lines(Letters::Book(Edition::V4), chapter),
            Letters::Python(edition) => {
                let both = self.lines(Letters::Book(edition), chapter);
                both.map(|line| in_python(&line))
            }
            Letters::Book(_) => {
                let both = self.edited(self.cpp).or_else(|| translated(in_cpp));
                both.expect("an edit fits the line")
            }
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
    pub fn is_of_another_edition(&self) -> bool {
        let [_, older] = self.lines(Letters::Book(Edition::V3), self.chapters[0]);
        let [wrong, _] = self.lines(Letters::Book(Edition::V4), self.chapters[0]);
        self.has_older_words() && older == wrong
    }

    /// How many people have reported that they made it.
    pub fn reports(&self) -> usize {
        self.reported.len()
    }

    /// The program of someone who made this slip in that chapter.
    pub fn program(&self, chapter: Chapter) -> Program {
        assert!(
            self.chapters.contains(&chapter),
            "{} can't be made in {chapter:?}",
            self.name
        );
        self.put_to(Program::right(chapter))
    }

    /// The same program with this slip in it.
    pub fn put_to(&self, mut program: Program) -> Program {
        (self.alter)(&mut program);
        program
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

    /// Whether the line is in a chapter, and not in what all of them share.
    pub fn is_in_a_chapter(&self) -> bool {
        self.part == Part::Chapter
    }

    /// Whether it is made where version 3.1 and later ones compute sizes, and earlier ones print
    /// them as numbers.
    pub fn is_of_the_size(&self) -> bool {
        self.part == Part::Sizes
    }
}
