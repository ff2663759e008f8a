//! Reading time: how long a chapter takes, counted from its page and its program.

use std::fs;
use std::path::Path;

use mdbook_markdown::pulldown_cmark::{Event, Parser, Tag, TagEnd};
use slips::Chapter;

use crate::directive::named;

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
    let folder = format!("../../chapters/{}_{}/src", chapter as usize, chapter.name());
    let lines = lines(&notes.join(folder))?;
    Ok(format!(
        "{minutes} minutes to read, and then a program of {lines} lines"
    ))
}

/// The words of a page that are not code, nor in a part that is closed.
fn words(text: &str) -> usize {
    let mut words = 0;
    let mut closed = 0_usize;
    let mut is_code = false;
    for event in Parser::new(text) {
        match event {
            Event::Html(html) if html.starts_with("<details") => closed += 1,
            Event::Html(html) if html.starts_with("</details") => closed -= 1,
            Event::Start(Tag::CodeBlock(_)) => is_code = true,
            Event::End(TagEnd::CodeBlock) => is_code = false,
            Event::Text(text) if closed == 0 && !is_code => {
                words += text.split_whitespace().count();
            }
            _ => {}
        }
    }
    words
}

/// The lines of code in a folder of sources, comments apart. All programs end with the
/// same `main.rs`.
fn lines(folder: &Path) -> Result<usize, String> {
    let cannot = |cause| format!("{}: {cause}", folder.display());
    let mut lines = 0;
    for entry in fs::read_dir(folder).map_err(cannot)? {
        let path = entry.map_err(cannot)?.path();
        if !path.ends_with("main.rs") {
            let text = read(&path)?;
            let code = text.lines().map(str::trim_start);
            lines += code
                .filter(|line| !line.is_empty() && !line.starts_with("//"))
                .count();
        }
    }
    Ok(lines)
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|cause| format!("{}: {cause}", path.display()))
}
