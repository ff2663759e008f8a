//! What the book shows as changed from chapter to chapter is what changed.

use std::path::Path;
use std::{env, fs};

use check::comparison::Comparison;
use check::png;
use check::report::difference_picture;
use common::rtweekend::Picture;
use insta::{assert_binary_snapshot, assert_snapshot};
use similar::TextDiff;
use slips::Chapter;

use crate::book::{WORKSPACE, folder_of};
use suite::command::names_in;
use suite::drawn::{SamePixels, shown_in};
use suite::left_out::left_out;

const NOTES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes/changes");

/// The sixth chapter changes nothing: it measures the functions of the others.
#[test]
fn the_snapshot_shows_the_changes_to_each_chapter() {
    for [before, after] in Chapter::OF_THE_BOOK.array_windows() {
        assert_changes(*before, *after);
    }
}

/// Compares what changed on the way to the chapter with the files in the book: the
/// picture. The code of a chapter may be typed in other words, so what the book shows
/// of that is only compared when it is written anew.
fn assert_changes(before: Chapter, after: Chapter) {
    let name = after.name();
    let pictures = [before, after].map(|chapter| chapter.picture(chapter.book_width()));
    let sentence = picture_sentence(&pictures);
    let text = format!("{sentence}\n\n{}", code(before, after));
    let shown = Path::new(NOTES).join(name).with_extension("snap");
    let shown = fs::read_to_string(shown).unwrap_or_default();
    let in_other_words = shown.contains(&sentence) && !shown.contains(&text);
    let mut settings = shown_in("changes");
    if in_other_words && env::var_os("INSTA_UPDATE").is_none() {
        left_out(&format!(
            "`{name}` or the chapter before it is typed in other words than the book shows. To show \
             these: INSTA_UPDATE=always cargo test the_snapshot_shows_the_changes_to"
        ));
    } else {
        settings.bind(|| assert_snapshot!(name, text));
    }
    if let Some(pixels) = changed_pixels(&pictures) {
        settings.set_comparator(Box::new(SamePixels));
        settings.bind(|| {
            assert_binary_snapshot!(&format!("{name}_pixels.png"), png::encode(&pixels));
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
    let [before, after] = [before, after].map(|chapter| folder_of(chapter).join("src"));
    let [old, new] = [&before, &after].map(|sources| Path::new(WORKSPACE).join(sources));
    let old_names = names_in(&old);
    let added: Vec<String> = names_in(&new)
        .into_iter()
        .filter(|name| !old_names.contains(name))
        .map(|name| format!("`{name}`"))
        .collect();
    let added = match added.is_empty() {
        true => String::new(),
        false => format!("New files: {}.\n\n", added.join(", ")),
    };
    let [old_text, new_text] = [&old, &new].map(|folder| {
        fs::read_to_string(folder.join("lib.rs"))
            .expect("lib.rs")
            .split_inclusive('\n')
            .filter(|line| !line.starts_with("//"))
            .collect::<String>()
    });
    let diff = TextDiff::from_lines(&old_text, &new_text);
    let diff = diff
        .unified_diff()
        .context_radius(30) // A chapter is short enough to be shown whole.
        .header(&shown(&before), &shown(&after))
        .to_string();
    format!("{added}```diff\n{diff}```")
}

/// The chapter's lib.rs, as seen from the workspace.
fn shown(sources: &Path) -> String {
    sources
        .join("lib.rs")
        .display()
        .to_string()
        .replace('\\', "/")
}
