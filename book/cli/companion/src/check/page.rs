//! The report page of a judged picture, with the mistakes that may draw it.

use std::error::Error;
use std::path::{Path, PathBuf};

use check::answer::{Judged, Part};
use check::html;
use check::report::Report;

use super::text::{self, Style};
use crate::files;

/// What the folder of a page is called where another one is refused.
pub(crate) const KIND: &str = "report";

/// Writes the page and its pictures into `folder`. Returns the path of the page.
pub(crate) fn write(folder: &Path, judged: &Judged) -> Result<PathBuf, Box<dyn Error>> {
    let finding = judged.check.finding();
    // The book lies elsewhere.
    let parts = judged.parts();
    let parts = parts.iter().filter(|part| !matches!(part, Part::Read(_)));
    let remarks = parts.map(html::part);
    let headline = text::headline(&judged.headline(), Style::plain());
    let report = Report {
        title: judged.scene.chapter.name(),
        headline: headline.trim_end(),
        pictures: finding.map(|finding| [&finding.right, &finding.yours]),
        remarks: &remarks.collect::<String>(),
    };
    files::fill(folder, KIND, &report.files())?;
    Ok(folder.join("index.html"))
}
