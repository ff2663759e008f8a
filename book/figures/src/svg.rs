//! A drawing in SVG, written element by element.

use std::fmt::Write;

use glam::DVec2;

use crate::number::number;

/// A drawing while it is made: x to the right, y down, in units of the viewBox.
///
/// An element has a class of two words: the idea that it shows, which gives its
/// color, and how it shows it (`line`, `dashed`, `area`, `label` …). Both are
/// defined in the style sheet, so the drawing follows the theme of its page.
#[derive(Clone, Debug)]
pub struct Svg {
    class: &'static str,
    name: String,
    title: String,
    description: String,
    size: DVec2,
    /// The elements so far.
    text: String,
}

/// Where a label stands relative to its point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Anchor {
    /// The point is at its left end.
    Start,
    /// The point is below its middle.
    Middle,
    /// The point is at its right end.
    End,
}

/// The size of a label, in units of the viewBox.
pub(crate) const TEXT: f64 = 14.0;

/// The size of a less important label.
pub(crate) const SMALL: f64 = 12.0;

/// The size of a subscript.
const SUBSCRIPT: f64 = 11.0;

impl Svg {
    /// An empty drawing of a class that the style sheet knows. Its ids begin with `name`, so
    /// several drawings can share a page; a reader who cannot see it is told `title` and
    /// `description`.
    pub(crate) fn new(
        class: &'static str,
        name: &str,
        title: &str,
        description: &str,
        size: DVec2,
    ) -> Self {
        Self {
            class,
            name: name.to_owned(),
            title: title.to_owned(),
            description: description.to_owned(),
            size,
            text: String::new(),
        }
    }

    /// Replaces the description; in `text`, `*t*` is a number, `**P**` a vector.
    pub(crate) fn describe(&mut self, text: &str) {
        self.description = styled(text).map(|(piece, _)| piece).collect();
    }

    /// A straight line.
    pub(crate) fn line(&mut self, class: &str, from: DVec2, to: DVec2) {
        self.element(
            "line",
            class,
            &[("x1", from.x), ("y1", from.y), ("x2", to.x), ("y2", to.y)],
        );
    }

    /// A line through several points; filled, if the class says so.
    pub(crate) fn path(&mut self, class: &str, points: &[DVec2]) {
        let mut path = String::new();
        for (point, step) in points.iter().zip("ML".chars().chain("L".chars().cycle())) {
            let _ = write!(path, "{step}{} {}", number(point.x), number(point.y));
        }
        let _ = write!(self.text, "<path class=\"{class}\" d=\"{path}\"/>");
    }

    /// A disc at each of these points, all in one path: the round ends of lines of no length.
    pub(crate) fn dots(&mut self, idea: &str, points: impl Iterator<Item = DVec2>, diameter: f64) {
        let mut path = String::new();
        for point in points {
            let _ = write!(path, "M{} {}h0", number(point.x), number(point.y));
        }
        let diameter = number(diameter);
        let _ = write!(
            self.text,
            "<path class=\"{idea}\" fill=\"none\" stroke=\"currentColor\" \
             stroke-linecap=\"round\" stroke-width=\"{diameter}\" d=\"{path}\"/>"
        );
    }

    /// A circle, or where the class fills it, a disc.
    pub(crate) fn circle(&mut self, class: &str, center: DVec2, radius: f64) {
        self.element(
            "circle",
            class,
            &[("cx", center.x), ("cy", center.y), ("r", radius)],
        );
    }

    /// A rectangle from its upper left corner.
    pub(crate) fn rect(&mut self, class: &str, corner: DVec2, size: DVec2) {
        self.element(
            "rect",
            class,
            &[
                ("x", corner.x),
                ("y", corner.y),
                ("width", size.x),
                ("height", size.y),
            ],
        );
    }

    /// A line that ends in an arrow head at `to`.
    pub(crate) fn arrow(&mut self, class: &str, from: DVec2, to: DVec2) {
        let along = (to - from).normalize_or_zero();
        let neck = to - 9.0 * along;
        let side = 4.0 * along.perp();
        self.line(class, from, to - 5.0 * along);
        let idea = class.split(' ').next().unwrap_or_default();
        self.path(&format!("{idea} solid"), &[to, neck + side, neck - side]);
    }

    /// A label. In `text`, `*t*` is italic, `**P**` a vector, and `_{00}` a subscript.
    pub(crate) fn label(&mut self, idea: &str, at: DVec2, anchor: Anchor, text: &str) {
        self.sized_label(idea, TEXT, at, anchor, text);
    }

    /// A smaller label.
    pub(crate) fn small_label(&mut self, idea: &str, at: DVec2, anchor: Anchor, text: &str) {
        self.sized_label(idea, SMALL, at, anchor, text);
    }

    fn sized_label(&mut self, idea: &str, size: f64, at: DVec2, anchor: Anchor, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let size = match size {
            TEXT => String::new(),
            other => format!(" font-size=\"{other}\""),
        };
        let _ = write!(
            self.text,
            "<text class=\"{idea} label\" x=\"{}\" y=\"{}\"{anchor}{size}>{}</text>",
            number(at.x),
            number(at.y),
            spans(text)
        );
    }

    /// A small label without a halo, for a colored ground.
    pub(crate) fn bare_label(&mut self, idea: &str, at: DVec2, anchor: Anchor, text: &str) {
        self.group("bare", |svg| svg.small_label(idea, at, anchor, text));
    }

    /// The digits of a decimal number, each span of a class; after the first one a point.
    pub(crate) fn digits(&mut self, at: DVec2, spans: &[(&str, &str)]) {
        let [x, y] = [at.x, at.y].map(number);
        let _ = write!(
            self.text,
            "<text class=\"digits label\" x=\"{x}\" y=\"{y}\">"
        );
        let mut is_first = true;
        for (class, digits) in spans.iter().filter(|(_, digits)| !digits.is_empty()) {
            let (first, rest) = digits.split_at(usize::from(is_first));
            let point = if is_first { "." } else { "" };
            let _ = write!(
                self.text,
                "<tspan class=\"{class}\">{first}{point}{rest}</tspan>"
            );
            is_first = false;
        }
        self.text += "</text>";
    }

    /// Those cells that are set, of a square grid with so many `columns`.
    pub(crate) fn cells(
        &mut self,
        class: &str,
        corner: DVec2,
        side: f64,
        columns: usize,
        cells: &[bool],
    ) {
        let mut path = String::new();
        for (row, j) in cells.chunks(columns).zip(0..) {
            let mut i = 0;
            for equal in row.chunk_by(|one, other| one == other) {
                if equal[0] {
                    let at = corner + side * DVec2::new(f64::from(i), f64::from(j));
                    let [x, y, side, run] =
                        [at.x, at.y, side, side * equal.len() as f64].map(number);
                    let _ = write!(path, "M{x} {y}h{run}v{side}h-{run}z");
                }
                i += equal.len() as i32;
            }
        }
        let _ = write!(self.text, "<path class=\"{class}\" d=\"{path}\"/>");
    }

    /// A rectangle whose color is what it is about, so no theme changes it.
    pub(crate) fn pixel(&mut self, corner: DVec2, size: DVec2, rgb: [u8; 3]) {
        let [red, green, blue] = rgb;
        let fill = format!("#{red:02x}{green:02x}{blue:02x}");
        let [x, y, width, height] = [corner.x, corner.y, size.x, size.y].map(number);
        let _ = write!(
            self.text,
            "<path fill=\"{fill}\" d=\"M{x} {y}h{width}v{height}h-{width}z\"/>"
        );
    }

    /// What `draw` draws, as a group of that class.
    pub(crate) fn group(&mut self, class: &str, draw: impl FnOnce(&mut Self)) {
        let _ = write!(self.text, "<g class=\"{class}\">");
        draw(self);
        self.text += "</g>";
    }

    /// The finished drawing as an `<svg>` element in one line, which a page can take in.
    pub fn finish(self) -> String {
        let id = format!("drawing-{}", self.name.replace('_', "-"));
        let [title, description] = [&self.title, &self.description].map(|words| escape(words));
        let [width, height] = self.size.to_array().map(number);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"{}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\" \
             aria-labelledby=\"{id}-title\" aria-describedby=\"{id}-description\" font-size=\"{TEXT}\">\
             <title id=\"{id}-title\">{title}</title>\
             <desc id=\"{id}-description\">{description}</desc>{}</svg>",
            self.class, self.text
        )
    }

    fn element(&mut self, name: &str, class: &str, attributes: &[(&str, f64)]) {
        let _ = write!(self.text, "<{name} class=\"{class}\"");
        for (attribute, value) in attributes {
            let _ = write!(self.text, " {attribute}=\"{}\"", number(*value));
        }
        self.text += "/>";
    }
}

/// How wide a label is at most, in the usual fonts.
pub(crate) fn width(label: &str, size: f64) -> f64 {
    let advance = |letter: char| match letter {
        '*' => 0.0,
        'i' | 'j' | 'l' | ' ' | ',' | '.' | ':' => 0.36,
        'f' | 't' | 'r' | '(' | ')' | '-' => 0.44,
        'm' | 'w' | 'M' | 'W' | '−' | '<' | '>' | '=' | '%' | '÷' => 0.96,
        'A'..='Z' => 0.76,
        _ => 0.65,
    };
    size * label.chars().map(advance).sum::<f64>()
}

/// Text that means itself in XML.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// The spans of a label, from the notation of [`Svg::label`].
fn spans(label: &str) -> String {
    let mut spans = String::new();
    let mut lowered = false;
    for (part, style) in styled(label) {
        for piece in part.split_inclusive('}') {
            let (level, low) = match piece.split_once("_{") {
                Some((level, low)) => (level, low.trim_end_matches('}')),
                None => (piece, ""),
            };
            for (text, low) in [(level, false), (low, true)] {
                if !text.is_empty() {
                    spans += &span(text, style, lowered, low);
                    lowered = low;
                }
            }
        }
    }
    spans
}

/// How a letter of a formula looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Style {
    /// A word or a digit.
    Plain,
    /// A number, `*t*`.
    Italic,
    /// A vector, `**P**`.
    Vector,
}

/// The stretches of a text with `*` and `**`.
pub(crate) fn styled(text: &str) -> impl Iterator<Item = (&str, Style)> {
    let outer = [None, Some(Style::Vector)].into_iter().cycle();
    text.split("**").zip(outer).flat_map(|(part, vector)| {
        let inner = [Style::Plain, Style::Italic].into_iter().cycle();
        part.split('*')
            .zip(inner)
            .map(move |(text, style)| (text, vector.unwrap_or(style)))
            .filter(|(text, _)| !text.is_empty())
    })
}

/// A stretch of a label; `lowered` says whether the one before it stood low.
fn span(text: &str, style: Style, lowered: bool, low: bool) -> String {
    let style = match style {
        Style::Plain => "",
        Style::Italic => " class=\"italic\"",
        Style::Vector => " class=\"vector\"",
    };
    let shift = match (lowered, low) {
        (false, true) => " dy=\"4\"",
        (true, false) => " dy=\"-4\"",
        _ => "",
    };
    let size = match low {
        true => format!(" font-size=\"{SUBSCRIPT}\""),
        false => String::new(),
    };
    let text = escape(text);
    match (style, shift, &size[..]) {
        ("", "", "") => text,
        _ => format!("<tspan{style}{shift}{size}>{text}</tspan>"),
    }
}
