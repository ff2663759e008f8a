//! The report page of `check`: the right picture, the reader's and their difference, side by side
//! and on top of each other.
//!
//! The page needs only the files beside it, so that it works from a disk and without a network.

use std::iter;

use common::rtweekend::Picture;

use crate::answer::Pictures;
use crate::comparison::{Comparison, differing_pixels};
use crate::html::escaped;
use crate::png;

/// The content of a report, a page of HTML that shows a reader's picture beside the right one.
#[derive(Debug)]
pub struct ReportPage<'a> {
    /// The title: the name of a chapter, as plain text, which is escaped.
    pub title: &'a str,
    /// The headline of the answer, as HTML, which is taken as it is.
    pub headline: &'a str,
    /// The reader's picture and the right one; `None` if the page shows no pictures.
    pub pictures: Option<&'a Pictures>,
    /// The rest of the answer, below the pictures, as HTML; may be empty.
    pub remarks: &'a str,
}

impl ReportPage<'_> {
    /// Makes the files of the page, each with its name and its bytes: the pictures that it shows,
    /// `expected.png`, `yours.png` and, if their sizes are equal, `difference.png`; then
    /// `index.html`.
    pub fn files(&self) -> Vec<(String, Vec<u8>)> {
        let mut files = Vec::new();
        // What the reader named comes last, so that braces in it are only braces.
        let html = TEMPLATE
            .replace("{figures}", &self.figures(&mut files))
            .replace("{remarks}", self.remarks)
            .replace("{title}", &escaped(self.title))
            .replace("{headline}", self.headline);
        files.push(("index.html".to_owned(), html.into_bytes()));
        files
    }

    /// Adds the pictures to `files`, and returns the HTML that shows them.
    fn figures(&self, files: &mut Vec<(String, Vec<u8>)>) -> String {
        let Some(Pictures { yours, right }) = self.pictures else {
            return String::new();
        };
        let difference = difference_picture(right, yours);
        let panels = [("expected", right), ("yours", yours)]
            .into_iter()
            .chain(difference.iter().map(|picture| ("difference", picture)));
        let mut figures = String::from("<div class=\"panels\">\n");
        for (name, picture) in panels {
            files.push((format!("{name}.png"), png::encode(picture)));
            figures += &format!(
                "<figure><img src=\"{name}.png\" alt=\"{name}\"><figcaption>{name}</figcaption></figure>\n"
            );
        }
        figures + "</div>\n" + ONION
    }
}

/// Draws the pixels that differ in red, on a faint gray copy of the expected picture; `None` if the
/// sizes differ.
pub fn difference_picture(expected: &Picture, actual: &Picture) -> Option<Picture> {
    if Comparison::of(expected, actual) == Comparison::AnotherSize {
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
    for pixel in differing_pixels(expected, actual) {
        let at = 3 * (pixel.row as usize * width as usize + pixel.column as usize);
        rgb[at..at + 3].copy_from_slice(&[220, 0, 0]);
    }
    Picture::from_rgb(width, height, rgb)
}

/// The HTML of the two pictures on top of each other, with a slider that fades the upper one.
const ONION: &str = "\
<figure class=\"onion\">
<div><img src=\"expected.png\" alt=\"expected\"><img id=\"top\" src=\"yours.png\" alt=\"yours\"></div>
<figcaption><label>expected <input id=\"slider\" type=\"range\" min=\"0\" max=\"100\" value=\"50\"> yours</label></figcaption>
</figure>
<script>
const slider = document.getElementById('slider');
const show = () => document.getElementById('top').style.opacity = slider.value / 100;
slider.addEventListener('input', show);
show();
</script>
";

/// The HTML of the page, with its four parts in braces.
const TEMPLATE: &str = "\
<!doctype html>
<html lang=\"en\">
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">
<meta name=\"color-scheme\" content=\"light dark\">
<title>{title}: expected and yours</title>
<style>
body { font: 1rem/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 80rem; padding: 0 1rem; overflow-wrap: anywhere; }
.panels { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(20rem, 100%), 1fr)); gap: 1rem; }
figure { margin: 0 0 1rem; }
img { display: block; width: 100%; image-rendering: pixelated; }
.onion { max-width: 50rem; }
.onion div { position: relative; }
.onion #top { position: absolute; inset: 0; }
.onion input { width: 50%; vertical-align: middle; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0 1rem; }
dt { color: GrayText; }
dd { margin: 0; }
</style>
<h1>{title}</h1>
<p>{headline}</p>
{figures}{remarks}</html>
";
