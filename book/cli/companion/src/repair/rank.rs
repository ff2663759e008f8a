//! Ranks by the chapter's own text: an edit that makes a line of it is likeliest, and a function
//! that is there word for word is seldom wrong.

use std::collections::HashSet;

use edits::Edit;

/// The addition to the ranks of the edits of a function that is the chapter's.
const RIGHT: u32 = 4;

/// The shortest line that tells something, in characters without blanks.
const TELLING: usize = 5;

/// Ranks edits of these texts by those of the chapters, and sorts them.
pub(super) fn rank(edits: &mut [Edit], texts: &[&str], chapters: &[String]) {
    let lines: HashSet<String> = chapters
        .iter()
        .flat_map(|it| it.lines())
        .map(flat)
        .collect();
    let has = |text: &str| {
        text.lines()
            .map(flat)
            .all(|it| it.is_empty() || lines.contains(&it))
    };
    for edit in edits.iter_mut() {
        let text = texts[edit.file];
        let shown = edit.lines(text);
        if has(&text[edit.function.clone()]) {
            edit.rank += RIGHT;
        } else if shown.new.len() >= TELLING && has(&shown.new) && !has(&shown.old) {
            edit.rank = 0;
        }
    }
    edits.sort_by_key(|it| it.rank);
}

/// Returns a line without blanks and comments.
fn flat(line: &str) -> String {
    let line = line.split("//").next().unwrap_or_default().trim();
    let line = line.strip_prefix("pub ").unwrap_or(line);
    line.split_whitespace().collect()
}
