//! The report page of a judged picture, with the mistakes that may draw it.

use std::io;
use std::path::{Path, PathBuf};

use check::diagnosis::{Scene, Set};
use check::judge::Finding;
use check::report::{Report, escaped};
use check::slips::Slip;

use super::judged::Judged;
use super::text::{self, Style};

/// Writes the page and its pictures into `folder`. Returns the path of the page.
pub(crate) fn write(folder: &Path, judged: &Judged) -> io::Result<PathBuf> {
    let finding = judged.check.finding();
    Report {
        title: judged.scene.chapter.name(),
        headline: text::headline(judged, Style::plain()).trim_end(),
        pictures: finding.map(|finding| [&finding.right, &finding.yours]),
        remarks: &finding.map_or(String::new(), |finding| diagnosis(&judged.scene, finding)),
    }
    .write(folder)
}

fn diagnosis(scene: &Scene, finding: &Finding) -> String {
    let mut html = String::new();
    for set in &finding.diagnosis.sets {
        html += &format!("<h2>{}</h2>\n", escaped(text::title(set, finding)));
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
