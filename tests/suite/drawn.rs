//! Fixture: pictures as text and as snapshots, and what is said of a wrong one.

use std::path::Path;

use check::Chapter;
use check::comparison::Comparison;
use check::diagnosis;
use check::judge::{self, Finding};
use check::report::{self, Report};
use check::{places, png, reading};
use common::rtweekend::*;
use insta::internals::SnapshotContents;
use insta::{Comparator, Snapshot, assert_binary_snapshot};

/// The pictures in the book are the snapshots: one file is shown and compared.
const PICTURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes/pictures");

/// Compares the picture with the snapshot of that name.
pub(crate) fn assert_picture(name: &str, picture: &Picture) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(PICTURES);
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_comparator(Box::new(SamePixels));
    settings.bind(|| {
        assert_binary_snapshot!(&format!("{name}.png"), png::encode(picture));
    });
}

/// Compares the pixels of two PNG snapshots, and explains a difference.
#[derive(Clone)]
pub(crate) struct SamePixels;

impl Comparator for SamePixels {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        let (Some(expected), Some(actual)) = (file_of(reference), file_of(test)) else {
            println!("The .png file of a snapshot is missing: restore it, or accept a new one.");
            return false;
        };
        let comparison = compare_files(expected, actual);
        if comparison == Comparison::Equal {
            return true;
        }
        let name = test.snapshot_name().unwrap_or("picture");
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .join("wrong-pictures")
            .join(name);
        println!(
            "\n{}Only if you meant to change it: INSTA_UPDATE=always cargo test is_right::{name}\n\
             (in PowerShell, first $env:INSTA_UPDATE = 'always')\n{}",
            explained(name, expected, actual, &folder),
            Chapter::find(name).map_or(String::new(), more)
        );
        false
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

/// Writes a page about a picture that is not its snapshot into `folder`, and says what
/// is wrong: first the cause, if it is the picture of a chapter and the cause is known.
pub(crate) fn explained(name: &str, expected: &[u8], actual: &[u8], folder: &Path) -> String {
    let comparison = compare_files(expected, actual);
    let chapter = Chapter::OF_THE_BOOK
        .into_iter()
        .find(|chapter| chapter.name() == name);
    let scene = chapter.and_then(|chapter| diagnosis::Scene::new(chapter, None));
    let (mut cause, mut remarks) = (String::new(), String::new());
    if let Some(scene) = scene
        && let Some(finding) = judge::check(&scene, actual, 0).finding()
    {
        cause = cause_of(finding);
        remarks = report::remarks(&scene, finding, Path::new(report::BOOK));
    }
    let said = format!("The picture of `{name}` is not its snapshot: {comparison}.\n{cause}");
    let [expected, actual] = [expected, actual].map(decoded);
    let page = Report {
        title: name,
        headline: said.trim_end(),
        pictures: Some([&expected, &actual]),
        remarks: &remarks,
    }
    .write(folder)
    .expect("the target folder takes the page");
    let page = page.display();
    format!("{said}See both, and the difference: {page}\n")
}

/// The mistakes that explain it best, or what can be seen. The page says more.
fn cause_of(finding: &Finding) -> String {
    let Some(set) = finding.diagnosis.sets.first() else {
        let sights = finding.diagnosis.sights.iter();
        return sights.map(|sight| format!("{sight}\n")).collect();
    };
    let mut said = set.title(finding.right.rgb().len() / 3) + "\n";
    // The page has them all.
    for slip in set.mistakes.iter().flatten().take(3) {
        let (name, wrong, right) = (slip.name, slip.wrong, slip.right);
        said += &format!("  {name}: probably {wrong}, should be {right}\n");
        let read = places::page(slip).unwrap_or_else(|| slip.page_in_words());
        said += &format!("    read {read}\n");
    }
    said
}

fn file_of(snapshot: &Snapshot) -> Option<&[u8]> {
    match snapshot.contents() {
        SnapshotContents::Binary(Some(file)) => Some(file),
        _ => None,
    }
}

pub(crate) fn compare_files(expected: &[u8], actual: &[u8]) -> Comparison {
    let [expected, actual] = [expected, actual].map(decoded);
    Comparison::of(&expected, &actual)
}

fn decoded(file: &[u8]) -> Picture {
    reading::read(file)
        .expect("a snapshot is a PNG file")
        .picture()
}

/// The text of a picture.
pub(crate) fn p3(picture: &Picture) -> Vec<u8> {
    let mut text = Vec::new();
    picture.write_p3(&mut text).expect("memory takes it");
    text
}

/// Where there is more to see of a chapter that is wrong, and what is not asked yet.
pub(crate) fn more(chapter: Chapter) -> String {
    let name = chapter.name();
    format!(
        "more:     cargo rtrace check {name} -- cargo run -q -p {name}\n\
         again:    cargo test {name}\n\
         waiting:  the program `suite`: all that stands on right chapters\n"
    )
}
