//! HTML: the parts of an answer in the elements of a page.

use check::answer::{Judged, Part};
use check::blind_spots::Next;
use check::html::{list, read};
use check::reading::{Cause, Reading};
use check::report::escaped;
use check::verdict::Check;
use check::whole::{Line, Verdict};
use slips::Letters;

/// The facts that the script asks for in the first line, the verdict in the second, since it
/// is announced before the rest is read, and the parts below.
pub(crate) fn answer(judged: &Judged, reading: Option<&Reading>) -> String {
    let difference = judged.check.finding().and_then(|it| it.difference.as_ref());
    let (column, row) = difference.map_or((0, 0), |it| it.first);
    let facts = [
        reading.map_or("", |_| judged.scene.chapter.name()),
        reading.map_or("", |_| judged.scene.probe.map_or("", |probe| probe.name)),
        judged.check.cause().map_or("", |cause| cause.name),
        &reading.map_or(String::new(), |it| {
            format!("{} {} {column} {row}", it.width, it.height)
        }),
        &difference.map_or(0, |it| it.count).to_string(),
    ];
    let parts: String = judged
        .parts()
        .iter()
        .map(|it| part(it, judged.known.letters))
        .collect();
    format!("{}\n{}\n{parts}", facts.join("\t"), headline(judged))
}

/// Said below a picture that `check` can't read.
pub(crate) fn foreign(cause: Cause) -> String {
    format!(
        "<p>Your browser has read this file: {}. It was judged as what the browser shows.</p>",
        escaped(&cause.problem)
    )
}

fn headline(judged: &Judged) -> String {
    let said = judged.headline();
    let class = if said.is_right {
        RIGHT
    } else if matches!(judged.check, Check::NotAPicture { .. }) {
        "is-none"
    } else {
        WRONG
    };
    let notes = said.notes.iter().map(|it| format!(" {}", escaped(it)));
    format!(
        "{}<strong class=\"{class}\">{}</strong>{}{}",
        escaped(&said.before),
        said.verdict,
        escaped(&said.after),
        notes.collect::<String>(),
    )
}

// The name `right` is taken: mdBook lets what has it float.
const RIGHT: &str = "is-right";
const WRONG: &str = "is-wrong";

fn part(part: &Part, letters: Option<Letters>) -> String {
    match part {
        Part::Next(it) => next(it, letters),
        other => check::html::part(other),
    }
}

fn next(it: &Next, letters: Option<Letters>) -> String {
    let probe = it.scene.probe.map_or("", |probe| probe.name);
    format!(
        "<p>{}: {}; and then <code>{}</code> <button type=\"button\" data-probe=\"{probe}\">Judge it here</button></p>",
        escaped(it.why()),
        escaped(it.change(letters)),
        escaped(it.scene.command()),
    )
}

/// The headline of a verdict on a text.
pub(crate) fn typed_headline(verdict: &Verdict) -> String {
    let said = escaped(&verdict.headline);
    if verdict.is_right {
        let unchecked = interpreter::UNCHECKED;
        format!("<strong class=\"{RIGHT}\">{said}</strong> {unchecked}")
    } else {
        format!("<strong class=\"{WRONG}\">{said}</strong>")
    }
}

/// What is below it: as a compiler prints it, in rows, and pages to read.
pub(crate) fn typed_rest(verdict: &Verdict) -> String {
    let mut printed = String::new();
    let mut rows: Vec<(&str, &str)> = Vec::new();
    for line in &verdict.cause {
        match line {
            Line::Labeled(label, text) => rows.push((label, text)),
            Line::Printed(text) => {
                printed += &format!("<p class=\"printed\">{}</p>", escaped(text));
            }
        }
    }
    if !verdict.next.is_empty() {
        rows.push(("next", &verdict.next));
    }
    let pages: String = verdict.read.iter().map(|slip| read(slip)).collect();
    printed + &with_code(&list(&rows)) + &pages
}

/// What stands between backticks is code.
fn with_code(html: &str) -> String {
    let parts = html.split('`').enumerate();
    parts
        .map(|(n, part)| match n % 2 {
            0 => part.to_owned(),
            _ => format!("<code>{part}</code>"),
        })
        .collect()
}
