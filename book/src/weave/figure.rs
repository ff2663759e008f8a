//! Figures and charts: SVG inside the page, so that it takes on the page's theme.

use std::fs;
use std::path::Path;

use figures::FIGURES;

/// The figure of that name, drawn now, with its caption.
pub(super) fn figure(name: &str) -> Result<String, String> {
    let figure = figures::find(name).ok_or_else(|| {
        let names: Vec<&str> = FIGURES.iter().map(|figure| figure.name).collect();
        format!(
            "there is no figure `{name}`: there are {}",
            names.join(", ")
        )
    })?;
    Ok(on_one_line(&format!(
        "<figure id=\"{name}\">{}<figcaption>{}</figcaption></figure>",
        (figure.draw)(),
        figure.caption
    )))
}

/// The chart `NAME.svg` in the folder `charts`, and the table `NAME.md` of the
/// same numbers.
pub(super) fn chart(charts: &Path, name: &str) -> Result<String, String> {
    let read = |extension| {
        let path = charts.join(name).with_extension(extension);
        fs::read_to_string(&path).map_err(|cause| format!("{}: {cause}", path.display()))
    };
    let drawing = on_one_line(&read("svg")?);
    Ok(format!(
        "<figure id=\"{name}\">{drawing}</figure>\n\n{}",
        read("md")?
    ))
}

/// An empty line would end the HTML in a page of Markdown.
fn on_one_line(html: &str) -> String {
    html.lines().map(str::trim).collect::<Vec<_>>().join(" ")
}
