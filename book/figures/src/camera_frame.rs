//! Figure 3 of the notes: the frame of the camera.

use common::rtweekend::*;
use glam::DVec2;

use crate::figure::Figure;
use crate::number::spoken;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "camera_frame",
    title: "The camera and its right-handed frame",
    description: "Seen from the side. From the eye at the origin three axes start: y up, z to \
        the left, and x towards whoever looks at the drawing. The viewport stands upright at the \
        right, across the negative z axis. A dashed line of length 1 joins the eye to its center, and four lines join the \
        eye to its corners.",
    caption: "Seen from the side: the eye is the origin of a right-handed frame. For whoever looks \
        through the camera, *x* points to the right, *y* up, and *z* back from where it looks. So it \
        looks along −*z*, through a viewport that is one focal length away.",
    draw,
};

/// Draws the frame and the viewport.
fn draw() -> String {
    let camera = Camera::with_size(16, 9);
    let mut svg = FIGURE.sheet(400.0, 320.0);
    let corners = corners(&camera);
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
    let beside = 0.5 * (on_sheet[1] + on_sheet[2]) + DVec2::new(10.0, -3.0);
    svg.label("viewport", beside, Anchor::Start, "viewport");
    let words = format!("{} × {}", spoken(size.x), spoken(-size.y));
    svg.label(
        "viewport",
        beside + DVec2::new(0.0, 20.0),
        Anchor::Start,
        &words,
    );
    let above = 0.5 * (project(camera.center) + project(middle)) - DVec2::new(0.0, 8.0);
    let words = spoken(camera.center.distance(middle));
    svg.label("ink", above, Anchor::Middle, &words);
    svg.finish()
}

fn axes(svg: &mut Svg, eye: Point3) {
    for (axis, length, name, aside) in [
        (Vec3::X, 1.1, "*x*", DVec2::new(12.0, 12.0)),
        (Vec3::Y, 0.9, "*y*", DVec2::new(-13.0, 4.0)),
        (Vec3::Z, 0.8, "*z*", DVec2::new(-11.0, 8.0)),
    ] {
        let tip = project(eye + length * axis);
        svg.arrow("ink line", project(eye), tip);
        svg.label("ink", tip + aside, Anchor::Middle, name);
    }
    svg.circle("ink solid", project(eye), 5.0);
    let below = project(eye) + DVec2::new(-2.0, 34.0);
    svg.label("ink", below, Anchor::End, "eye (0, 0, 0)");
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

/// Takes a point of space to the sheet, as seen from the right of the eye and a
/// little from above.
fn project(point: Point3) -> DVec2 {
    let (sin_turn, cos_turn) = 65_f64.to_radians().sin_cos();
    let (sin_tilt, cos_tilt) = 10_f64.to_radians().sin_cos();
    let right = point.x * cos_turn - point.z * sin_turn;
    let nearer = point.x * sin_turn + point.z * cos_turn;
    let up = point.y * cos_tilt - nearer * sin_tilt;
    DVec2::new(128.0, 172.0) + 110.0 * DVec2::new(right, -up)
}
