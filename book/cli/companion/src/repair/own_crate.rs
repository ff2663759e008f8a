//! Admission: which crates of a reader may be run with other texts than the reader's.
//!
//! A changed program runs with the reader's rights. So a crate is searched only if its text names
//! nothing by which a program reaches beyond its own memory and its output.

use std::fs;
use std::path::{Path, PathBuf};

use check::workspace;
use proc_macro2::{TokenStream, TokenTree};
use toml::{Table, Value};

use crate::limited;
use crate::sources;

/// A crate of a reader's that may be searched.
pub(super) struct OwnCrate {
    /// The crate's folder.
    pub(super) folder: PathBuf,
    /// Its manifest, for the copy: with absolute paths.
    pub(super) manifest: Table,
    /// Its files below `src`, each with its path in the crate.
    pub(super) files: Vec<(String, String)>,
    /// The test of the laws; empty if there is none.
    pub(super) laws: String,
    /// True if `src/main.rs` here takes the width of the picture from the environment.
    pub(super) is_sized: bool,
}

/// The file of the program, and how it asks for the book's width.
const MAIN: &str = "src/main.rs";
const BOOK_WIDTH: &str = "(400";
/// What asks for another width: all edits are tried on a small picture first.
const ANY_WIDTH: &str = "(crate::rtrace_width() as _";

/// Words by which a text reaches files, other programs, the network or foreign code.
const REFUSED: [&str; 20] = [
    "fs",
    "File",
    "OpenOptions",
    "DirBuilder",
    "net",
    "TcpStream",
    "TcpListener",
    "UdpSocket",
    "os",
    "Path",
    "PathBuf",
    "Command",
    "unsafe",
    "extern",
    "include",
    "include_str",
    "include_bytes",
    "asm",
    "global_asm",
    "libc",
];

/// Modules of which only these items are harmless.
const NARROW: [(&str, &[&str]); 4] = [
    ("process", &["ExitCode", "exit", "abort"]),
    ("env", &["args"]),
    // A glob or another name would bring in the rest.
    ("std", &["*", "as"]),
    ("core", &["*", "as"]),
];

/// The packages of this project that a crate of `start` depends on, each with its folder.
const PACKAGES: [(&str, &str); 2] = [("common", "common"), ("laws", "tests/laws")];

/// The parts of a manifest that change nothing but how the crate is built.
const PARTS: [&str; 8] = [
    "package",
    "lib",
    "bin",
    "dependencies",
    "dev-dependencies",
    "workspace",
    "profile",
    "lints",
];

impl OwnCrate {
    /// Reads the crate in `folder`.
    ///
    /// # Errors
    /// If it may not be searched; the text says why, after "not searched: ".
    pub(super) fn read(folder: &Path) -> Result<Self, String> {
        let unread = |cause| format!("its Cargo.toml can't be read: {cause}");
        let manifest = limited::read_text(&folder.join("Cargo.toml"));
        let manifest = manifest.map_err(|it| unread(it.to_string()))?;
        let manifest: Table = manifest
            .parse()
            .map_err(|_| unread("it is no TOML".to_owned()))?;
        let files = sources::rust_files(folder);
        for file in &files {
            admit(&file.name, &file.text)?;
        }
        let laws = limited::read_text(&folder.join("tests/laws.rs")).unwrap_or_default();
        admit("tests/laws.rs", &laws)?;
        let mut files: Vec<_> = files.into_iter().map(|it| (it.name, it.text)).collect();
        let main = files.iter_mut().find(|it| it.0 == MAIN);
        let main = main.filter(|it| it.1.matches(BOOK_WIDTH).count() == 1);
        let is_sized = main.is_some();
        if let Some((_, text)) = main {
            *text = text.replace(BOOK_WIDTH, ANY_WIDTH);
        }
        Ok(Self {
            manifest: admitted_manifest(folder, manifest)?,
            folder: folder.to_owned(),
            files,
            laws,
            is_sized,
        })
    }

    /// Returns true if the file with this index is what `start` gives, and nobody types.
    pub(super) fn is_given(&self, file: usize) -> bool {
        self.is_sized && self.files[file].0 == MAIN
    }
}

/// Checks a manifest, and returns it with absolute paths.
fn admitted_manifest(folder: &Path, mut manifest: Table) -> Result<Table, String> {
    let parts = manifest.keys().find(|it| !PARTS.contains(&&***it));
    if let Some(part) = parts {
        return Err(format!("its Cargo.toml has [{part}]"));
    }
    let has = |part: &str, key: &str| manifest.get(part).is_some_and(|it| it.get(key).is_some());
    if has("package", "build") || fs::symlink_metadata(folder.join("build.rs")).is_ok() {
        return Err("it has a build script, which would run".to_owned());
    }
    if has("lib", "proc-macro") || has("workspace", "members") {
        return Err("its Cargo.toml makes more than one program of it".to_owned());
    }
    for part in ["dependencies", "dev-dependencies"] {
        let Some(Value::Table(packages)) = manifest.get_mut(part) else {
            continue;
        };
        for (name, package) in packages {
            let path = package.get("path").and_then(Value::as_str);
            let path = path.and_then(|it| folder.join(it).canonicalize().ok());
            match path.filter(|it| is_ours(name, it)) {
                Some(path) => {
                    let path = Value::String(path.display().to_string());
                    *package = Table::from_iter([("path".to_owned(), path)]).into();
                }
                None => return Err(format!("it depends on {name}, which may write files")),
            }
        }
    }
    Ok(manifest)
}

/// Returns true for the folder of the package of that name in this workspace.
fn is_ours(name: &str, folder: &Path) -> bool {
    let ours = PACKAGES.iter().find(|it| it.0 == name);
    let ours = ours.and_then(|it| Some(workspace::workspace()?.join(it.1)));
    ours.and_then(|it| it.canonicalize().ok())
        .is_some_and(|it| it == folder)
}

/// Refuses a text that reaches beyond its own memory and its output.
fn admit(name: &str, text: &str) -> Result<(), String> {
    let tokens: TokenStream = text.parse().map_err(|_| format!("{name} is not Rust"))?;
    let mut all = Vec::new();
    flatten(tokens, &mut all);
    for (n, (word, line)) in all.iter().enumerate() {
        let narrow = NARROW.iter().find(|it| it.0 == word);
        let next = |n: usize| all.get(n).map_or("", |it| &*it.0);
        let is_path = [next(n + 1), next(n + 2)] == [":", ":"];
        let is_refused = REFUSED.contains(&&**word)
            || narrow.is_some_and(|(module, items)| match (is_path, *module) {
                (true, "std" | "core") => items.contains(&next(n + 3)),
                (true, _) => !items.contains(&next(n + 3)),
                (false, _) => next(n + 1) == "as",
            });
        if is_refused {
            return Err(format!(
                "{name}:{line} has `{word}`, which reaches beyond the program"
            ));
        }
    }
    Ok(())
}

/// Lists all words and signs of a text, also inside of brackets, each with its line.
fn flatten(tokens: TokenStream, all: &mut Vec<(String, usize)>) {
    for token in tokens {
        let line = token.span().start().line;
        match token {
            TokenTree::Group(group) => {
                all.push(("(".to_owned(), line));
                flatten(group.stream(), all);
                all.push((")".to_owned(), line));
            }
            TokenTree::Ident(word) => {
                let word = word.to_string();
                all.push((word.trim_start_matches("r#").to_owned(), line));
            }
            TokenTree::Punct(sign) => all.push((sign.as_char().to_string(), line)),
            TokenTree::Literal(_) => all.push((String::new(), line)),
        }
    }
}
