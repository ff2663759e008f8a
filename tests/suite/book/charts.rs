//! Every chart shows the numbers of its files.

use std::fs;
use std::path::Path;

use figures::{CHARTS, Chart, Drawn, find_chart, standalone};
use insta::assert_binary_snapshot;
use suite::drawn::shown_in;

const NOTES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes");

#[test]
fn every_chart_is_its_snapshot() {
    for chart in CHARTS {
        let drawn = from_notes(chart);
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

/// All panels of all charts, of what was measured.
pub(crate) fn of_the_book() -> impl Iterator<Item = (String, String)> {
    CHARTS.iter().flat_map(|chart| {
        let panels = from_notes(chart).panels.into_iter().zip(1..);
        panels.map(|(panel, n)| (format!("{}, panel {n}", chart.name), panel))
    })
}

fn from_notes(chart: &Chart) -> Drawn {
    chart
        .draw_from(Path::new(NOTES))
        .unwrap_or_else(|error| panic!("{error}"))
}
