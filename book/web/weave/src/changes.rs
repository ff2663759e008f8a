//! Diffs: what changed from one chapter to the next in the picture, and which files are new.

use check::comparison::Comparison;
use check::report::difference_picture;
use slips::Chapter;

use crate::slip::address;

/// The pictures of chapter `name` and of the one before, the pixels that changed, and the new files.
pub(crate) fn changes(name: &str) -> Result<String, String> {
    let [before, after] = Chapter::OF_THE_BOOK
        .array_windows()
        .find(|[_, after]| after.name() == name)
        .ok_or_else(|| format!("no chapter `{name}` comes after another one"))?;
    let (sentence, panels) = pictures(*before, *after);
    let files = new_files(*before, *after);
    Ok(format!("{panels}{sentence}{files}"))
}

/// Returns what becomes of the picture; and where only some of its pixels change, the pictures.
fn pictures(before: Chapter, after: Chapter) -> (String, String) {
    let [old, new] = [before, after].map(|chapter| chapter.picture(chapter.book_width()));
    match Comparison::of(&old, &new) {
        Comparison::Equal => {
            let same = "The picture does not change, not by a single bit.";
            (same.to_owned(), String::new())
        }
        Comparison::AnotherSize => {
            let [size, new_size] =
                [&old, &new].map(|it| format!("{} × {}", it.width(), it.height()));
            let sentence =
                format!("The picture is another one, of {new_size} pixels instead of {size}.");
            (sentence, String::new())
        }
        Comparison::Pixels(it) => {
            let sentence = format!(
                "{} of {} pixels change, in columns {} to {} and rows {} to {}.",
                it.count, it.total, it.columns[0], it.columns[1], it.rows[0], it.rows[1]
            );
            let panels = difference_picture(&old, &new).map(|changed| {
                let file = |of: Chapter| format!("pictures/{}.snap.png", of.name());
                let panels = [
                    panel("Before", &file(before), before.shows()),
                    panel("After", &file(after), after.shows()),
                    panel("Changed pixels", &address(&changed), &sentence),
                ];
                format!("<div class=\"changes\">{}</div>\n\n", panels.concat())
            });
            (sentence, panels.unwrap_or_default())
        }
    }
}

fn panel(title: &str, file: &str, alt: &str) -> String {
    format!("<figure><img src=\"{file}\" alt=\"{alt}\"><figcaption>{title}</figcaption></figure>")
}

fn new_files(before: Chapter, after: Chapter) -> String {
    let is_old = |name: &str| before.files().iter().any(|(old, _)| *old == name);
    let names = after.files().iter().map(|(name, _)| *name);
    let added: Vec<String> = names
        .filter(|name| !is_old(name))
        .map(|name| format!("`{}`", name.trim_start_matches("src/")))
        .collect();
    match &added[..] {
        [] => String::new(),
        _ => format!(" New files: {}.", added.join(", ")),
    }
}
