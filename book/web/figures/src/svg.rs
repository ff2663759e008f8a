//! A writer of SVG: drawings, element by element.

use glam::DVec2;

use crate::number::number;
use crate::text::{SMALL, TEXT, escape, plain, spans};

/// A drawing that is made element by element, and then written as SVG by [`Svg::finish`]: 400 units
/// wide, x to the right, y down, in units of the viewBox.
///
/// The class of an element has two words: the idea that it shows, which gives its color, and the
/// way it is drawn (`line`, `dashed`, `area`, `label` …). The style sheet [`CSS`](crate::CSS)
/// defines both, so the drawing follows the theme of its page.
#[derive(Clone, Debug)]
pub struct Svg {
    name: String,
    title: String,
    description: String,
    height: f64,
    /// The elements so far, as SVG.
    text: String,
}

/// Makes a place on a sheet: x to the right, y down.
pub(crate) const fn spot(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// Moves of a place on a sheet.
pub(crate) trait Shift {
    /// Moves the place to the right.
    fn right(self, by: f64) -> Self;
    /// Moves the place down.
    fn down(self, by: f64) -> Self;
}

impl Shift for DVec2 {
    fn right(self, by: f64) -> Self {
        self + spot(by, 0.0)
    }

    fn down(self, by: f64) -> Self {
        self + spot(0.0, by)
    }
}

/// The place of a label relative to its point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Anchor {
    /// The label begins at the point.
    Start,
    /// The middle of the label is at the point.
    Middle,
    /// The label ends at the point.
    End,
    // Off a dot at the point:
    Above,
    Below,
    Left,
    Right,
    UpperLeft,
    UpperRight,
    LowerRight,
}

impl Anchor {
    /// Returns the vector from the point to the written text, and the SVG `text-anchor` of the
    /// text.
    fn place(self) -> (DVec2, &'static str) {
        let (x, y, end) = match self {
            Self::Start => (0.0, 0.0, ""),
            Self::Middle => (0.0, 0.0, "middle"),
            Self::End => (0.0, 0.0, "end"),
            Self::Above => (0.0, -12.0, "middle"),
            Self::Below => (0.0, 24.0, "middle"),
            Self::Left => (-8.0, 5.0, "end"),
            Self::Right => (8.0, 5.0, ""),
            Self::UpperLeft => (-8.0, -9.0, "end"),
            Self::UpperRight => (8.0, -9.0, ""),
            Self::LowerRight => (8.0, 16.0, ""),
        };
        (spot(x, y), end)
    }
}

impl Svg {
    /// Makes an empty drawing, 400 units wide, so that its labels can be read on a phone. Its ids
    /// begin with `name`, so several drawings can share a page. A reader who cannot see it hears
    /// `title` and `description`.
    pub(crate) fn new(name: &str, title: &str, description: &str, height: f64) -> Self {
        Self {
            name: name.to_owned(),
            title: title.to_owned(),
            description: description.to_owned(),
            height,
            text: String::new(),
        }
    }

    /// Replaces the description by `text`, in the notation of [`crate::text`].
    pub(crate) fn describe(&mut self, text: &str) {
        self.description = plain(text);
    }

    /// Draws a straight line.
    pub(crate) fn line(&mut self, class: &str, from: DVec2, to: DVec2) {
        let ends = [("x1", from.x), ("y1", from.y), ("x2", to.x), ("y2", to.y)];
        self.element("line", class, &ends);
    }

    /// Draws a line through several points; its class may fill the area inside.
    pub(crate) fn path(&mut self, class: &str, points: &[DVec2]) {
        let mut path = String::new();
        for (n, point) in points.iter().enumerate() {
            let step = if n == 0 { "M" } else { "L" };
            path += &format!("{step}{} {}", number(point.x), number(point.y));
        }
        self.text += &format!("<path class=\"{class}\" d=\"{path}\"/>");
    }

    /// Draws a circle; its class may fill the disc.
    pub(crate) fn circle(&mut self, class: &str, center: DVec2, radius: f64) {
        let numbers = [("cx", center.x), ("cy", center.y), ("r", radius)];
        self.element("circle", class, &numbers);
    }

    /// Draws a dot with a label beside it.
    pub(crate) fn dot(&mut self, idea: &str, at: DVec2, anchor: Anchor, name: &str) {
        self.circle(&format!("{idea} solid"), at, 4.5);
        self.label(idea, at, anchor, name);
    }

    /// Draws a rectangle from its upper left corner.
    pub(crate) fn rect(&mut self, class: &str, corner: DVec2, size: DVec2) {
        let [x, y, width, height] = [corner.x, corner.y, size.x, size.y];
        let numbers = [("x", x), ("y", y), ("width", width), ("height", height)];
        self.element("rect", class, &numbers);
    }

    /// Draws a line that ends in an arrow head at `to`.
    pub(crate) fn arrow(&mut self, class: &str, from: DVec2, to: DVec2) {
        let along = (to - from).normalize_or_zero();
        let neck = to - 9.0 * along;
        let side = 4.0 * along.perp();
        self.line(class, from, to - 5.0 * along);
        let idea = class.split(' ').next().unwrap_or_default();
        self.path(&format!("{idea} solid"), &[to, neck + side, neck - side]);
    }

    /// Draws a bold arrow with a label above its middle.
    pub(crate) fn vector(&mut self, idea: &str, from: DVec2, to: DVec2, name: &str) {
        self.arrow(&format!("{idea} bold"), from, to);
        self.label(idea, 0.5 * (from + to), Anchor::Above, name);
    }

    /// Draws the sign of a right angle at `corner`, between the unit vectors `one` and `other`.
    pub(crate) fn right_angle(&mut self, corner: DVec2, one: DVec2, other: DVec2) {
        let points = [one, one + other, other].map(|way| corner + 9.0 * way);
        self.path("faint thin", &points);
    }

    /// Writes a label, in the notation of [`crate::text`].
    pub(crate) fn label(&mut self, idea: &str, at: DVec2, anchor: Anchor, text: &str) {
        self.sized_label(idea, "", at, anchor, text);
    }

    /// Writes a label in smaller letters, in the notation of [`crate::text`].
    pub(crate) fn small_label(&mut self, idea: &str, at: DVec2, anchor: Anchor, text: &str) {
        self.sized_label(idea, &format!(" font-size=\"{SMALL}\""), at, anchor, text);
    }

    fn sized_label(&mut self, idea: &str, size: &str, at: DVec2, anchor: Anchor, text: &str) {
        let (offset, end) = anchor.place();
        let [x, y] = (at + offset).to_array().map(number);
        let anchor = match end {
            "" => String::new(),
            end => format!(" text-anchor=\"{end}\""),
        };
        let text = spans(text);
        self.text += &format!(
            "<text class=\"{idea} label\" x=\"{x}\" y=\"{y}\"{anchor}{size}>{text}</text>"
        );
    }

    /// Writes lines of text below each other, the first one at `at`.
    pub(crate) fn readout(&mut self, at: DVec2, lines: &[String]) {
        for (line, n) in lines.iter().zip(0..) {
            let line_below = at.down(21.0 * f64::from(n));
            self.label("ink", line_below, Anchor::Start, line);
        }
    }

    /// Writes digits of equal width: `stretches` are pairs of a class and the digits that have it.
    pub(crate) fn digits(&mut self, at: DVec2, stretches: &[(&str, &str)]) {
        let [x, y] = at.to_array().map(number);
        self.text += &format!("<text class=\"digits label\" x=\"{x}\" y=\"{y}\">");
        for (class, digits) in stretches.iter().filter(|(_, it)| !it.is_empty()) {
            self.text += &format!("<tspan class=\"{class}\">{digits}</tspan>");
        }
        self.text += "</text>";
    }

    /// Fills a rectangle with a color that is the same in all themes: red, green and blue, 0–255.
    pub(crate) fn pixel(&mut self, corner: DVec2, size: DVec2, [red, green, blue]: [u8; 3]) {
        let [x, y, width, height] = [corner.x, corner.y, size.x, size.y].map(number);
        self.text += &format!(
            "<path fill=\"#{red:02x}{green:02x}{blue:02x}\" d=\"M{x} {y}h{width}v{height}h-{width}z\"/>"
        );
    }

    /// Puts the elements that `draw` draws into a group of that class.
    pub(crate) fn group(&mut self, class: &str, draw: impl FnOnce(&mut Self)) {
        self.text += &format!("<g class=\"{class}\">");
        draw(self);
        self.text += "</g>";
    }

    /// Returns the finished drawing as an `<svg>` element in one line.
    pub fn finish(self) -> String {
        let id = format!("drawing-{}", self.name.replace('_', "-"));
        let [title, description] = [&self.title, &self.description].map(|words| escape(words));
        let height = number(self.height);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"drawing\" \
             viewBox=\"0 0 400 {height}\" role=\"img\" \
             aria-labelledby=\"{id}-title\" aria-describedby=\"{id}-description\" font-size=\"{TEXT}\">\
             <title id=\"{id}-title\">{title}</title>\
             <desc id=\"{id}-description\">{description}</desc>{}</svg>",
            self.text
        )
    }

    /// Writes an element with a class and numbers as attributes.
    fn element(&mut self, name: &str, class: &str, attributes: &[(&str, f64)]) {
        self.text += &format!("<{name} class=\"{class}\"");
        for (attribute, value) in attributes {
            self.text += &format!(" {attribute}=\"{}\"", number(*value));
        }
        self.text += "/>";
    }
}
