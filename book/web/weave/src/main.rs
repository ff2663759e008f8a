//! `weave SOURCE FOLDER`: weaves the book in the folder SOURCE, and then puts it into FOLDER, which is
//! new or empty, or `target/book` beside SOURCE: an older book there goes. Without
//! arguments it serves mdBook's own program as a preprocessor.
//!
//! `cargo rtrace book` has cargo build this program and runs it, so that the command itself builds
//! without mdBook.

use std::ffi::OsString;
use std::io;
use std::path::Path;
use std::process::ExitCode;

use launcher::misuse::{exit_code, misuse};

fn main() -> ExitCode {
    let arguments: Vec<OsString> = std::env::args_os().skip(1).collect();
    let done = match &arguments[..] {
        [] => weave::preprocess(io::stdin(), io::stdout()),
        // mdBook asks before whether its renderer of this name is supported: each is.
        [supports, _] if supports == "supports" => Ok(()),
        [source, folder] => {
            let (source, folder) = (Path::new(source), Path::new(folder));
            let ours = source.with_file_name("target").join("book");
            weave::folder::replace(folder, &ours, |new| weave::weave(source, new))
        }
        _ => Err(misuse("two folders are needed: weave SOURCE FOLDER")),
    };
    exit_code(done.map(|()| ExitCode::SUCCESS))
}
