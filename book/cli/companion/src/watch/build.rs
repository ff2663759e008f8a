//! Cargo as a subprocess, whose messages are JSON: what was built, or why not.

use std::ffi::OsString;
use std::path::Path;
use std::process::Command;

use check::names;
use launcher::cargo;
use serde_json::Value;

use crate::terminal::Palette;

/// The programs of a reader's crate.
pub(super) struct Built {
    /// Prints the picture.
    pub(super) program: OsString,
    /// What the compiler warned of in the reader's files, each in its first line.
    pub(super) warnings: Vec<String>,
}

/// Why a crate was not built.
pub(super) struct Problem {
    /// The compiler's first message, as it prints it.
    pub(super) first: String,
    /// How many more there are.
    pub(super) more: usize,
}

/// What is said before more is built than the crate: for chapter 1, and for those with laws.
const PRELUDE: &str = "\nBuilding the prelude for all your crates: once, about a quarter of a minute. \
    The laws, from chapter 2 on, take a minute more, once";
const LAWS: &str =
    "\nBuilding the laws, which test your functions, for all your crates: once, about a minute";

/// Builds the crate in `folder`.
pub(super) fn build(folder: &Path) -> Result<Built, Problem> {
    let messages = cargo_says(folder, &["build"], PRELUDE)?;
    let missing = "the crate has no program: src/main.rs is missing";
    Ok(Built {
        program: executable(&messages, "bin").ok_or_else(|| problem(&[], missing))?,
        warnings: warnings(&messages),
    })
}

/// Builds the test that puts under the laws what the crate computes, if it computes something.
pub(super) fn laws(folder: &Path) -> Result<Option<OsString>, Problem> {
    if !folder.join("tests/laws.rs").is_file() {
        return Ok(None);
    }
    let messages = cargo_says(folder, &["test", "--no-run", "--test", "laws"], LAWS)?;
    Ok(executable(&messages, "test"))
}

/// What cargo says of this, if it succeeds, and `first` before it if it takes its time.
fn cargo_says(folder: &Path, words: &[&str], first: &str) -> Result<Vec<Value>, Problem> {
    let mut command = Command::new(cargo::cargo());
    command.args(words);
    command.arg(match Palette::of_stdout() {
        Some(_) => "--message-format=json-diagnostic-rendered-ansi",
        None => "--message-format=json",
    });
    command.current_dir(folder);
    let run = cargo::run(command, first)
        .map_err(|cause| problem(&[], &format!("cargo does not start: {cause}")))?;
    let printed = String::from_utf8_lossy(&run.printed);
    let messages = printed.lines().map(serde_json::from_str);
    let messages: Vec<Value> = messages.filter_map(Result::ok).collect();
    if !run.status.success() {
        return Err(problem(&messages, &run.said));
    }
    Ok(messages)
}

/// The compiler's warnings, each with its file and line. A program and its test have some in common.
fn warnings(messages: &[Value]) -> Vec<String> {
    let messages = messages.iter().map(|it| &it["message"]);
    let warning = |message: &Value| {
        let text = message["message"].as_str()?;
        let place = &message["spans"][0];
        let (file, line) = (place["file_name"].as_str()?, place["line_start"].as_u64()?);
        Some(format!("{file}:{line}  {text}"))
    };
    let mut warnings: Vec<String> = messages
        .filter(|message| message["level"] == "warning")
        .filter_map(warning)
        .collect();
    warnings.sort();
    warnings.dedup();
    warnings
}

/// The first error; what cargo itself says where the compiler has said nothing.
fn problem(messages: &[Value], said: &str) -> Problem {
    let errors: Vec<&str> = messages
        .iter()
        .filter(|message| message["message"]["level"] == "error")
        .filter_map(|message| message["message"]["rendered"].as_str())
        // The last one of each program only counts the others.
        .filter(|rendered| !rendered.contains("aborting due to"))
        .collect();
    // The compiler takes out of its messages what a terminal would obey; a script doesn't.
    let said: Vec<_> = said.lines().map(names::visible).collect();
    let said = said.join("\n");
    Problem {
        first: errors.first().unwrap_or(&&*said).trim_end().to_owned(),
        more: errors.len().saturating_sub(1),
    }
}

/// The program that was built of a target of this kind.
fn executable(messages: &[Value], kind: &str) -> Option<OsString> {
    let of_kind = |message: &&Value| message["target"]["kind"][0] == kind;
    let program = |message: &Value| Some(message["executable"].as_str()?.into());
    messages.iter().filter(of_kind).find_map(program)
}
