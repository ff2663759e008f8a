//! `weave SOURCE FOLDER`: weaves the book in the folder SOURCE, and then puts it in the place of an
//! older one in FOLDER. Without arguments it serves mdBook's own program as a preprocessor.
//!
//! `cargo rtrace book` has cargo build this program and runs it, so that the command itself builds
//! without mdBook.

use std::error::Error;
use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;
use std::{fs, io};

use common::engine::output;
use launcher::files;
use launcher::misuse::{exit_code, misuse};

fn main() -> ExitCode {
    let arguments: Vec<OsString> = std::env::args_os().skip(1).collect();
    exit_code(match &arguments[..] {
        [] => weave::preprocess(io::stdin(), io::stdout()),
        // mdBook asks before whether its renderer of this name is supported: each is.
        [supports, _] if supports == "supports" => Ok(()),
        [source, folder] => replace(Path::new(source), Path::new(folder)),
        _ => Err(misuse("two folders are needed: weave SOURCE FOLDER")),
    })
}

/// The word for the folder's content in the message that refuses a folder of something else.
const KIND: &str = "book";

/// Weaves the book into a new folder, and only when it is complete, replaces the old one.
fn replace(source: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    files::refuse_strangers(folder, KIND)?;
    let new = folder.join("new");
    output::forget_partials(&new);
    let woven = output::partial(&new)?;
    fs::create_dir_all(&woven).map_err(|cause| format!("cannot write {folder:?}: {cause}"))?;
    let read = weave::weave(source, &woven).and_then(|()| Ok(files::read_folder(&woven)?));
    fs::remove_dir_all(&woven)?;
    files::fill_folder(folder, KIND, &read?)
}
