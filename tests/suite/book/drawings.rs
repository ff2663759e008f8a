//! Golden drawings: every figure and every chart is its snapshot, and a chart is whole. Whether the
//! labels of figures hide each other is seen in `tests/browser`.

use std::fs;
use std::path::Path;

use figures::records::{Accuracy, Timing, WrongPixels};
use figures::table::{Record, Table};
use figures::{
    ADVICE, CHARTS, DrawnChart, Spot, figures, least, panel_with_key, scenes_table, standalone,
};
use fixtures::drawn::shown_in;
use insta::assert_binary_snapshot;
use scraper::{ElementRef, Html, Selector};
use speed_vs_accuracy::{METHODS, Precision, REGIMES};

use crate::book::whole::NOTES;

#[test]
fn every_figure_is_its_snapshot() {
    for figure in figures() {
        shown_in("figures").bind(|| {
            let drawing = figure.answer(&figure.defaults()).drawing;
            let file = standalone(&drawing.finish());
            assert_binary_snapshot!(&format!("{}.svg", figure.name()), file.into_bytes());
        });
    }
}

#[test]
fn every_chart_is_its_snapshot() {
    for chart in CHARTS {
        let drawn = chart.draw_from(Path::new(NOTES)).expect("its numbers");
        shown_in("charts").bind(|| {
            let name = chart.name;
            for (panel, n) in drawn.panels.iter().zip(1..) {
                let file = standalone(panel).into_bytes();
                assert_binary_snapshot!(&format!("{name}_{n}.svg"), file);
            }
            assert_binary_snapshot!(&format!("{name}_table.md"), drawn.table.into_bytes());
        });
    }
}

/// In each scene a method is marked in `f64` and one in `f32`, where one draws every pixel right.
#[test]
fn the_table_of_scenes_is_its_snapshot() {
    let [scenes, timings] = [WrongPixels::FILE, Timing::FILE].map(text);
    let table = scenes_table(&scenes, &timings).expect("its numbers");
    assert_eq!(table.lines().count(), 2 + METHODS.len());
    assert_eq!(table.matches('★').count(), 6 + 4);
    shown_in("charts").bind(|| assert_binary_snapshot!("scenes_table.md", table.into_bytes()));
}

/// The README shows the far sphere.
#[test]
fn the_chart_of_the_readme_is_its_snapshot() {
    let files = [Accuracy::FILE, Timing::FILE].map(text);
    let panel = panel_with_key(1, files.each_ref().map(|file| &file[..])).expect("its numbers");
    shown_in("charts").bind(|| {
        let file = standalone(&panel).into_bytes();
        assert_binary_snapshot!("speed_accuracy_readme.svg", file);
    });
}

#[test]
fn every_table_has_a_row_for_each_and_a_cell_for_each() {
    let spots = Precision::ALL.map(|precision| Spot::all(precision).count());
    for (name, rows, columns) in [
        ("speed_accuracy", REGIMES.len() * METHODS.len(), 8),
        ("map", spots.iter().sum(), 6),
    ] {
        let table = drawn(name).table;
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines.len(), 2 + rows, "rows of {name}");
        for line in lines {
            assert_eq!(line.matches('|').count(), 1 + columns, "{name}: {line}");
        }
    }
}

#[test]
fn every_chart_has_a_mark_for_each() {
    let [map, speed] = ["map", "speed_accuracy"].map(|name| drawn(name).panels);
    let spots: usize = Precision::ALL.map(|it| Spot::all(it).count()).iter().sum();
    for panel in map {
        // And one for each method and for none, in the two keys.
        assert_eq!(count(&panel, "rect"), spots + 9);
    }
    for panel in &speed[1..] {
        for method in METHODS
            .iter()
            .filter(|method| !["exact", "double_double"].contains(&method.name))
        {
            let is_it = |words: &String| words.split(' ').next() == Some(method.name);
            assert_eq!(
                words(panel).iter().filter(|it| is_it(it)).count(),
                1,
                "{}",
                method.name
            );
        }
        assert_eq!(
            count(panel, "circle.certain.line"),
            2,
            "rings, one of them before the advice"
        );
    }
}

/// The page advises what the table marks, or what decides rightly in all of a million.
#[test]
fn what_a_situation_is_advised_its_records_say() {
    let cells = table::<WrongPixels>().rows;
    let (accuracy, timings) = (table::<Accuracy>(), table::<Timing>());
    let page = text("speed_vs_accuracy.md");
    for (regime, [advised, condition]) in REGIMES.iter().zip(ADVICE) {
        let marked = least(regime.name, Precision::Double, &cells, &timings).expect("one is right");
        let decides = timings.quickest(Precision::Double, regime.name, |method| {
            let is_it = |row: &&Accuracy| row.regime == regime.name && row.method == method.name;
            accuracy
                .rows
                .iter()
                .find(is_it)
                .is_some_and(|row| row.wrong_per_million == 0.0)
        });
        let decides = decides.expect("one is right");
        assert!(
            [marked.name, decides.name].contains(&advised),
            "{}: {advised}",
            regime.name
        );
        let on_condition = marked.name != decides.name;
        assert!(!on_condition || !condition.is_empty(), "{}", regime.name);
        let row = page
            .lines()
            .find(|line| line.starts_with(&format!("| *{}*", regime.name)));
        let row = row.unwrap_or_else(|| panic!("What to take has no {}", regime.name));
        for name in [marked.name, decides.name] {
            assert!(row.contains(&format!("`{name}`")), "{name}: {row}");
        }
    }
}

/// No name of the chart of speed against accuracy touches another name, a mark's whisker or the
/// front.
#[test]
fn no_name_crosses_another_or_a_line() {
    for panel in &drawn("speed_accuracy").panels[1..] {
        let names = boxes(panel, "text.label", |it| {
            let [x, y] = ["x", "y"].map(|name| attribute(it, name));
            // What a letter takes in the widest of the fonts of the pages, on average.
            let wide = 6.6 * it.text().collect::<String>().chars().count() as f64;
            let left = match it.attr("text-anchor") {
                Some("end") => x - wide,
                Some(_) => x - 0.5 * wide,
                None => x,
            };
            vec![[left, y - 9.0, left + wide, y + 2.0]]
        });
        let lines = boxes(panel, "line:not(.grid)", |it| {
            let [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map(|name| attribute(it, name));
            vec![[x1.min(x2), y1.min(y2), x1.max(x2), y1.max(y2)]]
        });
        let front = boxes(panel, "path.front", |it| {
            let path = it.attr("d").unwrap_or_default();
            let points: Vec<Vec<f64>> = path
                .split(['M', 'L'])
                .skip(1)
                .map(|point| {
                    point
                        .split(' ')
                        .map(|it| it.parse().expect("a number"))
                        .collect()
                })
                .collect();
            let box_of = |ends: &[Vec<f64>]| {
                let [one, other] = [&ends[0], &ends[1]];
                let [least, most] =
                    [f64::min, f64::max].map(|of| [0, 1].map(|n| of(one[n], other[n])));
                [least[0], least[1], most[0], most[1]]
            };
            points.windows(2).map(box_of).collect()
        });
        for (n, name) in names.iter().enumerate() {
            for other in names[n + 1..].iter().chain(&lines).chain(&front) {
                let apart = name[2] < other[0]
                    || other[2] < name[0]
                    || name[3] < other[1]
                    || other[3] < name[1];
                assert!(apart, "{name:?} and {other:?} in {panel}");
            }
        }
    }
}

fn boxes(
    panel: &str,
    what: &str,
    boxes: impl Fn(ElementRef<'_>) -> Vec<[f64; 4]>,
) -> Vec<[f64; 4]> {
    let fragment = Html::parse_fragment(panel);
    let selector = Selector::parse(what).expect("a selector");
    fragment.select(&selector).flat_map(boxes).collect()
}

fn attribute(element: ElementRef<'_>, name: &str) -> f64 {
    let value = element.attr(name).and_then(|value| value.parse().ok());
    value.unwrap_or_else(|| panic!("no {name}"))
}

fn count(panel: &str, what: &str) -> usize {
    let selector = Selector::parse(what).expect("a selector");
    Html::parse_fragment(panel).select(&selector).count()
}

fn words(panel: &str) -> Vec<String> {
    let selector = Selector::parse("text").expect("a selector");
    let fragment = Html::parse_fragment(panel);
    fragment
        .select(&selector)
        .map(|it| it.text().collect())
        .collect()
}

fn drawn(name: &str) -> DrawnChart {
    let chart = CHARTS
        .iter()
        .find(|chart| chart.name == name)
        .expect("a chart");
    chart.draw_from(Path::new(NOTES)).expect("its numbers")
}

fn table<Row: Record>() -> Table<Row> {
    Table::read(&text(Row::FILE)).expect("the file is well-formed")
}

fn text(file: &str) -> String {
    fs::read_to_string(Path::new(NOTES).join(file)).expect("a file of the notes")
}
