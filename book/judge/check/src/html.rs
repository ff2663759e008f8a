//! The layout of an answer in a page: the elements of the book.

use std::fmt;

use crate::answer::{Answer, Grade, Headline, Row, RowKind};

/// Where an answer is shown as HTML.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HostPage {
    /// In a page of the book, whose other pages can be opened.
    Book,
    /// In the page that judges the picture of a probe, too.
    CheckPage,
    /// In a page alone, as a report is.
    Report,
}

/// Lays out the verdict; its class is the kind.
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

/// Lays out what follows the verdict: what was printed, the rows, what to do next, and pages.
pub fn below(answer: &Answer, page: HostPage) -> String {
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
    let pages = answer.read.iter().filter(|_| page != HostPage::Report);
    let pages = pages.map(|slip| {
        format!(
            "<p><a href=\"{}\">How it is right</a></p>",
            escaped(slip.address())
        )
    });
    printed.chain([list]).chain(pages).collect()
}

/// Returns a text as HTML shows it.
pub fn escaped(text: impl fmt::Display) -> String {
    text.to_string()
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

fn row(row: &Row, page: HostPage) -> String {
    let said = match row.kind {
        kind if kind.is_code() => format!("<code>{}</code>", escaped(&row.text)),
        RowKind::Probe(name) if page == HostPage::CheckPage => format!(
            "{} <button type=\"button\" data-probe=\"{name}\">Judge it here</button>",
            with_code(&row.text)
        ),
        _ => with_code(&row.text),
    };
    item(row.kind.label(), &said)
}

fn item(label: &str, said: &str) -> String {
    format!("<dt>{label}</dt><dd>{said}</dd>")
}

/// Shows what stands between backticks as code.
fn with_code(text: &str) -> String {
    let parts = text.split('`').enumerate();
    let part = |(n, part): (usize, &str)| match n % 2 {
        0 => escaped(part),
        _ => format!("<code>{}</code>", escaped(part)),
    };
    parts.map(part).collect()
}
