//! Tree comparison: the statements of a reader's files, in any language, beside those of a chapter.

use language::{Op, Role, Tree, canonical};

use super::chapter_statement::{ChapterStatement, chapter_statements};
use super::transplant::Transplant;
use super::{LineStatus, SourceLine, TypedStatement};

/// Above this [likeness](super::likeness()) a line is one of the chapter's with a mistake in it.
const MISTAKEN: f64 = 0.75;

/// A chapter's statements beside those that a reader typed.
pub(crate) struct LineComparison<'a> {
    chapter: Vec<ChapterStatement>,
    typed: &'a [TypedStatement],
}

/// The statements that an edit takes from functions of a chapter, and those that it adds.
pub(crate) struct StatementDiff {
    lost: Vec<ChapterStatement>,
    added: Vec<ChapterStatement>,
}

/// A reader's line with a mistake, and what should be in its place.
#[derive(Clone, Debug)]
pub(crate) struct CorrectedLine {
    /// The line as it is.
    pub(crate) line: SourceLine,
    /// The right text in the reader's language and names; empty where nothing should be.
    pub(crate) right: String,
}

impl<'a> LineComparison<'a> {
    /// Takes a chapter's functions, each by its name and text, and a reader's statements.
    pub(crate) fn new<'f>(
        functions: impl Iterator<Item = (&'f str, &'f str)>,
        typed: &'a [TypedStatement],
    ) -> Self {
        let chapter = functions.flat_map(|(name, text)| chapter_statements(name, text));
        Self {
            chapter: chapter.collect(),
            typed,
        }
    }

    /// Returns true if the reader's statements are not known.
    pub(crate) fn is_empty(&self) -> bool {
        self.typed.is_empty()
    }

    /// Counts the chapter's statements that the reader has typed too.
    pub(crate) fn count(&self) -> usize {
        let is_typed = |it: &&ChapterStatement| self.times_typed(it) > 0;
        self.chapter.iter().filter(is_typed).count()
    }

    /// Tells whether the reader has made an edit of the chapter. The edit is made if a statement
    /// that it adds is typed more often than it occurs in the chapter, and not made if one that it
    /// takes is typed as often as there; or, if it adds none, a similar one is typed in the place.
    pub(crate) fn status(&self, edit: &StatementDiff) -> LineStatus {
        let stands = |it: &ChapterStatement| {
            let stands = |own: &&ChapterStatement| {
                it.is_said_by(&own.role, own.pattern.tree(), &self.chapter)
            };
            self.chapter.iter().filter(stands).count()
        };
        let is_right =
            |it: &ChapterStatement| self.times_typed(it) > 0 && self.times_typed(it) >= stands(it);
        // If a line is left out, none that is much like it stands in its place.
        let is_mistaken =
            |it: &ChapterStatement| edit.added.is_empty() && self.closest(it) > MISTAKEN;
        if edit.lost.iter().any(|it| is_right(it) || is_mistaken(it)) {
            LineStatus::Right
        } else if edit
            .added
            .iter()
            .any(|it| self.times_typed(it) > stands(it))
        {
            LineStatus::Wrong
        } else {
            LineStatus::NotFound
        }
    }

    /// Finds the reader's line that says what an edit adds, and corrects it by what the edit takes.
    pub(crate) fn corrected(&self, edit: &StatementDiff) -> Option<CorrectedLine> {
        edit.added.iter().find_map(|wrong| {
            let is_it =
                |it: &&TypedStatement| wrong.is_said_by(&it.role, &it.normal, &self.chapter);
            let typed = self.typed.iter().find(is_it)?;
            let right = edit.lost.iter().find(|it| it.role == wrong.role);
            let right = right.or(edit.lost.first()).map(|right| {
                let found = wrong.pattern.find(&typed.normal);
                right.spelled_as(typed, &found.map_or(Vec::new(), |it| it.renames))
            });
            Some(CorrectedLine {
                line: typed.line.clone(),
                right: right.unwrap_or_default(),
            })
        })
    }

    /// Counts the reader's statements that say what a statement says, and all of it.
    fn times_typed(&self, statement: &ChapterStatement) -> usize {
        let says = |it: &&TypedStatement| {
            statement.is_said_by(&it.role, &it.normal, &self.chapter)
                && !self.is_computed_before(statement, it)
        };
        self.typed.iter().filter(says).count()
    }

    /// Returns true if the reader computes before what the chapter's statement has as a variable,
    /// which no statement of the chapter computes: then the reader's line is only a part of it.
    fn is_computed_before(&self, statement: &ChapterStatement, typed: &TypedStatement) -> bool {
        let Some(found) = statement.pattern.find(&typed.normal) else {
            return false;
        };
        let is_of =
            |role: &Role, name: &str| matches!(role, Role::ValueOf(own) if canonical(own) == name);
        let is_sum = |it: &&Tree| matches!(it.op, Op::Operator(_)) || it.is_call("sqrt");
        let computes = |name: &str| {
            let mut all = self.typed.iter();
            all.any(|it| {
                is_of(&it.role, name)
                    && it.line.file == typed.line.file
                    && it.normal.nodes().iter().any(is_sum)
            })
        };
        let is_given = |name: &str| self.chapter.iter().any(|it| is_of(&it.role, name));
        let mut renamed = found.renames.iter().filter(|it| it.from != it.to);
        renamed.any(|it| !is_given(&it.from) && computes(&it.to))
    }

    /// Returns the greatest likeness of a statement to a line that the chapter does not have; 0 if
    /// there is no such line.
    fn closest(&self, statement: &ChapterStatement) -> f64 {
        let foreign = self.foreign().into_iter();
        let like = foreign.map(|it| statement.likeness(&it.normal));
        like.fold(0.0, f64::max)
    }

    /// Lists the reader's statements that the chapter does not have.
    fn foreign(&self) -> Vec<&'a TypedStatement> {
        let is_right = |it: &TypedStatement| {
            let mut all = self.chapter.iter();
            all.any(|own| own.is_said_by(&it.role, &it.normal, &self.chapter))
        };
        self.typed.iter().filter(|it| !is_right(it)).collect()
    }

    /// Replaces each statement that only the chapter has by those that only the reader has and that
    /// are most like it, one at a time.
    pub(crate) fn transplants(&self) -> Vec<Transplant> {
        let foreign = self.foreign();
        let missing = self.chapter.iter().filter(|it| self.times_typed(it) == 0);
        let all = missing.flat_map(|it| it.transplants(&foreign));
        all.collect()
    }
}

impl StatementDiff {
    /// Compares functions, each given by its name, its text, and its text with an edit.
    pub(crate) fn of<'f>(functions: impl Iterator<Item = (&'f str, &'f str, &'f str)>) -> Self {
        let (mut lost, mut added) = (Vec::new(), Vec::new());
        for (name, right, wrong) in functions {
            let [right, wrong] = [right, wrong].map(|text| chapter_statements(name, text));
            let only = |one: &[ChapterStatement], other: &[ChapterStatement]| {
                let is_in_one =
                    |it: &&ChapterStatement| !other.iter().any(|other| it.is_same(other));
                one.iter().filter(is_in_one).cloned().collect::<Vec<_>>()
            };
            lost.extend(only(&right, &wrong));
            added.extend(only(&wrong, &right));
        }
        Self { lost, added }
    }

    /// Returns true if functions, each given by its name and text, have all statements that the
    /// edit adds, and the edit adds some.
    pub(crate) fn is_made_in<'f>(
        &self,
        functions: impl Iterator<Item = (&'f str, &'f str)>,
    ) -> bool {
        let all = functions.flat_map(|(name, text)| chapter_statements(name, text));
        let all: Vec<ChapterStatement> = all.collect();
        let mut added = self.added.iter();
        !self.added.is_empty() && added.all(|it| all.iter().any(|other| it.is_same(other)))
    }
}
