//! A page that shows two pictures and what differs between them.

use std::io;
use std::path::{Path, PathBuf};
use std::{fs, iter};

use common::rtweekend::Picture;

use crate::comparison::{Comparison, differing_pixels};
use crate::png;

/// Writes `NAME.html` into `folder`, and beside it the pictures it shows:
/// expected, actual, and the difference if they are of the same size. Returns
/// the path of the page.
///
/// # Errors
/// Those of creating the folder and writing the files.
pub fn write(
    folder: &Path,
    name: &str,
    expected: &Picture,
    actual: &Picture,
) -> io::Result<PathBuf> {
    fs::create_dir_all(folder)?;
    let comparison = Comparison::of(expected, actual);
    let difference = difference_picture(expected, actual);
    let panels = [("expected", expected), ("actual", actual)]
        .into_iter()
        .chain(difference.iter().map(|picture| ("difference", picture)));

    let mut figures = String::new();
    for (title, picture) in panels {
        let file = format!("{name}.{title}.png");
        fs::write(folder.join(&file), png::encode(picture))?;
        figures += &format!(
            "<figure><img src=\"{file}\" alt=\"{title}\"><figcaption>{title}</figcaption></figure>\n"
        );
    }
    let page = folder.join(format!("{name}.html"));
    fs::write(&page, html(name, &comparison.to_string(), &figures))?;
    Ok(page)
}

/// Differing pixels in red on a faint gray copy of what was expected, or `None`
/// if the sizes differ.
pub fn difference_picture(expected: &Picture, actual: &Picture) -> Option<Picture> {
    if let Comparison::Size(..) = Comparison::of(expected, actual) {
        return None;
    }
    let (pixels, _) = expected.rgb().as_chunks::<3>();
    let mut rgb: Vec<u8> = pixels
        .iter()
        .flat_map(|pixel| {
            let sum: u16 = pixel.iter().map(|&level| u16::from(level)).sum();
            iter::repeat_n(192 + (sum / 3 / 4) as u8, 3)
        })
        .collect();
    let (width, height) = (expected.width(), expected.height());
    for (i, j, ..) in differing_pixels(expected, actual) {
        let at = 3 * (j as usize * width as usize + i as usize);
        rgb[at..at + 3].copy_from_slice(&[220, 0, 0]);
    }
    Picture::from_rgb(width, height, rgb)
}

fn html(name: &str, summary: &str, figures: &str) -> String {
    format!(
        "<!doctype html>
<html lang=\"en\">
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width\">
<meta name=\"color-scheme\" content=\"light dark\">
<title>{name}: expected, actual, difference</title>
<style>
body {{ font: 1rem/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 80rem; padding: 0 1rem; }}
main {{ display: grid; grid-template-columns: repeat(auto-fit, minmax(min(20rem, 100%), 1fr)); gap: 1rem; }}
figure {{ margin: 0; }}
img {{ width: 100%; image-rendering: pixelated; }}
</style>
<h1>{name}</h1>
<p>{summary}</p>
<main>
{figures}</main>
</html>
"
    )
}
