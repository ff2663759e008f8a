//! Where the blend of the sky begins and ends.

use crate::vocabulary::*;

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "unit_sky",
    title: "From the direction of a ray to the blue of the sky",
    description: "Seen from the side: three rays leave the eye through the top, the middle and the \
        bottom of the viewport. Cut to length 1 they end on a circle. The height of each end leads \
        across to a scale from white, a = 0, to blue, a = 1. The topmost and the lowest ray reach \
        neither end of the scale.",
    caption: "The height *y* of the unit direction, from −1 to 1, becomes *a* = ½(*y* + 1), the share of \
        blue. No ray of this picture is steep enough for *a* = 0 or *a* = 1: they would point straight \
        down and up.",
    draw,
};

/// Seen from the side: −z, where the camera looks, is to the right.
const PLANE: Plane = Plane::new(56.0, 150.0, 118.0);

/// Where the scale of the sky is, and how wide.
const LEFT: f64 = 288.0;
const WIDE: f64 = 26.0;

/// Draws the rays from the side, and the scale of the sky.
fn draw() -> String {
    let camera = Camera::new(400);
    let mut svg = FIGURE.sheet(300.0);
    draw_arc(&mut svg);
    draw_scale(&mut svg);
    let [top, foot] = [xy(1.0, 1.0), xy(1.0, -1.0)].map(|it| PLANE.point(it));
    svg.line("viewport bold", top, foot);
    svg.label("viewport", top, Above, "viewport");
    let bottom = camera.image_height - 1;
    for row in [0, bottom / 2, bottom] {
        let ray = camera.ray(camera.image_width / 2, row);
        let from_the_side = |vector: Vec3| PLANE.point(xy(-vector.z, vector.y));
        let tip = from_the_side(ray.direction.normalize());
        svg.line("ray dashed", tip, from_the_side(ray.direction));
        svg.arrow("ray bold", PLANE.origin, tip);
        svg.line("ink dashed", tip, spot(LEFT, tip.y));
        // How far `sky` went from white to blue, in red, where the way is ½ long.
        let share = (1.0 - sky(&ray).x) / 0.5;
        let words = format!("*a* = {share:.3}");
        svg.label("ink", spot(LEFT + WIDE, tip.y), Right, &words);
    }
    svg.dot("ink", PLANE.origin, Left, "eye");
    svg.finish()
}

/// The front half of the circle on which unit directions end.
fn draw_arc(svg: &mut Svg) {
    let point = |degrees: i32| {
        let (y, x) = f64::from(degrees).to_radians().sin_cos();
        PLANE.point(xy(x, y))
    };
    let points: Vec<DVec2> = (-90..=90).step_by(3).map(point).collect();
    svg.path("faint dashed", &points);
    svg.small_label("faint", point(-69) + spot(-6.0, 18.0), Start, "length 1");
}

/// The sky from straight down to straight up.
fn draw_scale(svg: &mut Svg) {
    const STEPS: i32 = 40;
    let step = 2.0 / f64::from(STEPS);
    let at = |y: f64| spot(LEFT, PLANE.point(xy(0.0, y)).y);
    svg.group("pixels", |svg| {
        for n in 0..STEPS {
            let y = -1.0 + step * (f64::from(n) + 0.5);
            let direction = Vec3::new(0.0, y, -(1.0 - y * y).sqrt());
            let mut rgb = [0; 3];
            write_color(&mut rgb, sky(&Ray::new(Point3::ZERO, direction)));
            let size = spot(WIDE, PLANE.scale * step);
            svg.pixel(at(y + 0.5 * step), size, rgb);
        }
    });
    svg.rect("faint thin", at(1.0), spot(WIDE, 2.0 * PLANE.scale));
    for (y, words) in [(1.14, "1, straight up"), (-1.14, "0, straight down")] {
        svg.small_label("faint", at(y) + spot(13.0, 4.0), Middle, words);
    }
}
