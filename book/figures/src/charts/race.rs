//! A bar chart of times: the pictures by our programs and by the one in C++.

use super::chart::{Chart, Drawn, table};
use crate::records::Race;
use crate::svg::{Anchor, Step, spot};
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
    let heads = ["picture", "Rust, ms", "C++, ms", "C++ ÷ Rust"].map(str::to_owned);
    let row = |race: &Race| {
        vec![
            race.chapter.clone(),
            format!("{:.1}", race.rust_median_ms),
            format!("{:.0}", race.cpp_median_ms),
            format!("{:.1}", race.ratio()),
        ]
    };
    Ok(Drawn {
        panels: vec![bars(chart, &races, title)],
        table: table(1, &heads, races.iter().map(row)),
    })
}

/// From one picture to the next, and the longest bar.
const PITCH: f64 = 96.0;
const WIDE: f64 = 392.0;

fn bars(chart: &Chart, races: &[Race], title: &str) -> String {
    let times = races
        .iter()
        .flat_map(|it| [it.cpp_median_ms, it.rust_median_ms]);
    let longest = times.fold(1.0, f64::max);
    let mut svg = chart.sheet(40.0 + PITCH * races.len() as f64);
    let title = format!("milliseconds: {title}");
    svg.small_label("faint", spot(4.0, 18.0), Anchor::Start, &title);
    for (race, place) in races.iter().zip(0..) {
        let top = spot(4.0, 46.0 + PITCH * f64::from(place));
        svg.label("ink", top, Anchor::Start, &race.chapter);
        let (rust, cpp) = (race.rust_median_ms, race.cpp_median_ms);
        let ours = format!("{rust:.0} Rust, {}", times_as_fast(race.ratio()));
        let rival = format!("{cpp:.0} C++");
        for (idea, time, words, below) in [
            ("ray", rust, ours, top.down(17.0)),
            ("faint", cpp, rival, top.down(53.0)),
        ] {
            svg.small_label("ink", below, Anchor::Start, &words);
            let size = spot(WIDE * time / longest, 14.0);
            svg.rect(&format!("{idea} solid"), below.down(5.0), size);
        }
    }
    svg.finish()
}

/// How many times as fast, with as many digits as mean something.
fn times_as_fast(ratio: f64) -> String {
    let digits = usize::from(ratio < 9.95);
    format!("{ratio:.digits$} times as fast")
}
