//! Figure 4 of the notes: the viewport and its grid of pixels. The width of the picture
//! changes, and the marked pixel moves.

use common::rtweekend::*;
use glam::DVec2;
use slips::Chapter;

use crate::figure::Figure;
use crate::live::{Action, Answer, Handle, Live, Number, parameters};
use crate::number::spoken;
use crate::plane::Plane;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "viewport_grid",
    title: "The viewport and its grid of pixels",
    description: "A rectangle of eight by four squares, each with a point in its center. V 0 is the \
        upper left corner of the rectangle. The vector V u runs from there along the whole upper edge, \
        V v along the whole left edge, downwards. The point in the first square is P 0,0. From \
        there Δu leads to the point on its right, Δv to the point below. Another square is \
        marked, with the point P 5,2 in its center.",
    caption: "The pixels of a picture on its viewport. The first **P** is the \
        center of a pixel: half a step right and half a step down from the corner. Rows are counted \
        downwards, but *y* grows upwards, so Δ**v** points along −*y*.",
    draw: || LIVE.on_page(),
};

parameters! {
    width: Number::whole("Width", 1.0, 40.0, 8.0),
    i: Number {
        most_beside: Some(|numbers| f64::from(Parameters::of(numbers).right().image_width - 1)),
        ..Number::whole("Column i", 0.0, 39.0, 5.0)
    },
    j: Number {
        most_beside: Some(|numbers| f64::from(Parameters::of(numbers).right().image_height - 1)),
        downwards: true,
        ..Number::whole("Row j", 0.0, 21.0, 2.0)
    },
    first: Number::choice("The first P", CHOICES),
}

/// The figure, as a reader moves it: the height jumps, and a pixel has its ray.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: FIGURE,
    question: "At which widths does the picture gain a row? And where does the ray of the marked \
        pixel go, if the half pixel is forgotten?",
    solution: "At 4, 6, 8, 9, 11 and so on: wherever 9/16 of the width passes a whole number. Without the half \
        pixel it goes to the upper left corner of its pixel.",
    handles: &[Handle::new(&["i", "j"], |it, to| {
        let Camera {
            pixel00,
            pixel_delta_u,
            pixel_delta_v,
            ..
        } = it.camera();
        let way = it.grid().plane().place(to) - pixel00;
        let along = |step: Vec3| way.dot(step) / step.length_squared();
        [it.i, it.j] = [along(pixel_delta_u), along(pixel_delta_v)];
    })],
    // The pixel stays, where there is one.
    actions: &[
        Action::new("1 wide", |it| it.width = 1.0),
        Action::new("16 wide", |it| it.width = 16.0),
        Action::new("40 wide", |it| it.width = 40.0),
    ],
    answer,
};

/// The name of the slip in the catalogue.
const SLIP: &str = "grid-not-inset";
const CHOICES: &[&str] = &["half a pixel in", "at the corner"];

impl Parameters {
    /// The camera of the chapter.
    fn right(&self) -> Camera {
        Camera::new(self.width as u32)
    }

    /// The camera that is shown.
    fn camera(&self) -> Camera {
        let right = self.right();
        let slip = slips::find(SLIP).filter(|_| self.first >= 1.0);
        slip.map_or(right, |slip| {
            slip.program(Chapter::Gradient).camera(right.image_width)
        })
    }

    fn grid(&self) -> Grid {
        Grid {
            camera: self.camera(),
            pixel: [self.i, self.j].map(|it| it as u32),
        }
    }
}

fn answer(parameters: &Parameters) -> Answer {
    let grid = parameters.grid();
    let width = grid.camera.image_width;
    let [i, j] = grid.pixel;
    let right = parameters.right().ray(i, j).direction;
    Answer {
        drawing: draw(&grid),
        sentence: format!("{} {}", way(&grid, right), height(width)),
        handles: vec![grid.plane().point(grid.place([i, j]))],
        says: vec![
            ("width", width.to_string()),
            ("rows", rows(width)),
            ("because", because(width)),
            ("pixel", format!("({i}, {j})")),
            ("direction", triple(right)),
        ],
    }
}

/// Where the ray of the pixel goes, and that it should go to the `right`.
fn way(grid: &Grid, right: Vec3) -> String {
    let [i, j] = grid.pixel;
    let way = grid.camera.ray(i, j).direction;
    let corner = match way == right {
        true => String::new(),
        false => format!(
            ", to its corner: half a pixel up and to the left of {}",
            triple(right)
        ),
    };
    format!(
        "The ray of pixel ({i}, {j}) has the direction {}{corner}.",
        triple(way)
    )
}

/// How many rows there are, and why.
fn height(width: u32) -> String {
    let (rows, because) = (rows(width), because(width));
    format!("A picture {width} wide has {rows}: {because}.")
}

fn because(width: u32) -> String {
    // In sixteenths, so that no digit is cut.
    let quotient = f64::from(9 * width) / 16.0;
    let end = match quotient {
        ..1.0 => " would leave none",
        _ if quotient.fract() == 0.0 => ", and nothing is cut",
        _ => " is cut",
    };
    format!("{width} / (16/9) = {quotient}{end}")
}

fn rows(width: u32) -> String {
    match Camera::new(width).image_height {
        1 => "1 row".to_owned(),
        rows => format!("{rows} rows"),
    }
}

/// A grid with a pixel that is marked.
struct Grid {
    /// Whose grid it is.
    camera: Camera,
    /// Column and row of the pixel.
    pixel: [u32; 2],
}

impl Grid {
    /// Where the scene is on the sheet: the viewport as wide, or as high, as there is room.
    fn plane(&self) -> Plane {
        let [u, v] = self.viewport();
        let scale = (ROOM.x / u.x).min(ROOM.y / -v.y);
        let corner = self.corner();
        Plane::new(
            CORNER.x - scale * corner.x,
            CORNER.y + scale * corner.y,
            scale,
        )
    }

    /// The viewport's upper edge from left to right, and its left edge downwards.
    fn viewport(&self) -> [Vec3; 2] {
        let camera = &self.camera;
        [
            f64::from(camera.image_width) * camera.pixel_delta_u,
            f64::from(camera.image_height) * camera.pixel_delta_v,
        ]
    }

    /// The upper left corner of the viewport, by the formula of the page.
    fn corner(&self) -> Point3 {
        let [u, v] = self.viewport();
        self.camera.center - Vec3::Z - 0.5 * u - 0.5 * v
    }

    /// The place through which the ray of a pixel goes.
    fn place(&self, [i, j]: [u32; 2]) -> Point3 {
        self.camera.ray(i, j).at(1.0)
    }
}

/// Where the upper left corner of the viewport is on the sheet.
const CORNER: DVec2 = DVec2::new(84.0, 40.0);

/// How large the viewport can be there.
const ROOM: DVec2 = DVec2::new(288.0, 164.0);

/// Draws the grid with its points and vectors, and the numbers below.
fn draw(grid: &Grid) -> Svg {
    let mut svg = FIGURE.sheet(400.0, 346.0);
    let plane = grid.plane();
    draw_grid(&mut svg, grid, &plane);
    draw_viewport(&mut svg, grid, &plane);
    draw_steps(&mut svg, grid, &plane);
    draw_pixel(&mut svg, grid, &plane);
    draw_numbers(&mut svg, grid);
    svg
}

/// The edges of all pixels, of which one is marked, and where their rays go through.
fn draw_grid(svg: &mut Svg, grid: &Grid, plane: &Plane) {
    let camera = &grid.camera;
    let (width, height) = (camera.image_width, camera.image_height);
    let [u, v] = grid.viewport().map(|edge| plane.vector(edge));
    let step = plane.vector(camera.pixel_delta_u + camera.pixel_delta_v);
    let [i, j] = grid.pixel.map(f64::from);
    svg.rect("viewport wash", CORNER, u + v);
    svg.rect("ray area", CORNER + step * DVec2::new(i, j), step);
    for i in 0..=width {
        let top = CORNER + DVec2::new(step.x * f64::from(i), 0.0);
        svg.line("faint thin", top, top + v);
    }
    for j in 0..=height {
        let left = CORNER + DVec2::new(0.0, step.y * f64::from(j));
        svg.line("faint thin", left, left + u);
    }
    let pixels = (0..height).flat_map(|j| (0..width).map(move |i| [i, j]));
    let points = pixels.map(|pixel| plane.point(grid.place(pixel)));
    svg.dots("faint", points, (step.x / 3.0).min(5.0));
}

/// The two edges from the corner.
fn draw_viewport(svg: &mut Svg, grid: &Grid, plane: &Plane) {
    let [u, v] = grid.viewport().map(|edge| plane.vector(edge));
    svg.arrow("viewport bold", CORNER, CORNER + u);
    svg.arrow("viewport bold", CORNER, CORNER + v);
    svg.circle("viewport solid", CORNER, 5.0);
    let beside = CORNER + DVec2::new(-8.0, -9.0);
    svg.label("viewport", beside, Anchor::End, "**V**_{0}");
    let above = CORNER + 0.5 * u + DVec2::new(0.0, -10.0);
    svg.label("viewport", above, Anchor::Middle, "**V**_{u}");
    // Far below the first row, where its P is.
    let left = CORNER + 0.85 * v + DVec2::new(-12.0, 4.0);
    svg.label("viewport", left, Anchor::End, "**V**_{v}");
}

/// The first point, and from there the steps to its neighbors, as far as there are any.
fn draw_steps(svg: &mut Svg, grid: &Grid, plane: &Plane) {
    let first = plane.point(grid.place([0, 0]));
    let camera = &grid.camera;
    let [u, v] = [camera.pixel_delta_u, camera.pixel_delta_v].map(|step| plane.vector(step));
    let has_room = u.x >= LABELED;
    if camera.image_width > 1 && has_room {
        svg.arrow("ray bold", first, first + u);
        let above = first + 0.5 * u + DVec2::new(0.0, -6.0);
        svg.label("ray", above, Anchor::Middle, "Δ**u**");
    }
    if camera.image_height > 1 && has_room {
        svg.arrow("ray bold", first, first + v);
        let beside = first + 0.5 * v + DVec2::new(8.0, 0.0);
        svg.label("ray", beside, Anchor::Start, "Δ**v**");
    }
    let beside = DVec2::new(CORNER.x - 10.0, first.y);
    svg.line("faint dashed", beside, first);
    svg.circle("ink solid", first, (u.x / 3.0).min(5.0));
    let words = beside + DVec2::new(-4.0, 5.0);
    svg.label("ink", words, Anchor::End, "**P**_{0,0}");
}

/// The least width of a pixel on the sheet at which there is room for arrows and their names.
const LABELED: f64 = 26.0;

/// The point of the marked pixel, and its name.
fn draw_pixel(svg: &mut Svg, grid: &Grid, plane: &Plane) {
    let [i, j] = grid.pixel;
    let camera = &grid.camera;
    let step = plane.vector(camera.pixel_delta_u);
    let point = plane.point(grid.place(grid.pixel));
    svg.circle("ink solid", point, (step.x / 3.0).min(5.0));
    if grid.pixel == [0, 0] {
        return;
    }
    // Towards the middle there is always room.
    let (right, anchor) = match 2 * i < camera.image_width {
        true => (16.0, Anchor::Start),
        false => (-16.0, Anchor::End),
    };
    let down = match 2 * j < camera.image_height {
        true => 22.0,
        false => -14.0,
    };
    let name = format!("**P**_{{{i},{j}}}");
    svg.label("ink", point + DVec2::new(right, down), anchor, &name);
}

/// The vectors in numbers, below the grid in two columns, and the ratio.
fn draw_numbers(svg: &mut Svg, grid: &Grid) {
    let camera = &grid.camera;
    let [u, v] = grid.viewport();
    let [i, j] = grid.pixel;
    let pixel = format!("**P**_{{{i},{j}}}");
    let vectors = [
        ("viewport", "**V**_{u}", u),
        ("viewport", "**V**_{v}", v),
        ("ray", "Δ**u**", camera.pixel_delta_u),
        ("ray", "Δ**v**", camera.pixel_delta_v),
        ("viewport", "**V**_{0}", grid.corner()),
        ("ink", "**P**_{0,0}", grid.place([0, 0])),
        ("ink", &pixel, grid.place(grid.pixel)),
    ];
    let at = |column: f64, row: f64| DVec2::new(14.0 + 190.0 * column, 234.0 + 24.0 * row);
    for ((idea, name, vector), place) in vectors.into_iter().zip(0_u32..) {
        let words = format!("{name} = {}", triple(vector));
        let at = at((place % 2).into(), (place / 2).into());
        svg.label(idea, at, Anchor::Start, &words);
    }
    let (width, height) = (camera.image_width, camera.image_height);
    let [real, ideal] = [f64::from(width) / f64::from(height), 16.0 / 9.0].map(spoken);
    let ratio = format!("{width} : {height} = {real}, where 16 : 9 = {ideal}");
    svg.label("ink", at(0.0, 4.0), Anchor::Start, &ratio);
}

/// A vector in digits.
fn triple(vector: Vec3) -> String {
    let [x, y, z] = vector.to_array().map(spoken);
    format!("({x}, {y}, {z})")
}
