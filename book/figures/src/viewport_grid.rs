//! Figure 4 of the notes: the viewport and its grid of pixels. The width of the picture
//! changes, and the marked pixel moves.

use slips::Chapter;

use crate::vocabulary::*;

parameters! {
    width: f64 = Number::whole("Width", 1.0, 40.0, 8.0);
    pixel: Vec3 =
        Number {
            most_beside: Some(|numbers| f64::from(Camera::new(numbers[0] as u32).image_width - 1)),
            ..Number::whole("Column i", 0.0, 39.0, 5.0)
        },
        Number {
            most_beside: Some(|numbers| f64::from(Camera::new(numbers[0] as u32).image_height - 1)),
            downwards: true,
            ..Number::whole("Row j", 0.0, 21.0, 2.0)
        };
    first: f64 = Number::choice("The first P", CHOICES);
}

/// The figure, as a reader moves it: the height jumps, and a pixel has its ray.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: Figure {
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
    },
    question: "At which widths does the picture gain a row? And where does the ray of the marked \
        pixel go, if the half pixel is forgotten?",
    solution: "At 4, 6, 8, 9, 11 and so on: wherever 9/16 of the width passes a whole number. Without the half \
        pixel it goes to the upper left corner of its pixel.",
    handles: &[Handle {
        field: "pixel",
        at: |it| it.grid().at(it.grid().pixel),
        drag: |it, to| it.pixel = it.grid().pixel_at(to),
    }],
    // The pixel stays, where there is one.
    actions: &[
        ("1 wide", |it| it.width = 1.0),
        ("16 wide", |it| it.width = 16.0),
        ("40 wide", |it| it.width = 40.0),
    ],
    answer,
};

/// What may be wrong at the first point: the name of the slip in the catalogue.
const SLIPS: [&str; 1] = ["grid-not-inset"];
const CHOICES: &[&str] = &["half a pixel in", "at the corner"];

impl Parameters {
    /// The camera of the chapter.
    fn right(&self) -> Camera {
        Camera::new(self.width as u32)
    }

    /// The grid of the camera that is shown.
    fn grid(&self) -> Grid {
        let right = self.right();
        let slip = chosen(self.first, &SLIPS).map(|slip| slip.program(Chapter::Gradient));
        let camera = slip.map_or(right, |program| program.camera(right.image_width));
        let pixel = [self.pixel.x, self.pixel.y].map(|it| it as u32);
        Grid { camera, pixel }
    }
}

fn answer(parameters: &Parameters) -> Answer {
    let grid = parameters.grid();
    let width = grid.camera.image_width;
    let [i, j] = grid.pixel;
    let right = parameters.right().ray(i, j).direction;
    let (rows, because) = (rows(width), because(width));
    let sentence = format!(
        "{} A picture {width} wide has {rows}: {because}.",
        way(&grid, right)
    );
    let says = vec![
        ("width", width.to_string()),
        ("rows", rows),
        ("because", because),
        ("pixel", format!("({i}, {j})")),
        ("direction", triple(right)),
    ];
    Answer::new(draw(&grid), sentence, says)
}

/// Where the ray of the pixel goes, and that it should go to the `right`.
fn way(grid: &Grid, right: Vec3) -> String {
    let [i, j] = grid.pixel;
    let way = grid.camera.ray(i, j).direction;
    let said = format!(
        "The ray of pixel ({i}, {j}) has the direction {}",
        triple(way)
    );
    if way == right {
        return said + ".";
    }
    let right = triple(right);
    format!("{said}, to its corner: half a pixel up and to the left of {right}.")
}

/// Why there are so many rows.
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
        let origin = CORNER - scale * DVec2::new(corner.x, -corner.y);
        Plane { origin, scale }
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

    /// The same on the sheet.
    fn at(&self, pixel: [u32; 2]) -> DVec2 {
        self.plane().point(self.place(pixel))
    }

    /// The column and the row that are there on the sheet.
    fn pixel_at(&self, to: DVec2) -> Vec3 {
        let camera = &self.camera;
        let way = self.plane().place(to) - camera.pixel00;
        let along = |step: Vec3| way.dot(step) / step.length_squared();
        xy(along(camera.pixel_delta_u), along(camera.pixel_delta_v))
    }
}

/// Where the upper left corner of the viewport is on the sheet.
const CORNER: DVec2 = DVec2::new(84.0, 40.0);

/// How large the viewport can be there.
const ROOM: DVec2 = DVec2::new(288.0, 164.0);

/// Draws the grid with its points and vectors, and the numbers below.
fn draw(grid: &Grid) -> Svg {
    let mut svg = LIVE.figure.sheet(346.0);
    draw_grid(&mut svg, grid);
    draw_viewport(&mut svg, grid);
    draw_steps(&mut svg, grid);
    draw_pixel(&mut svg, grid);
    draw_numbers(&mut svg, grid);
    svg
}

/// The edges of all pixels, of which one is marked, and where their rays go through.
fn draw_grid(svg: &mut Svg, grid: &Grid) {
    let (camera, plane) = (&grid.camera, grid.plane());
    let (width, height) = (camera.image_width, camera.image_height);
    let [u, v] = grid.viewport().map(|edge| plane.vector(edge));
    let step = plane.vector(camera.pixel_delta_u + camera.pixel_delta_v);
    let corner = |[i, j]: [u32; 2]| CORNER + step * DVec2::new(i.into(), j.into());
    svg.rect("viewport wash", CORNER, u + v);
    svg.rect("ray area", corner(grid.pixel), step);
    for i in 0..=width {
        svg.line("faint thin", corner([i, 0]), corner([i, height]));
    }
    for j in 0..=height {
        svg.line("faint thin", corner([0, j]), corner([width, j]));
    }
    let pixels = (0..height).flat_map(|j| (0..width).map(move |i| [i, j]));
    let points = pixels.map(|pixel| plane.point(grid.place(pixel)));
    svg.dots("faint", points, (step.x / 3.0).min(5.0));
}

/// The two edges from the corner.
fn draw_viewport(svg: &mut Svg, grid: &Grid) {
    let [u, v] = grid.viewport().map(|edge| grid.plane().vector(edge));
    svg.vector("viewport", CORNER, CORNER + u, "**V**_{u}");
    svg.arrow("viewport bold", CORNER, CORNER + v);
    svg.dot("viewport", CORNER, UpperLeft, "**V**_{0}");
    // Far below the first row, where its P is.
    svg.label("viewport", CORNER + 0.85 * v, Left, "**V**_{v}");
}

/// The first point, and from there the steps to its neighbors, as far as there are any.
fn draw_steps(svg: &mut Svg, grid: &Grid) {
    let (camera, first) = (&grid.camera, grid.at([0, 0]));
    let steps = [camera.pixel_delta_u, camera.pixel_delta_v];
    let [u, v] = steps.map(|step| grid.plane().vector(step));
    let has_room = u.x >= LABELED;
    if camera.image_width > 1 && has_room {
        svg.arrow("ray bold", first, first + u);
        let above = first + 0.5 * u - DVec2::new(0.0, 6.0);
        svg.label("ray", above, Middle, "Δ**u**");
    }
    if camera.image_height > 1 && has_room {
        svg.arrow("ray bold", first, first + v);
        let beside = first + 0.5 * v + DVec2::new(8.0, 0.0);
        svg.label("ray", beside, Start, "Δ**v**");
    }
    let beside = DVec2::new(CORNER.x - 10.0, first.y);
    svg.line("faint dashed", beside, first);
    svg.circle("ink solid", first, (u.x / 3.0).min(5.0));
    svg.label("ink", beside, Left, "**P**_{0,0}");
}

/// The least width of a pixel on the sheet at which there is room for arrows and their names.
const LABELED: f64 = 26.0;

/// The point of the marked pixel, and its name.
fn draw_pixel(svg: &mut Svg, grid: &Grid) {
    let ([i, j], camera) = (grid.pixel, &grid.camera);
    let step = grid.plane().vector(camera.pixel_delta_u);
    let point = grid.at(grid.pixel);
    svg.circle("ink solid", point, (step.x / 3.0).min(5.0));
    if grid.pixel == [0, 0] {
        return;
    }
    // Towards the middle there is always room.
    let is_left = 2 * i < camera.image_width;
    let is_upper = 2 * j < camera.image_height;
    let (right, anchor) = if is_left { (16.0, Start) } else { (-16.0, End) };
    let down = if is_upper { 22.0 } else { -14.0 };
    let name = format!("**P**_{{{i},{j}}}");
    svg.label("ink", point + DVec2::new(right, down), anchor, &name);
}

/// The vectors in numbers, below the grid in two columns, and the ratio.
fn draw_numbers(svg: &mut Svg, grid: &Grid) {
    let (camera, [i, j]) = (&grid.camera, grid.pixel);
    let (width, height) = (camera.image_width, camera.image_height);
    let [u, v] = grid.viewport().map(triple);
    let [delta_u, delta_v] = [camera.pixel_delta_u, camera.pixel_delta_v].map(triple);
    let [first, pixel] = [[0, 0], grid.pixel].map(|it| triple(grid.place(it)));
    let [real, ideal] = [f64::from(width) / f64::from(height), 16.0 / 9.0].map(spoken);
    let left = [
        format!("**V**_{{u}} = {u}"),
        format!("Δ**u** = {delta_u}"),
        format!("**V**_{{0}} = {}", triple(grid.corner())),
        format!("**P**_{{{i},{j}}} = {pixel}"),
        format!("{width} : {height} = {real}, where 16 : 9 = {ideal}"),
    ];
    let right = [
        format!("**V**_{{v}} = {v}"),
        format!("Δ**v** = {delta_v}"),
        format!("**P**_{{0,0}} = {first}"),
    ];
    svg.readout(DVec2::new(14.0, 238.0), &left);
    svg.readout(DVec2::new(204.0, 238.0), &right);
}
