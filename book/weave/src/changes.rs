//! Diffs: what changed from one chapter to the next, in the picture and in the code.

use std::path::Path;

use slips::Chapter;

use crate::directive::snapshot;

/// The pictures of chapter `name` and of the one before, the pixels that changed,
/// and the lines of code: as the files say that a test keeps fresh.
pub(crate) fn changes(folder: &Path, name: &str) -> Result<String, String> {
    let [before, after] = Chapter::ALL
        .array_windows()
        .find(|[_, after]| after.name() == name)
        .ok_or_else(|| format!("no chapter `{name}` comes after another one"))?;
    let file = folder.join("changes").join(name).with_extension("snap");
    let body = snapshot(&file)?;
    let (picture, code) = body.split_once("\n\n").unwrap_or((&body, ""));

    let mut panels = String::new();
    let pixels = format!("changes/{name}_pixels.snap.png");
    if folder.join(&pixels).exists() {
        for (title, chapter) in [("Before", before), ("After", after)] {
            let file = format!("pictures/{}.snap.png", chapter.name());
            panels += &panel(title, &file, chapter.shows());
        }
        panels += &panel("Changed pixels", &pixels, &format!("In red: {picture}"));
    }
    let panels = match panels.is_empty() {
        true => panels,
        false => format!("<div class=\"changes\">{panels}</div>\n\n"),
    };
    Ok(format!(
        "{panels}{picture}\n\n<details><summary>The code, line by line</summary>\n\n{code}\n\n</details>"
    ))
}

fn panel(title: &str, file: &str, alt: &str) -> String {
    format!("<figure><img src=\"{file}\" alt=\"{alt}\"><figcaption>{title}</figcaption></figure>")
}
