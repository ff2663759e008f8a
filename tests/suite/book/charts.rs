//! Every chart shows the numbers of its files, whatever they are.

use std::fs;
use std::path::Path;

use figures::records::{Accuracy, Level, Timing, WrongPixels};
use figures::table::{Record, Table};
use figures::{CHARTS, Chart, Drawn, find_chart, standalone};
use insta::assert_binary_snapshot;
use speed_vs_accuracy::{METHODS, Method, Precision, REGIMES, Random};

use crate::figures::{all, parse, texts, words};

const NOTES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes");

#[test]
fn every_chart_is_its_snapshot() {
    println!(
        "If other numbers were measured: INSTA_UPDATE=always cargo test chart_is_its_snapshot"
    );
    for chart in CHARTS {
        let drawn = from_notes(chart);
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path(format!("{NOTES}/charts"));
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.bind(|| {
            let (name, file) = (chart.name, standalone(&drawn.svg));
            assert_binary_snapshot!(&format!("{name}.svg"), file.into_bytes());
            assert_binary_snapshot!(&format!("{name}_table.md"), drawn.table.into_bytes());
        });
    }
}

#[test]
fn the_chart_of_the_book_names_every_method() {
    for seed in 0..SEEDS {
        let drawn = invented("speed_accuracy", seed);
        for method in METHODS {
            for svg in [&drawn.svg, &drawn.narrow] {
                let is_name = |label: &String| label.split(',').next() == Some(method.name);
                let is_named = labels(svg).iter().any(is_name);
                assert!(
                    is_named,
                    "{} is not named with seed {seed}: {svg}",
                    method.name
                );
            }
            assert!(drawn.table.contains(&format!("`{}`", method.name)));
        }
    }
}

#[test]
fn every_panel_names_the_reference_and_the_certified_methods() {
    for seed in 0..SEEDS {
        let drawn = invented("speed_accuracy_regimes", seed);
        let certified = METHODS.iter().filter(|method| method.is_certified);
        for method in certified.chain([&Method::REFERENCE]) {
            let name = method.name;
            for svg in [&drawn.svg, &drawn.narrow] {
                let count = labels(svg).iter().filter(|label| *label == name).count();
                assert_eq!(count, REGIMES.len(), "{name} with seed {seed}: {svg}");
            }
        }
    }
}

#[test]
fn no_point_lies_beyond_the_line_of_the_best() {
    for seed in 0..SEEDS {
        let drawn = invented("speed_accuracy", seed);
        let drawing = parse(&drawn.svg);
        let front = all(&drawing, "path", "front line").next().expect("a line");
        let steps: Vec<(f64, f64)> = points(front.attribute("d").unwrap_or_default());
        // The first four discs explain the marks.
        for disc in all(&drawing, "circle", "ink solid").skip(1) {
            let [x, y] = ["cx", "cy"].map(|at| {
                disc.attribute(at)
                    .unwrap_or_default()
                    .parse()
                    .unwrap_or(0.0)
            });
            let beyond = steps
                .iter()
                .all(|step| x < step.0 - 0.02 || y < step.1 - 0.02);
            assert!(!beyond, "seed {seed}: ({x}, {y}) is better than {steps:?}");
        }
    }
}

#[test]
fn a_mistake_in_a_file_is_told_with_its_line() {
    let [accuracy, timings] = ["accuracy.csv", "timings.csv"]
        .map(|file| fs::read_to_string(format!("{NOTES}/measured/{file}")).expect("a file"));
    let draw = find_chart("speed_accuracy").expect("a chart").draw;
    assert!(draw(&[&accuracy, &timings]).is_ok());
    for (timings, message) in [
        (
            "# remark: 1\nWHAT\nmethod,half_b,f64,book,1,four,4,4,1\n",
            "measured/timings.csv, line 3, column `median_ns`: invalid float literal",
        ),
        (
            "WHAT\nmethod,half_b,f16,book,1,4,4,4,1\n",
            "measured/timings.csv, line 2: unknown variant `f16`, expected `f64` or `f32`",
        ),
        (
            "WHAT\nmethod,half_b,f64,book,1,4,4,4\n",
            "measured/timings.csv, line 2: 8 fields under 9 columns",
        ),
        ("", "measured/timings.csv has no rows"),
        ("WHAT\n", "measured/timings.csv has no rows"),
        (
            "what,name\nmethod,half_b\n",
            "measured/timings.csv, line 2: missing field `precision`",
        ),
    ] {
        let columns = "what,name,precision,where,n,median_ns,least_ns,greatest_ns,ratio";
        let timings = timings.replace("WHAT", columns);
        assert_eq!(draw(&[&accuracy, &timings]), Err(message.to_owned()));
    }
}

/// All charts, of what was measured, in both layouts.
pub(crate) fn of_the_book() -> impl Iterator<Item = (String, String)> {
    CHARTS
        .iter()
        .flat_map(|chart| both_layouts(chart.name.to_owned(), from_notes(chart)))
}

fn both_layouts(name: String, drawn: Drawn) -> [(String, String); 2] {
    let narrow = format!("{name}, narrow");
    [(name, drawn.svg), (narrow, drawn.narrow)]
}

/// Charts of numbers that nobody measured.
pub(crate) fn of_invented_numbers() -> impl Iterator<Item = (String, String)> {
    let names = [
        "speed_accuracy",
        "speed_accuracy_regimes",
        "distance",
        "scenes",
    ];
    let all = names.map(|name| (0..SEEDS).map(move |seed| (name, seed)));
    all.into_iter().flatten().flat_map(|(name, seed)| {
        both_layouts(format!("{name} with seed {seed}"), invented(name, seed))
    })
}

const SEEDS: u64 = 8;

fn from_notes(chart: &Chart) -> Drawn {
    chart
        .draw_from(Path::new(NOTES))
        .unwrap_or_else(|error| panic!("{error}"))
}

/// A chart of random numbers. With every other seed all methods are equally
/// fast, and with every other two equally exact.
fn invented(name: &str, seed: u64) -> Drawn {
    let mut random = Random::new(seed);
    let mut number = |varies: bool, low: f64, high: f64| {
        10_f64.powf(if varies {
            random.between(low, high)
        } else {
            low
        })
    };
    let (mut accuracy, mut levels) = (Vec::new(), Vec::new());
    let (mut timings, mut scenes) = (Vec::new(), Vec::new());
    for method in METHODS {
        let (name, precision) = (method.name.to_owned(), method.precision());
        for regime in REGIMES.map(|regime| regime.name) {
            let time = number(seed.is_multiple_of(2), 0.5, 1.5);
            let ulps = number(seed % 4 < 2, 0.0, 6.0);
            timings.push(timing(["method", &name, regime], precision, 1, time));
            accuracy.push(Accuracy {
                regime: regime.to_owned(),
                precision,
                method: name.clone(),
                cases: 1,
                hits: 1,
                wrong_per_million: (seed % 3) as f64,
                median_ulps: None,
                p999_ulps: Some(ulps),
                largest_ulps: None,
                surface_median_radii: None,
                surface_p999_radii: Some(1e-20 * ulps.powi(4)),
                surface_largest_radii: None,
                nans: 0,
                answers: 0,
            });
            scenes.push(WrongPixels {
                scene: regime.to_owned(),
                precision,
                method: name.clone(),
                pixels: 100_000,
                wrong: (number(true, 0.0, 5.0) - 1.0).round() as usize,
                off_by_one: 0,
            });
        }
        levels.extend((0..10).map(|level| Level {
            regime: "far".to_owned(),
            level,
            precision,
            method: name.clone(),
            wrong_per_million: f64::from(level / 9),
            median_ulps: None,
            p999_ulps: Some(number(seed % 4 < 2, 0.0, 6.0)),
            answers: 0,
        }));
    }
    let text_of = |file: &&str| match *file {
        Accuracy::FILE => Table::from(accuracy.clone()).text(),
        Level::FILE => Table::from(levels.clone()).text(),
        WrongPixels::FILE => Table::from(scenes.clone()).text(),
        _ => Table::from(timings.clone()).text(),
    };
    let chart = find_chart(name).expect("it is the name of a chart");
    let texts: Vec<String> = chart.files.iter().map(text_of).collect();
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    (chart.draw)(&texts).unwrap_or_else(|error| panic!("{error}"))
}

fn timing([what, name, place]: [&str; 3], precision: Precision, n: usize, time: f64) -> Timing {
    Timing {
        what: what.to_owned(),
        name: name.to_owned(),
        precision,
        place: place.to_owned(),
        n,
        median_ns: time,
        least_ns: time,
        greatest_ns: time,
        ratio: 1.0,
    }
}

/// What is written in a chart.
fn labels(svg: &str) -> Vec<String> {
    let drawing = parse(svg);
    texts(&drawing).map(|text| words(&text)).collect()
}

/// The points of a path.
fn points(path: &str) -> Vec<(f64, f64)> {
    path.split(['M', 'L'])
        .filter_map(|step| step.split_once(' '))
        .filter_map(|(x, y)| Some((x.parse().ok()?, y.parse().ok()?)))
        .collect()
}
