//! HTML: the parts of an answer in the elements of a page.

use check::answer::{Judged, Part};
use check::blind_spots::Next;
use check::html::{list, read};
use check::reading::{Cause, Reading};
use check::report::escaped;
use check::verdict::Check;
/// The facts in the first line, and the answer below it.
pub(crate) fn answer(judged: &Judged, reading: &Reading) -> String {
    let found = super::shown(judged);
    let first = judged.check.finding().and_then(|it| it.difference.as_ref());
    let (column, row) = first.map_or((0, 0), |it| it.first);
    let facts = [
        judged.check.exit_code().to_string(),
        judged.scene.chapter.name().to_owned(),
        judged.scene.probe.map_or("", |probe| probe.name).to_owned(),
        found.edition.to_string(),
        String::new(),
        format!("{} {} {column} {row}", reading.width, reading.height),
        first.map_or(0, |it| it.count).to_string(),
    ];
    let parts: String = judged.parts().iter().map(part).collect();
    format!("{}\n{}\n{parts}", facts.join("\t"), headline(judged))
}

/// The same where there is nothing to see.
pub(crate) fn refusal(judged: &Judged) -> String {
    let cause = judged.check.cause().map_or("", |cause| cause.name);
    let code = judged.check.exit_code();
    format!("{code}\t\t\t\t{cause}\t\t0\n{}\n", headline(judged))
}

/// Said below a picture that `check` can't read.
pub(crate) fn decoded(cause: &Cause) -> String {
    format!(
        "<p>Your browser has read this file: {}. It was judged as what the browser shows.</p>",
        escaped(&cause.problem)
    )
}

/// On one line: the verdict is announced before the rest is read.
fn headline(judged: &Judged) -> String {
    let said = judged.headline();
    let is_no_picture = matches!(judged.check, Check::NotAPicture { .. });
    let class = match (said.is_right, is_no_picture) {
        // The name `right` is taken: mdBook lets what has it float.
        (true, _) => "is-right",
        (_, true) => "is-none",
        _ => "is-wrong",
    };
    let notes: String = said
        .notes
        .iter()
        .map(|it| format!(" {}", escaped(it)))
        .collect();
    format!(
        "{}<strong class=\"{class}\">{}</strong>{}{notes}",
        escaped(&said.before),
        said.verdict,
        escaped(&said.after),
    )
}

fn part(part: &Part) -> String {
    match part {
        Part::Title(said) => format!("<h3>{}</h3>", escaped(said)),
        Part::Name(name) => format!("<p><code>{}</code></p>", escaped(name)),
        Part::Rows(rows) => list(rows),
        Part::Read(slip) => read(slip),
        Part::Next(it) => next(it),
    }
}

fn next(it: &Next) -> String {
    let probe = it.scene.probe.map_or("", |probe| probe.name);
    format!(
        "<p>{}: {}; and then <code>{}</code> <button type=\"button\" data-probe=\"{probe}\">Judge it here</button></p>",
        escaped(it.why()),
        escaped(it.change()),
        escaped(it.scene.command()),
    )
}
