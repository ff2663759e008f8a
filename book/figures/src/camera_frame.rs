//! Figure 3 of the notes: the frame of the camera.

use common::rtweekend::*;
use glam::DVec2;

use crate::Figure;
use crate::svg::{Anchor, Svg, spoken};

/// The words of this figure.
pub const FIGURE: Figure = Figure {
    name: "camera_frame",
    title: "The camera and its right-handed frame",
    description: "From the eye at the origin three axes start: x to the right, y up, and z \
        towards the viewer. The viewport stands upright on the other side, across the negative \
        z axis. A dashed line of length 1 joins the eye to its center, and four lines join the \
        eye to its corners.",
    caption: "The eye is the origin of a right-handed frame: x to the right, y up, z towards you. \
        The camera looks along −z, through a viewport that is one focal length away.",
    draw: || draw(&Parameters::default()),
};

/// What can be changed.
#[derive(Clone, Copy, Debug)]
pub struct Parameters {
    /// The camera, whose viewport is drawn.
    pub camera: Camera,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            camera: Camera::with_size(16, 9),
        }
    }
}

/// Draws the frame and the viewport.
pub fn draw(Parameters { camera }: &Parameters) -> String {
    let mut svg = FIGURE.sheet(400.0, 290.0);
    let corners = corners(camera);
    let middle = 0.5 * (corners[0] + corners[2]);
    let on_sheet = corners.map(project);

    for corner in on_sheet {
        svg.line("ray thin", project(camera.center), corner);
    }
    let mut outline = on_sheet.to_vec();
    outline.push(on_sheet[0]);
    svg.path("viewport area", &outline);
    svg.line("ink dashed", project(camera.center), project(middle));
    svg.circle("viewport solid", project(middle), 3.0);
    axes(&mut svg, camera.center);

    let size = corners[2] - corners[0];
    svg.label(
        "viewport",
        on_sheet[0] + DVec2::new(2.0, -8.0),
        Anchor::Start,
        &format!("viewport, {} × {}", spoken(size.x), spoken(-size.y)),
    );
    let focal_length = camera.center.distance(middle);
    svg.label(
        "ink",
        project(middle) + DVec2::new(8.0, -6.0),
        Anchor::Start,
        &format!("{} in front of the eye", spoken(focal_length)),
    );
    svg.finish()
}

fn axes(svg: &mut Svg, eye: Point3) {
    for (axis, length, name, aside) in [
        (Vec3::X, 0.95, "*x*", DVec2::new(10.0, 5.0)),
        (Vec3::Y, 0.95, "*y*", DVec2::new(-13.0, 4.0)),
        (Vec3::Z, 0.75, "*z*", DVec2::new(-11.0, 8.0)),
    ] {
        let tip = project(eye + length * axis);
        svg.arrow("ink line", project(eye), tip);
        svg.label("ink", tip + aside, Anchor::Middle, name);
    }
    svg.circle("ink solid", project(eye), 5.0);
    let below = project(eye) + DVec2::new(12.0, 22.0);
    svg.label("ink", below, Anchor::Start, "eye (0, 0, 0)");
}

/// The corners of the viewport, clockwise from the upper left: half a pixel
/// outside the centers of the outermost pixels.
fn corners(camera: &Camera) -> [Point3; 4] {
    let corner = |i: u32, j: u32| {
        camera.pixel00
            + (f64::from(i) - 0.5) * camera.pixel_delta_u
            + (f64::from(j) - 0.5) * camera.pixel_delta_v
    };
    let (width, height) = (camera.image_width, camera.image_height);
    [
        corner(0, 0),
        corner(width, 0),
        corner(width, height),
        corner(0, height),
    ]
}

/// Takes a point of space to the sheet: seen from the front, a little from the
/// right and from above.
fn project(point: Point3) -> DVec2 {
    let Point3 { x, y, z } = point;
    DVec2::new(130.0, 195.0) + 80.0 * DVec2::new(x - 0.9 * z, -y + 0.6 * z)
}
