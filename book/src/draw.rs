//! No command at all: all pictures into one folder.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Instant;
use std::{env, fs};

use check::places::shown;
use common::engine::{companion, output};
use slips::Chapter;

use crate::save::{Format, save};

/// Draws every picture at the book's size, as PNG and as PPM, and says where
/// it is, how large, and how long it took to trace.
pub(crate) fn all() -> Result<(), Box<dyn Error>> {
    let folder = folder()?;
    let mut report = format!("The pictures are in {}\n", shown(&folder));
    for chapter in Chapter::ALL {
        report += &draw(chapter, &folder)?;
    }
    Ok(output::to_stdout(|out| out.write_all(report.as_bytes()))?)
}

/// Where the pictures go: `target/pictures` of this workspace.
pub(crate) fn folder() -> Result<PathBuf, Box<dyn Error>> {
    let folder = workspace()?.join("target").join("pictures");
    fs::create_dir_all(&folder).map_err(|cause| {
        format!(
            "cannot create the folder {}: {cause}\n\
             Remove what is in its way, or allow yourself to write there. {}",
            folder.display(),
            without_it()
        )
    })?;
    Ok(folder)
}

/// The workspace that this program was built for, if it is still there.
pub(crate) fn workspace() -> Result<&'static Path, Box<dyn Error>> {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let workspace = package.parent().unwrap_or(package);
    if is_elsewhere(package) {
        return Err(format!(
            "this program was built for a workspace in {}, which is not there any more\n\
             Build it for where the workspace is now: run cargo clean --package rtrace in it, \
             then cargo rtrace, or cargo install --path book if it was installed.\n{}",
            workspace.display(),
            without_it()
        )
        .into());
    }
    Ok(workspace)
}

/// Whether this package was moved after it was built, or copied and is now run by
/// cargo in the copy. Cargo does not build a program anew for that.
fn is_elsewhere(package: &Path) -> bool {
    let run_by_cargo = env::var_os("CARGO_PKG_NAME").is_some_and(|it| it == env!("CARGO_PKG_NAME"));
    let here = env::var_os("CARGO_MANIFEST_DIR").filter(|_| run_by_cargo);
    let is_here = |here| fs::canonicalize(here).ok() == fs::canonicalize(package).ok();
    !package.join("Cargo.toml").is_file() || here.is_some_and(|here| !is_here(here))
}

/// What can be done where nothing can be written into the workspace.
fn without_it() -> String {
    let companion = companion();
    format!("To draw elsewhere: {companion} show CHAPTER --output FILE")
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
    for format in [Format::Png, Format::Ppm] {
        let path = folder
            .join(chapter.name())
            .with_extension(format.extension());
        save(&picture, format, &path).map_err(|error| format!("{error}\n{}", without_it()))?;
        let kilobytes = fs::metadata(&path)?.len() as f64 / 1e3;
        line += &format!("  .{} {kilobytes:6.1} kB", format.extension());
    }
    Ok(line + "\n")
}
