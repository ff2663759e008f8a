//! Diffs: what changed from one chapter to the next, in the picture and in the code.

use check::comparison::Comparison;
use check::report::difference_picture;
use similar::TextDiff;
use slips::Chapter;

use crate::slip::address;

/// The pictures of chapter `name` and of the one before, the pixels that changed,
/// and the lines of code.
pub(crate) fn changes(name: &str) -> Result<String, String> {
    let [before, after] = Chapter::OF_THE_BOOK
        .array_windows()
        .find(|[_, after]| after.name() == name)
        .ok_or_else(|| format!("no chapter `{name}` comes after another one"))?;
    let (sentence, panels) = pictures(*before, *after);
    Ok(format!(
        "{panels}{sentence}\n\n<details><summary>The code, line by line</summary>\n\n{}\n\n</details>",
        code(*before, *after)
    ))
}

/// What becomes of the picture; and where only some of its pixels change, the pictures.
fn pictures(before: Chapter, after: Chapter) -> (String, String) {
    let [old, new] = [before, after].map(|chapter| chapter.picture(chapter.book_width()));
    match Comparison::of(&old, &new) {
        Comparison::Equal => {
            let same = "The picture does not change, not by a single bit.";
            (same.to_owned(), String::new())
        }
        Comparison::Size((width, height), (new_width, new_height)) => {
            let sentence = format!(
                "The picture is another one, of {new_width} × {new_height} pixels instead of {width} × {height}."
            );
            (sentence, String::new())
        }
        Comparison::Pixels(it) => {
            let sentence = format!(
                "{} of {} pixels change, in columns {} to {} and rows {} to {}.",
                it.count, it.total, it.columns.0, it.columns.1, it.rows.0, it.rows.1
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

/// The new files, and the lines that change in `lib.rs`, as Markdown. Comments
/// are left out: they are all new, and hide how little the code changes.
fn code(before: Chapter, after: Chapter) -> String {
    let is_old = |name: &str| before.files().iter().any(|(old, _)| *old == name);
    let names = after.files().iter().map(|(name, _)| *name);
    let added: Vec<String> = names
        .filter(|name| !is_old(name))
        .map(|name| format!("`{}`", name.trim_start_matches("src/")))
        .collect();
    let added = if added.is_empty() {
        String::new()
    } else {
        format!("New files: {}.\n\n", added.join(", "))
    };
    let [old, new] = [before, after].map(lib);
    let [old_file, new_file] = [before, after].map(|chapter| {
        format!(
            "chapters/{}_{}/src/lib.rs",
            chapter as usize,
            chapter.name()
        )
    });
    let diff = TextDiff::from_lines(&old, &new)
        .unified_diff()
        .context_radius(30) // A chapter is short enough to be shown whole.
        .header(&old_file, &new_file)
        .to_string();
    format!("{added}```diff\n{diff}```")
}

/// The lines of the chapter's `lib.rs` but for those of comments.
fn lib(chapter: Chapter) -> String {
    let lib = chapter
        .files()
        .iter()
        .find(|(name, _)| *name == "src/lib.rs");
    let (_, text) = lib.expect("every chapter has one");
    let lines = text.split_inclusive('\n');
    lines.filter(|line| !line.starts_with("//")).collect()
}
