//! Golden drawings: every figure and every chart is its snapshot. Whether their labels hide each
//! other is seen in `tests/browser`.

use std::fs;
use std::path::Path;

use figures::{CHARTS, FIGURES, standalone};
use insta::assert_binary_snapshot;
use suite::drawn::shown_in;

use crate::book::NOTES;

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

#[test]
fn a_mistake_in_a_file_is_an_error_with_its_line() {
    let [accuracy, timings] = ["accuracy.csv", "timings.csv"]
        .map(|file| fs::read_to_string(format!("{NOTES}/measured/{file}")).expect("a file"));
    let draw = CHARTS[0].draw;
    assert!(draw(&[&accuracy, &timings]).is_ok());
    let columns = "what,name,precision,where,n,median_ns,least_ns,ratio,instructions";
    let error = |row: &str| draw(&[&accuracy, &format!("{columns}\n{row}")]).unwrap_err();
    let wrong = error("method,half_b,f64,book,1,four,4,1,\n");
    assert!(wrong.starts_with("measured/timings.csv: "), "{wrong}");
    assert!(wrong.contains("line: 2"), "{wrong}");
    assert!(wrong.contains("invalid float literal"), "{wrong}");
    assert_eq!(error(""), "measured/timings.csv has no rows");
}
