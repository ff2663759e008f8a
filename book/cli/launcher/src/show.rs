//! `show`: one picture, wherever the reader wants it.

use std::error::Error;
use std::path::Path;

use common::engine::parse_width;
use course::chapter::Chapter;
use course::names;

use crate::cargo::{self, Package};
use crate::command_line::Words;
use crate::draw;
use crate::drawing::Drawing;
use crate::misuse::misuse;
use crate::output;
use crate::save::{PictureFormat, save};
use crate::terminal::{self, Palette};

/// Has the program of a chapter draw its picture. Then prints it as P3, saves it, opens it in a
/// viewer, or shows it in the terminal, as the words say.
///
/// # Errors
/// If the words contradict each other, if the chapter does not compile, if there is no terminal
/// with colors to show the picture in, or if it can't be written or opened.
pub(crate) fn show(words: &Words) -> Result<(), Box<dyn Error>> {
    let chapter = words.required_chapter()?;
    let width = words.option("--width", parse_width)?;
    let width = width.unwrap_or(chapter.book_width());
    let drawing = || start(chapter, width);
    let opens = words.has("--open");
    match words.path("--output") {
        Some(path) if path == Path::new("-") && opens => Err(misuse(
            "--open needs a file: name one with --output, or leave --output out",
        )),
        Some(path) if path == Path::new("-") => {
            let drawing = drawing()?;
            Ok(output::to_stdout(|out| drawing.copy(out))?)
        }
        Some(path) => {
            let why = "the name must end in .png or .ppm, or be - for standard output";
            let refused = || words.refused("--output", &path.to_string_lossy(), why);
            let format = PictureFormat::of(&path).ok_or_else(refused)?;
            save_and_say(drawing()?, format, &path, opens)
        }
        None if opens => {
            let path = draw::pictures_folder()?.join(chapter.name());
            let path = path.with_extension("png");
            save_and_say(drawing()?, PictureFormat::Png, &path, opens)
        }
        None => {
            let palette = Palette::of_stdout().ok_or_else(|| {
                misuse(
                    "there is no terminal with colors here to show the picture in: \
                     name a file with --output, or print the numbers with --output -",
                )
            })?;
            let picture = drawing()?.picture()?;
            Ok(output::to_stdout(|out| {
                terminal::show_picture(&picture, palette, out)
            })?)
        }
    }
}

/// Starts the chapter's program, which cargo builds first if it is not up to date.
fn start(chapter: Chapter, width: u32) -> Result<Drawing, Box<dyn Error>> {
    let (name, package) = (chapter.name(), Package::of(chapter));
    let built = cargo::build(&[package], &format!("Building {name}"))?;
    let missing = || built.failure(package);
    let program = built.program(package).ok_or_else(missing)?;
    let drawing = Drawing::start(&program, width);
    drawing.map_err(|cause| format!("{name} draws nothing: {cause}").into())
}

/// Saves the picture, prints where, and opens it in a viewer if `opens`.
fn save_and_say(
    drawing: Drawing,
    format: PictureFormat,
    path: &Path,
    opens: bool,
) -> Result<(), Box<dyn Error>> {
    let (width, height) = (drawing.width, drawing.height);
    match format {
        PictureFormat::Ppm => output::to_file(path, |out| drawing.copy(out))?,
        PictureFormat::Png => save(&drawing.picture()?, format, path)?,
    }
    let shown = names::escaped_name(path);
    output::print(&format!("{width} × {height} pixels in {shown}\n"))?;
    if opens {
        open::that_detached(path).map_err(|cause| {
            format!("no viewer opened {shown}: {cause}\nOpen the picture by hand.")
        })?;
    }
    Ok(())
}
