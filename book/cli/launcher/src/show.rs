//! `show`: one picture, wherever the reader wants it.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{OsStringValueParser, TypedValueParser};
use common::engine::{output, parse_width};
use common::rtweekend::Picture;
use course::chapter::Chapter;
use course::names;

use crate::chapter::ChapterParser;
use crate::draw;
use crate::misuse::misuse;
use crate::save::{PictureFormat, save};
use crate::terminal::{self, Palette};

/// The arguments of `cargo rtrace show`.
#[derive(Args)]
pub struct Arguments {
    /// The chapter whose picture to draw
    #[arg(value_name = "CHAPTER", value_parser = ChapterParser(&Chapter::ALL))]
    chapter: Chapter,

    /// Width in pixels [default: as in the book]
    #[arg(long, value_name = "N", value_parser = parse_width, allow_hyphen_values = true)]
    width: Option<u32>,

    /// A .png or .ppm file, or - to print the numbers (P3); without it the
    /// terminal shows the picture
    #[arg(long, short, value_name = "FILE", value_parser = destination_parser())]
    output: Option<Destination>,

    /// Open the picture in the system's viewer
    #[arg(long)]
    open: bool,
}

/// Draws the picture of a chapter, at the book's width unless the arguments have another. Then
/// prints it as P3, saves it, opens it in a viewer, or shows it in the terminal, as the arguments
/// say.
///
/// # Errors
/// If the arguments contradict each other, if there is no terminal with colors to show the picture
/// in, or if it can't be written or opened.
pub fn show(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let Arguments {
        chapter,
        width,
        output,
        open,
    } = arguments;
    let picture = || chapter.picture(width.unwrap_or(chapter.book_width()));
    match output {
        Some(Destination::Stdout) if *open => Err(misuse(
            "--open needs a file: name one with --output, or leave --output out",
        )),
        Some(Destination::Stdout) => Ok(output::to_stdout(|out| picture().write_p3(out))?),
        Some(Destination::File(path, format)) => save_and_say(&picture(), *format, path, *open),
        None if *open => {
            let path = draw::pictures_folder()?
                .join(chapter.name())
                .with_extension("png");
            save_and_say(&picture(), PictureFormat::Png, &path, true)
        }
        None => {
            let palette = Palette::of_stdout().ok_or_else(|| {
                misuse(
                    "there is no terminal with colors here to show the picture in: \
                     name a file with --output, or print the numbers with --output -",
                )
            })?;
            Ok(output::to_stdout(|out| {
                terminal::show_picture(&picture(), palette, out)
            })?)
        }
    }
}

/// The place for a picture that is not shown in the terminal.
#[derive(Clone, Debug)]
enum Destination {
    Stdout,
    File(PathBuf, PictureFormat),
}

fn save_and_say(
    picture: &Picture,
    format: PictureFormat,
    path: &Path,
    open: bool,
) -> Result<(), Box<dyn Error>> {
    save(picture, format, path)?;
    let (width, height) = (picture.width(), picture.height());
    let said = format!(
        "{width} × {height} pixels in {}\n",
        names::escaped_name(path)
    );
    output::to_stdout(|out| out.write_all(said.as_bytes()))?;
    if open {
        open::that_detached(path).map_err(|cause| {
            format!(
                "no viewer opened {}: {cause}\nOpen the picture by hand.",
                path.display()
            )
        })?;
    }
    Ok(())
}

fn destination_parser() -> impl TypedValueParser<Value = Destination> {
    OsStringValueParser::new().try_map(|name| {
        if name == "-" {
            return Ok(Destination::Stdout);
        }
        let path = PathBuf::from(name);
        PictureFormat::of(&path)
            .map(|format| Destination::File(path, format))
            .ok_or("the name must end in .png or .ppm, or be - for standard output")
    })
}
