//! A map of methods: the cheapest one that suffices, by where a ray starts and what it passes.

use speed_vs_accuracy::{Method, Precision};

use super::chart::{Chart, DrawnChart, table};
use super::spot::{MAPPED, Spot};
use crate::prelude::*;
use crate::records::{MapCell, Timing};
use crate::table::{Record, Table};
use crate::text::{SMALL, width};

/// The map of methods, a picture for each of [`DIGITS`].
pub(super) const CHART: Chart = Chart {
    name: "map",
    title: "A map for my scene",
    description: "Two maps, of f64 and of f32. To the right a ray starts ever more radii away from a \
        sphere, from 1 to ten to the fifteen. Downwards it passes ever nearer to the rim. Two columns at the \
        left are for rays that start near the surface, above it or inside: downwards ever nearer. A \
        colored region says which method is the cheapest that suffices there. half_b_q suffices at \
        the top left, cross_q farther to the right, compensated and the certified methods along the \
        lower edge, where rays nearly touch. Dashed lines show the rules.",
    caption: "The cheapest method that suffices, as measured: it decided a thousand rays of each cell \
        rightly, and its worst hit has so many digits, of the hit point in radii, or near the surface \
        of <i>t</i>. Dashed are the rules: at the left <i>uk</i>² and, on the slope, 24<i>uk</i>² \
        against the distance from the rim; at the right, and near the surface, <i>uk</i>. Times are \
        those of <i>telescope</i>; near a sphere those of <i>book</i>, <i>grazing</i>, <i>ground</i> \
        and <i>inside</i>. Where <code>half_b_q</code> suffices, <code>half_b</code> does. Blank: a \
        ray so near to the rim can’t be stored.",
    choices: &["3 digits, for pictures", "6 digits", "12 digits"],
    files: &[MapCell::FILE, Timing::FILE],
    draw: |files| draw(files[0], files[1]),
};

/// The digits of each picture.
const DIGITS: [i32; 3] = [3, 6, 12];

fn draw(cells: &str, timings: &str) -> Result<DrawnChart, String> {
    let map = Map::read(cells, timings)?;
    let panel = |((digits, shows), place): ((&i32, &&str), usize)| {
        let mut svg = CHART.panel(place, shows, 494.0);
        for (precision, top, key) in [
            (Precision::Double, 26.0, spot(276.0, 140.0)),
            (Precision::Single, 334.0, spot(222.0, 376.0)),
        ] {
            draw_map(&mut svg, &map, *digits, precision, spot(86.0, top));
            draw_key(&mut svg, precision, key);
        }
        svg.finish()
    };
    let panels = DIGITS.iter().zip(CHART.choices).zip(1..).map(panel);
    Ok(DrawnChart {
        panels: panels.collect(),
        table: map.numbers(),
    })
}

/// What was measured: the answers at each spot, and the times.
pub struct Map {
    cells: Table<MapCell>,
    /// The times, by which a method is cheap.
    pub timings: Table<Timing>,
}

impl Map {
    /// Reads the map from the texts of its two files, [`MapCell::FILE`] and [`Timing::FILE`].
    ///
    /// # Errors
    /// A message that names the file and the line that is wrong.
    pub fn read(cells: &str, timings: &str) -> Result<Self, String> {
        Ok(Self {
            cells: Table::read(cells)?,
            timings: Table::read(timings)?,
        })
    }

    /// Returns the cheapest method in this precision that decides rightly at `spot` with so many
    /// digits; `None` if none does.
    pub fn least(&self, spot: Spot, precision: Precision, digits: i32) -> Option<Method> {
        let suffices = |method: &Method| {
            let is_here = |cell: &&MapCell| {
                cell.method == method.name && cell.row == spot.row() && cell.column == spot.column()
            };
            let cell = self.cells.rows.iter().find(is_here);
            cell.is_some_and(|cell| cell.wrong == 0 && cell.off <= 0.1_f64.powi(digits))
        };
        self.timings.quickest(precision, spot.situation(), suffices)
    }

    /// Writes the map as a table: a row for each spot, with the method for each of [`DIGITS`].
    fn numbers(&self) -> String {
        let heads = [
            "in",
            "starts",
            "nearness",
            "3 digits",
            "6 digits",
            "12 digits",
        ];
        let all = Precision::ALL.map(|it| Spot::all(it).map(move |spot| (it, spot)));
        let rows = all.into_iter().flatten().map(|(precision, spot)| {
            let starts = spot.column().parse().map_or(spot.column(), power_of_ten);
            let names = DIGITS.map(|digits| {
                let least = self.least(spot, precision, digits);
                least.map_or("–".to_owned(), |it| format!("`{}`", it.name))
            });
            let place = [
                precision.name().to_owned(),
                starts,
                power_of_ten(-spot.row()),
            ];
            place.into_iter().chain(names).collect()
        });
        table(6, &heads.map(str::to_owned), rows)
    }
}

/// The size of a cell, and the distance of the two columns at the left from the others.
const CELL: DVec2 = spot(19.4, 14.0);
const GAP: f64 = 8.0;

/// Draws one precision, with the upper left corner of the rays from afar at `corner`.
fn draw_map(svg: &mut Svg, map: &Map, digits: i32, precision: Precision, corner: DVec2) {
    let last = Spot::last(precision);
    let title = format!("**{}**, {digits} digits", precision.name());
    svg.label("ink", spot(4.0, corner.y - 11.0), Start, &title);
    let place = |spot: Spot| {
        let column = match spot {
            Spot::Above(_) => -2.0 - GAP / CELL.x,
            Spot::Inside(_) => -1.0 - GAP / CELL.x,
            Spot::Away(k, _) => f64::from(k),
        };
        corner + CELL * DVec2::new(column, f64::from(spot.row()))
    };
    let cells = Spot::all(precision).map(|it| (it, map.least(it, precision, digits)));
    let cells: Vec<Cell> = cells.map(|(it, method)| (it, place(it), method)).collect();
    svg.group("pixels", |svg| {
        for (_, corner, method) in &cells {
            svg.rect(color(*method), *corner, CELL);
        }
    });
    draw_axes(svg, last, corner);
    draw_rules(svg, precision, digits, corner);
    for method in MAPPED.iter().map(Some).chain([None]) {
        let name = method.map(|method| method.name);
        let is_it = |cell: &&Cell| cell.2.map(|method| method.name) == name;
        draw_name(svg, name.unwrap_or("none"), cells.iter().filter(is_it));
    }
}

/// A cell: what it is for, its corner, and the method that suffices there.
type Cell = (Spot, DVec2, Option<Method>);

/// Writes a name into the middle of its region, the given cells, if they are wide enough for it.
fn draw_name<'a>(svg: &mut Svg, name: &str, cells: impl Iterator<Item = &'a Cell>) {
    let mut away: Vec<DVec2> = cells
        .filter(|(spot, ..)| matches!(spot, Spot::Away(..)))
        .map(|(_, corner, _)| *corner)
        .collect();
    away.sort_by(|one, other| one.y.total_cmp(&other.y).then(one.x.total_cmp(&other.x)));
    let rows = away.chunk_by(|one, other| one.y == other.y);
    let wide = rows.filter(|row| CELL.x * row.len() as f64 > width(name, SMALL));
    let wide: Vec<&[DVec2]> = wide.collect();
    if let Some([first, .., last]) = wide.get(wide.len() / 2) {
        let middle = spot(0.5 * (first.x + last.x + CELL.x), first.y + 11.0);
        svg.small_label("ink", middle, Middle, name);
    }
}

fn draw_axes(svg: &mut Svg, last: i32, corner: DVec2) {
    let far = CELL * f64::from(last + 1);
    let low = corner.down(far.y);
    let step = if last > 7 { 3 } else { 2 };
    let powers = |sign: i32| {
        let marked = (0..=last).step_by(step).map(f64::from);
        ticks(marked, |n| power_of_ten(sign * n as i32))
    };
    let columns = Axis::new(low.x, low.y, far.x, -0.5, f64::from(last) + 0.5);
    columns.draw_ticks(svg, "faint thin", spot(0.0, 4.0), &powers(1));
    let left = corner.right(-GAP - 2.0 * CELL.x);
    let rows = Axis {
        start: left,
        end: left.down(far.y),
        ..columns
    };
    rows.draw_ticks(svg, "faint thin", spot(-4.0, 0.0), &powers(-1));
    for (x, y, words) in [(-2.0, 15.0, "above"), (8.0, 29.0, "inside")] {
        svg.small_label("faint", left + spot(x, far.y + y), Start, words);
    }
    let words = if last > 7 {
        "the ray starts so many radii away →"
    } else {
        "radii away →"
    };
    svg.small_label("faint", low + spot(far.x, 34.0), End, words);
    let words = "↓ nearer to the rim, or to the surface, in radii";
    svg.small_label("faint", spot(396.0, corner.y - 11.0), End, words);
}

/// Draws the rules as dashed lines: u·k² and u·k radii are 10 to the power −`digits`, and where
/// decisions may fail; near the surface u is that part of the height.
fn draw_rules(svg: &mut Svg, precision: Precision, digits: i32, corner: DVec2) {
    let (u, last) = (0.5 * precision.epsilon(), Spot::last(precision));
    let place = |k: f64, n: f64| corner + CELL * DVec2::new(k + 0.5, n + 0.5);
    let [digits, far] = [digits, last].map(f64::from);
    // 24·u·k² is twice the nearness to the rim, which is l = r·(1 ± 10⁻ⁿ) in r² − l².
    let rim = |k: f64| -(12.0 * u).log10() - 2.0 * k;
    let square = -0.5 * (u.log10() + digits);
    let linear = -(u.log10() + digits);
    let deepest = 0.5 * (-(12.0 * u).log10() - far - 0.5);
    if square > -0.5 {
        let bend = place(square, rim(square).clamp(-0.5, far + 0.5));
        let top = spot(bend.x, corner.y);
        svg.path("ink dashed", &[top, bend, place(deepest, rim(deepest))]);
    }
    if (-0.5..far).contains(&linear) {
        let low = place(linear, (far + 1.5 - linear).min(far + 0.5));
        svg.line("ink dashed", spot(low.x, corner.y), low);
        let left = spot(corner.x - GAP, place(0.0, linear).y);
        svg.line("ink dashed", left.right(-2.0 * CELL.x), left);
    }
}

/// Draws the color of each method of a precision, with its name.
fn draw_key(svg: &mut Svg, precision: Precision, corner: DVec2) {
    let methods = MAPPED
        .iter()
        .filter(|method| method.precision() == precision);
    for (method, n) in methods.map(Some).chain([None]).zip(0_u8..) {
        let at = corner.down(18.0 * f64::from(n));
        svg.rect(color(method.copied()), at, CELL);
        let words = method.map_or("none suffices", |it| it.name);
        svg.small_label("ink", at + spot(26.0, 11.0), Start, words);
    }
}

/// Returns the class of the cells of a method.
fn color(method: Option<Method>) -> &'static str {
    match method.map(|method| method.name) {
        Some("half_b_q" | "half_b_f32") => "sphere tint",
        Some("cross_q" | "widened_half_b_q_f32") => "viewport tint",
        Some("compensated") => "ray deep",
        Some("certified_hit") => "normal tint",
        Some(_) => "normal deep",
        None => "faint wash",
    }
}
