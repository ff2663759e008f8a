//! Golden diffs: what the book shows as changed from chapter to chapter is what changed.
//!
//! A chapter may be typed in other words, so plain `cargo test` does not ask.

use std::fs;
use std::path::Path;

use check::comparison::Comparison;
use check::png;
use check::report::difference_picture;
use common::rtweekend::Picture;
use insta::{assert_binary_snapshot, assert_snapshot};
use similar::TextDiff;
use slips::Chapter;

use crate::book::{WORKSPACE, folder_of};
use suite::command::names_in;
use suite::drawn::shown_in;

/// The sixth chapter changes nothing: it measures the functions of the others.
#[test]
#[ignore = "a reader may type a chapter in other words"]
fn the_snapshot_shows_the_changes_to_each_chapter() {
    for &[before, after] in Chapter::OF_THE_BOOK.array_windows() {
        let pictures = [before, after].map(|chapter| chapter.picture(chapter.book_width()));
        let text = format!("{}\n\n{}", picture_sentence(&pictures), code(before, after));
        shown_in("changes").bind(|| {
            assert_snapshot!(after.name(), text);
            if let Some(pixels) = changed_pixels(&pictures) {
                let name = format!("{}_pixels.png", after.name());
                assert_binary_snapshot!(&name, png::encode(&pixels));
            }
        });
    }
}

fn picture_sentence([before, after]: &[Picture; 2]) -> String {
    match Comparison::of(before, after) {
        Comparison::Equal => "The picture does not change, not by a single bit.".to_owned(),
        Comparison::Size((width, height), (new_width, new_height)) => format!(
            "The picture is another one, of {new_width} × {new_height} pixels instead of {width} × {height}."
        ),
        Comparison::Pixels(difference) => format!(
            "{} of {} pixels change, in columns {} to {} and rows {} to {}.",
            difference.count,
            difference.total,
            difference.columns.0,
            difference.columns.1,
            difference.rows.0,
            difference.rows.1
        ),
    }
}

/// The pixels that change, if some do and some don't.
fn changed_pixels([before, after]: &[Picture; 2]) -> Option<Picture> {
    match Comparison::of(before, after) {
        Comparison::Pixels(_) => difference_picture(before, after),
        Comparison::Equal | Comparison::Size(..) => None,
    }
}

/// The new files, and the lines that change in `lib.rs`, as Markdown. Comments
/// are left out: they are all new, and hide how little the code changes.
fn code(before: Chapter, after: Chapter) -> String {
    let [old, new] = [before, after].map(|chapter| folder_of(chapter).join("src"));
    let old_names = names_in(&Path::new(WORKSPACE).join(&old));
    let mut added = names_in(&Path::new(WORKSPACE).join(&new));
    added.retain(|name| !old_names.contains(name));
    let added = if added.is_empty() {
        String::new()
    } else {
        format!("New files: `{}`.\n\n", added.join("`, `"))
    };
    let [old_text, new_text] = [&old, &new].map(|folder| {
        let text = fs::read_to_string(Path::new(WORKSPACE).join(folder).join("lib.rs"));
        let text = text.expect("lib.rs");
        let lines = text.split_inclusive('\n');
        lines
            .filter(|line| !line.starts_with("//"))
            .collect::<String>()
    });
    let [old, new] = [old, new].map(|folder| format!("{}/lib.rs", folder.display()));
    let diff = TextDiff::from_lines(&old_text, &new_text);
    let diff = diff
        .unified_diff()
        .context_radius(30) // A chapter is short enough to be shown whole.
        .header(&old, &new)
        .to_string();
    format!("{added}```diff\n{diff}```")
}
