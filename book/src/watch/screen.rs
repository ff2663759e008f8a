//! One screen: both pictures small, the verdict, its cause, and what is next.

use std::io::{IsTerminal, stdout};
use std::iter;
use std::time::Duration;

use common::engine::output;
use jiff::Zoned;

use super::verdict::{Line, Verdict};
use crate::check::Style;
use crate::terminal::{self, Palette};

/// No more lines than this, whatever there is to say.
const MOST_LINES: usize = 25;

/// How large each picture is, in characters.
const PICTURE: (u32, u32) = (32, 9);

/// The screen as text; on a terminal it replaces the one before.
pub(super) fn compose(title: &str, verdict: &Verdict, news: &[String], took: Duration) -> String {
    let style = Style::of_stdout();
    let now = Zoned::now().strftime("%H:%M:%S").to_string();
    let mut lines = vec![format!(
        "{}  {}",
        style.bold(title),
        style.dim(&format!(
            "saved {now}, judged in {:.1} s",
            took.as_secs_f64()
        ))
    )];
    lines.extend(pictures(verdict));
    let headline = textwrap::wrap(&verdict.headline, terminal::text_width());
    lines.extend(headline.iter().map(|line| colored(line, verdict, style)));
    let mut below: Vec<String> = Vec::new();
    if !verdict.next.is_empty() {
        below.extend(wrapped("next", &verdict.next));
    }
    below.extend(news.iter().map(|thing| labeled("done", thing)));
    let room = MOST_LINES.saturating_sub(lines.len() + below.len());
    let mut cause: Vec<String> = verdict.cause.iter().flat_map(shown).collect();
    if cause.len() > room {
        cause.truncate(room.saturating_sub(1));
        cause.push("…".to_owned());
    }
    lines.extend(cause);
    lines.extend(below);
    lines.truncate(MOST_LINES);
    let clear = match stdout().is_terminal() {
        true => "\x1b[2J\x1b[H",
        false => "",
    };
    format!("{clear}{}\n", lines.join("\n"))
}

fn colored(line: &str, verdict: &Verdict, style: Style) -> String {
    match verdict.is_right {
        true => style.green(line),
        false => style.bold(line),
    }
}

/// Yours at the left, and at the right what it should be.
fn pictures(verdict: &Verdict) -> Vec<String> {
    let (Some(palette), Some((yours, right))) = (Palette::of_stdout(), &verdict.pictures) else {
        return Vec::new();
    };
    let (columns, rows) = PICTURE;
    let [yours, right] = [yours, right].map(|it| terminal::lines(it, palette, columns, 2 * rows));
    let both = yours.iter().zip(&right);
    let mut lines: Vec<String> = both
        .map(|(yours, right)| format!("{yours}  {right}"))
        .collect();
    let label = format!("{:<34}{}", "yours", "what it should be");
    lines.push(label);
    lines
}

fn shown(line: &Line) -> Vec<String> {
    match line {
        Line::Labeled(label, text) => wrapped(label, text),
        Line::Printed(line) => vec![line.clone()],
    }
}

/// The text in as many lines as it takes, with the label before the first.
fn wrapped(label: &str, text: &str) -> Vec<String> {
    let lines = textwrap::wrap(text, terminal::text_width() - labeled("", "").len()).into_iter();
    let labels = iter::once(label).chain(iter::repeat(""));
    labels
        .zip(lines)
        .map(|(label, line)| labeled(label, &line))
        .collect()
}

fn labeled(label: &str, text: &str) -> String {
    format!("{label:<9}  {}", output::visible(text))
}
