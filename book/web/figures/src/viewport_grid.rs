//! Figure 4 of the notes: the viewport and its grid of pixels. The width of the picture
//! changes, and the marked pixel moves.

use crate::prelude::*;

parameters! {
    width: f64 = Parameter::whole("Width", 1.0, 11.0, 8.0);
    pixel: Vec3 =
        Parameter {
            most_beside: Some(|numbers| f64::from(Camera::new(numbers[0] as u32).image_width - 1)),
            ..Parameter::whole("Column i", 0.0, 10.0, 5.0)
        },
        Parameter {
            most_beside: Some(|numbers| f64::from(Camera::new(numbers[0] as u32).image_height - 1)),
            downwards: true,
            ..Parameter::whole("Row j", 0.0, 5.0, 2.0)
        };
}

/// The live figure: a reader changes the width of the picture, whose height follows in jumps, and
/// chooses a pixel.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: figure!("viewport_grid"),
    handles: &[Handle {
        field: "pixel",
        at: |it| Grid::of(it).at(Grid::of(it).pixel),
        drag: |it, to| it.pixel = Grid::of(it).pixel_at(to),
    }],
    // The pixel stays, where there is one.
    actions: &[
        ("1 wide", |it| it.width = 1.0),
        ("7 wide", |it| it.width = 7.0),
        ("11 wide", |it| it.width = 11.0),
    ],
    answer,
};

fn answer(chosen: &Parameters) -> DrawnFigure {
    let grid = Grid::of(chosen);
    let Camera {
        image_width: width,
        image_height: height,
        ..
    } = grid.camera;
    let [i, j] = grid.pixel;
    let direction = triple(grid.camera.ray(i, j).direction);
    let rows = if height == 1 { "row" } else { "rows" };
    let rows = format!("{height} {rows}");
    let because = because(width);
    let sentence = format!(
        "The ray of pixel ({i}, {j}) has the direction {direction}. A picture {width} wide has \
        {rows}: {because}."
    );
    let says = [
        ("width", width.to_string()),
        ("rows", rows),
        ("because", because),
        ("pixel", format!("({i}, {j})")),
        ("direction", direction),
    ];
    DrawnFigure::new(draw(&grid), sentence, says)
}

/// Says why a picture of this width has so many rows.
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

/// The pixels of a viewport, of which one is marked.
struct Grid {
    /// The camera whose viewport it is.
    camera: Camera,
    /// The marked pixel: its column and its row, from 0 at the upper left.
    pixel: [u32; 2],
    /// The upper edge of the viewport from left to right, and its left edge downwards.
    edges: [Vec3; 2],
    /// The upper left corner of the viewport, by the formula of the page.
    corner: Point3,
    /// The place of the scene on the sheet, so that the viewport fills the room in width or in
    /// height.
    plane: Plane,
}

impl Grid {
    /// Makes the grid of the chapter's camera for these parameters.
    fn of(chosen: &Parameters) -> Self {
        let camera = Camera::new(chosen.width as u32);
        let u = f64::from(camera.image_width) * camera.pixel_delta_u;
        let v = f64::from(camera.image_height) * camera.pixel_delta_v;
        let corner = camera.center - Vec3::Z - 0.5 * u - 0.5 * v;
        let scale = (ROOM.x / u.x).min(ROOM.y / -v.y);
        let origin = CORNER - scale * spot(corner.x, -corner.y);
        Self {
            camera,
            pixel: [chosen.pixel.x, chosen.pixel.y].map(|it| it as u32),
            edges: [u, v],
            corner,
            plane: Plane { origin, scale },
        }
    }

    /// Returns the point of the scene through which the ray of a pixel goes.
    fn place(&self, [i, j]: [u32; 2]) -> Point3 {
        self.camera.ray(i, j).at(1.0)
    }

    /// Returns the place on the sheet of the point through which the ray of a pixel goes.
    fn at(&self, pixel: [u32; 2]) -> DVec2 {
        self.plane.point(self.place(pixel))
    }

    /// Returns the column and the row, with fractions, at a place on the sheet.
    fn pixel_at(&self, to: DVec2) -> Vec3 {
        let way = self.plane.place(to) - self.camera.pixel00;
        let along = |step: Vec3| way.dot(step) / step.length_squared();
        xy(
            along(self.camera.pixel_delta_u),
            along(self.camera.pixel_delta_v),
        )
    }

    /// Returns the vectors on the sheet from a pixel to its neighbors on the right and below.
    fn steps(&self) -> [DVec2; 2] {
        let steps = [self.camera.pixel_delta_u, self.camera.pixel_delta_v];
        steps.map(|step| self.plane.vector(step))
    }
}

/// The upper left corner of the viewport on the sheet.
const CORNER: DVec2 = spot(84.0, 40.0);

/// The greatest size of the viewport on the sheet.
const ROOM: DVec2 = spot(288.0, 164.0);

/// Draws the pixels with their points and vectors, and below them the numbers.
fn draw(grid: &Grid) -> Svg {
    let mut svg = LIVE.figure.sheet(326.0);
    draw_grid(&mut svg, grid);
    draw_viewport(&mut svg, grid);
    draw_steps(&mut svg, grid);
    draw_pixel(&mut svg, grid);
    draw_numbers(&mut svg, grid);
    svg
}

/// Draws the edges of all pixels, of which one is marked, and a dot where each ray goes through.
fn draw_grid(svg: &mut Svg, grid: &Grid) {
    let (width, height) = (grid.camera.image_width, grid.camera.image_height);
    let [u, v] = grid.steps();
    let corner = |i: u32, j: u32| CORNER + f64::from(i) * u + f64::from(j) * v;
    let [i, j] = grid.pixel;
    svg.rect("viewport wash", CORNER, corner(width, height) - CORNER);
    svg.rect("ray area", corner(i, j), u + v);
    for i in 0..=width {
        svg.line("faint thin", corner(i, 0), corner(i, height));
    }
    for j in 0..=height {
        svg.line("faint thin", corner(0, j), corner(width, j));
    }
    let pixels = (0..height).flat_map(|j| (0..width).map(move |i| [i, j]));
    for pixel in pixels {
        svg.circle("faint solid", grid.at(pixel), 0.5 * DOT);
    }
}

/// Draws the two edges of the viewport as vectors from its corner.
fn draw_viewport(svg: &mut Svg, grid: &Grid) {
    let [u, v] = grid.edges.map(|edge| grid.plane.vector(edge));
    svg.vector("viewport", CORNER, CORNER + u, "**V**_{u}");
    svg.arrow("viewport bold", CORNER, CORNER + v);
    svg.dot("viewport", CORNER, UpperLeft, "**V**_{0}");
    // Far below the first row, where its P is.
    svg.label("viewport", CORNER + 0.85 * v, Left, "**V**_{v}");
}

/// Draws the point of the first pixel, and the vectors to its neighbors, if there are any.
fn draw_steps(svg: &mut Svg, grid: &Grid) {
    let ([u, v], first) = (grid.steps(), grid.at([0, 0]));
    if grid.camera.image_width > 1 {
        svg.arrow("ray bold", first, first + u);
        svg.label("ray", (first + 0.5 * u).down(-6.0), Middle, "Δ**u**");
    }
    if grid.camera.image_height > 1 {
        svg.arrow("ray bold", first, first + v);
        svg.label("ray", (first + 0.5 * v).right(8.0), Start, "Δ**v**");
    }
    let beside = spot(CORNER.x - 10.0, first.y);
    svg.line("faint dashed", beside, first);
    svg.circle("ink solid", first, DOT);
    svg.label("ink", beside, Left, "**P**_{0,0}");
}

/// The radius of the dot of a pixel.
const DOT: f64 = 5.0;

/// Draws the point of the marked pixel, and its name.
fn draw_pixel(svg: &mut Svg, grid: &Grid) {
    let [i, j] = grid.pixel;
    let point = grid.at([i, j]);
    svg.circle("ink solid", point, DOT);
    if [i, j] == [0, 0] {
        return;
    }
    // Towards the middle there is always room.
    let is_left = 2 * i < grid.camera.image_width;
    let is_upper = 2 * j < grid.camera.image_height;
    let (right, anchor) = if is_left { (16.0, Start) } else { (-16.0, End) };
    let down = if is_upper { 22.0 } else { -14.0 };
    let name = format!("**P**_{{{i},{j}}}");
    svg.label("ink", point + spot(right, down), anchor, &name);
}

/// Writes the vectors in numbers, in two columns below the grid.
fn draw_numbers(svg: &mut Svg, grid: &Grid) {
    let [i, j] = grid.pixel;
    let [u, v] = grid.edges.map(triple);
    let left = [
        format!("**V**_{{u}} = {u}"),
        format!("Δ**u** = {}", triple(grid.camera.pixel_delta_u)),
        format!("**V**_{{0}} = {}", triple(grid.corner)),
        format!("**P**_{{{i},{j}}} = {}", triple(grid.place([i, j]))),
    ];
    let right = [
        format!("**V**_{{v}} = {v}"),
        format!("Δ**v** = {}", triple(grid.camera.pixel_delta_v)),
        format!("**P**_{{0,0}} = {}", triple(grid.place([0, 0]))),
    ];
    svg.readout(spot(14.0, 238.0), &left);
    svg.readout(spot(204.0, 238.0), &right);
}
