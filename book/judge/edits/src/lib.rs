//! Mutation operators: lists the single edits of a Rust text that people make when they type, and
//! writes them all into one program (*mutant schemata*: Untch, Offutt and Harrold, 1993).
//!
//! In a right text the edits are the likely mistakes; in a wrong text some of them undo one. So one
//! list serves both ways: a program with an edit is run, and its picture is compared. This package
//! runs nothing. It knows the words of the language and those that a text defines, not what they
//! are about.
//!
//! An edit need not type-check. What runs the program decides: rustc refuses the wrong arms of a
//! `match`, an interpreter loses a mutant that it can't read.
//!
//! ```
//! let edits = edits::of_texts(&["fn f(a: f64, b: f64) -> f64 { a - b }"])?.edits;
//! let text = edits[0].applied_to("fn f(a: f64, b: f64) -> f64 { a - b }");
//! assert_eq!(text, "fn f(a: f64, b: f64) -> f64 { a + b }");
//! # Ok::<(), syn::Error>(())
//! ```

mod calls;
mod defined;
mod hosts;
mod lists;
mod maker;
mod mistaken;
mod operators;
pub mod schemata;
mod statements;
mod values;
mod walk;

use std::collections::HashSet;
use std::ops::Range;

use syn::visit::Visit;

pub use defined::Defined;
use maker::Maker;

/// A replacement in a text that a person may make by mistake, or that undoes one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The index of the edited text in the list that was given, from 0.
    pub file: usize,
    /// The bytes that are replaced; empty where text is inserted.
    pub at: Range<usize>,
    /// The text for their place; empty if they are left out. Brackets are there where it needs
    /// some.
    pub new: String,
    /// How unlikely the edit is: 1 for the likeliest (a sign, a comparison), 9 for the least likely
    /// (a missing statement). The 0 is left to those who know more, as which lines are right.
    pub rank: u32,
    /// The bytes of the function or constant that is edited.
    pub function: Range<usize>,
    /// The smallest part around the edit that can be written as a choice.
    pub host: Host,
    /// True if the edit gives a bare number a type, as `0.0` → `width`: elsewhere in the function a
    /// type may then be inferred that no error of this place tells.
    pub gives_type: bool,
}

/// A part of a text that can be replaced by a choice between it and its alternatives: a `match`, or
/// the interpreter's `mutants!`.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Host {
    /// The bytes of the part; empty between two statements.
    pub at: Range<usize>,
    /// What the part is.
    pub form: Form,
}

/// The form of a [`Host`], which says how a choice is written there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Form {
    /// A block with its braces, as the body of a function.
    Block,
    /// A statement with its semicolon, or the place between two.
    Statement,
    /// An expression, but no place that is assigned or borrowed, no closure and no jump.
    Expression,
    /// A constant: each edit makes another constant beside it, and the choice stands at its uses.
    Constant,
}

/// A use of a constant whose value may be edited.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConstantUse {
    /// The index of the text, from 0.
    pub file: usize,
    /// The bytes of the path, such as `BLUE` or `Color::BLUE`.
    pub at: Range<usize>,
}

/// The edits of some texts.
#[derive(Clone, Debug, Default)]
pub struct Edits {
    /// All edits, the likeliest first, of equal ranks in the order of the text. No two make the
    /// same text.
    pub edits: Vec<Edit>,
    /// The uses of constants, for edits whose host is a constant.
    pub uses: Vec<ConstantUse>,
}

/// Lists the edits of all functions and constants in some files, which are one program.
///
/// Tests are left out, and so are modules for some configurations only, bodies of `macro_rules!`,
/// attributes, types and signatures.
///
/// # Errors
/// If a text is not Rust.
pub fn of_texts(texts: &[&str]) -> syn::Result<Edits> {
    let files = texts.iter().map(|it| syn::parse_file(it));
    let files = files.collect::<syn::Result<Vec<_>>>()?;
    let defined = Defined::in_files(&files);
    let mut all = Edits::default();
    for (n, file) in files.iter().enumerate() {
        let mut maker = Maker::new(n, texts[n], &defined);
        maker.visit_file(file);
        all.edits.append(&mut maker.edits);
        all.uses.append(&mut maker.uses);
    }
    tidy(&mut all.edits, texts);
    Ok(all)
}

/// Lists the edits of one function from its text, which goes from `fn`, or what stands before it,
/// to the closing brace. `name` is `hit_sphere`, or for a method `Sphere::hit`; `defined` says what
/// the program around it has. Bytes count from the beginning of this text.
///
/// # Errors
/// If the text is no function.
pub fn of_function(name: &str, text: &str, defined: &Defined) -> syn::Result<Vec<Edit>> {
    let function: syn::ImplItemFn = syn::parse_str(text)?;
    let mut maker = Maker::new(0, text, defined);
    maker.of_type(name.rsplit_once("::").map_or("", |it| it.0));
    maker.visit_impl_item_fn(&function);
    tidy(&mut maker.edits, &[text]);
    Ok(maker.edits)
}

/// Sorts edits by their ranks, and keeps the likeliest of those that make the same text.
fn tidy(edits: &mut Vec<Edit>, texts: &[&str]) {
    edits.sort_by_key(|it| it.rank);
    let mut seen = HashSet::new();
    edits.retain(|it| {
        let made = (it.file, it.host.clone(), it.hosted(texts[it.file]));
        seen.insert(made)
    });
}

impl Edit {
    /// Returns the text with the edit made.
    pub fn applied_to(&self, text: &str) -> String {
        let mut text = text.to_owned();
        text.replace_range(self.at.clone(), &self.new);
        text
    }

    /// Returns the text of the host with the edit made.
    pub fn hosted(&self, text: &str) -> String {
        let (before, after) = (
            self.host.at.start..self.at.start,
            self.at.end..self.host.at.end,
        );
        [&text[before], &self.new, &text[after]].concat()
    }

    /// Returns the lines of the text that the edit changes, before and after it, without the blanks
    /// around them, and the number of the first, from 1.
    pub fn lines(&self, text: &str) -> EditedLines {
        let start = text[..self.at.start].rfind('\n').map_or(0, |n| n + 1);
        let end = text[self.at.end..].find('\n');
        let end = end.map_or(text.len(), |n| self.at.end + n);
        let (before, after) = (&text[start..self.at.start], &text[self.at.end..end]);
        EditedLines {
            number: 1 + text[..start].matches('\n').count(),
            old: text[start..end].trim().to_owned(),
            new: [before, &self.new, after].concat().trim().to_owned(),
        }
    }
}

/// The lines of a text that an edit changes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EditedLines {
    /// The number of the first of these lines, from 1.
    pub number: usize,
    /// The lines before the edit.
    pub old: String,
    /// The lines after the edit; empty if it leaves them out.
    pub new: String,
}
