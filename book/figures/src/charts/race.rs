//! Our pictures and those of a plain C++ program.

use std::fmt::Write;

use glam::DVec2;

use super::{Chart, Drawn, WIDTH};
use crate::svg::{Anchor, number};

/// Bars: ours and the rival's.
pub(super) const CHART: Chart = Chart {
    name: "race",
    title: "Milliseconds to draw a picture 3840 pixels wide as text",
    description: "Two bars for each picture: a short one for our program, and one many times as \
        long for a plain C++ program in the manner of the book.",
    caption: "Milliseconds to draw a picture 3840 pixels wide as text, the median of several runs. \
        Both programs write the same bytes.",
    files: &["speed/heats.txt"],
    draw: |files| draw(files[0]),
};

/// A picture, and the milliseconds of both programs.
struct Heat<'a> {
    picture: &'a str,
    ours: f64,
    rival: f64,
}

fn draw(file: &str) -> Result<Drawn, String> {
    let heats = read(file)?;
    let longest = heats.iter().map(|heat| heat.rival).fold(1.0, f64::max);
    let bar = |time: f64| (WIDTH - 270.0) * time / longest;
    let mut svg = CHART.sheet(34.0 + 52.0 * heats.len() as f64);
    let title = "milliseconds for a picture 3840 pixels wide, as text";
    svg.small_label("faint", DVec2::new(12.0, 20.0), Anchor::Start, title);
    for (heat, place) in heats.iter().zip(0..) {
        let corner = DVec2::new(132.0, 38.0 + 52.0 * f64::from(place));
        svg.label(
            "ink",
            corner + DVec2::new(-10.0, 24.0),
            Anchor::End,
            heat.picture,
        );
        let ours = format!(
            "{:.0} Rust, {} times as fast",
            heat.ours,
            number((heat.rival / heat.ours).round())
        );
        let rival = format!("{:.0} C++", heat.rival);
        for (idea, time, words, y) in [
            ("ray", heat.ours, ours, 0.0),
            ("faint", heat.rival, rival, 19.0),
        ] {
            let from = corner + DVec2::new(0.0, y);
            svg.rect(&format!("{idea} solid"), from, DVec2::new(bar(time), 16.0));
            let at = from + DVec2::new(bar(time) + 8.0, 12.5);
            svg.small_label("ink", at, Anchor::Start, &words);
        }
    }
    Ok(Drawn {
        svg: svg.finish(),
        table: table(&heats),
    })
}

/// The heats of large pictures that went nowhere.
fn read(file: &str) -> Result<Vec<Heat<'_>>, String> {
    let mut heats = Vec::new();
    for (line, n) in file.lines().zip(1..) {
        if line.starts_with('#') {
            continue;
        }
        let words: Vec<&str> = line.split(' ').collect();
        let [picture, width, to, ours, _, _, rival, _, _] = words[..] else {
            return Err(format!("heats.txt, line {n}: a heat has nine words"));
        };
        let time = |word: &str| {
            word.parse::<f64>()
                .map_err(|_| format!("heats.txt, line {n}: `{word}` is no time"))
        };
        let (ours, rival) = (time(ours)?, time(rival)?);
        if width == "3840" && to == "nowhere" {
            heats.push(Heat {
                picture,
                ours,
                rival,
            });
        }
    }
    Ok(heats)
}

fn table(heats: &[Heat]) -> String {
    let mut table = "\
| picture | Rust, ms | C++, ms | C++ ÷ Rust |
|---|---:|---:|---:|
"
    .to_owned();
    for Heat {
        picture,
        ours,
        rival,
    } in heats
    {
        let _ = writeln!(
            table,
            "| {picture} | {ours:.1} | {rival:.0} | {:.1} |",
            rival / ours
        );
    }
    table
}
