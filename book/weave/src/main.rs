//! `weave SOURCE FOLDER`: weaves the book in the folder SOURCE into an empty FOLDER.
//!
//! `cargo rtrace book` has cargo run this into a temporary folder, and puts the book in its
//! place. So the companion builds without mdBook.

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let [source, folder] = &arguments[..] else {
        eprintln!("usage: weave SOURCE FOLDER");
        return ExitCode::from(2);
    };
    match weave::weave(Path::new(source), Path::new(folder)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
