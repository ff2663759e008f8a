//! Each picture is the book's, to the last bit.

use std::fs;
use std::path::Path;

use check::Chapter;
use check::comparison::Comparison;
use check::diagnosis;
use check::judge::{self, Finding};
use check::places;
use check::report::{self, Report};
use check::{png, reading, slips};
use common::rtweekend::*;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use insta::internals::SnapshotContents;
use insta::{Comparator, Snapshot, assert_binary_snapshot};
use sha2::{Digest, Sha256};
use speed_vs_accuracy::{Method, Scene};
use tempfile::TempDir;

/// The pictures in the book are the snapshots: one file is shown and compared.
const PICTURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes/pictures");

mod the_snapshot_is_drawn_by {
    macro_rules! stages {
        ($($chapter:ident)*) => {
            pub(super) const NAMES: &[&str] = &[$(stringify!($chapter)),*];
            $(
                #[test]
                fn $chapter() {
                    super::assert_stage(stringify!($chapter));
                }
            )*
        };
    }
    stages! { build_test gradient red_sphere normals half_b_sphere hittable_list speed_vs_accuracy }
}

/// Scenes of chapter 6 in which a method fails, and what they should look like.
mod the_snapshot_is_drawn_by_a_method {
    use super::*;

    const WIDTH: u32 = 200;

    #[test]
    fn telescope() {
        assert_failure(Scene::TELESCOPE, Method::HALF_B);
    }

    #[test]
    fn grazing() {
        assert_failure(Scene::GRAZING, Method::HALF_B);
    }

    #[test]
    fn shadows() {
        assert_failure(Scene::SHADOWS, Method::HALF_B_F32);
    }

    fn assert_failure(scene: Scene, method: Method) {
        let wrong = scene.picture(method, WIDTH);
        let right = scene.right_picture(method.precision(), WIDTH);
        assert_ne!(wrong, right);
        assert_picture(&format!("{}_{}", scene.name, method.name), &wrong);
        assert_picture(&format!("{}_right", scene.name), &right);
    }
}

#[test]
fn no_stage_goes_without_a_snapshot() {
    let names: Vec<&str> = Chapter::ALL.iter().map(|chapter| chapter.name()).collect();
    assert_eq!(
        names,
        the_snapshot_is_drawn_by::NAMES,
        "name the new chapter in the list above this test, in the same order"
    );
}

#[test]
fn the_text_of_each_picture_has_the_sum_of_the_books_own() {
    let sums: Vec<(&str, &str, u32)> = include_str!("reference_sums.txt")
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| match line.split(' ').collect::<Vec<_>>()[..] {
            [sum, name, width] => (sum, name, width.parse().expect("a width is a number")),
            _ => panic!("reference_sums.txt has a line that is not `sum chapter width`: {line}"),
        })
        .collect();
    for &(expected, name, width) in &sums {
        let chapter = Chapter::find(name).expect("reference_sums.txt names stages");
        let actual = sha256(&p3(&chapter.picture(width)));
        let same_as = sums.iter().find(|(sum, ..)| *sum == actual);
        assert!(
            actual == expected,
            "{name} at {width} wide is not what the book's C++ draws{}.\n\
             If its snapshot differs too, start there. If only this differs, look for another \
             order of operations, a fused multiply-add, f32 somewhere, v / s for v * (1.0 / s), or the \
             text: P3, width and height, 255, each on its line, then a pixel a line.",
            same_as.map_or(String::new(), |(_, name, _)| format!(
                ": it is exactly the picture of {name}"
            ))
        );
    }
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    // Large enough for three strips, and no multiple of anything.
    let picture = hittable_list::picture(263);
    let text = |threads| p3_with_threads(&picture, threads);
    for threads in [2, 3, 7, 100] {
        assert!(text(1) == text(threads), "the text of {threads} threads");
        assert!(
            picture.rgb_with_threads(1) == picture.rgb_with_threads(threads),
            "the bytes of {threads} threads"
        );
    }
}

#[test]
fn chapters_3_and_4_draw_the_same_picture_at_any_width() {
    for width in [1, 2, 3, 50, 333] {
        assert_equal(
            &normals::picture(width),
            &half_b_sphere::picture(width),
            &format!("chapters 3 and 4 at {width} wide"),
        );
    }
}

#[test]
fn a_snapshot_may_be_compressed_in_another_way_but_not_show_another_picture() {
    let picture = gradient::picture(40);
    let stored = png::encode(&picture);

    let mut other_file = Vec::new();
    PngEncoder::new_with_quality(&mut other_file, CompressionType::Best, FilterType::NoFilter)
        .write_image(picture.rgb(), 40, 22, ExtendedColorType::Rgb8)
        .expect("memory takes it");
    assert_ne!(stored, other_file);
    assert_eq!(compare_files(&stored, &other_file), Comparison::Equal);

    let mut rgb = picture.rgb().to_vec();
    rgb[3 * (40 * 7 + 5) + 1] ^= 1;
    let other_picture = Picture::from_rgb(40, 22, rgb).expect("the size is the same");
    let comparison = compare_files(&stored, &png::encode(&other_picture));
    assert!(
        comparison.to_string().starts_with(
            "1 of 880 pixels differ, in columns 5 to 5 and rows 7 to 7; \
             the first is column 5, row 7:"
        ),
        "{comparison}"
    );
}

#[test]
fn a_wrong_picture_of_a_chapter_is_explained_with_its_cause_and_a_page() {
    let right = png::encode(&half_b_sphere::picture(400));
    let slip = slips::find("minus-h").expect("a slip");
    let wrong = slip.program(Chapter::HalfBSphere).run(400).picture();
    let folder = TempDir::new().expect("a folder");
    let page = folder.path().join("page");
    // The snapshot is right here, and the chapter is not.
    let said = explained("half_b_sphere", &right, &png::encode(&wrong), &page);
    let lines: Vec<&str> = said.lines().collect();
    assert!(lines[0].starts_with("The picture of `half_b_sphere` is not its snapshot: "));
    assert!(lines[1].ends_with("exactly this picture:"), "{said}");
    let named = format!(
        "  minus-h: probably {}, should be {}",
        slip.wrong, slip.right
    );
    assert!(lines.contains(&&*named), "{said}");
    let html = fs::read_to_string(page.join("index.html")).expect("a page");
    assert!(html.contains("<h3>minus-h</h3>"), "{html}");
    assert!(page.join("difference.png").is_file());
    // Any other picture is shown without a cause.
    let said = explained("telescope_right", &right, &png::encode(&wrong), &page);
    assert!(!said.contains("minus-h"), "{said}");
}

#[test]
fn pictures_are_equal_if_size_and_bytes_are() {
    let picture = |width, height, level| {
        Picture::from_rgb(width, height, vec![level; 12]).expect("12 bytes are 4 pixels")
    };
    assert_eq!(picture(2, 2, 7), picture(2, 2, 7));
    assert_ne!(picture(2, 2, 7), picture(2, 2, 8));
    assert_ne!(picture(4, 1, 7), picture(1, 4, 7));
    assert_ne!(picture(4, 1, 7), picture(2, 2, 7));
    let wider = Picture::from_rgb(5, 2, vec![0; 30]).expect("30 bytes are 10 pixels");
    let narrower = Picture::from_rgb(4, 2, vec![0; 24]).expect("24 bytes are 8 pixels");
    assert_ne!(wider, narrower);
    assert_eq!(format!("{wider:?}"), "Picture of 5 × 2 pixels");
}

#[test]
fn bytes_that_are_not_three_a_pixel_are_no_picture() {
    assert_eq!(Picture::from_rgb(2, 2, vec![0; 11]), None);
    assert!(Picture::from_rgb(2, 2, vec![0; 12]).is_some());
}

/// Compares the picture of the chapter with its snapshot.
fn assert_stage(name: &str) {
    let chapter = Chapter::find(name).expect("the chapter is in the list of stages");
    assert_picture(name, &chapter.picture(chapter.book_width()));
}

/// Compares the picture with the snapshot of that name.
fn assert_picture(name: &str, picture: &Picture) {
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
            "\n{}Only if you meant to change it: INSTA_UPDATE=always cargo test the_snapshot_is_drawn_by::{name}\n\
             (in PowerShell, first $env:INSTA_UPDATE = 'always')\n",
            explained(name, expected, actual, &folder)
        );
        false
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

/// Writes a page about a picture that is not its snapshot into `folder`, and says what
/// is wrong: first the cause, if it is the picture of a chapter and the cause is known.
fn explained(name: &str, expected: &[u8], actual: &[u8], folder: &Path) -> String {
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
    for slip in set.mistakes.iter().flatten() {
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

fn compare_files(expected: &[u8], actual: &[u8]) -> Comparison {
    let [expected, actual] = [expected, actual].map(decoded);
    Comparison::of(&expected, &actual)
}

fn decoded(file: &[u8]) -> Picture {
    reading::read(file)
        .expect("a snapshot is a PNG file")
        .picture()
}

fn assert_equal(expected: &Picture, actual: &Picture, what: &str) {
    let comparison = Comparison::of(expected, actual);
    assert!(comparison == Comparison::Equal, "{what}: {comparison}");
}

/// The text of a picture.
pub(crate) fn p3(picture: &Picture) -> Vec<u8> {
    let mut text = Vec::new();
    picture.write_p3(&mut text).expect("memory takes it");
    text
}

/// The same, by so many threads.
pub(crate) fn p3_with_threads(picture: &Picture, threads: usize) -> Vec<u8> {
    let mut text = Vec::new();
    picture
        .write_p3_with_threads(threads, &mut text)
        .expect("memory takes it");
    text
}

fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes)
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}
