//! Names on a command line. That of a chapter may be its number, or its folder as a shell
//! completes it.

use std::error::Error;
use std::ffi::OsStr;
use std::path::Path;

use course::chapter::Chapter;

use crate::command_line::{Words, suggestion};

/// Returns the chapter that the first word of a command line names, one of those of its command: by
/// its name, its number from 0, or a path whose last part is its name or its folder, such as
/// `normals`, `3` or `chapters/3_normals/`. Returns `None` if there is no word.
///
/// # Errors
/// If the word means no chapter of the command; the message lists them, and names the one that is
/// most alike.
pub fn chapter(words: &Words) -> Result<Option<Chapter>, Box<dyn Error>> {
    let Some(typed) = words.values.first() else {
        return Ok(None);
    };
    let mut chapters = words.command.chapters().iter();
    let found = chapters.find(|&&chapter| is_meant(typed, chapter)).copied();
    let names = words
        .command
        .chapters()
        .iter()
        .map(|chapter| chapter.name());
    found.map(Some).ok_or_else(|| {
        let typed = typed.to_string_lossy();
        words.refused("CHAPTER", &typed, &choose_one_of(&typed, names))
    })
}

/// Returns the chapter of [`chapter`], which must be there.
///
/// # Errors
/// If it is not, or the word means no chapter of the command.
pub fn required_chapter(words: &Words) -> Result<Chapter, Box<dyn Error>> {
    chapter(words)?.ok_or_else(|| words.command.misuse("CHAPTER is missing"))
}

/// Lists the names that a word should be one of, and asks for the one that is most alike.
pub fn choose_one_of<'a>(typed: &str, names: impl Iterator<Item = &'a str> + Clone) -> String {
    let suggested = suggestion(typed, names.clone());
    let names: Vec<&str> = names.collect();
    format!("choose one of {}{suggested}", names.join(", "))
}

/// Returns true if `typed` means the chapter, as `normals`, `3`, `chapters/3_normals/` and
/// `mine/normals` mean [`Chapter::Normals`].
fn is_meant(typed: &OsStr, chapter: Chapter) -> bool {
    let (number, name) = (chapter as usize, chapter.name());
    let last = Path::new(typed).file_name().unwrap_or_default();
    [name, &format!("{number}"), &format!("{number}_{name}")]
        .map(OsStr::new)
        .contains(&last)
}
