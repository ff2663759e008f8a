//! Cargo as a subprocess, whose messages are JSON: what was built, or why not.

use std::ffi::OsString;
use std::io::BufReader;
use std::path::Path;
use std::process::{ChildStderr, Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::time::Duration;

use check::names;
use launcher::cargo;
use serde_json::Value;

use crate::subprocess::{self, ProgramEnd};
use crate::terminal::Palette;

/// A reader's crate that cargo has built.
pub(super) struct BuiltCrate {
    /// The path of its program, which prints the picture.
    pub(super) program: OsString,
    /// The compiler's warnings: of each the file, the line and the first sentence, in one line.
    pub(super) warnings: Vec<String>,
}

/// The reason why cargo could not build a crate.
pub(super) struct BuildFailure {
    /// The compiler's first error, or else the words of cargo, in several lines.
    pub(super) first: String,
    /// The number of errors after the first.
    pub(super) more: usize,
    /// The advice to the reader.
    pub(super) advice: &'static str,
}

/// The line to show before cargo builds more than the crate, for its program.
const PRELUDE: &str = "\nBuilding the prelude for all your crates: once, about a quarter of a minute. \
    The laws, from chapter 2 on, take a minute more, once";
/// The line to show before cargo builds more than the crate, for its test of the laws.
const LAWS: &str =
    "\nBuilding the laws, which test your functions, for all your crates: once, about a minute";

/// The reason why a crate is not judged.
pub(super) enum NoVerdict {
    /// A newer save, which is judged instead.
    NewerSave,
    /// A crate that can't be built.
    NotBuilt(BuildFailure),
}

/// Builds the reader's crate in `folder`.
///
/// # Errors
/// If the crate can't be built, or if `is_old` returns true meanwhile: there is a newer save.
pub(super) fn build_crate(
    folder: &Path,
    is_old: &mut dyn FnMut() -> bool,
) -> Result<BuiltCrate, NoVerdict> {
    let show = |errors| cargo::show_work(errors, PRELUDE);
    let messages = cargo_says(folder, &["build"], show, is_old)?;
    let missing = "the crate has no program: src/main.rs is missing";
    let problem = || NoVerdict::NotBuilt(problem(&[], missing));
    Ok(BuiltCrate {
        program: executable(&messages, "bin").ok_or_else(problem)?,
        warnings: warnings(&messages),
    })
}

/// Builds the test that puts the functions of a crate under the laws, and returns the path of its
/// program. Without `waits`, returns `None` as soon as cargo has more to build than the crate; with
/// it, `None` if there is no such test.
///
/// # Errors
/// If the test can't be built, or if `is_old` returns true meanwhile: there is a newer save.
pub(super) fn build_laws_test(
    folder: &Path,
    waits: bool,
    is_old: &mut dyn FnMut() -> bool,
) -> Result<Option<OsString>, NoVerdict> {
    let works = Arc::new(AtomicBool::new(false));
    let heard = Arc::clone(&works);
    let listen = move |errors| match waits {
        true => cargo::show_work(errors, LAWS),
        false => cargo::listen_for_work(errors, |_, _| heard.store(true, Relaxed)),
    };
    let gives_up = || !waits && works.load(Relaxed);
    let test = ["test", "--no-run", "--test", "laws"];
    match cargo_says(folder, &test, listen, &mut || gives_up() || is_old()) {
        Err(NoVerdict::NewerSave) if gives_up() => Ok(None),
        messages => Ok(executable(&messages?, "test")),
    }
}

/// Makes the command that runs cargo with the arguments `words` in `folder`, without input and
/// color.
pub(crate) fn cargo_command(folder: &Path, words: &[&str]) -> Command {
    let mut command = Command::new(cargo::program_name());
    command.args(words).current_dir(folder);
    command
        .env("CARGO_TERM_COLOR", "never")
        .stdin(Stdio::null());
    command
}

/// Runs cargo to its end and returns its messages, if it succeeds. `listen` reads its standard
/// error.
fn cargo_says(
    folder: &Path,
    words: &[&str],
    listen: impl FnOnce(BufReader<ChildStderr>) -> String + Send + 'static,
    is_old: &mut dyn FnMut() -> bool,
) -> Result<Vec<Value>, NoVerdict> {
    let mut command = cargo_command(folder, words);
    command.arg(match Palette::of_stdout() {
        Some(_) => "--message-format=json-diagnostic-rendered-ansi",
        None => "--message-format=json",
    });
    let listen = |errors| listen(BufReader::new(errors));
    let failed = |messages: &[Value], said: &str| Err(NoVerdict::NotBuilt(problem(messages, said)));
    match subprocess::run(command, Duration::MAX, listen, is_old) {
        Ok((ProgramEnd::Itself(status, printed), said)) => {
            let printed = String::from_utf8_lossy(&printed);
            let messages = printed.lines().map(serde_json::from_str);
            let messages: Vec<Value> = messages.filter_map(Result::ok).collect();
            if status.success() {
                Ok(messages)
            } else {
                failed(&messages, &said)
            }
        }
        Ok((ProgramEnd::Interrupted, _)) => Err(NoVerdict::NewerSave),
        Ok((ProgramEnd::Full(_) | ProgramEnd::TooSlow, _)) => {
            failed(&[], "cargo prints more than rtrace reads")
        }
        Err(cause) => failed(&[], &format!("cargo does not start: {cause}")),
    }
}

/// Lists the compiler's warnings in order, each once, as a line with file, line and text.
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

/// Describes the first error of the compiler, or the words of cargo where the compiler has none.
fn problem(messages: &[Value], said: &str) -> BuildFailure {
    let messages = messages.iter().map(|message| &message["message"]);
    let is_error = |message: &&Value| {
        let rendered = message["rendered"].as_str().unwrap_or_default();
        // The last one of each program only counts the others.
        message["level"] == "error" && !rendered.contains("aborting due to")
    };
    let errors: Vec<&Value> = messages.filter(is_error).collect();
    // The compiler takes out of its messages what a terminal would obey; a script doesn't.
    let said = said
        .lines()
        .map(names::escape_for_terminal)
        .collect::<Vec<_>>();
    let said = said.join("\n");
    let first = errors.first().and_then(|it| it["rendered"].as_str());
    BuildFailure {
        first: without_impls(first.unwrap_or(&said).trim_end()),
        more: errors.len().saturating_sub(1),
        advice: match errors.first() {
            Some(error) if compares_an_option(error) => UNWRAP,
            _ => "put this right",
        },
    }
}

/// Leaves out of a message the lists of types that implement a trait: they don't help here.
fn without_impls(message: &str) -> String {
    let mut is_listing = false;
    let is_kept = |line: &&str| {
        let begins = line.contains("following other types implement trait");
        is_listing = begins || is_listing && line.starts_with("          ");
        !is_listing
    };
    message
        .lines()
        .filter(is_kept)
        .collect::<Vec<_>>()
        .join("\n")
}

/// Returns true if the compiler advises to compare an `Option` with another one, where the reader
/// should take the number out of it.
fn compares_an_option(error: &Value) -> bool {
    let line = error["spans"][0]["text"][0]["text"].as_str();
    let compares = |line: &str| {
        [" > ", " < ", " >= ", " <= "]
            .iter()
            .any(|it| line.contains(it))
    };
    let rendered = error["rendered"].as_str().unwrap_or_default();
    line.is_some_and(compares) && rendered.contains("wrapping the expression in `Some`")
}

/// The advice to give instead of the compiler's.
const UNWRAP: &str =
    "do not wrap the number: take t out of the Option, as in `if let Some(t) = … && t > 0.0`";

/// Returns the path of the program that was built for a target of this kind, such as `bin`.
pub(crate) fn executable(messages: &[Value], kind: &str) -> Option<OsString> {
    let of_kind = |message: &&Value| message["target"]["kind"][0] == kind;
    let program = |message: &Value| Some(message["executable"].as_str()?.into());
    messages.iter().filter(of_kind).find_map(program)
}
