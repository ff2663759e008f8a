//! The report page of a judged picture, with the mistakes that may draw it.

use std::error::Error;
use std::path::{Path, PathBuf};

use check::answer::Judged;
use check::report::{self, Report};
use check::workspace::workspace;

use super::text::{self, Style};
use crate::files;

/// What the folder of a page is called where another one is refused.
pub(crate) const KIND: &str = "report";

/// Writes the page and its pictures into `folder`. Returns the path of the page.
pub(crate) fn write(folder: &Path, judged: &Judged) -> Result<PathBuf, Box<dyn Error>> {
    let finding = judged.check.finding();
    let book = workspace().map_or(PathBuf::new(), |it| it.join("target/book"));
    let headline = text::headline(&judged.headline(), Style::plain());
    let report = Report {
        title: judged.scene.chapter.name(),
        headline: headline.trim_end(),
        pictures: finding.map(|finding| [&finding.right, &finding.yours]),
        remarks: &finding.map_or(String::new(), |finding| {
            report::remarks(&judged.scene, finding, &book)
        }),
    };
    files::fill(folder, KIND, &report.files())?;
    Ok(folder.join("index.html"))
}
