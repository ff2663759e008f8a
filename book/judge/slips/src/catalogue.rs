//! The catalogue of all slips, read from `catalogue.txt`.

use std::sync::LazyLock;

use crate::edit::Edit;
use crate::slip::Slip;

/// A paragraph for each slip: its name and page, its edits, and labeled lines.
const TEXT: &str = include_str!("catalogue.txt");

static SLIPS: LazyLock<Vec<Slip>> = LazyLock::new(|| {
    let paragraphs = TEXT.split("\n\n").map(str::trim_end);
    let slips = paragraphs.filter(|it| !it.is_empty() && !it.starts_with('#'));
    slips.map(read).collect()
});

/// Lists all slips (known mistakes) that have a name, in the order in which a reader of the book
/// can first make them.
pub fn all() -> impl Iterator<Item = &'static Slip> {
    let is_mistake = |slip: &&Slip| !slip.name.is_empty() && slip.right.is_empty();
    SLIPS.iter().filter(is_mistake)
}

/// Returns what version 3 of the book has otherwise than version 4, which the chapters follow: no
/// mistake, though made by edits as a slip is.
///
/// # Panics
/// If the catalogue has no such slip.
pub fn version_3() -> &'static Slip {
    let mut slips = SLIPS.iter();
    slips
        .find(|slip| !slip.right.is_empty())
        .expect("the catalogue has it")
}

/// Lists the slips (known mistakes) that have no name for commands and tables; pictures and the
/// answers of functions are compared with them, too.
pub fn unnamed() -> impl Iterator<Item = &'static Slip> {
    SLIPS.iter().filter(|slip| slip.name.is_empty())
}

/// Finds a slip by its [`name`](Slip::name); `None` if no slip has it, and for an empty one.
pub fn find(name: &str) -> Option<&'static Slip> {
    all().find(|slip| slip.name == name)
}

/// Reads a paragraph of the catalogue.
///
/// # Panics
/// If a line is neither an edit nor labeled.
fn read(paragraph: &'static str) -> Slip {
    let mut lines = paragraph.lines().map(str::trim);
    let first = lines.next().unwrap_or_default();
    let (name, page) = first.split_once(' ').unwrap_or((first, ""));
    let mut slip = Slip {
        name: name.trim_start_matches('-'),
        page: page.trim(),
        ..Slip::default()
    };
    for line in lines {
        match line.split_once(": ") {
            Some(("why", why)) => slip.why = why,
            Some(("right", by)) => slip.right = by,
            Some(("reported", by)) => slip.reported = by,
            Some(("only in", languages)) => slip.only_in = languages,
            Some(("equivalent", proof)) => slip.equivalent = proof,
            Some(("law", law)) => slip.law = law,
            Some((label, line)) if label.starts_with("Rust") => slip.rust.add(label, line),
            Some((label, line)) if label.starts_with("C++") => slip.cpp.add(label, line),
            _ if line.contains('→') => slip.edits.push(Edit::parse(line)),
            _ => panic!("the catalogue says \"{line}\" of {name}"),
        }
    }
    slip
}
