//! Heat maps: false shadows and light leaks, for each way to leave a surface and radius.

use glam::DVec2;

use super::chart::{Chart, Drawn, table};
use super::heat::cell;
use crate::number::{raised, short};
use crate::records::Shadows;
use crate::svg::{Anchor, Svg};
use crate::table::{Record, Table};

/// Two heat maps.
pub(super) const CHART: Chart = Chart {
    name: "leaving",
    title: "False shadows and light leaks, from the smallest ground to the largest",
    description: "Two tables with a row for each way to leave a surface, in f64 and in f32, and a \
        column for each radius of the ground from a thousandth to ten million. A cell says how many \
        of a thousand suns are seen wrongly: in the first table as a shadow where the sun shines, in \
        the second as light where a ball is in the way. To leave at once shows false shadows at every \
        radius. To wait for a thousandth leaks light on small grounds, and in f32 shows false \
        shadows on large ones. The integer offset shows false shadows on small and on large grounds. \
        The offset of pbrt and the proven one have ticks everywhere.",
    caption: "How many of a thousand suns the test of chapter 5 sees wrongly. Each column is a radius \
        of the ground, from a thousandth to ten million. The last two offsets are always right. The \
        table below also has what exact arithmetic sees from there.",
    files: &[Shadows::FILE],
    draw: |files| draw(files[0]),
};

/// The rows of one way, precision and tester, from the least radius on.
type Line = Vec<Shadows>;

fn draw(file: &str) -> Result<Drawn, String> {
    let mut lines: Vec<Line> = Vec::new();
    let key = |row: &Shadows| {
        (
            row.precision.name(),
            row.leaving.clone(),
            row.tester.clone(),
        )
    };
    for row in Table::<Shadows>::read(file)?.rows {
        match lines.iter_mut().find(|line| key(&line[0]) == key(&row)) {
            Some(line) => line.push(row),
            None => lines.push(vec![row]),
        }
    }
    let by_plain_test = |line: &&Line| line[0].tester != "exact";
    let drawn: Vec<&Line> = lines.iter().filter(by_plain_test).collect();
    let heads: Vec<String> = lines[0].iter().map(|row| power(row.level)).collect();
    let name = "false shadows and light leaks per million, at".to_owned();
    let row = |line: &Line| {
        let (first, precision) = (&line[0], line[0].precision.name());
        let name = format!("`{}`, {precision}, by `{}`", first.leaving, first.tester);
        let counts = line.iter().map(|row| {
            let [dark, light] = MAPS.map(|(_, count)| short(count(row)));
            format!("{dark}, {light}")
        });
        [name].into_iter().chain(counts).collect()
    };
    let maps = MAPS.into_iter().zip(1..);
    Ok(Drawn {
        panels: maps
            .map(|((title, count), place)| heat_map(place, title, count, &drawn))
            .collect(),
        table: table(1, &[vec![name], heads].concat(), lines.iter().map(row)),
    })
}

/// What a heat map is of.
type Count = fn(&Shadows) -> f64;

const MAPS: [(&str, Count); 2] = [
    ("false shadows", |row| row.false_shadows_per_million),
    ("light leaks", |row| row.light_leaks_per_million),
];

const HIGH: f64 = 24.0;

fn heat_map(place: usize, title: &str, count: Count, lines: &[&Line]) -> String {
    let pitch = HIGH + 18.0;
    let mut svg = CHART.panel(place, title, 68.0 + pitch * lines.len() as f64);
    let wide = 398.0 / lines[0].len() as f64;
    let words = format!("{title}, of 1000");
    svg.small_label("ink", DVec2::new(1.0, 20.0), Anchor::Start, &words);
    for (place, row) in (0_u32..).zip(lines[0]).step_by(2) {
        let middle = DVec2::new(1.0 + wide * (f64::from(place) + 0.5), 44.0);
        svg.small_label("faint", middle, Anchor::Middle, &power(row.level));
    }
    for (place, line) in (0_u32..).zip(lines) {
        let below = DVec2::new(1.0, 50.0 + pitch * f64::from(place + 1));
        map_line(&mut svg, below - DVec2::new(0.0, HIGH), wide, line, count);
        let name = format!("{}, {}", line[0].leaving, line[0].precision.name());
        let above = below - DVec2::new(0.0, HIGH + 5.0);
        svg.small_label("ink", above, Anchor::Start, &name);
    }
    svg.finish()
}

fn map_line(svg: &mut Svg, corner: DVec2, wide: f64, line: &Line, count: Count) {
    let size = DVec2::new(wide - 2.0, HIGH - 3.0);
    for (place, row) in (0_u32..).zip(line) {
        let share = count(row) / 1e6;
        let words = match 1000.0 * share {
            ..0.95 => "<1".to_owned(),
            many => format!("{many:.0}"),
        };
        let at = corner + DVec2::new(wide * f64::from(place), 0.0);
        cell(svg, at, size, share, &words);
    }
}

fn power(level: i32) -> String {
    match level {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => format!("10{}", raised(level)),
    }
}
