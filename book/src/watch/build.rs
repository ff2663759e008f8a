//! Cargo as a subprocess, whose messages are JSON: what was built, or why not.

use std::ffi::OsString;
use std::path::Path;
use std::time::Duration;
use std::{env, iter};

use check::names;
use serde_json::Value;

use super::progress::Progress;
use crate::subprocess::{self, End};
use crate::terminal::Palette;

/// The programs of a reader's crate.
pub(super) struct Built {
    /// Prints the picture.
    pub(super) program: OsString,
    /// Puts what the chapter computes under the laws, if it computes something.
    pub(super) laws: Option<OsString>,
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

/// Builds the crate in `folder`, and the test that puts it under the laws; `None` if
/// `is_old` says meanwhile that there is something newer.
pub(super) fn build(
    folder: &Path,
    is_old: &mut dyn FnMut() -> bool,
) -> Result<Option<Built>, Problem> {
    let has_test = folder.join("tests/laws.rs").is_file();
    // A test brings its program with it.
    let what: &[&str] = match has_test {
        true => &["test", "--no-run", "--test", "laws"],
        false => &["build"],
    };
    let format = match Palette::of_stdout() {
        Some(_) => "--message-format=json-diagnostic-rendered-ansi",
        None => "--message-format=json",
    };
    let words: Vec<OsString> = iter::once(cargo())
        .chain(what.iter().chain(&["--quiet", format]).map(OsString::from))
        .collect();
    let mut command = subprocess::command(&words);
    command.current_dir(folder);
    let mut progress = Progress::new(folder, has_test);
    let mut is_old = |said: &[u8]| {
        progress.show(said);
        is_old()
    };
    match subprocess::run(command, LONGEST, &mut is_old) {
        Ok((End::Interrupted, _)) => Ok(None),
        Ok((End::Itself(status, said), errors)) => {
            let messages = messages(&said);
            match status.success() {
                true => built(&messages).map(Some),
                false if !folder.join("src/lib.rs").is_file() => {
                    Err(problem(&[], "src/lib.rs is missing: the chapter itself"))
                }
                false => Err(problem(&messages, &errors)),
            }
        }
        Ok((_, errors)) => Err(problem(&[], &errors)),
        Err(cause) => Err(problem(&[], &format!("cargo does not start: {cause}"))),
    }
}

/// The first build takes a minute, on a slow machine some.
const LONGEST: Duration = Duration::from_secs(1800);

/// The program that builds crates.
pub(super) fn cargo() -> OsString {
    env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

/// What cargo has printed, message by message.
pub(super) fn messages(said: &[u8]) -> Vec<Value> {
    let text = String::from_utf8_lossy(said);
    let messages = text.lines().map(serde_json::from_str);
    messages.filter_map(Result::ok).collect()
}

fn built(messages: &[Value]) -> Result<Built, Problem> {
    let missing = "the crate has no program: src/main.rs is missing";
    let program = executable(messages, "bin").ok_or_else(|| problem(&[], missing))?;
    let laws = executable(messages, "test");
    Ok(Built {
        program,
        laws,
        warnings: warnings(messages),
    })
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

/// The program that was built of a target of this kind: of several, the one that `start`
/// named.
fn executable(messages: &[Value], kind: &str) -> Option<OsString> {
    messages
        .iter()
        .filter(|message| message["target"]["kind"][0] == kind)
        .filter_map(|message| {
            Some((
                message["target"]["name"].as_str()?,
                message["executable"].as_str()?,
            ))
        })
        .max_by_key(|(name, _)| name.starts_with("my_"))
        .map(|(_, program)| program.into())
}
