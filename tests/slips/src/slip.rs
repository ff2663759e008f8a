//! Mutation operators: a slip is a known mistake, as a change of the right program, and
//! what there is to say of it.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use crate::chapter::Chapter;
use crate::edition::Edition;
use crate::letters::{Letters, in_python};
use crate::program::{Interpreted, Program};

/// A mistake that readers make, as a change of the program without it.
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
    words: Words<&'static str>,
    /// The words for those who follow an edition before version 4, where they are others.
    before_4: Option<Words<&'static str>>,
    /// Lines in other letters, or of one chapter. The first that fits is said.
    lines: [Option<Line>; 4],
    made_in: fn(Letters) -> bool,
    reported: &'static [&'static str],
    alter: fn(&mut Program),
    /// What runs in place of the chapter, if it is a text of it with a change.
    code: Option<&'static dyn Interpreted>,
    /// In which chapters neither picture nor probe shows it, and why.
    unseen: Option<(&'static [Chapter], Unseen)>,
}

/// The heading about the sizes of picture and viewport.
pub(super) const SIZES: &str = "gradient#how-large-is-the-picture";

/// Where a line is right: see the fields of [`Slip`].
pub(super) struct Place {
    pub(super) page: &'static str,
    pub(super) source: &'static str,
}

/// What there is to say of a slip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words<Line = Cow<'static, str>> {
    /// What the code probably says.
    pub wrong: Line,
    /// What it should say.
    pub right: Line,
    /// Why, and what the mistake does to the picture.
    pub why: &'static str,
}

/// What the code of some chapters says, and what it should say.
#[derive(Clone, Copy, Debug)]
struct Line {
    letters: Letters,
    chapters: &'static [Chapter],
    wrong: &'static str,
    right: &'static str,
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
pub(super) const fn slip(name: &'static str, chapters: &'static [Chapter], place: Place) -> Slip {
    Slip {
        name,
        chapters,
        page: place.page,
        source: place.source,
        words: Words {
            wrong: "",
            right: "",
            why: "",
        },
        before_4: None,
        lines: [None; 4],
        made_in: |_| true,
        reported: &[],
        alter: |_| {},
        code: None,
        unseen: None,
    }
}

/// A mistake in a function that has no name, and no page of its own.
pub(super) const fn unnamed(chapters: &'static [Chapter]) -> Slip {
    let nowhere = Place {
        page: "",
        source: "",
    };
    slip("", chapters, nowhere)
}

/// The parts of an entry in the catalogue.
impl Slip {
    pub(super) const fn says(mut self, words: Words<&'static str>) -> Self {
        self.words = words;
        self
    }

    pub(super) const fn before_4(mut self, words: Words<&'static str>) -> Self {
        self.before_4 = Some(words);
        self
    }

    /// What version 4 says in these chapters, where others have b for h.
    pub(super) const fn in_book(
        self,
        chapters: &'static [Chapter],
        wrong: &'static str,
        right: &'static str,
    ) -> Self {
        self.line(Letters::Book(Edition::V4), chapters, wrong, right)
    }

    /// What our own chapters say, token by token where that can be.
    pub(super) const fn in_rust(
        self,
        chapters: &'static [Chapter],
        wrong: &'static str,
        right: &'static str,
    ) -> Self {
        self.line(Letters::Rust, chapters, wrong, right)
    }

    /// What Python says, where [`Letters::Python`] can't be made of the book's words.
    pub(super) const fn in_python(self, wrong: &'static str, right: &'static str) -> Self {
        self.line(
            Letters::Python(Edition::V4),
            &Chapter::OF_THE_BOOK,
            wrong,
            right,
        )
    }

    const fn line(
        mut self,
        letters: Letters,
        chapters: &'static [Chapter],
        wrong: &'static str,
        right: &'static str,
    ) -> Self {
        let mut free = 0;
        while self.lines[free].is_some() {
            free += 1;
        }
        self.lines[free] = Some(Line {
            letters,
            chapters,
            wrong,
            right,
        });
        self
    }

    /// In which languages alone it can be made: not all take a number for a truth, or -1.0
    /// for a miss.
    pub(super) const fn made_in(mut self, made_in: fn(Letters) -> bool) -> Self {
        self.made_in = made_in;
        self
    }

    /// Who made it: issues of `RayTracing/raytracing.github.io`, or of another repository
    /// if that is named. Few people report a slip.
    pub(super) const fn reported(mut self, issues: &'static [&'static str]) -> Self {
        self.reported = issues;
        self
    }

    pub(super) const fn alters(mut self, alter: fn(&mut Program)) -> Self {
        self.alter = alter;
        self
    }

    pub(super) const fn equivalent(
        mut self,
        chapters: &'static [Chapter],
        proof: &'static str,
    ) -> Self {
        self.unseen = Some((chapters, Unseen::Equivalent(proof)));
        self
    }

    pub(super) const fn only_by_law(
        mut self,
        chapters: &'static [Chapter],
        law: &'static str,
    ) -> Self {
        self.unseen = Some((chapters, Unseen::OnlyByLaw(law)));
        self
    }
}

impl Line {
    fn said(&self) -> [&'static str; 2] {
        [self.wrong, self.right]
    }
}

impl Slip {
    /// A change in the text of a chapter, which has no name and no page.
    pub fn interpreted(
        chapter: Chapter,
        source: &'static str,
        words: Words<&'static str>,
        code: &'static dyn Interpreted,
    ) -> Self {
        static CHAPTERS: [Chapter; 7] = Chapter::ALL;
        let at = chapter as usize;
        Self {
            source,
            code: Some(code),
            ..unnamed(&CHAPTERS[at..=at]).says(words)
        }
    }

    /// What there is to say of it to someone who made it in that chapter.
    pub fn words(&self, letters: Letters, chapter: Chapter) -> Words {
        let older = match letters {
            Letters::Book(edition) | Letters::Python(edition) if edition != Edition::V4 => {
                self.before_4
            }
            _ => None,
        };
        // Lines of one language or some chapters are version 4's.
        let own = |wanted: Letters| {
            let mut lines = self.lines.iter().flatten().filter(|_| older.is_none());
            lines.find(|line| line.letters == wanted && line.chapters.contains(&chapter))
        };
        let line = match letters {
            Letters::Python(_) => own(Letters::Python(Edition::V4)),
            _ => own(letters),
        };
        let Words { wrong, right, why } = older.unwrap_or(self.words);
        let book = own(Letters::Book(Edition::V4)).map_or([wrong, right], Line::said);
        let [wrong, right] = match (line, letters) {
            (Some(line), _) => line.said().map(Cow::Borrowed),
            (None, Letters::Python(_)) => book.map(|said| Cow::Owned(in_python(said))),
            (None, Letters::Rust) => book.map(Cow::Borrowed),
            (None, Letters::Book(_)) => [wrong, right].map(Cow::Borrowed),
        };
        Words { wrong, right, why }
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
        self.before_4.is_some()
    }

    /// Whether it is a line of another edition in a program of this one.
    pub fn is_of_another_edition(&self) -> bool {
        self.before_4
            .is_some_and(|before| before.right == self.words.wrong)
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
        program.code = self.code.or(program.code);
        program
    }

    /// Why nothing shows the slip in that chapter, or `None` if something does.
    pub fn unseen_in(&self, chapter: Chapter) -> Option<Unseen> {
        self.unseen
            .filter(|(chapters, _)| chapters.contains(&chapter))
            .map(|(_, why)| why)
    }

    /// The page and its heading apart.
    pub fn page_and_heading(&self) -> (&'static str, &'static str) {
        self.page.split_once('#').unwrap_or((self.page, ""))
    }

    /// The page and its heading, as seen from another page.
    pub fn address(&self) -> String {
        self.page.replace('#', ".html#")
    }

    /// Where `cargo rtrace book` puts the page, as seen from the workspace.
    pub fn read(&self) -> String {
        format!("target/book/{}", self.address())
    }

    /// The page and its heading in words, where it can't be opened.
    pub fn page_in_words(&self) -> String {
        let (page, heading) = self.page_and_heading();
        format!(
            "\"{}\", on the page {page} of the book",
            heading.replace('-', " ")
        )
    }

    /// The page with the heading, if the book was woven in that workspace.
    pub fn page_in(&self, workspace: &Path) -> Option<PathBuf> {
        let path = workspace.join(self.read());
        let (file, _) = path.to_str()?.rsplit_once('#')?;
        Path::new(file).is_file().then_some(path)
    }

    /// Whether the line is in a chapter, and not in what all of them share.
    pub fn is_in_a_chapter(&self) -> bool {
        self.source.starts_with("chapters/")
    }

    /// Whether it is made in the camera, which no two editions have the same.
    pub fn is_of_the_camera(&self) -> bool {
        self.source.ends_with("camera.rs")
    }

    /// Whether it is made where version 3.1 and later ones compute sizes, and earlier ones print
    /// them as numbers.
    pub fn is_of_the_size(&self) -> bool {
        self.page == SIZES
    }

    /// The file that has the line right, if it is in that workspace.
    pub fn source_in(&self, workspace: &Path) -> Option<PathBuf> {
        Some(workspace.join(self.source)).filter(|file| file.is_file())
    }
}
