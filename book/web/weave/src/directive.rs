//! Directives of a page: the text between `{{` and `}}`, and what it is replaced by.

use std::path::Path;

use crate::code::{self, Listed};
use crate::ground::{read, split};
use crate::{changes, controls, figure, measured, slip, step};

/// The text that takes the place of a directive or a formula in a page.
pub(crate) enum Woven {
    /// A part of a line.
    Inline(String),
    /// Markdown that needs lines of its own.
    Block(String),
}

/// Returns the text that replaces a directive in a page of `folder`; `text` is all between its
/// braces.
///
/// | directive | its replacement |
/// |---|---|
/// | `{{code PATH}}` | the whole source file |
/// | `{{code PATH ITEM, ITEM}}` | these items of a source, and where they stand beside items listed before |
/// | `{{traced FIGURE PATH ITEMS}}` | such a listing, with each line's value for the ray of the figure |
/// | `{{figure NAME}}` | the figure, drawn now, with its question, caption and handles |
/// | `{{figure NAME 2}}` | the same figure with its second question |
/// | `{{live FIGURE NAME}}` | a number that this live figure says, also when it is moved |
/// | `{{chart NAME}}` | the chart, and a table of its numbers |
/// | `{{changes NAME}}` | the differences between a chapter's picture and the one before |
/// | `{{slip NAME CHAPTER}}` | the wrong picture that this slip draws |
/// | `{{slips LOOK}}` | all slips of a look; also `{{slips LOOK NAMES}}`, `{{slips LOOK not NAMES}}` |
/// | `{{symptoms SLIPS}}` | the parts of the page of slips, each as the picture of its slip |
/// | `{{names}}` | all slips by name |
/// | `{{step CHAPTER NUMBER}}` | the picture after this step on the way to the chapter |
/// | `{{snapshot PATH}}` | the Markdown in a snapshot |
/// | `{{value FILE KEY}}` | a number that was measured |
///
/// # Errors
/// If there is no such directive, or its replacement cannot be made.
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
        "figure" => figure::figure(first, second),
        "chart" => figure::chart(folder, rest),
        "changes" => changes::changes(rest),
        "slip" => slip::slip(first, second),
        "slips" => slip::gallery(rest),
        "symptoms" => slip::symptoms(folder, rest),
        "names" => Ok(slip::names()),
        "probes" => Ok(slip::probes()),
        "snapshot" => snapshot(&folder.join(rest)),
        "step" => step::step(first, second),
        _ => Err(format!(
            "there is no directive `{name}`: choose code, traced, figure, live, chart, changes, \
             names, probes, slip, slips, step, snapshot, symptoms or value"
        )),
    };
    block.map(Woven::Block)
}

/// Returns the text of the snapshot at `path`, without the header that insta writes.
fn snapshot(path: &Path) -> Result<String, String> {
    let text = read(path)?;
    // insta begins a snapshot with a header between lines of dashes.
    let body = text.splitn(3, "---\n").nth(2);
    Ok(body.unwrap_or(&text).to_owned())
}
