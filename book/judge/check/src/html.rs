//! The layout of an answer as HTML, with the elements and classes of the book's pages.

use std::fmt;

use crate::answer::{Answer, Grade, Headline, Row, RowKind};

/// The page of the book in which an answer is shown, with links to other pages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HostPage {
    /// Any page but the next one. A reader types there, so the right line is folded, and how it was
    /// tried.
    Book,
    /// The page *Check your picture*, with a button that judges the picture of a probe (a changed
    /// scene).
    CheckPage,
}

/// Lays out a headline as HTML without an element around it: the verdict is strong, in a class for
/// its grade.
pub fn headline(headline: &Headline) -> String {
    // The name `right` is taken: mdBook lets what has it float.
    let class = match headline.grade {
        Grade::Right => "is-right",
        Grade::OnTheWay => "is-calm",
        Grade::Wrong => "is-wrong",
        Grade::NoPicture => "is-none",
    };
    let [before, verdict, rest] = headline.parts().map(escaped);
    format!("{before}<strong class=\"{class}\">{verdict}</strong>{rest}")
}

/// Lays out all that follows the headline, but for the pictures, as HTML: lines that were printed,
/// rows, what to do next, and links to pages. Empty if there is none of these.
pub fn details(answer: &Answer, page: HostPage) -> String {
    let printed = answer.rows.iter().filter(|it| it.kind == RowKind::Printed);
    let printed = printed.map(|it| format!("<p class=\"printed\">{}</p>", escaped(&it.text)));
    let rows = answer.rows.iter().filter(|it| it.kind != RowKind::Printed);
    let tells = |it: &Row| matches!(it.kind, RowKind::ShouldBe | RowKind::Missing);
    let is_folded = page == HostPage::Book && answer.rows.iter().any(tells);
    let is_told = |it: &&Row| !is_folded || !tells(it) && it.kind != RowKind::Tried;
    let (told, folded): (Vec<&Row>, Vec<&Row>) = rows.partition(is_told);
    let item = |it: &Row| item(it.kind.label(), &said(it, page));
    let next = (!answer.next.is_empty()).then(|| self::item("next", &with_code(&answer.next)));
    let told = list(told.into_iter().map(item).chain(next).collect());
    let folded = list(folded.into_iter().map(item).collect());
    let folded = match &*folded {
        "" => folded,
        rows => format!("<details><summary>Show the answer</summary>{rows}</details>"),
    };
    let pages = answer.read.iter().map(|slip| {
        format!(
            "<p><a href=\"{}\">How the line is right</a></p>",
            escaped(slip.page_link())
        )
    });
    printed.chain([told, folded]).chain(pages).collect()
}

/// Escapes the characters `&`, `<`, `>` and `"` of a text for HTML, between tags and in attributes.
pub fn escaped(text: impl fmt::Display) -> String {
    text.to_string()
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Lays out the text of a row.
fn said(row: &Row, page: HostPage) -> String {
    match row.kind {
        kind if kind.is_code() => format!("<code>{}</code>", escaped(&row.text)),
        RowKind::Probe(name) if page == HostPage::CheckPage => format!(
            "{} <button type=\"button\" data-probe=\"{name}\">Judge it here</button>",
            with_code(&row.text)
        ),
        _ => with_code(&row.text),
    }
}

/// Makes a description list of its items, or nothing of none.
fn list(items: String) -> String {
    match &*items {
        "" => items,
        items => format!("<dl>{items}</dl>"),
    }
}

/// Makes an item of a description list.
fn item(label: &str, said: &str) -> String {
    format!("<dt>{label}</dt><dd>{said}</dd>")
}

/// Escapes a text for HTML, and puts each part between backticks into a `code` element.
fn with_code(text: &str) -> String {
    let parts = text.split('`').enumerate();
    let part = |(n, part): (usize, &str)| match n % 2 {
        0 => escaped(part),
        _ => format!("<code>{}</code>", escaped(part)),
    };
    parts.map(part).collect()
}
