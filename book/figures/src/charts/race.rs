//! A bar chart of times: the pictures by our programs and by the one in C++.

use std::fmt::Write;

use glam::DVec2;

use super::bars::bar;
use super::chart::{Chart, Drawn, Layout};
use crate::records::Race;
use crate::svg::Anchor;
use crate::table::{Record, Table};

/// Program against program: from the start of each process to its end, with the text.
pub(super) const PROGRAMS: Chart = Chart {
    name: "race",
    title: "Milliseconds to draw a picture 3840 pixels wide as text",
    description: "Two bars for each picture: a short one for our program, and one many times as \
        long for a plain C++ program in the manner of the book.",
    caption: "Milliseconds to draw a picture 3840 pixels wide as text, the median of several runs. \
        Both programs write the same bytes: ours on all threads, the C++ program on one.",
    files: &[Race::FILE],
    draw: |files| draw(&PROGRAMS, files[0], "nowhere", "the program, with its text"),
};

/// Tracing against tracing: one thread each, and no text.
pub(super) const TRACING: Chart = Chart {
    name: "race_tracing",
    title: "Milliseconds to trace the same picture, without the text",
    description: "The same pictures without printing, on one thread each. The bars of the C++ \
        program are a small part of what they were, and those of the two programs near to each \
        other.",
    caption: "Milliseconds to trace the same picture on one thread, without printing it, the median \
        of several runs. Both keep the bytes of the picture in memory.",
    files: &[Race::FILE],
    draw: |files| draw(&TRACING, files[0], "traced", "tracing alone, on one thread"),
};

fn draw(chart: &Chart, file: &str, to: &str, title: &str) -> Result<Drawn, String> {
    let mut races = Table::<Race>::read(file)?.rows;
    races.retain(|race| race.width == 3840 && race.to == to);
    Ok(Drawn::new(table(&races), |layout| {
        bars(layout, chart, &races, title)
    }))
}

fn bars(layout: Layout, chart: &Chart, races: &[Race], title: &str) -> String {
    let longest = races
        .iter()
        .map(|race| race.cpp_median_ms.max(race.rust_median_ms));
    let longest = longest.fold(1.0, f64::max);
    let length = |time: f64| (layout.width() - layout.choose(290.0, 8.0)) * time / longest;
    let pitch = layout.choose(52.0, 108.0);
    let mut svg = chart.sheet(layout, 34.0 + pitch * races.len() as f64);
    let left = layout.choose(12.0, 4.0);
    let unit = layout.choose(
        "milliseconds for a picture 3840 pixels wide",
        "milliseconds",
    );
    let title = format!("{unit}: {title}");
    svg.small_label("faint", DVec2::new(left, 20.0), Anchor::Start, &title);
    let (aside, anchor, heights) = layout.choose(
        (DVec2::new(-10.0, 24.0), Anchor::End, [0.0, 19.0]),
        (DVec2::new(0.0, 16.0), Anchor::Start, [20.0, 57.0]),
    );
    for (race, place) in races.iter().zip(0..) {
        let corner = DVec2::new(layout.choose(132.0, left), 38.0 + pitch * f64::from(place));
        svg.label("ink", corner + aside, anchor, &race.chapter);
        let (rust, cpp) = (race.rust_median_ms, race.cpp_median_ms);
        let ours = format!("{rust:.0} Rust, {}", times(race.ratio()));
        let rival = format!("{cpp:.0} C++");
        let two = [("ray", rust, ours), ("faint", cpp, rival)];
        for ((idea, time, words), height) in two.into_iter().zip(heights) {
            let from = corner + DVec2::new(0.0, height);
            bar(&mut svg, layout, idea, from, length(time), &words);
        }
    }
    svg.finish()
}

/// How many times as fast, with as many digits as mean something.
fn times(ratio: f64) -> String {
    let digits = usize::from(ratio < 9.95);
    format!("{ratio:.digits$} times as fast")
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
