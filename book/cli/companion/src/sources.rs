//! Source discovery: finds the source files of a reader's program, by its name or its picture.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use check::names;
use check::sources::{SourceFile, Sources};
use language::Language;
use slips::{Chapter, Edition, ReaderLanguage};

use crate::limited;

/// The source files of a reader's program, as far as they could be found.
#[derive(Default)]
pub(crate) struct FoundSources {
    /// The files; empty if none were found.
    pub(crate) sources: Sources,
    /// The language of the first file; `None` if there is no file.
    pub(crate) language: Option<Language>,
    /// A sentence that says why files that were found are not read, and how to name the right ones;
    /// `None` if they are read, or there are none.
    pub(crate) why_none: Option<String>,
}

impl FoundSources {
    /// Returns the language in which an answer shows lines, if that is Rust or Python; `None` for
    /// all others, to which the book's C++ is shown.
    pub(crate) fn reader_language(&self) -> Option<ReaderLanguage> {
        match self.language? {
            Language::Rust => Some(ReaderLanguage::Rust),
            Language::Python => Some(ReaderLanguage::Python(Edition::V4)),
            _ => None,
        }
    }
}

/// Reads the files of a crate that `start` made for `chapter`, beside the chapter's own.
pub(crate) fn of_crate(folder: &Path, chapter: Chapter) -> Sources {
    let files = all_in(folder, Path::new("src"));
    Sources::of_chapter(texts(folder, &files), chapter)
}

/// Finds the files of a reader's program below `folder`: those that its command `words` names, or
/// else those with the program's name, or else all, if at most one of them has a `main`.
pub(crate) fn of_program(words: &[OsString], folder: &Path) -> FoundSources {
    let command = words.iter().filter_map(|it| it.to_str());
    let is_end = |c: char| c.is_whitespace() || "'\"=;&|".contains(c);
    let words: Vec<&str> = command.flat_map(|it| it.split(is_end)).collect();
    found(folder, all_in(folder, Path::new("")), &words)
}

/// Finds the files beside a picture from which it was drawn. If one was changed after the picture,
/// reads none, and says so.
pub(crate) fn beside_picture(picture: &Path) -> FoundSources {
    let folder = picture.parent().unwrap_or(Path::new(""));
    let folder = if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    };
    let drawn = changed(picture);
    let (files, newer): (Vec<_>, Vec<_>) = all_in(folder, Path::new(""))
        .into_iter()
        .partition(|it| changed(&folder.join(it)) <= drawn);
    let name = picture.file_name().and_then(|it| it.to_str());
    match &newer[..] {
        [] => found(folder, files, &[name.unwrap_or_default()]),
        [first, ..] => FoundSources {
            why_none: Some(format!(
                "No source was read: {} was changed after the picture was drawn.",
                names::escaped_name(first)
            )),
            ..FoundSources::default()
        },
    }
}

fn changed(path: &Path) -> Option<SystemTime> {
    fs::metadata(path).and_then(|it| it.modified()).ok()
}

/// Chooses the files of one program among `files`, by the words of the command that runs it.
fn found(folder: &Path, files: Vec<PathBuf>, words: &[&str]) -> FoundSources {
    let is_named = |it: &&PathBuf| {
        words
            .iter()
            .any(|word| Path::new(word.trim_start_matches("./")) == **it)
    };
    let stems: Vec<&str> = words
        .iter()
        .filter_map(|word| Path::new(word).file_stem()?.to_str())
        .collect();
    let is_called_so = |it: &&PathBuf| stem(it).is_some_and(|stem| stems.contains(&stem));
    let texts = texts(folder, &files);
    let is_main = |it: &&PathBuf| {
        let file = texts.iter().find(|file| Path::new(&file.name) == **it);
        file.is_some_and(|it| begins(&it.text))
    };
    let choose =
        |is: &dyn Fn(&&PathBuf) -> bool| files.iter().filter(|it| is(it)).collect::<Vec<_>>();
    let mut chosen = choose(&is_named);
    if chosen.is_empty() {
        chosen = choose(&is_called_so);
    }
    let programs = choose(&is_main);
    let all = match (chosen.is_empty(), programs.len()) {
        (true, 2..) => {
            let names: Vec<_> = programs
                .iter()
                .take(3)
                .map(|it| names::escaped_name(it).to_string())
                .collect();
            return FoundSources {
                why_none: Some(format!(
                    "No source was read: {} are programs of their own. Name the right one in your command, or give it the name of your program.",
                    names.join(", ")
                )),
                ..FoundSources::default()
            };
        }
        (true, _) => texts,
        (false, _) => with_imports(&chosen, &programs, texts),
    };
    let language = all.first().and_then(|it| Language::of_file(&it.name));
    FoundSources {
        sources: Sources::new(all, Vec::new()),
        language,
        why_none: None,
    }
}

/// Adds to the chosen files those that they import, directly or not: by the name in a line that
/// imports, or, in languages in which a folder is a package, all files without a `main`.
fn with_imports(
    chosen: &[&PathBuf],
    programs: &[&PathBuf],
    texts: Vec<SourceFile>,
) -> Vec<SourceFile> {
    let is = |name: &str, all: &[&PathBuf]| all.iter().any(|it| it.as_path() == Path::new(name));
    let (mut taken, mut rest): (Vec<_>, Vec<_>) =
        texts.into_iter().partition(|it| is(&it.name, chosen));
    let mut next = 0;
    while next < taken.len() {
        let SourceFile { name, text } = taken[next].clone();
        let language = Language::of_file(&name);
        let (more, others) = rest.into_iter().partition(|SourceFile { name, .. }| {
            Language::of_file(name) == language
                && (imports(&text, name) || takes_its_folder(language) && !is(name, programs))
        });
        taken.extend::<Vec<_>>(more);
        (rest, next) = (others, next + 1);
    }
    taken
}

fn takes_its_folder(language: Option<Language>) -> bool {
    use Language::{CSharp, Go, Java, Kotlin, Rust, Swift};
    matches!(language, Some(CSharp | Go | Java | Kotlin | Rust | Swift))
}

/// Returns true if a line of the text imports the file of that name.
fn imports(text: &str, name: &str) -> bool {
    let is_import = |line: &&str| {
        let words = ["#include", "import", "from", "export"];
        words.iter().any(|it| line.starts_with(it)) || line.contains("require(")
    };
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let stem = Path::new(name).file_stem().and_then(|it| it.to_str());
    let lines = text.lines().map(str::trim).filter(is_import);
    lines
        .flat_map(|line| line.split(|c| !is_word(c)))
        .any(|word| Some(word) == stem)
}

/// Returns true if the text has a `main`, where a program begins.
fn begins(text: &str) -> bool {
    [" main(", "__main__", "Main(string"]
        .iter()
        .any(|it| text.contains(it))
}

fn stem(path: &Path) -> Option<&str> {
    path.file_stem()?.to_str()
}

/// Returns true if the file is a source in a language that is read here, by its extension.
pub(crate) fn is_source(path: &Path) -> bool {
    language(path).is_some()
}

/// Returns the language of a source file by its extension; `None` for any other file.
pub(crate) fn language(path: &Path) -> Option<Language> {
    Language::of_file(path.file_name()?.to_str()?)
}

/// The number of files that no program of these chapters exceeds.
const MOST_FILES: usize = 40;
/// The number of folders, one in the other, that no program of these chapters exceeds.
const DEEPEST: usize = 3;
/// The names of folders with others' sources, or with what was built.
const OTHERS: [&str; 7] = [
    "target",
    "build",
    "node_modules",
    "venv",
    "dist",
    "out",
    "bin",
];

/// Lists the sources in the folder `below` and the folders in it, each with its path from `folder`:
/// at most [`MOST_FILES`], the nearest first.
fn all_in(folder: &Path, below: &Path) -> Vec<PathBuf> {
    let mut all = Vec::new();
    let mut folders = vec![below.to_owned()];
    for _ in 0..=DEEPEST {
        let mut next = Vec::new();
        for below in folders {
            let entries = fs::read_dir(folder.join(&below))
                .into_iter()
                .flatten()
                .flatten();
            let mut paths: Vec<_> = entries.map(|it| below.join(it.file_name())).collect();
            paths.sort();
            for path in paths.into_iter().filter(|it| !is_of_others(it)) {
                match folder.join(&path).symlink_metadata() {
                    Ok(it) if it.is_dir() => next.push(path),
                    Ok(_) if is_source(&path) => all.push(path),
                    _ => {}
                }
            }
        }
        folders = next;
    }
    all.truncate(MOST_FILES);
    all
}

fn is_of_others(path: &Path) -> bool {
    let name = path.file_name().and_then(|it| it.to_str());
    name.is_none_or(|it| it.starts_with(['.', '_']) || OTHERS.contains(&it))
}

/// Reads the files, but for those that are too long or are not UTF-8.
fn texts(folder: &Path, files: &[PathBuf]) -> Vec<SourceFile> {
    let file = |it: &PathBuf| {
        let text = limited::read_text(&folder.join(it)).ok()?;
        Some(SourceFile::new(it.to_str()?, text))
    };
    files.iter().filter_map(file).collect()
}
