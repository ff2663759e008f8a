//! `show`: one picture, wherever the reader wants it.

use std::error::Error;
use std::path::Path;

use common::engine::parse_width;
use common::rtweekend::Picture;
use course::chapter::Chapter;
use course::names;

use crate::cargo::{self, Package};
use crate::command_line::Words;
use crate::draw;
use crate::drawing::drawn_by;
use crate::misuse::misuse;
use crate::output;
use crate::save::{PictureFormat, save};
use crate::terminal::{self, Palette};

/// Has the program of a chapter draw its picture. Then prints it as P3, saves it, opens it in a
/// viewer, or shows it in the terminal, as the words say.
pub(crate) fn show(words: &Words) -> Result<(), Box<dyn Error>> {
    let chapter = words.required_chapter()?;
    let width = words.option("--width", parse_width)?;
    let width = width.unwrap_or(chapter.book_width());
    let picture = || drawn(chapter, width);
    let opens = words.has("--open");
    match words.path("--output") {
        Some(path) if path == Path::new("-") && opens => Err(misuse(
            "--open needs a file: name one with --output, or leave --output out",
        )),
        Some(path) if path == Path::new("-") => {
            let picture = picture()?;
            Ok(output::to_stdout(|out| picture.write_p3(out))?)
        }
        Some(path) => {
            let why = "the name must end in .png or .ppm, or be - for standard output";
            let refused = || words.refused("--output", &path.to_string_lossy(), why);
            let format = PictureFormat::of(&path).ok_or_else(refused)?;
            save_and_say(&picture()?, format, &path, opens)
        }
        None if opens => {
            let path = draw::pictures_folder()?.join(chapter.name());
            let path = path.with_extension("png");
            save_and_say(&picture()?, PictureFormat::Png, &path, opens)
        }
        None => {
            let palette = Palette::of_stdout().ok_or_else(|| {
                misuse(
                    "there is no terminal with colors here to show the picture in: \
                     name a file with --output, or print the numbers with --output -",
                )
            })?;
            let picture = picture()?;
            Ok(output::to_stdout(|out| {
                terminal::show_picture(&picture, palette, out)
            })?)
        }
    }
}

/// Has the chapter's program draw its picture; cargo builds it first if it is not up to date.
fn drawn(chapter: Chapter, width: u32) -> Result<Picture, Box<dyn Error>> {
    let (name, package) = (chapter.name(), Package::of(chapter));
    let built = cargo::build(&[package], &format!("Building {name}"))?;
    let missing = || built.failure(package);
    let program = built.program(package).ok_or_else(missing)?;
    let picture = drawn_by(&program, width);
    picture.map_err(|cause| format!("{name} draws nothing: {cause}").into())
}

/// Saves the picture, prints where, and opens it in a viewer if `opens`.
fn save_and_say(
    picture: &Picture,
    format: PictureFormat,
    path: &Path,
    opens: bool,
) -> Result<(), Box<dyn Error>> {
    save(picture, format, path)?;
    let (width, height) = (picture.width(), picture.height());
    let shown = names::escaped_name(path);
    output::print(&format!("{width} × {height} pixels in {shown}\n"))?;
    if opens {
        open::that_detached(path).map_err(|cause| {
            format!("no viewer opened {shown}: {cause}\nOpen the picture by hand.")
        })?;
    }
    Ok(())
}
