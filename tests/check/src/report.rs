//! The report page: the right picture, yours and the difference, side by side and on
//! top of each other.
//!
//! Everything is in the page or beside it, so that it also works from a disk and
//! without a network.

use std::path::Path;
use std::{fmt, fs, iter};

use common::rtweekend::Picture;

use crate::comparison::{Comparison, differing_pixels};
use crate::png;
use crate::scene::Scene;
use crate::verdict::Finding;
use slips::{Letters, Slip};

/// What a report page shows.
#[derive(Debug)]
pub struct Report<'a> {
    /// What it is about: the name of a chapter.
    pub title: &'a str,
    /// What there is to say first; a line of it becomes a line of the page.
    pub headline: &'a str,
    /// The right picture and yours, if there is anything to see.
    pub pictures: Option<[&'a Picture; 2]>,
    /// What follows the pictures, as HTML.
    pub remarks: &'a str,
}

impl Report<'_> {
    /// The page, `index.html`, and the pictures that it shows, by their names.
    pub fn files(&self) -> Vec<(String, Vec<u8>)> {
        let mut files = Vec::new();
        // What the reader named comes last, so that braces in it are only braces.
        let html = TEMPLATE
            .replace("{figures}", &self.figures(&mut files))
            .replace("{remarks}", self.remarks)
            .replace("{title}", &escaped(self.title))
            .replace("{headline}", &escaped(self.headline).replace('\n', "<br>"));
        files.push(("index.html".to_owned(), html.into_bytes()));
        files
    }

    /// Adds the pictures to `files`, and returns the figures that show them.
    fn figures(&self, files: &mut Vec<(String, Vec<u8>)>) -> String {
        let Some([expected, yours]) = self.pictures else {
            return String::new();
        };
        let difference = difference_picture(expected, yours);
        let panels = [("expected", expected), ("yours", yours)]
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

/// What is to be said below the pictures: the mistakes that may draw yours, and what
/// can be seen. Pages that are in the folder `book` are linked.
pub fn remarks(scene: &Scene, finding: &Finding, book: &Path) -> String {
    let mut html = String::new();
    let pixels = finding.right.rgb().len() / 3;
    if let Some(mistakes) = &finding.mistakes {
        html += &format!("<h2>{}</h2>\n", escaped(mistakes.title(pixels)));
        for slip in mistakes.all.iter().flatten() {
            html += &slip_as_html(slip, &mistakes.scene, book);
        }
    }
    if let Some(next) = finding.next(|probe| scene.probed_command(probe)) {
        html += &format!("<p>Next: {}</p>\n", escaped(next));
    }
    let seen: String = finding
        .sights
        .iter()
        .map(|it| format!("<p>{}</p>\n", escaped(it)))
        .collect();
    if !seen.is_empty() {
        html += &format!("<h2>What can be seen</h2>\n{seen}");
    }
    html
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

/// `text` as HTML shows it.
pub fn escaped(text: impl fmt::Display) -> String {
    text.to_string()
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

fn slip_as_html(slip: &Slip, scene: &Scene, book: &Path) -> String {
    let [wrong, right, why] = slip
        .rows(Letters::Book(scene.edition), scene.chapter)
        .map(|(label, said)| (label, escaped(said)));
    let rows = [
        (wrong.0, format!("<code>{}</code>", wrong.1)),
        (right.0, format!("<code>{}</code>", right.1)),
        why,
        ("read", page_of_book(slip, book)),
        ("code", escaped(slip.source)),
    ];
    let rows = rows.map(|(label, said)| format!("<dt>{label}</dt><dd>{said}</dd>"));
    format!(
        "<h3>{}</h3>\n<dl>{}</dl>\n",
        escaped(slip.name),
        rows.concat()
    )
}

/// The page that tells how it is right: a link, or its name in words while there is no
/// such page.
fn page_of_book(slip: &Slip, book: &Path) -> String {
    let (page, heading) = slip.page_and_heading();
    match fs::canonicalize(book.join(page).with_extension("html")) {
        Ok(file) => format!(
            "<a href=\"{}#{heading}\">{}</a>",
            url_of(&file),
            escaped(slip.read())
        ),
        Err(_) => escaped(slip.page_in_words()),
    }
}

/// The address of a file on this machine: it leads there from wherever the report is.
fn url_of(file: &Path) -> String {
    let mut url = String::from("file://");
    let path = file.to_string_lossy();
    // Windows has no slash at the beginning, and a mark of its own that is none of
    // the address.
    let path = path.strip_prefix(r"\\?\").unwrap_or(&path);
    if !path.starts_with('/') {
        url.push('/');
    }
    for byte in path.bytes() {
        match byte {
            b'\\' if cfg!(windows) => url.push('/'),
            b'/' | b':' | b'-' | b'.' | b'_' | b'~' => url.push(byte.into()),
            _ if byte.is_ascii_alphanumeric() => url.push(byte.into()),
            _ => url += &format!("%{byte:02X}"),
        }
    }
    url
}

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
