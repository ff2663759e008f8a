//! Every figure and chart is well made.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use figures::{CSS, FIGURES, standalone, width};
use insta::assert_binary_snapshot;
use roxmltree::{Document, Node};

use crate::charts;
use suite::drawn::shown_in;

#[test]
fn every_figure_is_its_snapshot() {
    for figure in FIGURES {
        shown_in("figures").bind(|| {
            let file = standalone(&(figure.draw)());
            assert_binary_snapshot!(&format!("{}.svg", figure.name), file.into_bytes());
        });
    }
}

#[test]
fn the_style_sheet_has_every_class_that_is_used_and_no_other() {
    let mut used = BTreeSet::from(["paper".to_owned()]);
    for (_, svg) in drawings() {
        for node in parse(svg).descendants() {
            let classes = node.attribute("class").unwrap_or_default();
            used.extend(classes.split_whitespace().map(str::to_owned));
        }
    }
    let defined: BTreeSet<String> = CSS
        .lines()
        .filter(|line| line.starts_with('.'))
        .flat_map(|line| line.split('{').next().unwrap_or_default().split(['.', ' ']))
        .filter(|word| word.starts_with(|first: char| first.is_ascii_lowercase()))
        .map(str::to_owned)
        .collect();
    assert_eq!(used, defined);
}

#[test]
fn no_label_hides_another_or_leaves_the_sheet() {
    let faults: String = drawings()
        .iter()
        .map(|(name, svg)| faults(name, svg))
        .collect();
    assert!(faults.is_empty(), "{faults}");
}

/// The labels of a drawing that meet others, or leave the sheet.
fn faults(name: &str, svg: &str) -> String {
    let mut faults = String::new();
    let drawing = parse(svg);
    let (width, height) = size(&drawing);
    let texts = drawing.descendants().filter(|it| it.has_tag_name("text"));
    let labels: Vec<Label> = texts.map(|text| Label::of(&text)).collect();
    for (n, label) in labels.iter().enumerate() {
        if !label.lies_within(width, height) {
            faults += &format!("{name}: {label:?} leaves the sheet\n");
        }
        for other in labels[n + 1..].iter().filter(|other| label.touches(other)) {
            faults += &format!("{name}: {label:?} meets {other:?}\n");
        }
    }
    faults
}

/// All figures and charts.
fn drawings() -> &'static [(String, String)] {
    static DRAWINGS: LazyLock<Vec<(String, String)>> = LazyLock::new(|| {
        let figures = FIGURES
            .iter()
            .map(|figure| (figure.name.to_owned(), (figure.draw)()));
        figures.chain(charts::of_the_book()).collect()
    });
    &DRAWINGS
}

fn parse(svg: &str) -> Document<'_> {
    Document::parse(svg).unwrap_or_else(|error| panic!("{error}:\n{svg}"))
}

fn size(drawing: &Document) -> (f64, f64) {
    let numbers: Vec<f64> = drawing
        .root_element()
        .attribute("viewBox")
        .expect("a drawing has a size")
        .split(' ')
        .map(|number| number.parse().expect("a number"))
        .collect();
    (numbers[2], numbers[3])
}

/// The number that is an attribute of `node`.
fn f(node: &Node, attribute: &str) -> f64 {
    let value = node
        .attribute(attribute)
        .unwrap_or_else(|| panic!("{node:?} has no {attribute}"));
    value
        .parse()
        .unwrap_or_else(|_| panic!("{attribute} is no number: {value}"))
}

/// The size of the font in an element, or what it has from outside.
fn size_of(node: &Node, outer: f64) -> f64 {
    let has_one = node.has_attribute("font-size");
    if has_one { f(node, "font-size") } else { outer }
}

/// The place that a text takes, in the widest of the usual fonts.
#[derive(Debug)]
struct Label {
    #[expect(dead_code, reason = "it is printed when a test fails")]
    words: String,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

impl Label {
    fn of(text: &Node) -> Self {
        let own = size_of(text, 14.0);
        let pieces = || text.descendants().filter(Node::is_text);
        let words = |piece: &Node| piece.text().unwrap_or_default().to_owned();
        let long = |piece: Node| {
            let parent = piece.parent().expect("text is in an element");
            width(&words(&piece), size_of(&parent, own))
        };
        let long: f64 = pieces().map(long).sum();
        let (x, y) = (f(text, "x"), f(text, "y"));
        let left = match text.attribute("text-anchor") {
            Some("middle") => x - 0.5 * long,
            Some("end") => x - long,
            _ => x,
        };
        Self {
            words: pieces().map(|piece| words(&piece)).collect(),
            left,
            right: left + long,
            top: y - 0.76 * own,
            bottom: y + 0.2 * own,
        }
    }

    fn lies_within(&self, width: f64, height: f64) -> bool {
        self.left >= 0.0 && self.right <= width && self.top >= 0.0 && self.bottom <= height
    }

    fn touches(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }
}
