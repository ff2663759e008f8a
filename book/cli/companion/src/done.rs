//! `done`: the list of things that a reader has done.

use std::error::Error;
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use check::names::{self, name_from_here};

use crate::command_line::Words;
use crate::limited;
use crate::reader_crates::ReaderCrates;

/// Adds the words to the list of done things as one line. Without words, returns the list.
pub(crate) fn done(words: &Words) -> Result<String, Box<dyn Error>> {
    let list = Done::find(words.path("--in").as_deref());
    let texts = words.values.iter().map(|it| it.to_string_lossy());
    let text = texts.collect::<Vec<_>>().join(" ");
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if words.values.is_empty() {
        return Ok(list.show()?);
    }
    if line.is_empty() {
        return Err(words.command.misuse("TEXT is empty"));
    }
    list.add(std::slice::from_ref(&line))?;
    let said = format!(
        "{}: {}\n",
        name_from_here(&list.file),
        names::escape_for_terminal(&line)
    );
    Ok(said)
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

    /// Takes the list in the `chosen` folder. Without one, that in the folder of the crate that the
    /// reader is in, or that in the reader's folder `mine` if this is in the workspace or exists, and
    /// else that in the current folder.
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
    pub(crate) fn add_all(&self, things: &[String]) -> io::Result<Vec<String>> {
        let text = self.text()?;
        let is_new = |thing: &&String| !is_on(&text, thing);
        let news: Vec<String> = things.iter().filter(is_new).cloned().collect();
        if !news.is_empty() {
            self.add(&news)?;
        }
        Ok(news)
    }

    /// Adds lines to the list, and changes nothing else in the file, which is the reader's.
    fn add(&self, things: &[String]) -> io::Result<()> {
        let mut added = match self.text()?.as_str() {
            "" => "# Done\n\n".to_owned(),
            text if text.ends_with('\n') => String::new(),
            _ => "\n".to_owned(),
        };
        // The day of a time such as 2026-11-23T17:41:00Z.
        let now = humantime::format_rfc3339_seconds(SystemTime::now()).to_string();
        for thing in things {
            added += &format!("- {}  {thing}\n", &now[..10]);
        }
        if let Some(folder) = self.file.parent() {
            fs::create_dir_all(folder)?;
        }
        let length = fs::metadata(&self.file).map_or(0, |it| it.len());
        let file = OpenOptions::new()
            .append(true)
            .create(true)
            .open(&self.file);
        let written = file.and_then(|mut file| {
            file.write_all(added.as_bytes()).inspect_err(|_| {
                // A full disk leaves no half of a line.
                let _ = file.set_len(length);
            })
        });
        written.map_err(|cause| self.named(&cause))
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

    fn show(&self) -> io::Result<String> {
        let text = self.text()?;
        let lines = text.lines().filter(|line| line.starts_with("- "));
        let lines = lines.map(|line| format!("  {}\n", names::escape_for_terminal(line)));
        let (list, lines) = (name_from_here(&self.file), lines.collect::<String>());
        Ok(match lines.as_str() {
            "" => "Nothing is done yet.\n".to_owned(),
            lines => format!("Done, in {list}\n{lines}"),
        })
    }
}

/// Returns true if a line of the list ends with `thing`.
fn is_on(text: &str, thing: &str) -> bool {
    text.lines().any(|line| line.ends_with(thing))
}
