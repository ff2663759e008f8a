//! No command at all: draws all pictures into one folder.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use course::chapter::Chapter;

use crate::cargo::{self, Package};
use crate::drawing::drawn_by;
use crate::output;
use crate::save::{PictureFormat, save};

/// Has cargo build the programs of these chapters, and each draw its picture at the book's width
/// into `target/pictures`, as PNG and as PPM. Then prints for each its size in pixels, the time that
/// its program took, and the sizes of both files; or that it could not be drawn, in which case the
/// others are drawn all the same.
pub(crate) fn draw(chapters: &[Chapter]) -> Result<(), Box<dyn Error>> {
    let folder = pictures_folder()?;
    let packages: Vec<Package> = chapters.iter().copied().map(Package::of).collect();
    let built = cargo::build(&packages, "Building the chapters' programs")?;
    let mut said = String::new();
    let mut are_drawn = true;
    for (&chapter, &package) in chapters.iter().zip(&packages) {
        let drawn = match built.program(package) {
            Some(program) => draw_one(chapter, &program, &folder)?,
            None => Err("does not compile: see above".to_owned()),
        };
        are_drawn &= drawn.is_ok();
        let line = drawn.unwrap_or_else(|problem| problem);
        said += &format!("  {:<17} {line}\n", chapter.name());
    }
    output::print(&said)?;
    match are_drawn {
        true => Ok(()),
        false => {
            Err("a picture is missing; the book is woven when each chapter draws its own".into())
        }
    }
}

/// Makes the folder `target/pictures` of the workspace, unless it exists, and returns its path.
pub(crate) fn pictures_folder() -> Result<PathBuf, Box<dyn Error>> {
    let folder = find_workspace()?.join("target").join("pictures");
    fs::create_dir_all(&folder).map_err(|cause| {
        format!(
            "cannot create the folder {}: {cause}\n\
             Remove what is in its way, or allow yourself to write there.",
            folder.display()
        )
    })?;
    Ok(folder)
}

/// Finds the folder of this project, as [`course::workspace::workspace`] does.
pub(crate) fn find_workspace() -> Result<&'static Path, Box<dyn Error>> {
    course::workspace::workspace().ok_or_else(|| {
        "the workspace that this program was built from is not there any more\n\
         Run this command in another clone of the workspace."
            .into()
    })
}

/// Has a chapter's program draw its picture, and saves that. Returns what to print about it, or how
/// the program has failed.
fn draw_one(
    chapter: Chapter,
    program: &Path,
    folder: &Path,
) -> Result<Result<String, String>, Box<dyn Error>> {
    let start = Instant::now();
    let picture = match drawn_by(program, chapter.book_width()) {
        Ok(picture) => picture,
        Err(problem) => return Ok(Err(format!("is not drawn: {problem}"))),
    };
    let mut line = format!(
        "{} × {}  {:5.1} ms to draw  ",
        picture.width(),
        picture.height(),
        1e3 * start.elapsed().as_secs_f64()
    );
    for format in [PictureFormat::Png, PictureFormat::Ppm] {
        let path = folder
            .join(chapter.name())
            .with_extension(format.extension());
        save(&picture, format, &path)?;
        let kilobytes = fs::metadata(&path)?.len() as f64 / 1e3;
        line += &format!("  .{} {kilobytes:6.1} kB", format.extension());
    }
    Ok(Ok(line))
}
