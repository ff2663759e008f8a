//! The program that has all edits, built by cargo: edits that do not type-check are dropped by the
//! places of rustc's errors.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::ops::Range;
use std::path::PathBuf;
use std::time::Duration;

use edits::schemata::{self, Notation, Schema, Written};
use edits::{Edit, Edits};
use serde_json::Value;

use super::copy::Copy;
use super::own_crate::OwnCrate;
use crate::subprocess::{self, ProgramEnd};
use crate::watch::build;

/// The most times that cargo is run for one program.
const MOST_ROUNDS: usize = 15;

/// The function by which a program asks for the width of its picture.
const WIDTH: &str = r#"
#[doc(hidden)]
pub fn rtrace_width() -> u32 {
    let width = ::std::env::var("RTRACE_WIDTH").ok();
    width.and_then(|it| it.parse().ok()).unwrap_or(400)
}
"#;

/// The environment variable with the width of the picture.
pub(super) const WIDTH_VARIABLE: &str = "RTRACE_WIDTH";

/// A program with all the edits that type-check.
pub(super) struct Built {
    /// The path of the program, which prints the picture.
    pub(super) program: PathBuf,
    /// The path of the test of the laws, if there is one.
    pub(super) laws: Option<PathBuf>,
    /// The edits in it, the likeliest first: of each the index and the number that chooses it.
    pub(super) numbers: Vec<(usize, u32)>,
}

/// The edits of a crate, some of which are dropped.
pub(super) struct Build<'a> {
    own: &'a OwnCrate,
    copy: &'a Copy,
    edits: &'a Edits,
    texts: Vec<&'a str>,
    /// The indices of the edits that are left.
    left: BTreeSet<usize>,
}

/// A function, by its file and its bytes.
type Function = (usize, Range<usize>);

impl<'a> Build<'a> {
    /// Prepares to build a crate with these edits.
    pub(super) fn new(
        own: &'a OwnCrate,
        copy: &'a Copy,
        edits: &'a Edits,
        chosen: impl IntoIterator<Item = usize>,
    ) -> Self {
        let texts = own.files.iter().map(|it| &*it.1).collect();
        let left = chosen.into_iter().collect();
        Self {
            own,
            copy,
            edits,
            texts,
            left,
        }
    }

    /// Builds the program without what does not type-check. Returns `None` if that fails, or if
    /// `is_old` returns true meanwhile.
    pub(super) fn build(&mut self, is_old: &mut dyn FnMut() -> bool) -> Option<Built> {
        for _ in 0..MOST_ROUNDS {
            let chosen: Vec<usize> = self.left.iter().copied().collect();
            let numbers = schemata::numbered(&self.edits.edits, &chosen, 0);
            let written = self.write(&numbers)?;
            let messages = self.cargo(is_old)?;
            if let Some(program) = executable(&messages, "bin") {
                let laws = executable(&messages, "test");
                let numbers = chosen.iter().map(|it| (*it, numbers[it])).collect();
                return Some(Built {
                    program,
                    laws,
                    numbers,
                });
            }
            let before = self.left.len();
            self.drop_refused(&messages, &written);
            if self.left.len() == before {
                return None;
            }
        }
        None
    }

    /// Writes all files with the edits that are left.
    fn write(&self, numbers: &HashMap<usize, u32>) -> Option<Vec<Written>> {
        let Edits { edits, uses } = self.edits;
        let schema = Schema {
            edits,
            uses,
            numbers,
        };
        let mut all = Vec::new();
        for (n, (name, _)) in self.own.files.iter().enumerate() {
            let mut written = schema.write(n, &self.texts, Notation::Match);
            if is_root(name) {
                written.prepend("#![allow(warnings)] ");
                written.text += schemata::CHOICE;
                written.text += WIDTH;
            }
            // What warns is no error here; of equal length, so that places stay.
            let text = written.text.replace("#![deny(", "#![warn(");
            self.copy.write(name, &text).ok()?;
            all.push(written);
        }
        Some(all)
    }

    /// Runs cargo in the copy, and returns its messages; `None` if it was interrupted or does not
    /// start.
    fn cargo(&self, is_old: &mut dyn FnMut() -> bool) -> Option<Vec<Value>> {
        let words = ["build", "--offline", "--bins", "--message-format=json"];
        let mut cargo = build::cargo_command(&self.copy.folder, &words);
        if !self.own.laws.is_empty() {
            cargo.args(["--test", "laws"]);
        }
        cargo.env("CARGO_TARGET_DIR", &self.copy.target);
        let ran = subprocess::run(cargo, Duration::MAX, subprocess::last_errors, is_old);
        let Ok((ProgramEnd::Itself(_, printed), _)) = ran else {
            return None;
        };
        let printed = String::from_utf8_lossy(&printed);
        let messages = printed.lines().map(serde_json::from_str);
        Some(messages.filter_map(Result::ok).collect())
    }

    /// Drops the edits that the errors are about.
    ///
    /// An error outside of all edits comes from a type that some edit gives to a number: first these
    /// are dropped, and what else is wrong in the function waits for the next round.
    fn drop_refused(&mut self, messages: &[Value], written: &[Written]) {
        let errors = messages.iter().map(|it| &it["message"]);
        let errors = errors.filter(|it| it["level"] == "error");
        let guilty: Vec<(&Value, Vec<usize>)> =
            errors.map(|it| (it, self.guilty(it, written))).collect();
        let elsewhere = guilty.iter().filter(|it| it.1.is_empty());
        let suspects: Vec<usize> = elsewhere
            .flat_map(|it| self.suspects(it.0, written))
            .collect();
        let typed = suspects
            .iter()
            .filter(|it| self.edits.edits[**it].gives_type);
        let typed: HashSet<usize> = typed.copied().collect();
        let waiting: HashSet<Function> = typed.iter().map(|it| self.function(*it)).collect();
        let guilty = guilty.into_iter().flat_map(|it| it.1);
        let guilty: Vec<usize> = guilty
            .filter(|it| !waiting.contains(&self.function(*it)))
            .collect();
        let before = self.left.len();
        self.left
            .retain(|it| !guilty.contains(it) && !typed.contains(it));
        if self.left.len() == before {
            self.left.retain(|it| !suspects.contains(it));
        }
    }

    /// Lists the edits at the places of an error: the first of these groups of places that has
    /// some.
    fn guilty(&self, error: &Value, written: &[Written]) -> Vec<usize> {
        let spans = |it: &'_ Value| it["spans"].as_array().cloned().unwrap_or_default();
        let children = error["children"].as_array().cloned().unwrap_or_default();
        let below: Vec<Value> = children.iter().flat_map(spans).collect();
        let (primary, others): (Vec<_>, Vec<_>) = spans(error)
            .into_iter()
            .partition(|it| it["is_primary"] == true);
        for group in [primary, others, below] {
            let found = group.iter().filter_map(|it| self.edit_at(it, written));
            let found: BTreeSet<usize> = found.collect();
            if !found.is_empty() {
                return found.into_iter().collect();
            }
        }
        Vec::new()
    }

    /// Finds the innermost edit around a place.
    fn edit_at(&self, span: &Value, written: &[Written]) -> Option<usize> {
        let (file, at) = self.place(span)?;
        let around = written[file].alternatives.iter();
        let around = around.filter(|it| it.0.start <= at.start && at.end <= it.0.end);
        around.min_by_key(|it| it.0.len()).map(|it| it.1)
    }

    /// Lists the edits that an error outside of all edits may be about: the first group that is not
    /// empty of those that give a type in the function, those that bring names into what is wrong
    /// (a closure borrows more), those of the choice around it, and all of the function.
    fn suspects(&self, error: &Value, written: &[Written]) -> Vec<usize> {
        let spans = error["spans"].as_array();
        let primary = spans
            .into_iter()
            .flatten()
            .filter(|it| it["is_primary"] == true);
        for (file, at) in primary.filter_map(|it| self.place(it)) {
            let (written, edits) = (&written[file], &self.edits.edits);
            let byte = written.origin(at.start);
            let is_of =
                |it: &&usize| edits[**it].file == file && edits[**it].function.contains(&byte);
            let of_function: Vec<usize> = self.left.iter().filter(is_of).copied().collect();
            let typed = of_function
                .iter()
                .copied()
                .filter(|it| edits[*it].gives_type)
                .collect();
            let inside = written.alternatives.iter();
            let inside = inside.filter(|it| at.start <= it.0.start && it.0.end <= at.end);
            let named = inside
                .map(|it| it.1)
                .filter(|it| edits[*it].new.contains(char::is_alphabetic));
            let choices = written.choices.iter();
            let around = choices.filter(|it| it.0.start <= at.start && at.end <= it.0.end);
            let around = around.min_by_key(|it| it.0.len()).map(|it| it.1.clone());
            let groups: [Vec<usize>; 4] = [
                typed,
                named.collect(),
                around.unwrap_or_default(),
                of_function,
            ];
            if let Some(group) = groups.into_iter().find(|it| !it.is_empty()) {
                return group;
            }
        }
        Vec::new()
    }

    fn function(&self, edit: usize) -> Function {
        let Edit { file, function, .. } = &self.edits.edits[edit];
        (*file, function.clone())
    }

    /// Finds the file and the bytes of a span, or of the macro call that it comes from.
    fn place(&self, span: &Value) -> Option<(usize, Range<usize>)> {
        let name = span["file_name"].as_str()?.replace('\\', "/");
        match self.own.files.iter().position(|it| it.0 == name) {
            Some(file) => {
                let byte = |end: &str| Some(span[end].as_u64()? as usize);
                Some((file, byte("byte_start")?..byte("byte_end")?))
            }
            None if span["expansion"].is_null() => None,
            None => self.place(&span["expansion"]["span"]),
        }
    }
}

/// Returns true for the file of a library or a program, which needs the items that choose.
fn is_root(name: &str) -> bool {
    ["src/lib.rs", "src/main.rs"].contains(&name) || name.starts_with("src/bin/")
}

/// Returns the path of the program that was built for a target of this kind.
fn executable(messages: &[Value], kind: &str) -> Option<PathBuf> {
    let is_done = messages
        .iter()
        .any(|it| it["reason"] == "build-finished" && it["success"] == true);
    let path = build::executable(messages, kind).filter(|_| is_done);
    path.map(PathBuf::from)
}
