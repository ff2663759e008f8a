//! Every figure and chart is well made.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use common::rtweekend::*;
use figures::{CSS, FIGURES, find_live, standalone};
use insta::assert_binary_snapshot;
use roxmltree::{Document, Node};

use crate::charts;
use suite::drawn::shown_in;

#[test]
fn every_figure_is_its_snapshot() {
    println!("If you meant to change it: INSTA_UPDATE=always cargo test figure_is_its_snapshot");
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

#[test]
fn the_labels_of_the_grid_have_room_at_every_width_and_at_its_edges() {
    let live = find_live("viewport_grid").expect("a live figure");
    let mut all = String::new();
    for width in 1..=40 {
        let height = Camera::new(width).image_height;
        for i in [0, 1, width / 2, width - 1] {
            for (j, first) in [0, 1, height / 2, height - 1]
                .map(|j| [(j, 0), (j, 1)])
                .as_flattened()
            {
                let mut numbers = [width, i, *j, *first].map(f64::from);
                live.confine(&mut numbers);
                let svg = live.answer(&numbers).drawing.finish();
                all += &faults(&format!("{numbers:?}"), &svg);
            }
        }
    }
    assert!(all.is_empty(), "{all}");
}

#[test]
fn no_leader_of_a_chart_goes_through_the_label_of_another() {
    for (name, svg) in charts::of_the_book() {
        let drawing = parse(&svg);
        let labels: Vec<Label> = texts(&drawing).map(|text| Label::of(&text)).collect();
        let lines = drawing.descendants().filter(|it| it.has_tag_name("line"));
        for line in lines.filter(|it| it.attribute("class") == Some("faint thin")) {
            let [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map(|it| f(&line, it));
            let at = |n: i32| f64::from(n) / 50.0;
            let strikes = |label: &Label| {
                (0..50).any(|n| label.holds(x1 + at(n) * (x2 - x1), y1 + at(n) * (y2 - y1), -1.0))
            };
            // Its own label begins where it ends.
            let others = labels.iter().filter(|label| !label.holds(x2, y2, 3.0));
            let struck: Vec<&Label> = others.filter(|label| strikes(label)).collect();
            assert!(struck.is_empty(), "{name}: {struck:?}");
        }
    }
}

/// The labels of a drawing that meet others, or leave the sheet.
fn faults(name: &str, svg: &str) -> String {
    let mut faults = String::new();
    let drawing = parse(svg);
    let (width, height) = size(&drawing);
    let labels: Vec<Label> = texts(&drawing).map(|text| Label::of(&text)).collect();
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

fn texts<'a>(drawing: &'a Document) -> impl Iterator<Item = Node<'a, 'a>> {
    drawing
        .descendants()
        .filter(|node| node.has_tag_name("text"))
}

fn words(text: &Node) -> String {
    text.descendants()
        .filter_map(|node| node.is_text().then(|| node.text()).flatten())
        .collect()
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
        let size = |node: &Node| {
            node.has_attribute("font-size")
                .then(|| f(node, "font-size"))
        };
        let own = size(text).unwrap_or(14.0);
        let width: f64 = text
            .descendants()
            .filter(Node::is_text)
            .map(|piece| {
                let parent = piece.parent().expect("text is in an element");
                let size = size(&parent).unwrap_or(own);
                size * piece
                    .text()
                    .unwrap_or_default()
                    .chars()
                    .map(advance)
                    .sum::<f64>()
            })
            .sum();
        let (x, y) = (f(text, "x"), f(text, "y"));
        let left = match text.attribute("text-anchor") {
            Some("middle") => x - 0.5 * width,
            Some("end") => x - width,
            _ => x,
        };
        Self {
            words: words(text),
            left,
            right: left + width,
            top: y - 0.76 * own,
            bottom: y + 0.2 * own,
        }
    }

    fn lies_within(&self, width: f64, height: f64) -> bool {
        self.left >= 0.0 && self.right <= width && self.top >= 0.0 && self.bottom <= height
    }

    /// Whether the point lies in it, or so far outside.
    fn holds(&self, x: f64, y: f64, outside: f64) -> bool {
        (self.left - outside..self.right + outside).contains(&x)
            && (self.top - outside..self.bottom + outside).contains(&y)
    }

    fn touches(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }
}

/// How wide a letter is, in sizes of the font: as in DejaVu Sans, rounded up.
fn advance(letter: char) -> f64 {
    match letter {
        'i' | 'j' | 'l' | ' ' | ',' | '.' | ':' | '|' => 0.34,
        'f' | 't' | 'r' | '(' | ')' | '-' | '·' => 0.42,
        'm' | 'w' | 'M' | 'W' | '−' | '<' | '>' | '=' | '+' | '×' | '∞' => 0.86,
        'A'..='Z' | 'Δ' => 0.74,
        _ => 0.64,
    }
}
