//! What the bibliography lists is what the book rests on: each entry is cited, and each
//! citation has an entry.

use std::fs;
use std::path::Path;

use crate::book::{pages, select, text_of};
use suite::command::files;

#[test]
fn each_entry_is_cited_by_a_page_or_in_the_code() {
    let comments = comments();
    let pages = pages();
    let page = pages.iter().find(|page| page.name == PAGE).expect("a page");
    let entries = page.all("main h3[id]");
    assert!(entries.len() > 10);
    for entry in entries {
        let id = entry.attr("id").expect("it was selected by it");
        let link = select(&format!("a[href=\"{PAGE}#{id}\"]"));
        let others = pages.iter().filter(|page| page.name != PAGE);
        let on_pages: usize = others.map(|page| page.all_of(&link).len()).sum();
        let heading = text_of(entry);
        let author = heading.split([' ', ',']).next().unwrap_or_default();
        assert!(
            on_pages > 0 || comments.contains(author),
            "nobody cites {heading}"
        );
    }
}

/// A comment names what it cites between asterisks.
#[test]
fn each_title_in_a_comment_has_an_entry() {
    let pages = pages();
    let page = pages.iter().find(|page| page.name == PAGE).expect("a page");
    let titles: Vec<String> = page.all("main em").into_iter().map(text_of).collect();
    let titles: Vec<String> = titles.iter().map(|title| plain(title)).collect();
    let comments = comments();
    let cited = comments.split('*').skip(1).step_by(2);
    let cited: Vec<String> = cited
        .filter(|title| title.split(' ').count() > 3)
        .map(plain)
        .collect();
    assert!(cited.len() >= 6, "{cited:?}");
    for title in cited {
        assert!(titles.contains(&title), "no entry for {title}");
    }
}

const PAGE: &str = "bibliography.html";

/// The comments of the sixth chapter, which cites, as one line.
fn comments() -> String {
    let chapter =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../chapters/6_speed_vs_accuracy/src");
    let sources = files(&chapter).into_iter();
    let text: String = sources
        .map(|file| fs::read_to_string(file).expect("a source"))
        .collect();
    let comments = text.lines().filter_map(|line| {
        let line = line.trim_start();
        line.strip_prefix("///").or(line.strip_prefix("//!"))
    });
    let words = comments.flat_map(str::split_whitespace);
    words.collect::<Vec<_>>().join(" ")
}

/// Without capitals, and with the plain apostrophe.
fn plain(title: &str) -> String {
    let words: Vec<&str> = title.split_whitespace().collect();
    words.join(" ").to_lowercase().replace('’', "'")
}
