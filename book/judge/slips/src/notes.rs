//! A trace of one pixel: what each `let` of a program comes to.

use common::rtweekend::*;
use interpreter::{Note, number};

use crate::program::Output;

/// A label and what it is about.
pub type Row = (String, String);

impl Output {
    /// The numbers of the `n`th pixel, with their names in the chapter, from the viewport to the
    /// levels.
    pub fn traced(&self, n: u32) -> Vec<Row> {
        let mut rows = Vec::new();
        let mut row = |label: &str, it: Vec3| rows.push((label.to_owned(), vector(it)));
        if let Some(ray) = self.ray(n) {
            row("point on the viewport", ray.at(1.0));
            row("origin", ray.origin);
            row("direction", ray.direction);
        }
        rows.extend(numbered(self.notes(n).into_iter()));
        if let Some(color) = self.color(n) {
            rows.push(("color".into(), vector(color)));
        }
        let [r, g, b] = self.pixel(n);
        rows.push(("levels".into(), format!("{r} {g} {b}")));
        rows
    }
}

/// The numbers of a trace by their names in the chapter. What comes again has a number of its
/// own, as with the second sphere.
fn numbered(notes: impl Iterator<Item = Note>) -> impl Iterator<Item = Row> {
    let mut rows: Vec<Row> = Vec::new();
    for (function, name, said) in notes {
        let is_of_the_way = ["Camera::new", "Camera::with_size"].contains(&function.as_str());
        if is_of_the_way || name == "return" {
            continue;
        }
        let again = |row: &&Row| row.0 == name || row.0.starts_with(&format!("{name}, again"));
        let label = match rows.iter().filter(again).count() {
            0 => name,
            1 => format!("{name}, again"),
            n => format!("{name}, again {n}"),
        };
        rows.push((label, said));
    }
    rows.into_iter()
}

/// Lines with tabs: a label of the first, and what each has for it.
pub fn side_by_side(all: &[Vec<Row>]) -> String {
    let [first, others @ ..] = all else {
        return String::new();
    };
    let said = |rows: &Vec<Row>, label: &str| {
        let row = rows.iter().find(|(other, _)| other == label);
        row.map_or("none".to_owned(), |(_, said)| said.clone())
    };
    let more = others.iter().flatten();
    let more = more.filter(|(label, _)| first.iter().all(|(other, _)| other != label));
    let labels = first.iter().chain(more).map(|(label, _)| label);
    let line = |label: &String| {
        let columns = all.iter().map(|rows| said(rows, label));
        let columns: Vec<String> = columns.collect();
        format!("{label}\t{}", columns.join("\t"))
    };
    labels.map(line).collect::<Vec<_>>().join("\n")
}

fn vector(of: Vec3) -> String {
    let [x, y, z] = of.to_array().map(number);
    format!("({x}, {y}, {z})")
}
