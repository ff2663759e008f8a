//! Figure 3 of the notes, turned by the reader: the eye, the viewport, and the rays of a row
//! of pixels, in perspective.

use normals::hit_sphere;

use crate::prelude::*;

parameters! {
    side: Vec3 =
        Parameter::whole("Turn, in degrees", -180.0, 180.0, 60.0),
        Parameter::whole("Tilt, in degrees", -90.0, 90.0, 20.0);
    row: f64 = Parameter {
        downwards: true,
        ..Parameter::whole("Row j", 0.0, 8.0, 4.0)
    };
}

/// The live figure: the camera's scene in perspective, which a reader turns, and one row of rays.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: figure!("camera_frame"),
    handles: &[Handle {
        field: "side",
        at: |it| KNOB + KNOB_ROOM * spot(it.side.x / 180.0, -it.side.y / 90.0),
        drag: |it, to| {
            let way = (to - KNOB) / KNOB_ROOM;
            it.side = xy(180.0 * way.x, -90.0 * way.y);
        },
    }],
    actions: &[
        ("From behind", |it| it.side = xy(0.0, 0.0)),
        ("From the side", |it| it.side = xy(90.0, 0.0)),
        ("From above", |it| it.side = xy(0.0, 90.0)),
    ],
    answer,
};

/// The sphere of chapter 2.
const CENTER: Point3 = Point3::new(0.0, 0.0, -1.0);
const RADIUS: f64 = 0.5;

/// Draws the figure and says how many rays of the chosen row meet the sphere.
fn answer(&Parameters { side, row }: &Parameters) -> DrawnFigure {
    let camera = Camera::with_size(16, 9);
    let rays: Vec<Ray> = (0..16).map(|i| camera.ray(i, row as u32)).collect();
    let meet = |ray: &&Ray| hit_sphere(CENTER, RADIUS, ray).is_some();
    let height = spoken(rays[0].direction.y);
    let meet = match rays.iter().filter(meet).count() {
        0 => "none of its rays meets the sphere".to_owned(),
        count => format!("{count} of its {} rays meet the sphere", rays.len()),
    };
    let sentence = format!("Row {row}, at *y* = {height}: {meet}.");
    let drawing = draw(&OutsideView::new(side), &camera, row as u32, &rays);
    DrawnFigure::new(drawing, sentence, [])
}

/// The view of somebody who looks at the camera and its scene from outside, in perspective.
struct OutsideView {
    /// The unit vector of the scene that points to the right on the sheet.
    right: Vec3,
    /// The unit vector of the scene that points upwards on the sheet.
    up: Vec3,
    /// The unit vector from the scene towards the viewer.
    back: Vec3,
}

impl OutsideView {
    /// Makes the view from behind the camera, turned by `side.x` degrees to the right and tilted
    /// upwards by `side.y` degrees.
    fn new(side: Vec3) -> Self {
        let (sin_turn, cos_turn) = side.x.to_radians().sin_cos();
        let (sin_tilt, cos_tilt) = side.y.to_radians().sin_cos();
        let right = Vec3::new(cos_turn, 0.0, -sin_turn);
        let back = Vec3::new(sin_turn * cos_tilt, sin_tilt, cos_turn * cos_tilt);
        let up = back.cross(right);
        Self { right, up, back }
    }

    /// Returns the place on the sheet where a point of the scene is seen.
    fn point(&self, point: Point3) -> DVec2 {
        let way = point - PIVOT;
        let scale = ZOOM / (DISTANCE - way.dot(self.back));
        MIDDLE + scale * spot(way.dot(self.right), -way.dot(self.up))
    }

    /// Returns points on the sheet along a circle of the scene, which lies at right angles to a
    /// unit `normal`. The last point is the first again.
    fn circle(&self, center: Point3, radius: f64, normal: Vec3) -> [DVec2; 49] {
        let (one, other) = normal.any_orthonormal_pair();
        std::array::from_fn(|n| {
            let (sin, cos) = (std::f64::consts::TAU * n as f64 / 48.0).sin_cos();
            self.point(center + radius * (cos * one + sin * other))
        })
    }
}

/// The point that the scene turns around, and its distance from the viewer.
const PIVOT: Point3 = Point3::new(0.0, 0.0, -0.7);
const DISTANCE: f64 = 7.0;

/// The place of the pivot on the sheet, and the size on the sheet of a unit at distance 1.
const MIDDLE: DVec2 = spot(200.0, 140.0);
const ZOOM: f64 = 620.0;

/// The place on the sheet of the knob that turns the scene, and how far it slides across and
/// upwards.
const KNOB: DVec2 = spot(200.0, 302.0);
const KNOB_ROOM: DVec2 = spot(150.0, 26.0);

/// The t up to which a ray is drawn that meets nothing.
const FAR: f64 = 1.4;

fn draw(view: &OutsideView, camera: &Camera, row: u32, rays: &[Ray]) -> Svg {
    let mut svg = LIVE.figure.sheet(336.0);
    draw_viewport(&mut svg, view, camera, row);
    draw_sphere(&mut svg, view);
    for ray in rays {
        let hit = hit_sphere(CENTER, RADIUS, ray);
        let end = view.point(ray.at(hit.unwrap_or(FAR)));
        svg.line("ray thin", view.point(ray.origin), end);
        if hit.is_some() {
            svg.circle("ray solid", end, 2.5);
        }
    }
    draw_axes(&mut svg, view, camera.center);
    draw_knob(&mut svg);
    svg
}

/// Draws the pixels of the viewport: those of `row` filled.
fn draw_viewport(svg: &mut Svg, view: &OutsideView, camera: &Camera, row: u32) {
    let (width, height) = (camera.image_width, camera.image_height);
    let (u, v) = (camera.pixel_delta_u, camera.pixel_delta_v);
    let first = camera.pixel00 - 0.5 * (u + v);
    let corner = |i: u32, j: u32| view.point(first + f64::from(i) * u + f64::from(j) * v);
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

/// Draws the sphere's outline, where lines of sight touch it, and its equator.
fn draw_sphere(svg: &mut Svg, view: &OutsideView) {
    let (towards, distance) = (PIVOT + DISTANCE * view.back - CENTER).normalize_and_length();
    let nearer = RADIUS * RADIUS / distance;
    let radius = (RADIUS * RADIUS - nearer * nearer).sqrt();
    let outline = view.circle(CENTER + nearer * towards, radius, towards);
    svg.path("sphere area", &outline);
    svg.path("sphere thin", &view.circle(CENTER, RADIUS, Vec3::Y));
}

fn draw_axes(svg: &mut Svg, view: &OutsideView, eye: Point3) {
    for (axis, name) in [(Vec3::X, "*x*"), (Vec3::Y, "*y*"), (Vec3::Z, "*z*")] {
        svg.arrow("ink line", view.point(eye), view.point(eye + 0.7 * axis));
        let beyond = view.point(eye + 0.85 * axis);
        svg.label("ink", beyond.down(5.0), Middle, name);
    }
    svg.dot("ink", view.point(eye), UpperLeft, "eye");
}

/// Draws the cross along which the knob slides.
fn draw_knob(svg: &mut Svg) {
    let DVec2 { x, y } = KNOB_ROOM;
    svg.line("faint thin", KNOB.right(-x), KNOB.right(x));
    svg.line("faint thin", KNOB.down(-y), KNOB.down(y));
    svg.small_label("faint", KNOB.right(x).down(20.0), End, "drag to turn");
}
