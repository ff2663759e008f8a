//! Cargo as a subprocess, whose messages are JSON: what was built, or why not.

use std::env;
use std::ffi::OsString;
use std::io::IsTerminal;
use std::path::Path;
use std::process::{Command, Stdio};

use serde_json::Value;

/// The programs of a reader's crate.
pub(super) struct Built {
    /// Prints the picture.
    pub(super) program: OsString,
    /// Puts what the chapter computes under the laws, if it computes something.
    pub(super) laws: Option<OsString>,
}

/// Why a crate was not built.
pub(super) struct Problem {
    /// The compiler's first message, as it prints it.
    pub(super) first: String,
    /// How many more there are.
    pub(super) more: usize,
}

/// Builds the crate in `folder`, and the test that puts it under the laws.
pub(super) fn build(folder: &Path) -> Result<Built, Problem> {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let format = match std::io::stdout().is_terminal() {
        true => "--message-format=json-diagnostic-rendered-ansi",
        false => "--message-format=json",
    };
    // A test brings its program with it.
    let what: &[&str] = match folder.join("tests/laws.rs").is_file() {
        true => &["test", "--no-run", "--test", "laws"],
        false => &["build"],
    };
    let output = Command::new(cargo)
        .args(what)
        .args(["--quiet", format])
        .current_dir(folder)
        .stdin(Stdio::null())
        .output();
    let output = output.map_err(|cause| Problem {
        first: format!("cargo does not start: {cause}"),
        more: 0,
    })?;
    let text = String::from_utf8_lossy(&output.stdout);
    let messages: Vec<Value> = text
        .lines()
        .filter_map(|line| serde_json::from_str(line).ok())
        .collect();
    if !output.status.success() {
        return Err(problem(&messages, &String::from_utf8_lossy(&output.stderr)));
    }
    let program = executable(&messages, "bin").ok_or_else(|| Problem {
        first: "the crate has no program: src/main.rs is missing".to_owned(),
        more: 0,
    })?;
    let laws = executable(&messages, "test");
    Ok(Built { program, laws })
}

/// The first error; what cargo itself says where the compiler has said nothing.
fn problem(messages: &[Value], said: &str) -> Problem {
    let errors: Vec<&str> = messages
        .iter()
        .filter(|message| message["message"]["level"] == "error")
        .filter_map(|message| message["message"]["rendered"].as_str())
        .collect();
    Problem {
        first: errors.first().unwrap_or(&said).trim_end().to_owned(),
        // The last one only counts the others.
        more: errors.len().saturating_sub(2),
    }
}

/// The program that was built of a target of this kind.
fn executable(messages: &[Value], kind: &str) -> Option<OsString> {
    messages
        .iter()
        .filter(|message| message["target"]["kind"][0] == kind)
        .find_map(|message| message["executable"].as_str())
        .map(OsString::from)
}
