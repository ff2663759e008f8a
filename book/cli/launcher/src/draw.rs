//! No command at all: draws all pictures into one folder.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use common::engine::output;
use course::chapter::Chapter;
use course::names::name_from_here;

use crate::save::{PictureFormat, save};

/// Draws the picture of every chapter at the book's width into `target/pictures`, as PNG and as
/// PPM. Then prints the folder, and for each picture its size in pixels, the time that tracing it
/// took, and the sizes of both files.
///
/// # Errors
/// If the workspace is gone, or a file can't be written.
pub fn draw_all() -> Result<(), Box<dyn Error>> {
    let folder = pictures_folder()?;
    let mut report = format!("The pictures are in {}\n", name_from_here(&folder));
    for chapter in Chapter::ALL {
        report += &draw(chapter, &folder)?;
    }
    Ok(output::to_stdout(|out| out.write_all(report.as_bytes()))?)
}

/// Makes the folder `target/pictures` of the workspace, unless it exists, and returns its path.
///
/// # Errors
/// If the workspace is gone, or the folder can't be made.
pub fn pictures_folder() -> Result<PathBuf, Box<dyn Error>> {
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
///
/// # Errors
/// If there is no such folder any more; the message advises what to do.
pub fn find_workspace() -> Result<&'static Path, Box<dyn Error>> {
    course::workspace::workspace().ok_or_else(|| {
        "the workspace that this program was built from is not there any more\n\
         Run this command in another clone of the workspace."
            .into()
    })
}

fn draw(chapter: Chapter, folder: &Path) -> Result<String, Box<dyn Error>> {
    let start = Instant::now();
    let picture = chapter.picture(chapter.book_width());
    picture.rgb();
    let traced = start.elapsed();
    let mut line = format!(
        "  {:<14} {} × {}  {:4.1} ms to trace  ",
        chapter.name(),
        picture.width(),
        picture.height(),
        1e3 * traced.as_secs_f64()
    );
    for format in [PictureFormat::Png, PictureFormat::Ppm] {
        let path = folder
            .join(chapter.name())
            .with_extension(format.extension());
        save(&picture, format, &path)?;
        let kilobytes = fs::metadata(&path)?.len() as f64 / 1e3;
        line += &format!("  .{} {kilobytes:6.1} kB", format.extension());
    }
    Ok(line + "\n")
}
