//! Mutations of a whole program, for a reader who wants to see what each of its words is for.

use std::ops::Range;

use interpreter::{Program, SourceFile};

use super::functions::functions;
use super::mutation::mutations;

/// A replacement of text in a file of a program, which makes a mistake that people make when they
/// type.
#[derive(Clone, Debug)]
pub struct FileEdit {
    /// The index of the file in the list that was given to [`edits_everywhere`].
    pub file: usize,
    /// The bytes of the file's text that are replaced; empty where text is inserted.
    pub at: Range<usize>,
    /// The text that replaces these bytes; empty if they are left out.
    pub new: String,
    /// A rank by how unlikely the mistake is, less for a likelier one: 2 for each word that
    /// changes, plus a penalty for the kind of edit.
    pub rank: u32,
}

/// Lists every single edit of a program's functions that a person may make by mistake, function by
/// function and in each from top to bottom.
///
/// `files` are those from which the program was read. A function that is in none of them is left
/// out.
pub fn edits_everywhere(program: &Program, files: &[SourceFile]) -> Vec<FileEdit> {
    let mut all = Vec::new();
    for function in functions(program) {
        let Some((file, start)) = function.place(files) else {
            continue;
        };
        all.extend(mutations(&function).iter().map(|mutation| {
            let edit = mutation.edit(&function.text);
            FileEdit {
                file,
                at: start + edit.at.start..start + edit.at.end,
                new: edit.new,
                rank: edit.rank,
            }
        }));
    }
    all
}
