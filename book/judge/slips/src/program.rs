//! Mutation of source text: a chapter's whole program, which the interpreter runs, and edits of it.

use std::sync::OnceLock;

use crate::chapter::Chapter;
use crate::edit::Edit;
use crate::files::program_files;

/// The whole program of a chapter, which the interpreter runs: right, with edits that make
/// mistakes, or as a reader typed it.
#[derive(Clone, Debug)]
pub struct ChapterProgram {
    /// The chapter that the program is meant to be.
    pub chapter: Chapter,
    code: interpreter::Program,
    /// True if a reader typed the code. The prelude is then given, and right.
    is_typed: bool,
}

impl ChapterProgram {
    /// Returns the right program of a chapter. Its text is read at the first call.
    ///
    /// # Panics
    /// If the chapter is not one of [`Chapter::OF_THE_BOOK`].
    pub fn right(chapter: Chapter) -> Self {
        static RIGHT: [OnceLock<ChapterProgram>; 6] = [const { OnceLock::new() }; 6];
        let right = RIGHT.get(chapter as usize);
        let right = right.expect("chapter 6 is no program of the book");
        right.get_or_init(|| Self::read(chapter)).clone()
    }

    /// Makes the program of a chapter from the code that a reader typed for it, and that the
    /// interpreter has read. Nothing is run or checked.
    pub fn from_reader(chapter: Chapter, code: interpreter::Program) -> Self {
        Self {
            chapter,
            code,
            is_typed: true,
        }
    }

    /// Reads the program of a chapter from its own text.
    fn read(chapter: Chapter) -> Self {
        let code = interpreter::read(&program_files(chapter))
            .unwrap_or_else(|fault| panic!("the text of {chapter:?} is read: {fault}"));
        Self {
            chapter,
            code,
            is_typed: false,
        }
    }

    /// Returns the program with all of these edits made, one after the other, each in every place
    /// where its right code occurs; a copy for no edits.
    ///
    /// Returns `None` if the right code of an edit occurs nowhere, or if the interpreter can't read
    /// an edited function.
    pub fn with_edits(&self, edits: &[Edit]) -> Option<Self> {
        let mut changed = Vec::new();
        let mut program = self.clone();
        for edit in edits {
            if edit.is_precision() && self.chapter != Chapter::BuildTest {
                program = program.in_single_precision();
            } else if !self.change(edit, &mut changed) {
                return None;
            }
        }
        let mut all = changed.into_iter();
        all.try_fold(program, |program, (name, text)| {
            program.with_function(&name, &text)
        })
    }

    /// Returns the program with those edits whose right code occurs in it; `None` if a function with
    /// edits can't be read.
    pub(crate) fn with_any(&self, edits: &[Edit]) -> Option<Self> {
        let edits = edits.iter().filter(|edit| self.has(edit)).cloned();
        self.with_edits(&edits.collect::<Vec<_>>())
    }

    /// Makes an edit in the texts of functions that are in `changed`, by name and text, or else in
    /// the program's; adds those that are new. Returns false if its right code occurs in none.
    fn change(&self, edit: &Edit, changed: &mut Vec<(String, String)>) -> bool {
        let mut stands = false;
        for (name, text) in self.functions() {
            let place = changed.iter().position(|it| it.0 == name);
            let text = place.map_or(text, |place| &changed[place].1);
            let Some(new) = edit.applied_to(text) else {
                continue;
            };
            stands = true;
            match place {
                Some(place) => changed[place].1 = new,
                None => changed.push((name.to_owned(), new)),
            }
        }
        stands
    }

    /// Returns true if the right code of an edit occurs in the program. An edit of the precision
    /// can be made in every program with rays.
    pub(crate) fn has(&self, edit: &Edit) -> bool {
        match edit.is_precision() {
            true => self.chapter != Chapter::BuildTest,
            false => self.functions().any(|it| edit.stands_in(it.1)),
        }
    }

    /// Finds the first statement that one of these edits changes, as it is and with all of them
    /// made. For an edit of the precision, which changes no statement, returns that edit. `None` if
    /// no edit can be made in the program.
    pub(crate) fn statement_with(&self, edits: &[Edit]) -> Option<Edit> {
        let mut standing = edits.iter().filter(|edit| self.has(edit));
        let first = standing.next()?;
        if first.is_precision() {
            return Some(first.clone());
        }
        self.functions()
            .find_map(|(_, text)| first.statement(text, edits))
    }

    /// Returns the program with the text of one function replaced. `function` is its name,
    /// `hit_sphere` or `Sphere::hit`, and `text` goes from `fn` to the last brace.
    ///
    /// Returns `None` if there is no such function or the interpreter can't read the text.
    pub fn with_function(&self, function: &str, text: &str) -> Option<Self> {
        let code = self.code.patched(function, text).ok()?;
        Some(Self { code, ..*self })
    }

    /// Returns the program with every number and result rounded to single precision.
    fn in_single_precision(&self) -> Self {
        Self {
            code: self.code.in_single_precision(),
            ..*self
        }
    }

    /// Returns this program with the changes of `other` made, too; both have to be changed copies
    /// of the program `from`. `None` if both have changed the same function.
    pub fn merged_with(&self, other: &Self, from: &Self) -> Option<Self> {
        let code = self.code.merged_with(&other.code, &from.code)?;
        Some(Self {
            code,
            ..self.clone()
        })
    }

    /// Lists the functions of the program as pairs of name and text, which goes from `fn` to the
    /// last brace. A method has the name of its type before its own: `Sphere::hit`. Unless a reader
    /// typed the program, the functions of the prelude follow that its chapter uses.
    pub fn functions(&self) -> impl Iterator<Item = (&str, &str)> {
        let is_used = |it: &(&str, &str)| !self.is_typed && uses(self.chapter, it.0);
        let of_prelude = self.code.prelude_functions().filter(is_used);
        self.code.functions().chain(of_prelude)
    }

    /// Returns the code of the program, as the interpreter runs it.
    pub fn code(&self) -> &interpreter::Program {
        &self.code
    }
}

/// Returns true if a chapter uses a function of the prelude.
fn uses(chapter: Chapter, function: &str) -> bool {
    match function {
        // No chapter multiplies vectors by components, or divides one.
        "DVec3::mul" | "DVec3::div" | "DVec3::rem" => false,
        "DVec3::neg" => chapter == Chapter::HittableList,
        // The first chapter with rays has no function for its sky.
        "sky" | "DVec3::dot" => chapter > Chapter::Gradient,
        _ => chapter > Chapter::BuildTest,
    }
}
