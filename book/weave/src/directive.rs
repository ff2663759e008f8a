//! The directives: what stands between `{{` and `}}`.

use std::path::Path;

use crate::code::Listed;
use crate::woven::Woven;
use crate::{changes, code, controls, figure, measured, picture, slip, snapshot, step};

/// What the directive with this `text` stands for, in a page of `folder`.
///
/// | in a page | there appears |
/// |---|---|
/// | `{{code PATH}}` | the whole source file |
/// | `{{code PATH ITEM, ITEM}}` | these items of it, and beside which of those listed before they stand |
/// | `{{figure NAME}}` | the figure, drawn now, with its caption; handles, if it is live |
/// | `{{live FIGURE NAME}}` | a number that this live figure tells, and follows it |
/// | `{{chart NAME}}` | the chart, and a table of its numbers |
/// | `{{changes NAME}}` | what changed from the chapter before to this one |
/// | `{{editions}}` | what each edition of the book draws |
/// | `{{picture CHAPTER IMAGE}}` | this image, which a reader can paint anew |
/// | `{{slip NAME CHAPTER}}` | the wrong picture that this slip draws |
/// | `{{slips}}` | all slips, by what there is to see |
/// | `{{step CHAPTER NUMBER}}` | the picture after this step on the way to the chapter |
/// | `{{snapshot PATH}}` | the Markdown in a snapshot |
/// | `{{value FILE KEY}}` | a number that was measured |
pub(crate) fn resolve(text: &str, folder: &Path, listed: &mut Listed) -> Result<Woven, String> {
    let (name, rest) = split(text.trim());
    match name {
        "code" => {
            let (path, items) = split(rest);
            code::listing(folder, path, items, listed).map(Woven::Block)
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
        "slips" => Ok(Woven::Block(slip::gallery())),
        "step" => {
            let (chapter, number) = split(rest);
            step::step(chapter, number).map(Woven::Block)
        }
        "snapshot" => snapshot::text(&folder.join(rest)).map(Woven::Block),
        "value" => {
            let (file, key) = split(rest);
            measured::value(&folder.join(file), key).map(Woven::Inline)
        }
        _ => Err(format!(
            "there is no directive `{name}`: choose code, figure, live, chart, changes, editions, \
             picture, slip, slips, step, snapshot or value"
        )),
    }
}

/// The first word, and what follows.
fn split(text: &str) -> (&str, &str) {
    let (first, rest) = text.split_once(' ').unwrap_or((text, ""));
    (first, rest.trim())
}
