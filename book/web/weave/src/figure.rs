//! Figures and charts: SVG inside the page, so that it takes on the page's theme.

use std::path::Path;

use figures::CHARTS;

use crate::controls;
use crate::ground::named;

/// The figure of that name, drawn now, with its caption and with what moves it.
pub(crate) fn figure(name: &str) -> Result<String, String> {
    let figure = named("figure", name, figures::figures(), |figure| figure.name())?;
    Ok(controls::around(figure))
}

/// The chart of that name, drawn now from its files in the folder `notes`, with its
/// caption and a table of the same numbers.
pub(crate) fn chart(notes: &Path, name: &str) -> Result<String, String> {
    let chart = named("chart", name, CHARTS, |chart| chart.name)?;
    let drawn = chart.draw_from(notes)?;
    let figure = on_one_line(&format!(
        "<figure id=\"{name}\"><div class=\"panels\">{}</div><figcaption>{}</figcaption></figure>",
        drawn.panels.concat(),
        chart.caption
    ));
    Ok(format!(
        "{figure}\n\n<details class=\"numbers\"><summary>The numbers of this chart</summary>\n\n{}\n\n</details>",
        drawn.table
    ))
}

/// An empty line would end the HTML in a page of Markdown.
fn on_one_line(html: &str) -> String {
    html.lines().map(str::trim).collect::<Vec<_>>().join(" ")
}
