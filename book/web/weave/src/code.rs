//! Listings: items of the sources, below a line that says where they stand.

use std::ops::Range;
use std::path::Path;

use crate::folded::folded;
use crate::ground::{escaped, read};
use crate::source::{self, SourceItem};
use crate::{controls, lesson};

/// The items that a page has listed so far: file, lines, and name, so that a later listing can say
/// where it stands beside them.
#[derive(Default)]
pub(crate) struct Listed(Vec<(String, Range<usize>, String)>);

impl Listed {
    /// Returns `, below NAME` for the nearest listed item above this one in the same file, else `,
    /// above NAME` for the nearest below, or nothing if the page has listed none.
    fn beside(&self, file: &str, item: &SourceItem) -> String {
        let of_file = || self.0.iter().filter(|(of, ..)| of == file);
        let before = of_file().filter(|(_, lines, _)| lines.end <= item.lines.start);
        let behind = of_file().filter(|(_, lines, _)| lines.start >= item.lines.end);
        let below = before.max_by_key(|(_, lines, _)| lines.end);
        let above = behind.min_by_key(|(_, lines, _)| lines.start);
        let (word, beside) = below.map_or(("above", above), |it| ("below", Some(it)));
        beside.map_or(String::new(), |(_, _, name)| {
            format!(", {word} <b>{}</b>", escaped(name))
        })
    }

    /// Remembers items as listed; imports are left out.
    fn add(&mut self, file: &str, items: &[SourceItem]) {
        let entries = items.iter().filter(|item| !item.is_import).map(|item| {
            let name = item.called().to_owned();
            (file.to_owned(), item.lines.clone(), name)
        });
        self.0.extend(entries);
    }
}

/// Returns the listing of a source as Markdown: the `items` of the file at `path`, seen from
/// `folder`, or all of it if the list is empty. Beside each line stands its value for the ray of
/// the `figure`, if one is given.
///
/// # Errors
/// If the file cannot be read, or an item or the figure is not there.
pub(crate) fn listing(
    folder: &Path,
    path: &str,
    items: &str,
    listed: &mut Listed,
    figure: Option<&str>,
) -> Result<String, String> {
    // The pages are in book/notes, so without `../../` it is as seen from the workspace.
    let file = path.trim_start_matches("../");
    let text = read(&folder.join(path))?;
    let (name, beside, code) = if items.is_empty() {
        (file.to_owned(), String::new(), text)
    } else {
        let found = source::items(&text, items).map_err(|cause| format!("{file}{cause}"))?;
        let main = found.iter().find(|item| !item.is_import);
        let main = main.unwrap_or(&found[0]);
        let (name, beside) = (main.names[0].clone(), listed.beside(file, main));
        listed.add(file, &found);
        (name, beside, source::excerpt(&text, &found))
    };
    let lesson = lesson::listing(file, code);
    let stair = if lesson.file == file { "" } else { "first-" };
    let id = format!("{stair}{name}").replace(|it: char| !it.is_alphanumeric(), "-");
    let values = figure.map_or(Ok(String::new()), |figure| values(figure, &lesson.code))?;
    let (code, folded) = folded(&lesson.code);
    Ok(format!(
        "<div class=\"listing\"><p class=\"source\" id=\"listing-{id}\"><span class=\"file\">{}</span>{}{beside}</p>\
         {}\n\n````rust\n{}\n````\n\n{values}</div>\n\n{folded}",
        lesson.file,
        lesson.whose,
        lesson.tools,
        code.trim_end(),
    ))
}

/// Returns a column of values beside the code, as HTML: that of a name at its `let`, and the result
/// at the last line.
fn values(figure: &str, code: &str) -> Result<String, String> {
    let says = controls::says(figure)?;
    // What stands above the first value may be wrapped, so no line counts before the comments end.
    let is_comment = |line: &&str| line.trim_start().starts_with("//");
    let lines: Vec<&str> = code.lines().collect();
    let start = lines.iter().rposition(is_comment).map_or(0, |n| n + 1);
    let lines: Vec<&str> = lines[start..].iter().map(|line| line.trim()).collect();
    let last = lines.iter().rposition(|line| !["", "}"].contains(line));
    let value = |n: usize| {
        let name = match lines[n] {
            _ if Some(n) == last => "result",
            "return None;" => "none",
            it if it.ends_with(';') => it.strip_prefix("let ")?.split(' ').next()?,
            _ => return None,
        };
        let (name, value) = says.get_key_value(name)?;
        let value = controls::followed(figure, name, value);
        Some(match *name {
            "none" | "result" => value,
            name => format!("<span class=\"of\">{name} = </span>{value}"),
        })
    };
    let row = |n| format!("<span>{}</span>", value(n).unwrap_or_default());
    let rows: String = (0..lines.len()).map(row).collect();
    Ok(format!(
        "<div class=\"values\" role=\"group\" aria-label=\"For the ray of the figure\">{rows}</div>\n\n"
    ))
}
