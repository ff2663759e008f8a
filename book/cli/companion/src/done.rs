//! `done`: the list of things that a reader has done, and the steps that are ahead.

use std::error::Error;
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use check::names::{self, name_from_here};
use check::sentences::{picture_done_line, step_done_line};
use slips::{Chapter, steps};

use crate::command_line::Words;
use crate::limited;
use crate::output;
use crate::reader_crates::ReaderCrates;
use crate::wrap::wrap_hanging;

/// The arguments of `cargo rtrace done`.
pub(crate) struct Arguments {
    text: Vec<String>,
    in_folder: Option<PathBuf>,
}

impl Arguments {
    /// Reads the arguments from a command line.
    ///
    /// # Errors
    /// If there is a text, and it is blank.
    pub(crate) fn read(words: &Words) -> Result<Self, Box<dyn Error>> {
        let text = words
            .values
            .iter()
            .map(|it| it.to_string_lossy().into_owned());
        let text: Vec<String> = text.collect();
        if !text.is_empty() && text.iter().all(|it| it.trim().is_empty()) {
            return Err(words.command.misuse("TEXT is empty"));
        }
        Ok(Self {
            text,
            in_folder: words.path("--in <FOLDER>"),
        })
    }
}

/// Adds the words of the arguments to the list of done things as one line. Without words, prints
/// the list and the steps that are still ahead.
///
/// # Errors
/// If the list can't be read or written.
pub(crate) fn done(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let list = Done::find(arguments.in_folder.as_deref());
    let text = arguments.text.join(" ");
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let said = match line.as_str() {
        "" => list.show()?,
        line => {
            list.add(line)?;
            format!("{}: {line}\n", name_from_here(&list.file))
        }
    };
    let mut lines = said.lines().map(names::escape_for_terminal);
    Ok(output::to_stdout(|out| {
        lines.try_for_each(|line| writeln!(out, "{line}"))
    })?)
}

/// The length that no list exceeds, in bytes.
const MOST_BYTES: u64 = 1 << 22;

/// The name of the file with the list of done things.
pub(crate) const DONE: &str = "done.md";

/// The list of done things in a reader's folder, a Markdown file: a line for each, with its day in
/// UTC.
pub(crate) struct Done {
    file: PathBuf,
}

impl Done {
    /// Takes the list in `folder`, whose file may not exist yet.
    pub(crate) fn in_folder(folder: &Path) -> Self {
        let file = folder.join(DONE);
        Self { file }
    }

    /// Takes the list in the `chosen` folder. Without one, that in the reader's folder `mine` if
    /// this is in the workspace or exists, and else that in the current folder.
    pub(crate) fn find(chosen: Option<&Path>) -> Self {
        let crates = ReaderCrates::find(None);
        match chosen {
            Some(folder) => Self::in_folder(folder),
            None if crates.is_of_workspace() || crates.folder().is_dir() => {
                Self::in_folder(crates.folder())
            }
            None => Self::in_folder(Path::new(".")),
        }
    }

    /// Adds to the list those of `things` that are not on it yet, and returns these, in their
    /// order.
    ///
    /// # Errors
    /// If the list can't be read or written.
    pub(crate) fn add_all(&self, things: &[String]) -> io::Result<Vec<String>> {
        let text = self.text()?;
        let is_new = |thing: &&String| !is_on(&text, thing);
        let news: Vec<String> = things.iter().filter(is_new).cloned().collect();
        for thing in &news {
            self.add(thing)?;
        }
        Ok(news)
    }

    /// Adds a line to the list, and changes nothing else in the file, which is the reader's.
    fn add(&self, thing: &str) -> io::Result<()> {
        let text = self.text()?;
        let before = match text.as_str() {
            "" => "# Done\n\n",
            text if text.ends_with('\n') => "",
            _ => "\n",
        };
        if let Some(folder) = self.file.parent() {
            fs::create_dir_all(folder)?;
        }
        let length = fs::metadata(&self.file).map_or(0, |it| it.len());
        // The day of a time such as 2026-11-23T17:41:00Z.
        let now = humantime::format_rfc3339_seconds(SystemTime::now()).to_string();
        let line = format!("{before}- {}  {thing}\n", &now[..10]);
        let file = OpenOptions::new()
            .append(true)
            .create(true)
            .open(&self.file);
        let added = file.and_then(|mut file| {
            file.write_all(line.as_bytes()).inspect_err(|_| {
                // A full disk leaves no half of a line.
                let _ = file.set_len(length);
            })
        });
        added.map_err(|cause| self.named(&cause))
    }

    /// Returns the text of the list, empty if there is no list yet.
    fn text(&self) -> io::Result<String> {
        match limited::read_bytes(&self.file, MOST_BYTES) {
            Ok(bytes) => Ok(String::from_utf8_lossy(&bytes).into_owned()),
            Err(cause) if cause.kind() == io::ErrorKind::NotFound => Ok(String::new()),
            Err(cause) => Err(self.named(&cause)),
        }
    }

    /// Returns true if a line of the list ends with `thing`; false if the list can't be read.
    pub(crate) fn has(&self, thing: &str) -> bool {
        self.text().is_ok_and(|text| is_on(&text, thing))
    }

    fn named(&self, cause: &io::Error) -> io::Error {
        io::Error::new(
            cause.kind(),
            format!("{}: {cause}", name_from_here(&self.file)),
        )
    }

    fn show(&self) -> Result<String, Box<dyn Error>> {
        let text = self.text()?;
        let lines: Vec<&str> = text.lines().filter(|line| line.starts_with("- ")).collect();
        let mut said = if lines.is_empty() {
            "Nothing is done yet.\n".to_owned()
        } else {
            let (list, lines) = (name_from_here(&self.file), lines.join("\n  "));
            format!("Done, in {list}\n  {lines}\n")
        };
        let ahead: String = Chapter::TYPED
            .into_iter()
            .flat_map(|chapter| ahead(chapter, &text))
            .collect();
        said += &if ahead.is_empty() {
            "Nothing is left: you have done all chapters.\n".to_owned()
        } else {
            format!("Ahead\n{ahead}")
        };
        Ok(said)
    }
}

/// Returns a line for each step of the chapter after the last one on the list, or none if the
/// chapter's picture is on it.
fn ahead(chapter: Chapter, text: &str) -> Vec<String> {
    if is_on(text, &picture_done_line(chapter)) {
        return Vec::new();
    }
    let steps = (1..).zip(steps::of_chapter(chapter));
    let last =
        (1..=steps::of_chapter(chapter).len()).rfind(|&n| is_on(text, &step_done_line(chapter, n)));
    steps
        .skip(last.unwrap_or(0))
        .map(|(number, step)| format!("  {:<14} {number}. {}", chapter.name(), step.instruction))
        .map(|line| wrap_hanging(&line, 20) + "\n")
        .collect()
}

/// Returns true if a line of the list ends with `thing`.
fn is_on(text: &str, thing: &str) -> bool {
    text.lines().any(|line| line.ends_with(thing))
}
