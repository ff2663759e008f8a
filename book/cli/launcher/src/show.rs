//! `show`: one picture, wherever the reader wants it.

use std::error::Error;
use std::path::{Path, PathBuf};

use common::engine::parse_width;
use course::chapter::Chapter;
use course::names;

use crate::cargo::{self, Package};
use crate::chapter::required_chapter;
use crate::command_line::Words;
use crate::draw;
use crate::drawing::Drawing;
use crate::misuse::misuse;
use crate::output;
use crate::save::{PictureFormat, save};
use crate::terminal::{self, Palette};

/// The arguments of `cargo rtrace show`.
pub(crate) struct Arguments {
    chapter: Chapter,
    /// The width in pixels.
    width: u32,
    output: Option<Destination>,
    open: bool,
}

impl Arguments {
    /// Reads the arguments from a command line.
    ///
    /// # Errors
    /// If there is no chapter, or a word is not what it should be.
    pub(crate) fn read(words: &Words) -> Result<Self, Box<dyn Error>> {
        let chapter = required_chapter(words)?;
        let width = words.option("--width <N>", parse_width)?;
        let output = words.path(OUTPUT).map(|path| {
            let why = "the name must end in .png or .ppm, or be - for standard output";
            let refused = || words.refused(OUTPUT, &path.to_string_lossy(), why);
            Destination::of(&path).ok_or_else(refused)
        });
        Ok(Self {
            chapter,
            width: width.unwrap_or(chapter.book_width()),
            output: output.transpose()?,
            open: words.has("--open"),
        })
    }
}

const OUTPUT: &str = "-o, --output <FILE>";

/// Has the program of a chapter draw its picture. Then prints it as P3, saves it, opens it in a
/// viewer, or shows it in the terminal, as the arguments say.
///
/// # Errors
/// If the arguments contradict each other, if the chapter does not compile, if there is no terminal
/// with colors to show the picture in, or if it can't be written or opened.
pub(crate) fn show(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let Arguments { output, open, .. } = arguments;
    match output {
        Some(Destination::Stdout) if *open => Err(misuse(
            "--open needs a file: name one with --output, or leave --output out",
        )),
        Some(Destination::Stdout) => {
            let drawing = arguments.drawing()?;
            Ok(output::to_stdout(|out| drawing.copy(out))?)
        }
        Some(Destination::File(path, format)) => arguments.save_and_say(*format, path),
        None if *open => {
            let path = draw::pictures_folder()?.join(arguments.chapter.name());
            arguments.save_and_say(PictureFormat::Png, &path.with_extension("png"))
        }
        None => {
            let palette = Palette::of_stdout().ok_or_else(|| {
                misuse(
                    "there is no terminal with colors here to show the picture in: \
                     name a file with --output, or print the numbers with --output -",
                )
            })?;
            let picture = arguments.drawing()?.picture()?;
            Ok(output::to_stdout(|out| {
                terminal::show_picture(&picture, palette, out)
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

impl Destination {
    fn of(path: &Path) -> Option<Self> {
        if path == Path::new("-") {
            return Some(Self::Stdout);
        }
        Some(Self::File(path.to_owned(), PictureFormat::of(path)?))
    }
}

impl Arguments {
    /// Starts the chapter's program, which cargo builds first if it is not up to date.
    fn drawing(&self) -> Result<Drawing, Box<dyn Error>> {
        let (chapter, package) = (self.chapter.name(), Package::of(self.chapter));
        let built = cargo::build(&[package], &format!("Building {chapter}"))?;
        let program = built
            .program(package)
            .ok_or_else(|| built.failure(package))?;
        let drawing = Drawing::start(&program, self.width);
        drawing.map_err(|cause| format!("{chapter} draws nothing: {cause}").into())
    }

    /// Saves the picture, prints where, and opens it in a viewer if the reader asks for that.
    fn save_and_say(&self, format: PictureFormat, path: &Path) -> Result<(), Box<dyn Error>> {
        let drawing = self.drawing()?;
        let (width, height) = (drawing.width, drawing.height);
        match format {
            PictureFormat::Ppm => output::to_file(path, |out| drawing.copy(out))?,
            PictureFormat::Png => save(&drawing.picture()?, format, path)?,
        }
        let shown = names::escaped_name(path);
        let said = format!("{width} × {height} pixels in {shown}\n");
        output::to_stdout(|out| out.write_all(said.as_bytes()))?;
        if self.open {
            open::that_detached(path).map_err(|cause| {
                format!("no viewer opened {shown}: {cause}\nOpen the picture by hand.")
            })?;
        }
        Ok(())
    }
}
