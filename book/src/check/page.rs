//! A page that shows a picture beside the right one.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use common::output;
use common::rtweekend::Picture;
use tests::check::Finding;
use tests::diagnosis::{Scene, Set};
use tests::slips::Slip;
use tests::{diff_page, png};

use super::Judged;
use super::text::{self, Style};

/// Writes `index.html` into `folder`, and beside it the pictures it shows.
/// Returns the path of the page.
pub(crate) fn write(folder: &Path, judged: &Judged) -> Result<PathBuf, Box<dyn Error>> {
    fs::create_dir_all(folder)
        .map_err(|cause| format!("cannot create the folder {}: {cause}", folder.display()))?;
    let headline = text::headline(judged, Style::plain());
    let body = match judged.check.finding() {
        None => String::new(),
        Some(finding) => {
            let figures = figures(folder, finding)?;
            figures + &diagnosis(&judged.scene, finding)
        }
    };
    let title = escaped(judged.scene.chapter.stage().name);
    let headline = escaped(headline.trim_end()).replace('\n', "<br>");
    let page = folder.join("index.html");
    let html = TEMPLATE
        .replace("{title}", &title)
        .replace("{headline}", &headline)
        .replace("{body}", &body);
    output::to_file(&page, |out| out.write_all(html.as_bytes()))?;
    Ok(page)
}

/// Expected, yours and the difference side by side, and two of them on top of
/// each other.
fn figures(folder: &Path, finding: &Finding) -> Result<String, Box<dyn Error>> {
    let difference = diff_page::difference_picture(&finding.right, &finding.yours);
    let panels: [(&str, Option<&Picture>); 3] = [
        ("expected", Some(&finding.right)),
        ("yours", Some(&finding.yours)),
        ("difference", difference.as_ref()),
    ];
    let mut figures = String::from("<div class=\"panels\">\n");
    for (name, picture) in panels {
        let Some(picture) = picture else { continue };
        let bytes = png::encode(picture);
        output::to_file(&folder.join(format!("{name}.png")), |out| {
            out.write_all(&bytes)
        })?;
        figures += &format!(
            "<figure><img src=\"{name}.png\" alt=\"{name}\"><figcaption>{name}</figcaption></figure>\n"
        );
    }
    Ok(figures + "</div>\n" + ONION)
}

fn diagnosis(scene: &Scene, finding: &Finding) -> String {
    let mut html = String::new();
    for set in &finding.diagnosis.sets {
        html += &format!("<h2>{}</h2>\n", escaped(&text::title(set, finding)));
        for mistake in &set.mistakes {
            html += &mistake
                .iter()
                .map(|slip| slip_as_html(slip))
                .collect::<String>();
        }
        html += &telling(scene, set);
    }
    if !finding.diagnosis.sights.is_empty() {
        html += "<h2>What can be seen</h2>\n";
        for sight in &finding.diagnosis.sights {
            html += &format!("<p>{}</p>\n", escaped(sight));
        }
    }
    html
}

fn slip_as_html(slip: &Slip) -> String {
    let [name, wrong, right, explanation, page, source] = [
        slip.name,
        slip.wrong,
        slip.right,
        slip.explanation,
        &text::page(slip),
        slip.source,
    ]
    .map(escaped);
    format!(
        "<h3>{name}</h3>\n<dl><dt>probably</dt><dd><code>{wrong}</code></dd>\
         <dt>should be</dt><dd><code>{right}</code></dd>\
         <dt>why</dt><dd>{explanation}</dd><dt>read</dt><dd>{page}</dd>\
         <dt>code</dt><dd>{source}</dd></dl>\n"
    )
}

fn telling(scene: &Scene, set: &Set) -> String {
    match text::telling(scene, set) {
        telling if telling.is_empty() => telling,
        telling => format!("<pre>{}</pre>\n", escaped(telling.trim())),
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
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

/// Everything is in the page or beside it, so that it also works from a disk
/// and without a network.
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
pre { white-space: pre-wrap; }
</style>
<h1>{title}</h1>
<p>{headline}</p>
{body}</html>
";
