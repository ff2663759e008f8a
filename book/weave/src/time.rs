//! Reading time: how long a chapter takes, counted from its page and its program.

use std::path::Path;

use slips::Chapter;

use crate::ground::{named, read};

/// How many words a reader of such texts reads in a minute (Brysbaert, 2019, has 238 for
/// texts without formulas).
const WORDS_A_MINUTE: usize = 200;

/// The minutes that the page of the chapter takes, in the folder `notes`, and the lines of
/// its program.
pub(crate) fn time(notes: &Path, chapter: &str) -> Result<String, String> {
    let chapter = named("chapter", chapter, Chapter::ALL, |chapter| chapter.name())?;
    let page = match chapter {
        Chapter::BuildTest => "setup",
        other => other.name(),
    };
    let text = read(&notes.join(page).with_extension("md"))?;
    let minutes = words(&text).div_ceil(WORDS_A_MINUTE);
    let lines = chapter.files().iter().flat_map(|(_, text)| text.lines());
    let code = lines.map(str::trim_start);
    let code = code.filter(|line| !line.is_empty() && !line.starts_with("//"));
    Ok(format!(
        "{minutes} minutes to read, and then a program of {} lines",
        code.count()
    ))
}

/// The words of a page that are not code, nor in a part that is closed.
fn words(text: &str) -> usize {
    let outside_code: String = text.split("```").step_by(2).collect();
    let open = outside_code.split("</details>");
    let open = open.filter_map(|part| part.split("<details").next());
    open.flat_map(str::split_whitespace).count()
}
