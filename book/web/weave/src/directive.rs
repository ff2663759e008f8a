//! The directives: what stands between `{{` and `}}`.

use std::path::Path;

use crate::code::{self, Listed};
use crate::ground::{read, split};
use crate::{changes, controls, figure, measured, slip, step};

/// What stands in a page in place of a directive or a formula.
pub(crate) enum Woven {
    /// Part of a line.
    Inline(String),
    /// Markdown that needs lines of its own.
    Block(String),
}

/// Returns what the directive with this `text` stands for, in a page of `folder`.
///
/// | in a page | there appears |
/// |---|---|
/// | `{{code PATH}}` | the whole source file |
/// | `{{code PATH ITEM, ITEM}}` | these items of it, and beside which of those listed before they stand |
/// | `{{traced FIGURE PATH ITEMS}}` | the same, and beside each line its value for the ray of the figure |
/// | `{{figure NAME}}` | the figure, drawn now, with its caption; handles, if it is live |
/// | `{{live FIGURE NAME}}` | a number that this live figure says, and follows it |
/// | `{{chart NAME}}` | the chart, and a table of its numbers |
/// | `{{changes NAME}}` | what changed from the chapter before to this one |
/// | `{{editions}}` | what each edition of the book draws |
/// | `{{slip NAME CHAPTER}}` | the wrong picture that this slip draws |
/// | `{{slips LOOK}}` | all slips that look like that; `{{slips LOOK NAMES}}`, `{{slips LOOK not NAMES}}` |
/// | `{{symptoms SLIPS}}` | the parts of the page of slips, each as the picture of its slip, and all slips by their names |
/// | `{{step CHAPTER NUMBER}}` | the picture after this step on the way to the chapter |
/// | `{{snapshot PATH}}` | the Markdown in a snapshot |
/// | `{{value FILE KEY}}` | a number that was measured |
pub(crate) fn resolve(text: &str, folder: &Path, listed: &mut Listed) -> Result<Woven, String> {
    let (name, rest) = split(text.trim());
    let (first, second) = split(rest);
    let block = match name {
        "live" => return controls::number(first, second).map(Woven::Inline),
        "value" => return measured::value(&folder.join(first), second).map(Woven::Inline),
        "code" => code::listing(folder, first, second, listed, None),
        "traced" => {
            let (path, items) = split(second);
            code::listing(folder, path, items, listed, Some(first))
        }
        "figure" => figure::figure(rest),
        "chart" => figure::chart(folder, rest),
        "changes" => changes::changes(rest),
        "editions" => Ok(slip::editions()),
        "slip" => slip::slip(first, second),
        "slips" => slip::gallery(rest),
        "symptoms" => slip::symptoms(folder, rest),
        "snapshot" => snapshot(&folder.join(rest)),
        "step" => step::step(first, second),
        _ => Err(format!(
            "there is no directive `{name}`: choose code, traced, figure, live, chart, changes, \
             editions, slip, slips, step, snapshot, symptoms or value"
        )),
    };
    block.map(Woven::Block)
}

/// Returns what the snapshot at `path` holds, without the header of the file.
fn snapshot(path: &Path) -> Result<String, String> {
    let text = read(path)?;
    // insta begins a snapshot with a header between lines of dashes.
    let body = text.splitn(3, "---\n").nth(2);
    Ok(body.unwrap_or(&text).to_owned())
}
