//! Figures and charts: SVG inside the page, so that it takes on the page's theme.

use std::path::Path;

use figures::{CHARTS, Chart};

use crate::controls;
use crate::ground::named;

/// Draws the figure `name`; returns it with its caption, handles, inputs and buttons. `number` says
/// which of its questions it asks, from 1, which is also meant by an empty text.
///
/// # Errors
/// If there is no such figure, or no such question.
pub(crate) fn figure(name: &str, number: &str) -> Result<String, String> {
    let figure = named("figure", name, figures::figures(), |figure| figure.name())?;
    let questions = &figure.figure().questions;
    let number = if number.is_empty() { "1" } else { number };
    let place = number.parse::<usize>().unwrap_or(0).checked_sub(1);
    let question = place.and_then(|place| questions.get(place));
    let question = question.ok_or_else(|| format!("{name} has no question {number}"))?;
    Ok(controls::around(figure, question))
}

/// Draws the chart `name` from its files in the folder `notes`; returns it with its caption and a
/// table of its numbers.
///
/// # Errors
/// If there is no such chart, or one of its files is missing or wrong.
pub(crate) fn chart(notes: &Path, name: &str) -> Result<String, String> {
    let chart = named("chart", name, CHARTS, |chart| chart.name)?;
    let drawn = chart.draw_from(notes)?;
    let figure = on_one_line(&format!(
        "<figure id=\"{name}\">{}<div class=\"panels\">{}</div><figcaption>{}</figcaption></figure>",
        choice(chart),
        drawn.panels.concat(),
        chart.caption
    ));
    Ok(format!(
        "{figure}\n\n<details class=\"numbers\"><summary>The numbers of this chart</summary>\n\n{}\n\n</details>",
        drawn.table
    ))
}

/// Returns radio buttons for the panels of a chart, of which the style sheet shows one; nothing if
/// the page shows all.
fn choice(chart: &Chart) -> String {
    let button = |(n, words): (usize, &&str)| {
        let checked = if n == 0 { " checked" } else { "" };
        let name = chart.name;
        format!("<label><input type=\"radio\" name=\"{name}\"{checked}> {words}</label>")
    };
    let buttons: String = chart.choices.iter().enumerate().map(button).collect();
    match chart.choices {
        [] => buttons,
        _ => format!("<fieldset class=\"choice\" aria-label=\"Digits\">{buttons}</fieldset>"),
    }
}

/// Puts HTML on one line: an empty line would end it in a page of Markdown.
fn on_one_line(html: &str) -> String {
    html.lines().map(str::trim).collect::<Vec<_>>().join(" ")
}
