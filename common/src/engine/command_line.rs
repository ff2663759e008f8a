//! The command line of a chapter: a width, and where the picture goes.

use std::env;
use std::fs::{self, File};
use std::io::{self, BufWriter, ErrorKind, IsTerminal, Write};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::process::{self, ExitCode};

use lexopt::{Arg, ValueExt};

use super::picture::Picture;

/// The widths, in pixels, that a command line may ask for. At the largest one, as a PNG file, the
/// square picture takes 805 MB of memory and the others 453 MB; as text they take next to nothing.
pub const WIDTHS: RangeInclusive<u32> = 1..=16_384;

/// Runs the program of a chapter: draws `picture` at `book_width` pixels, or at the width that the
/// command line asks for, and prints it as P3 text, or writes that to the file named there.
///
/// The exit code is 0 if all went well, 1 if the picture could not be written, and 2 if the command
/// line is wrong; a message on standard error then names the fix.
pub fn main(book_width: u32, picture: fn(u32) -> Picture) -> ExitCode {
    let wish = match Wish::read(book_width, io::stdout().is_terminal()) {
        Ok(wish) => wish,
        Err(problem) => {
            complain(&format!("{problem}\n\n{}", usage(book_width)));
            return ExitCode::from(2);
        }
    };
    let written = match &wish {
        Wish::Help => print(|out| out.write_all(usage(book_width).as_bytes())),
        Wish::Stdout(width) => print(|out| picture(*width).write_p3(out)),
        Wish::File(width, path) => save(&picture(*width), path),
    };
    let Err(cause) = written else {
        return ExitCode::SUCCESS;
    };
    let place = match &wish {
        Wish::File(_, path) => &format!("{path:?}"),
        _ => "standard output",
    };
    let fix = match cause.kind() {
        ErrorKind::StorageFull => "Free some space, or write to another disk.",
        _ => "Name a file that you may write, in a folder that is there.",
    };
    complain(&format!("cannot write {place}: {cause}\n{fix}"));
    ExitCode::FAILURE
}

/// Reads a width in pixels from a command line.
///
/// # Errors
/// If `text` is no whole number, or not in [`WIDTHS`]; the message says which numbers are.
pub fn parse_width(text: &str) -> Result<u32, String> {
    let width = text.parse().ok().filter(|width| WIDTHS.contains(width));
    width.ok_or_else(|| {
        let (least, most) = WIDTHS.into_inner();
        format!("choose a whole number of pixels from {least} to {most}, such as 400")
    })
}

/// Writes to standard output. A reader that has seen enough and closes the pipe, as `head` does, is
/// no error.
fn print(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut stdout = BufWriter::new(io::stdout().lock());
    match write(&mut stdout).and_then(|()| stdout.flush()) {
        Err(cause) if cause.kind() == ErrorKind::BrokenPipe => Ok(()),
        printed => printed,
    }
}

/// Writes a file, which appears whole or not at all: it is renamed when it is complete.
fn save(picture: &Picture, path: &Path) -> io::Result<()> {
    // A link stays a link.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if fs::metadata(&target).is_ok_and(|old| old.permissions().readonly()) {
        return Err(ErrorKind::PermissionDenied.into());
    }
    let partial = target.with_extension(format!("{}.partial", process::id()));
    let mut out = BufWriter::with_capacity(1 << 16, File::create_new(&partial)?);
    let written = picture.write_p3(&mut out).and_then(|()| out.flush());
    let saved = written.and_then(|()| fs::rename(&partial, target));
    if saved.is_err() {
        // The first failure is the one to report, whether or not this works.
        let _ = fs::remove_file(&partial);
    }
    saved
}

/// The request of a command line: help, or a picture of this width in pixels to standard output or
/// to a file.
enum Wish {
    Help,
    Stdout(u32),
    File(u32, PathBuf),
}

impl Wish {
    fn read(book_width: u32, terminal: bool) -> Result<Self, lexopt::Error> {
        let mut width = book_width;
        let mut file: Option<PathBuf> = None;
        let mut arguments = lexopt::Parser::from_env();
        while let Some(argument) = arguments.next()? {
            match argument {
                Arg::Short('h') | Arg::Long("help") => return Ok(Self::Help),
                Arg::Long("width") => {
                    let said = arguments.value()?.string()?;
                    width = parse_width(&said).map_err(|fix| format!("--width {said:?}: {fix}"))?;
                }
                Arg::Value(_) if file.is_some() => return Err("one file name is enough".into()),
                Arg::Value(name) => file = Some(name.into()),
                Arg::Short(letter) => return Err(no_option(&format!("-{letter}"))),
                Arg::Long(name) => return Err(no_option(&format!("--{name}"))),
            }
        }
        match file {
            None if terminal => {
                Err("the picture is a megabyte of numbers: send it to a file".into())
            }
            None => Ok(Self::Stdout(width)),
            Some(dash) if dash == Path::new("-") => Ok(Self::Stdout(width)),
            Some(path) if is_ppm(&path) => Ok(Self::File(width, path)),
            Some(path) => Err(format!("{path:?}: this program writes .ppm files").into()),
        }
    }
}

/// Returns the error about an unknown option. `Debug` escapes it, so that a terminal shows the
/// option and does not obey it.
fn no_option(typed: &str) -> lexopt::Error {
    format!("there is no option {typed:?}").into()
}

fn is_ppm(path: &Path) -> bool {
    let extension = path.extension();
    extension.is_some_and(|extension| extension.eq_ignore_ascii_case("ppm"))
}

fn complain(about: &str) {
    // If even this can't be written, there is nobody left to tell.
    let _ = writeln!(io::stderr(), "{}: {about}", program());
}

fn usage(book_width: u32) -> String {
    let name = program();
    format!(
        "\
cargo run -p {name} > {name}.ppm
    prints the picture as plain PPM (P3)
cargo run -p {name} -- {name}.ppm
    writes the file itself; PowerShell before 7.4 needs this: its > changes the text
cargo run -p {name} -- --width 1001 {name}.ppm
    as wide as you like; {book_width} pixels without it
cargo rtrace show {name}
    shows the picture, or saves it as .png\n"
    )
}

fn program() -> String {
    let path = env::current_exe().unwrap_or_default();
    path.file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}
