//! Golden drawings: every figure and every chart is its snapshot. Whether their labels hide each
//! other is seen in `tests/browser`.

use std::path::Path;

use figures::{CHARTS, figures, standalone};
use insta::assert_binary_snapshot;
use suite::drawn::shown_in;

use crate::book::NOTES;

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
