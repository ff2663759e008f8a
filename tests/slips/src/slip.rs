//! A slip: a mutation of the right program, and what there is to say about it.

use std::path::{Path, PathBuf};

use super::program::Program;
use crate::chapter::Chapter;
use crate::edition::Edition;

/// A mistake: the right program with one step replaced.
#[derive(Clone, Copy, Debug)]
pub struct Slip {
    /// What it is called, on the command line and in tables. It never changes.
    pub name: &'static str,
    /// The chapters in which it can be made.
    pub chapters: &'static [Chapter],
    /// What the code probably says, in no particular language.
    pub wrong: &'static str,
    /// What it should say.
    pub right: &'static str,
    /// Why that is wrong, and what it does to the picture.
    pub explanation: &'static str,
    /// The same three for who follows an edition before version 4, where they are
    /// others.
    pub before_4: Option<[&'static str; 3]>,
    /// Who made it: issues of `RayTracing/raytracing.github.io`, or of another
    /// repository if that is named. Often empty: few people report a slip.
    pub evidence: &'static [&'static str],
    /// The page of the book and its heading that tell how it is right, as the
    /// end of an address: `half_b_sphere#two-observations`.
    pub page: &'static str,
    /// The file of this workspace that has the line right.
    pub source: &'static str,
    /// Replaces the step.
    pub alter: fn(Program) -> Program,
    /// Where no picture and no probe shows it, with the reason.
    pub unseen: &'static [(&'static [Chapter], Unseen)],
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

/// What there is to say of a slip in one edition: what the code probably says, what it
/// should say, and why.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words {
    /// What the code probably says.
    pub wrong: &'static str,
    /// What it should say.
    pub right: &'static str,
    /// Why, and what it does to the picture.
    pub explanation: &'static str,
}

impl Slip {
    /// What most slips have in common; the rest is empty.
    pub(super) const USUAL: Self = Self {
        name: "",
        chapters: &[],
        wrong: "",
        right: "",
        explanation: "",
        before_4: None,
        evidence: &[],
        page: "",
        source: "",
        alter: |right| right,
        unseen: &[],
    };

    /// What there is to say of it to someone who follows that edition.
    pub fn words(&self, edition: Edition) -> Words {
        let [wrong, right, explanation] = match self.before_4 {
            Some(words) if edition != Edition::V4 => words,
            _ => [self.wrong, self.right, self.explanation],
        };
        Words {
            wrong,
            right,
            explanation,
        }
    }

    /// The program of someone who made this slip in that chapter.
    pub fn program(&self, chapter: Chapter) -> Program {
        assert!(
            self.chapters.contains(&chapter),
            "{} can't be made in {chapter:?}",
            self.name
        );
        (self.alter)(Program::right(chapter))
    }

    /// Where `cargo rtrace book` puts the page that tells how it is right, as seen
    /// from the workspace.
    pub fn read(&self) -> String {
        format!("target/book/{}", self.address())
    }

    /// The page that tells how it is right, and its heading, as seen from another page.
    pub fn address(&self) -> String {
        self.page.replace('#', ".html#")
    }

    /// Whether the line is in a chapter, and not in what all of them share.
    pub fn is_in_a_chapter(&self) -> bool {
        self.source.starts_with("chapters/")
    }

    /// Why nothing shows the slip in that chapter, or `None` if something does.
    pub fn unseen_in(&self, chapter: Chapter) -> Option<Unseen> {
        self.unseen
            .iter()
            .find(|(chapters, _)| chapters.contains(&chapter))
            .map(|&(_, why)| why)
    }

    /// The page of the book that tells how it is right, with the heading, if the book was
    /// woven in that workspace.
    pub fn page_in(&self, workspace: &Path) -> Option<PathBuf> {
        let path = workspace.join(self.read());
        let (file, _) = path.to_str()?.rsplit_once('#')?;
        Path::new(file).is_file().then_some(path)
    }

    /// The file that has the line right, if it is in that workspace.
    pub fn source_in(&self, workspace: &Path) -> Option<PathBuf> {
        Some(workspace.join(self.source)).filter(|file| file.is_file())
    }

    /// The page and its heading in words, for whoever can't open it.
    pub fn page_in_words(&self) -> String {
        let (page, heading) = self.page.split_once('#').unwrap_or((self.page, ""));
        format!(
            "\"{}\", on the page {page} of the book",
            heading.replace('-', " ")
        )
    }
}
