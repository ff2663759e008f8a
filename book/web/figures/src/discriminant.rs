//! A ray, a sphere, and the roots: where a parabola over the axis of t is 0. Ray and sphere move.

use normals::hit_sphere;

use crate::prelude::*;
use crate::traced::red_sphere_lines;

parameters! {
    q: Point3 =
        Parameter::new("Q, to the right", -0.7, 5.3, 0.0),
        Parameter::new("Q, upwards", -1.5, 1.7, 0.0);
    d: Vec3 =
        Parameter::new("d, to the right", -3.0, 3.0, 1.0),
        Parameter::new("d, upwards", -2.0, 2.0, 0.0);
    c: Point3 =
        Parameter::new("C, to the right", 0.5, 4.8, 3.0),
        Parameter::new("C, upwards", -0.6, 0.8, 0.6);
    radius: f64 = Parameter::new("radius", 0.2, 1.3, 1.2);
}

/// The live figure: a ray and a sphere to be moved, and the roots on an axis of t.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: figure!("discriminant"),
    handles: &[
        point!(PLANE, q),
        point!(PLANE, d from q),
        point!(PLANE, c),
        Handle {
            field: "radius",
            at: |it| PLANE.point(it.c - it.radius * Vec3::Y),
            drag: |it, to| it.radius = (PLANE.place(to) - it.c).length(),
        },
    ],
    actions: &[
        ("Hit", |it| it.put(xy(0.0, 0.0), xy(3.0, 0.6), 1.2)),
        ("Miss", |it| it.put(xy(0.0, -0.7), xy(3.0, 0.5), 0.8)),
        ("Touch", |it| it.put(xy(0.0, -0.5), xy(3.0, 0.5), 1.0)),
        ("Inside", |it| it.put(xy(2.5, 0.0), xy(3.0, 0.6), 1.2)),
        ("Behind", |it| it.put(xy(4.0, 0.5), xy(2.0, 0.5), 1.0)),
    ],
    answer,
};

impl Parameters {
    /// Puts the origin of the ray and the sphere there; the ray points to the right.
    fn put(&mut self, q: Point3, c: Point3, radius: f64) {
        let d = Vec3::X;
        *self = Self { q, d, c, radius };
    }

    fn ray(&self) -> Ray {
        ray(self.q, self.d)
    }

    /// Finds all t at which the line of the ray meets the sphere.
    fn roots(&self) -> Vec<f64> {
        roots(&self.ray(), |ray| hit_sphere(self.c, self.radius, ray))
    }

    /// Returns the point of the line that is nearest to the center.
    fn foot(&self) -> Point3 {
        self.ray().at(nearest(&self.ray(), self.c))
    }

    /// Returns a, b and c of the quadratic equation.
    fn coefficients(&self) -> [f64; 3] {
        let (Ray { direction: d, .. }, oc) = (self.ray(), self.c - self.q);
        [
            d.dot(d),
            -2.0 * d.dot(oc),
            oc.dot(oc) - self.radius * self.radius,
        ]
    }
}

fn answer(chosen: &Parameters) -> DrawnFigure {
    let roots = chosen.roots();
    let at = listed(&roots);
    let in_words = match roots.len() {
        0 => "there is no root".to_owned(),
        1 => format!("there is one root, {at}"),
        _ => format!("the roots are {at}"),
    };
    let mut says = red_sphere_lines(chosen.c, chosen.radius, &chosen.ray());
    says.insert("roots", in_words);
    let [a, b, c] = chosen.coefficients();
    let discriminant = printed(b * b - 4.0 * a * c);
    let sentence = format!("*b*² − 4*ac* = {discriminant}{}", meaning(&roots));
    DrawnFigure::new(draw(chosen, &roots), sentence, says)
}

/// Says what the number and the signs of the roots mean.
fn meaning(roots: &[f64]) -> String {
    let at = listed(roots);
    match roots[..] {
        [] => " is negative: *l* is more than *r*, the parabola stays above the axis, and the line misses.".to_owned(),
        [only] if only < 0.0 => {
            format!(": the line only touches, behind the eye: {at}. The ray misses.")
        }
        [_] => format!(": the line only touches. Its one root is {at}."),
        [one, other] if near(one, 0.0) || near(other, 0.0) => {
            format!(" is positive. The eye is on the sphere, where *t* is 0: the roots are {at}.")
        }
        [nearer, _] if nearer > 0.0 => {
            format!(" is positive, and both roots are ahead: {at}. The eye sees the first.")
        }
        [_, farther] if farther > 0.0 => {
            format!(" is positive. One root is behind the eye and one ahead: {at}. The eye is inside.")
        }
        _ => format!(
            " is positive, but both roots are behind the eye: {at}. The line meets the sphere, the ray does not."
        ),
    }
}

/// Returns true if two roots of this figure differ by rounding alone.
fn near(one: f64, other: f64) -> bool {
    (one - other).abs() < 1e-9
}

/// The place of the scene on the sheet, and the size of its part of the sheet.
const PLANE: Plane = Plane::new(60.0, 118.0, 60.0);
const SIZE: DVec2 = spot(400.0, 226.0);

/// The axis of t, below the scene, and the room above and below it.
const AXIS: Axis = Axis::new(23.0, 342.0, 357.0, -2.5, 6.0);
const ROOM: [f64; 2] = [96.0, 40.0];

/// Draws the scene, and the parabola over the axis, with a mark for each root on both.
fn draw(chosen: &Parameters, roots: &[f64]) -> Svg {
    let mut svg = LIVE.figure.sheet(AXIS.start.y + ROOM[1] + 4.0);
    draw_scene(&mut svg, chosen);
    draw_axis(&mut svg, roots);
    draw_parabola(&mut svg, chosen);
    for (&t, n) in roots.iter().zip(1..) {
        let point = PLANE.point(chosen.ray().at(t));
        let name = format!("*t*_{{{n}}}");
        if point.clamp(DVec2::ZERO, SIZE) == point {
            svg.circle("ink hollow", point, 5.0);
            svg.label("ink", point, Below, &name);
        }
        if (AXIS.least..=AXIS.most).contains(&t) {
            svg.circle("ink hollow", AXIS.point(t), 5.0);
            svg.label("ink", AXIS.point(t), Above, &name);
        }
    }
    svg
}

fn draw_scene(svg: &mut Svg, chosen: &Parameters) {
    let [middle, foot] = [chosen.c, chosen.foot()].map(|it| PLANE.point(it));
    svg.circle("sphere area", middle, PLANE.scale * chosen.radius);
    svg.line("sphere dashed", middle, foot);
    PLANE.draw_line(svg, &chosen.ray(), SIZE, f64::INFINITY);
    PLANE.draw_ray(svg, &chosen.ray());
    svg.dot("sphere", middle, UpperRight, "**C**");
    svg.label("sphere", 0.5 * (middle + foot), Right, "*l*");
}

fn draw_axis(svg: &mut Svg, roots: &[f64]) {
    let [start, zero] = [AXIS.start, AXIS.point(0.0)];
    let behind = (zero - start).down(ROOM[0] + ROOM[1]);
    svg.rect("faint wash", start.down(-ROOM[0]), behind);
    svg.small_label("ink", start + spot(6.0, 14.0 - ROOM[0]), Start, "behind");
    svg.arrow("ray line", start, AXIS.end.right(10.0));
    let whole = ticks((-2..=6).map(f64::from), spoken);
    AXIS.draw_ticks(svg, "ray thin", spot(0.0, 5.0), &whole);
    if let &[nearer, farther] = roots {
        svg.line("ink bold", AXIS.point(nearer), AXIS.point(farther));
    }
}

/// Draws *at*² + *bt* + *c* over the axis, as far as there is room.
fn draw_parabola(svg: &mut Svg, chosen: &Parameters) {
    let [a, b, c] = chosen.coefficients();
    let above = |t: f64| UNIT * ((a * t + b) * t + c);
    let lowest = nearest(&chosen.ray(), chosen.c);
    // So far to each side it stays below the upper rim.
    let wide = ((ROOM[0] - above(lowest)) / (UNIT * a)).max(0.0).sqrt();
    let [from, to] = [lowest - wide, lowest + wide].map(|t| t.clamp(AXIS.least, AXIS.most));
    let along = (0..=STEPS).map(|n| from + (to - from) * f64::from(n) / f64::from(STEPS));
    let points: Vec<DVec2> = along.map(|t| AXIS.point(t).down(-above(t))).collect();
    if from < to && wide > 0.0 {
        svg.path("sphere line", &points);
    }
    if above(0.0) < ROOM[0] {
        svg.dot("sphere", AXIS.point(0.0).down(-above(0.0)), Right, "*c*");
    }
    let corner = AXIS.end.down(ROOM[1] - 2.0);
    svg.label("sphere", corner, End, "*a* *t*² + *b* *t* + *c*");
}

/// The height on the sheet of a unit of the parabola, and the number of straight pieces in which it
/// is drawn.
const UNIT: f64 = 18.0;
const STEPS: u32 = 40;
