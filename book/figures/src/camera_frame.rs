//! Figure 3 of the notes, turned by the reader: the eye, the viewport, and the rays of a row
//! of pixels, in perspective.

use common::rtweekend::*;
use glam::DVec2;
use normals::hit_sphere;

use crate::figure::Figure;
use crate::live::{Action, Answer, Handle, Live, Number, parameters};
use crate::number::spoken;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "camera_frame",
    title: "The eye, the viewport, and the rays of a row",
    description: "Seen from the right, from behind and a little from above. From the eye at the \
        origin three axes start: x to the right, y up, and z back. The viewport, a rectangle of \
        16 by 9 pixels, stands upright ahead of the eye, across the negative z axis. A ray goes \
        from the eye through the middle of each pixel of one row, and on. In the middle of the \
        viewport is the sphere of chapter 2, at which six of the rays end.",
    caption: "The eye is where the axes meet, and looks along −*z* through a viewport that \
        is one focal length away. A ray goes through the middle of each pixel; here is a row of \
        them, and the sphere that chapter 2 will put there.",
    draw: || LIVE.on_page(),
};

parameters! {
    turn: Number::whole("Turn, in degrees", -180.0, 180.0, 60.0),
    tilt: Number::whole("Tilt, in degrees", -90.0, 90.0, 20.0),
    row: Number {
        downwards: true,
        ..Number::whole("Row j", 0.0, 8.0, 4.0)
    },
}

/// The figure, as a reader turns it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: FIGURE,
    question: "In which rows do rays meet the sphere? And what do all rays have in common? Turn the scene, \
        and choose the row.",
    solution: "In the rows 2 to 6. All rays start in the eye. So they spread, and what is far away takes \
        fewer of them: it looks small.",
    handles: &[Handle::new(&["turn", "tilt"], |it, to| {
        let way = (to - KNOB) / KNOB_ROOM;
        [it.turn, it.tilt] = [180.0 * way.x, -90.0 * way.y];
    })],
    actions: &[
        Action::new("From behind", |it| it.look(0.0, 0.0)),
        Action::new("From the side", |it| it.look(90.0, 0.0)),
        Action::new("From above", |it| it.look(0.0, 90.0)),
    ],
    answer,
};

impl Parameters {
    /// Looks at the scene from that side.
    fn look(&mut self, turn: f64, tilt: f64) {
        [self.turn, self.tilt] = [turn, tilt];
    }
}

/// The sphere of chapter 2.
const CENTER: Point3 = Point3::new(0.0, 0.0, -1.0);
const RADIUS: f64 = 0.5;

fn answer(parameters: &Parameters) -> Answer {
    let camera = Camera::with_size(16, 9);
    let row = parameters.row as u32;
    let rays = (0..camera.image_width).map(|i| camera.ray(i, row));
    let rays: Vec<(Ray, Option<f64>)> = rays
        .map(|ray| (ray, hit_sphere(CENTER, RADIUS, &ray)))
        .collect();
    let meet = rays.iter().filter(|(_, t)| t.is_some()).count();
    let height = spoken(rays[0].0.direction.y);
    let meet = match meet {
        0 => "none of its rays meets the sphere".to_owned(),
        _ => format!("{meet} of its {} rays meet the sphere", rays.len()),
    };
    Answer {
        drawing: draw(&View::new(parameters), &camera, row, &rays),
        sentence: format!("Row {row}, at *y* = {height}: {meet}."),
        handles: vec![knob(parameters)],
        says: vec![],
    }
}

/// Where the scene is looked at from.
struct View {
    right: Vec3,
    up: Vec3,
    /// From the scene towards whoever looks.
    back: Vec3,
}

impl View {
    /// From behind the eye, turned to the right and tilted upwards.
    fn new(parameters: &Parameters) -> Self {
        let (sin_turn, cos_turn) = parameters.turn.to_radians().sin_cos();
        let (sin_tilt, cos_tilt) = parameters.tilt.to_radians().sin_cos();
        let right = Vec3::new(cos_turn, 0.0, -sin_turn);
        let back = Vec3::new(sin_turn * cos_tilt, sin_tilt, cos_turn * cos_tilt);
        let up = back.cross(right);
        Self { right, up, back }
    }

    /// Whoever looks.
    fn place(&self) -> Point3 {
        PIVOT + DISTANCE * self.back
    }

    /// A point of the scene on the sheet, in perspective.
    fn point(&self, point: Point3) -> DVec2 {
        let way = point - PIVOT;
        let scale = ZOOM / (DISTANCE - way.dot(self.back));
        MIDDLE + scale * DVec2::new(way.dot(self.right), -way.dot(self.up))
    }

    /// A circle of the scene, around a unit normal.
    fn circle(&self, center: Point3, radius: f64, normal: Vec3) -> [DVec2; 49] {
        let (one, other) = normal.any_orthonormal_pair();
        std::array::from_fn(|n| {
            let (sin, cos) = (std::f64::consts::TAU * n as f64 / 48.0).sin_cos();
            self.point(center + radius * (cos * one + sin * other))
        })
    }
}

/// What the scene turns around, and how far away it is looked at from.
const PIVOT: Point3 = Point3::new(0.0, 0.0, -0.7);
const DISTANCE: f64 = 7.0;

/// Where the pivot is on the sheet, and how large what is 1 unit away.
const MIDDLE: DVec2 = DVec2::new(200.0, 140.0);
const ZOOM: f64 = 620.0;

/// Where the knob is that turns the scene, and how far it can be moved.
const KNOB: DVec2 = DVec2::new(200.0, 302.0);
const KNOB_ROOM: DVec2 = DVec2::new(150.0, 26.0);

fn knob(&Parameters { turn, tilt, .. }: &Parameters) -> DVec2 {
    KNOB + KNOB_ROOM * DVec2::new(turn / 180.0, -tilt / 90.0)
}

/// How far a ray is drawn that meets nothing.
const FAR: f64 = 1.4;

fn draw(view: &View, camera: &Camera, row: u32, rays: &[(Ray, Option<f64>)]) -> Svg {
    let mut svg = FIGURE.sheet(400.0, 336.0);
    draw_viewport(&mut svg, view, camera, row);
    draw_sphere(&mut svg, view);
    for (ray, t) in rays {
        let end = view.point(ray.at(t.unwrap_or(FAR)));
        svg.line("ray thin", view.point(ray.origin), end);
        if t.is_some() {
            svg.circle("ray solid", end, 2.5);
        }
    }
    draw_axes(&mut svg, view, camera.center);
    draw_knob(&mut svg);
    svg
}

/// The pixels, those of the row filled.
fn draw_viewport(svg: &mut Svg, view: &View, camera: &Camera, row: u32) {
    let (width, height) = (camera.image_width, camera.image_height);
    let corner = |i: u32, j: u32| {
        let across = (f64::from(i) - 0.5) * camera.pixel_delta_u;
        view.point(camera.pixel00 + across + (f64::from(j) - 0.5) * camera.pixel_delta_v)
    };
    let strip = |j: u32, end: u32| {
        [(0, j), (width, j), (width, end), (0, end), (0, j)].map(|(i, j)| corner(i, j))
    };
    svg.path("viewport area", &strip(0, height));
    svg.path("viewport wash", &strip(row, row + 1));
    for i in 1..width {
        svg.line("grid thin", corner(i, 0), corner(i, height));
    }
    for j in 1..height {
        svg.line("grid thin", corner(0, j), corner(width, j));
    }
}

/// Its outline, where the lines of sight touch it, and its equator.
fn draw_sphere(svg: &mut Svg, view: &View) {
    let way = view.place() - CENTER;
    let distance = way.length();
    let towards = way * (1.0 / distance);
    let nearer = RADIUS * RADIUS / distance;
    let radius = (RADIUS * RADIUS - nearer * nearer).sqrt();
    let outline = view.circle(CENTER + nearer * towards, radius, towards);
    svg.path("sphere area", &outline);
    svg.path("sphere thin", &view.circle(CENTER, RADIUS, Vec3::Y));
}

fn draw_axes(svg: &mut Svg, view: &View, eye: Point3) {
    for (axis, name) in [(Vec3::X, "*x*"), (Vec3::Y, "*y*"), (Vec3::Z, "*z*")] {
        svg.arrow("ink line", view.point(eye), view.point(eye + 0.7 * axis));
        let beyond = view.point(eye + 0.85 * axis) + DVec2::new(0.0, 5.0);
        svg.label("ink", beyond, Anchor::Middle, name);
    }
    svg.circle("ink solid", view.point(eye), 5.0);
    let below = view.point(eye) + DVec2::new(0.0, 24.0);
    svg.label("ink", below, Anchor::Middle, "eye");
}

/// What the knob slides on.
fn draw_knob(svg: &mut Svg) {
    let [across, up] = [DVec2::new(KNOB_ROOM.x, 0.0), DVec2::new(0.0, KNOB_ROOM.y)];
    svg.line("faint thin", KNOB - across, KNOB + across);
    svg.line("faint thin", KNOB - up, KNOB + up);
    let beside = KNOB + across + DVec2::new(0.0, 20.0);
    svg.small_label("faint", beside, Anchor::End, "drag to turn");
}
