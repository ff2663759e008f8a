//! The `main` of a chapter.

use std::env;
use std::ffi::OsString;
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;

use crate::output;
use crate::picture::Picture;

/// Draws a picture and prints it as P3 text, or writes it to the file that is
/// named on the command line.
///
/// The exit code is 0 when all went well, 1 if the picture could not be
/// written, and 2 if the command line asks for something else; the message on
/// standard error names the fix.
pub fn main(picture: impl FnOnce() -> Picture) -> ExitCode {
    let arguments: Vec<OsString> = env::args_os().skip(1).collect();
    let destination = match destination(&arguments, io::stdout().is_terminal()) {
        Ok(destination) => destination,
        Err(problem) => {
            complain(&format!("{problem}\n\n{}", usage()));
            return ExitCode::from(2);
        }
    };
    let written = match destination {
        Destination::Help => output::to_stdout(|out| out.write_all(usage().as_bytes())),
        Destination::Stdout => output::to_stdout(|out| picture().write_p3(out)),
        Destination::File(path) => output::to_file(path, |out| picture().write_p3(out)),
    };
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            complain(&error.to_string());
            ExitCode::FAILURE
        }
    }
}

/// Where the picture goes, or the usage instead of it.
enum Destination<'a> {
    Help,
    Stdout,
    File(&'a Path),
}

fn destination(arguments: &[OsString], terminal: bool) -> Result<Destination<'_>, String> {
    let is_option = |argument: &&OsString| argument.to_string_lossy().starts_with('-');
    match arguments {
        [] if terminal => Err("the picture is a megabyte of numbers: send it to a file".to_owned()),
        [] => Ok(Destination::Stdout),
        [dash] if dash == "-" => Ok(Destination::Stdout),
        [option] if option == "-h" || option == "--help" => Ok(Destination::Help),
        [path] if !is_option(&path) && promises_another_format(Path::new(path)) => Err(format!(
            "{} would not be what its name says: this program writes .ppm files",
            path.display()
        )),
        [path] if !is_option(&path) => Ok(Destination::File(Path::new(path))),
        several => Err(match several.iter().find(is_option) {
            Some(option) => format!("there is no option {}", option.display()),
            None => "one file name is enough".to_owned(),
        }),
    }
}

fn promises_another_format(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| !extension.eq_ignore_ascii_case("ppm"))
}

fn complain(about: &str) {
    // If even this can't be written, there is nobody left to tell.
    let _ = writeln!(io::stderr(), "{}: {about}", program());
}

fn usage() -> String {
    let name = program();
    format!(
        "\
cargo run -p {name} > {name}.ppm
    prints the picture as plain PPM (P3)
cargo run -p {name} -- {name}.ppm
    writes the file itself; PowerShell before 7.4 needs this: its > changes the text
cargo rtrace show {name}
    shows the picture, at any width, or saves it as .png\n"
    )
}

fn program() -> String {
    let path = env::current_exe().unwrap_or_default();
    path.file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}
