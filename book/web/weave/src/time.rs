//! Reading time: how long a chapter takes, counted from its page and its program.

use std::path::Path;

use slips::Chapter;

use crate::code::{self, Listed};
use crate::ground::{named, read, split};

/// How many words a reader of such texts reads in a minute (Brysbaert, 2019, has 238 for
/// texts without formulas).
const WORDS_A_MINUTE: usize = 200;

/// The minutes that the page of the chapter takes, in the folder `notes`, with its code, and
/// with what is folded; and the lines of its program.
pub(crate) fn time(notes: &Path, chapter: &str) -> Result<String, String> {
    let chapter = named("chapter", chapter, Chapter::ALL, |chapter| chapter.name())?;
    let page = match chapter {
        Chapter::BuildTest => "setup",
        other => other.name(),
    };
    let text = read(&notes.join(page).with_extension("md"))?;
    let lines: Result<Vec<String>, String> = text.lines().map(|it| with_code(notes, it)).collect();
    let text = lines?.join("\n");
    let open = text.split("</details>");
    let open: Vec<&str> = open.filter_map(|it| it.split("<details").next()).collect();
    let minutes = |text: &str| text.split_whitespace().count().div_ceil(WORDS_A_MINUTE);
    let (least, most) = (minutes(&open.join("\n")), minutes(&text));
    let lines = chapter.files().iter().flat_map(|(_, text)| text.lines());
    let code = lines.map(str::trim_start);
    let code = code.filter(|line| !line.is_empty() && !line.starts_with("//"));
    Ok(format!(
        "{least} minutes to read with its code, {most} with all hints and answers, and then a \
         program of {} lines",
        code.count()
    ))
}

/// The line of a page, or the listing that it asks for.
fn with_code(notes: &Path, line: &str) -> Result<String, String> {
    let directive = line.strip_prefix("{{").and_then(|it| it.strip_suffix("}}"));
    let (path, items) = match directive.map(split) {
        Some(("code", rest)) => split(rest),
        Some(("traced", rest)) => split(split(rest).1),
        _ => return Ok(line.to_owned()),
    };
    code::listing(notes, path, items, &mut Listed::default(), None)
}
