//! Our pictures and those of a plain C++ program.

use std::fmt::Write;

use glam::DVec2;

use super::chart::{Chart, Drawn, WIDTH};
use crate::records::Race;
use crate::svg::{Anchor, number};
use crate::table::{Record, Table};

/// Bars: ours and the rival's.
pub(super) const CHART: Chart = Chart {
    name: "race",
    title: "Milliseconds to draw a picture 3840 pixels wide as text",
    description: "Two bars for each picture: a short one for our program, and one many times as \
        long for a plain C++ program in the manner of the book.",
    caption: "Milliseconds to draw a picture 3840 pixels wide as text, the median of several runs. \
        Both programs write the same bytes.",
    files: &[Race::FILE],
    draw: |files| draw(files[0]),
};

fn draw(file: &str) -> Result<Drawn, String> {
    let mut races = Table::<Race>::read(file)?.rows;
    races.retain(|race| race.width == 3840 && race.to == "nowhere");
    let longest = races.iter().map(|race| race.cpp_median_ms);
    let longest = longest.fold(1.0, f64::max);
    let bar = |time: f64| (WIDTH - 270.0) * time / longest;
    let mut svg = CHART.sheet(34.0 + 52.0 * races.len() as f64);
    let title = "milliseconds for a picture 3840 pixels wide, as text";
    svg.small_label("faint", DVec2::new(12.0, 20.0), Anchor::Start, title);
    for (race, place) in races.iter().zip(0..) {
        let corner = DVec2::new(132.0, 38.0 + 52.0 * f64::from(place));
        svg.label(
            "ink",
            corner + DVec2::new(-10.0, 24.0),
            Anchor::End,
            &race.chapter,
        );
        let (rust, cpp) = (race.rust_median_ms, race.cpp_median_ms);
        let ratio = number(race.ratio().round());
        let ours = format!("{rust:.0} Rust, {ratio} times as fast");
        let rival = format!("{cpp:.0} C++");
        for (idea, time, words, y) in [("ray", rust, ours, 0.0), ("faint", cpp, rival, 19.0)] {
            let from = corner + DVec2::new(0.0, y);
            svg.rect(&format!("{idea} solid"), from, DVec2::new(bar(time), 16.0));
            let at = from + DVec2::new(bar(time) + 8.0, 12.5);
            svg.small_label("ink", at, Anchor::Start, &words);
        }
    }
    Ok(Drawn {
        svg: svg.finish(),
        table: table(&races),
    })
}

fn table(races: &[Race]) -> String {
    let mut table = "\
| picture | Rust, ms | C++, ms | C++ ÷ Rust |
|---|---:|---:|---:|
"
    .to_owned();
    for race in races {
        let _ = writeln!(
            table,
            "| {} | {:.1} | {:.0} | {:.1} |",
            race.chapter,
            race.rust_median_ms,
            race.cpp_median_ms,
            race.ratio()
        );
    }
    table
}
