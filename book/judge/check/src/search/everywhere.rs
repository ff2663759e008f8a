//! Mutations of a whole program, for a reader who wants to see what each of its words is for.

use std::ops::Range;

use interpreter::{Program, SourceFile};

use super::functions::functions;
use super::mutation::mutations;

/// An edit of a file, as people make them when they type.
#[derive(Clone, Debug)]
pub struct FileEdit {
    /// The place of the file in the list of files.
    pub file: usize,
    /// The bytes that are replaced.
    pub at: Range<usize>,
    /// The text that takes their place.
    pub new: String,
    /// The lower, the likelier.
    pub rank: u32,
}

/// Lists all single edits of the functions of a program that was read from these files.
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
