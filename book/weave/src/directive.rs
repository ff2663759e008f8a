//! The directives: what stands between `{{` and `}}`.

use std::fs;
use std::path::Path;

use crate::code::Listed;
use crate::{changes, code, controls, figure, measured, picture, slip, step, time};

/// What stands in a page in place of a directive or a formula.
pub(crate) enum Woven {
    /// Part of a line.
    Inline(String),
    /// Markdown that needs lines of its own.
    Block(String),
}

/// What the directive with this `text` stands for, in a page of `folder`.
///
/// | in a page | there appears |
/// |---|---|
/// | `{{code PATH}}` | the whole source file |
/// | `{{code PATH ITEM, ITEM}}` | these items of it, and beside which of those listed before they stand |
/// | `{{traced FIGURE PATH ITEMS}}` | the same, and beside each line its value for the ray of the figure |
/// | `{{figure NAME}}` | the figure, drawn now, with its caption; handles, if it is live |
/// | `{{live FIGURE NAME}}` | a number that this live figure tells, and follows it |
/// | `{{chart NAME}}` | the chart, and a table of its numbers |
/// | `{{changes NAME}}` | what changed from the chapter before to this one |
/// | `{{editions}}` | what each edition of the book draws |
/// | `{{picture CHAPTER IMAGE}}` | this image, which a reader can paint anew |
/// | `{{slip NAME CHAPTER}}` | the wrong picture that this slip draws |
/// | `{{slips LOOK}}` | all slips that look like that |
/// | `{{step CHAPTER NUMBER}}` | the picture after this step on the way to the chapter |
/// | `{{snapshot PATH}}` | the Markdown in a snapshot |
/// | `{{time CHAPTER}}` | how long its page is to read, and its program to type |
/// | `{{value FILE KEY}}` | a number that was measured |
pub(crate) fn resolve(text: &str, folder: &Path, listed: &mut Listed) -> Result<Woven, String> {
    let (name, rest) = split(text.trim());
    match name {
        "code" => {
            let (path, items) = split(rest);
            code::listing(folder, path, items, listed, None).map(Woven::Block)
        }
        "traced" => {
            let (figure, rest) = split(rest);
            let (path, items) = split(rest);
            code::listing(folder, path, items, listed, Some(figure)).map(Woven::Block)
        }
        "figure" => figure::figure(rest).map(Woven::Block),
        "live" => {
            let (figure, number) = split(rest);
            controls::number(figure, number).map(Woven::Inline)
        }
        "chart" => figure::chart(folder, rest).map(Woven::Block),
        "changes" => changes::changes(folder, rest).map(Woven::Block),
        "editions" => Ok(Woven::Block(slip::editions())),
        "picture" => {
            let (chapter, image) = split(rest);
            picture::picture(folder, chapter, image).map(Woven::Block)
        }
        "slip" => {
            let (name, chapter) = split(rest);
            slip::slip(name, chapter).map(Woven::Block)
        }
        "slips" => slip::gallery(rest).map(Woven::Block),
        "step" => {
            let (chapter, number) = split(rest);
            step::step(chapter, number).map(Woven::Block)
        }
        "snapshot" => snapshot(&folder.join(rest)).map(Woven::Block),
        "time" => time::time(folder, rest).map(Woven::Inline),
        "value" => {
            let (file, key) = split(rest);
            measured::value(&folder.join(file), key).map(Woven::Inline)
        }
        _ => Err(format!(
            "there is no directive `{name}`: choose code, traced, figure, live, chart, changes, \
             editions, picture, slip, slips, step, snapshot, time or value"
        )),
    }
}

/// The first word, and what follows.
fn split(text: &str) -> (&str, &str) {
    let (first, rest) = text.split_once(' ').unwrap_or((text, ""));
    (first, rest.trim())
}

/// The one of `all` that has this name.
///
/// # Errors
/// If there is none, with the names that there are.
pub(crate) fn named<T>(
    kind: &str,
    name: &str,
    all: impl IntoIterator<Item = T>,
    name_of: impl Fn(&T) -> &'static str,
) -> Result<T, String> {
    let mut names = Vec::new();
    for one in all {
        if name_of(&one) == name {
            return Ok(one);
        }
        names.push(name_of(&one));
    }
    let names = names.join(", ");
    Err(format!("there is no {kind} `{name}`: there are {names}"))
}

/// What the snapshot at `path` holds, without the header of the file.
pub(crate) fn snapshot(path: &Path) -> Result<String, String> {
    let text = fs::read_to_string(path).map_err(|cause| format!("{}: {cause}", path.display()))?;
    // insta begins a snapshot with a header between lines of dashes.
    let body = text.splitn(3, "---\n").nth(2);
    Ok(body.unwrap_or(&text).to_owned())
}
