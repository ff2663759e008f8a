//! The layout of an answer as HTML, with the elements and classes of the book's pages.

use std::fmt;

use crate::answer::{Answer, Grade, Headline, Row, RowKind};

/// The page of the book in which an answer is shown, with links to other pages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HostPage {
    /// Any page but the next one. A reader types there, so the right line is folded.
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
    let is_printed = |it: &&Row| it.kind == RowKind::Printed;
    let (printed, rows): (Vec<&Row>, Vec<&Row>) = answer.rows.iter().partition(is_printed);
    let printed = printed
        .iter()
        .map(|it| format!("<p class=\"printed\">{}</p>", escaped(&it.text)));
    let rows = rows.iter().map(|it| row(it, page));
    let next = (!answer.next.is_empty()).then(|| item("next", &with_code(&answer.next)));
    let rows: String = rows.chain(next).collect();
    let list = match &*rows {
        "" => String::new(),
        rows => format!("<dl>{rows}</dl>"),
    };
    let pages = answer.read.iter().map(|slip| {
        format!(
            "<p><a href=\"{}\">How the line is right</a></p>",
            escaped(slip.page_link())
        )
    });
    printed.chain([list]).chain(pages).collect()
}

/// Escapes the characters `&`, `<`, `>` and `"` of a text for HTML, between tags and in attributes.
pub fn escaped(text: impl fmt::Display) -> String {
    text.to_string()
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Lays out a row with its label.
fn row(row: &Row, page: HostPage) -> String {
    let said = match row.kind {
        RowKind::ShouldBe | RowKind::Missing if page == HostPage::Book => format!(
            "<details><summary>Show it</summary><code>{}</code></details>",
            escaped(&row.text)
        ),
        kind if kind.is_code() => format!("<code>{}</code>", escaped(&row.text)),
        RowKind::Probe(name) if page == HostPage::CheckPage => format!(
            "{} <button type=\"button\" data-probe=\"{name}\">Judge it here</button>",
            with_code(&row.text)
        ),
        _ => with_code(&row.text),
    };
    item(row.kind.label(), &said)
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
