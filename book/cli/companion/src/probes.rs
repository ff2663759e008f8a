//! `probes`: small scenes, and what a reader changes to draw them.

use std::error::Error;
use std::fmt::Write;

use check::names::companion_command;
use check::task::Task;
use slips::{Chapter, Languages, PROBES};

use crate::chapter::chapter;
use crate::command_line::Words;
use crate::output;

/// Prints the probes that a chapter has spheres for, each with what it shows and the lines to
/// change.
///
/// # Errors
/// If the word names no chapter, or standard output can't be written to.
pub(crate) fn list(words: &Words) -> Result<(), Box<dyn Error>> {
    let chapter = chapter(words)?.unwrap_or(Chapter::HittableList);
    let name = chapter.name();
    let mut text = format!(
        "Probes for {name}. Change your program as a probe says, draw, and then:\n  {} check {name} --probe NAME PICTURE\n",
        companion_command()
    );
    for probe in PROBES {
        if Task::new(chapter, Some(probe)).is_some() {
            let lines = probe
                .instructions(chapter, Languages::Both)
                .replace('\n', "\n    ");
            write!(text, "\n{}\n  {}\n    {lines}\n", probe.name, probe.shows)?;
        }
    }
    Ok(output::to_stdout(|out| out.write_all(text.as_bytes()))?)
}
