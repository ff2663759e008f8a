//! Escaping: names in messages, so that a terminal shows them instead of obeying them.

use std::borrow::Cow;
use std::env;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// Replaces each character of `text` that a terminal would obey instead of showing it, a line break
/// too, or that turns the direction of the text around it, by its escape in Rust, such as `\u{1b}`.
/// Returns `text` itself if it has no such character.
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

/// The Unicode characters that turn the direction of a text, or break a line.
const TURNS: [char; 14] = [
    '\u{061c}', '\u{200e}', '\u{200f}', '\u{2028}', '\u{2029}', '\u{202a}', '\u{202b}', '\u{202c}',
    '\u{202d}', '\u{202e}', '\u{2066}', '\u{2067}', '\u{2068}', '\u{2069}',
];

/// Returns the name of a file, or another word of a command line, as a message may show it, in one
/// line: by [`escape_for_terminal`], and with � for what is not UTF-8.
pub fn escaped_name(name: impl AsRef<OsStr>) -> String {
    escape_for_terminal(&name.as_ref().to_string_lossy()).into_owned()
}

/// Returns `path` as a message shows it: relative to the current folder if it is below that, and
/// else as it is; by [`escaped_name`]. Empty for the current folder itself.
pub fn name_from_here(path: &Path) -> String {
    let here = env::current_dir().ok();
    let below = here.and_then(|here| path.strip_prefix(here).ok());
    // Put together anew, it has one kind of slash between folders.
    escaped_name(below.unwrap_or(path).components().collect::<PathBuf>())
}

/// Returns the command that starts the program `rtrace`: `cargo rtrace` if cargo has started the
/// program that asks, or if that runs in a web page, and else `rtrace`.
pub fn companion_command() -> &'static str {
    // Cargo tells all that it runs where cargo is. A page was woven in the workspace.
    if cfg!(target_family = "wasm") || env::var_os("CARGO").is_some() {
        "cargo rtrace"
    } else {
        "rtrace"
    }
}
