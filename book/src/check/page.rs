//! The report page of a judged picture, with the mistakes that may draw it.

use std::io;
use std::path::{Path, PathBuf};

use check::report::{self, Report};

use super::judged::Judged;
use super::text::{self, Style};

/// Writes the page and its pictures into `folder`. Returns the path of the page.
pub(crate) fn write(folder: &Path, judged: &Judged) -> io::Result<PathBuf> {
    let finding = judged.check.finding();
    Report {
        title: judged.scene.chapter.name(),
        headline: text::headline(judged, Style::plain()).trim_end(),
        pictures: finding.map(|finding| [&finding.right, &finding.yours]),
        remarks: &finding.map_or(String::new(), |finding| {
            report::remarks(&judged.scene, finding, Path::new(report::BOOK))
        }),
    }
    .write(folder)
}
