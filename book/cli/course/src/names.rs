//! Escaping: names in messages, so that a terminal shows them instead of obeying them.

use std::borrow::Cow;
use std::env;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// Spells out, as `\u{1b}`, the characters of `text` that a terminal obeys instead of showing them,
/// or that turn the order of the others.
pub fn escape_for_terminal(text: &str) -> Cow<'_, str> {
    let obeyed = |c: char| c.is_control() || TURNS.contains(&c);
    if !text.contains(obeyed) {
        return text.into();
    }
    let spell = |c: char| {
        if obeyed(c) {
            c.escape_default().to_string()
        } else {
            c.to_string()
        }
    };
    text.chars().map(spell).collect()
}

/// The marks of Unicode by which a text runs from right to left, or back, or breaks a line.
const TURNS: [char; 14] = [
    '\u{061c}', '\u{200e}', '\u{200f}', '\u{2028}', '\u{2029}', '\u{202a}', '\u{202b}', '\u{202c}',
    '\u{202d}', '\u{202e}', '\u{2066}', '\u{2067}', '\u{2068}', '\u{2069}',
];

/// Returns the name of a file, or another word of a command line, as a message shows it.
pub fn escaped_name(name: impl AsRef<OsStr>) -> String {
    escape_for_terminal(&name.as_ref().to_string_lossy()).into_owned()
}

/// Returns `path` as a message shows it: as seen from the current folder, if it is below that.
pub fn name_from_here(path: &Path) -> String {
    let here = env::current_dir().ok();
    let below = here.and_then(|here| path.strip_prefix(here).ok());
    // Put together anew, it has one kind of slash between folders.
    escaped_name(below.unwrap_or(path).components().collect::<PathBuf>())
}

/// Returns the name by which the companion can be called again: `cargo rtrace` if cargo runs the
/// program that asks, in this workspace by an alias and elsewhere as a subcommand; else
/// `rtrace`, which is installed then.
pub fn companion_command() -> &'static str {
    // Cargo tells all that it runs where cargo is. A page was woven in the workspace.
    if cfg!(target_family = "wasm") || env::var_os("CARGO").is_some() {
        "cargo rtrace"
    } else {
        "rtrace"
    }
}
