//! Backward ray tracing: a lamp, a ball, a pane and an eye. The ray goes from square to square
//! of the pane.

use normals::hit_sphere;

use crate::prelude::*;

parameters! {
    square: f64 = Parameter {
        downwards: true,
        ..Parameter::whole("Square", 1.0, SQUARES as f64, 5.0)
    };
}

/// The live figure: a ray goes from the eye through a square of the pane that a reader chooses.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: figure!("backwards"),
    handles: &[Handle {
        field: "square",
        at: |it| PLANE.point(middle(it.square)),
        drag: |it, to| it.square = 0.5 + (TOP - PLANE.place(to).y) / SIDE,
    }],
    actions: &[],
    answer,
};

/// The lamp and the ball in the plane of the scene, whose origin is the eye.
const LAMP: Point3 = xy(2.0, 1.25);
const BALL: Point3 = xy(3.0, -0.25);
const RADIUS: f64 = 0.8;

/// The pane: its x, its top, the side of a square, and the number of squares.
const AHEAD: f64 = 1.4;
const TOP: f64 = 1.08;
const SIDE: f64 = 0.24;
const SQUARES: u32 = 9;

/// The place of the scene on the sheet, and the size of its part of the sheet.
const PLANE: Plane = Plane::new(34.0, 138.0, 80.0);
const SIZE: DVec2 = spot(400.0, 246.0);

/// Returns the middle of a square of the pane; squares are counted from 1 at the top.
fn middle(square: f64) -> Point3 {
    xy(AHEAD, TOP - (square - 0.5) * SIDE)
}

/// Returns the ray from the eye through the middle of a square, and the point of the ball that it
/// meets, if any.
fn seen(square: f64) -> (Ray, Option<Point3>) {
    let ray = Ray::new(Point3::ZERO, middle(square));
    let hit = hit_sphere(BALL, RADIUS, &ray).map(|t| ray.at(t));
    (ray, hit)
}

/// Draws the figure and says what the ray of the chosen square meets.
fn answer(&Parameters { square }: &Parameters) -> DrawnFigure {
    let (ray, hit) = seen(square);
    let meets = match hit {
        Some(_) => "meets the ball, and the square gets the color of the ball there",
        None => "meets nothing, and the square gets the color of the sky",
    };
    let sentence = format!("The ray through square {square} {meets}.");
    DrawnFigure::new(draw(square, &ray, hit), sentence, [])
}

fn draw(square: f64, ray: &Ray, hit: Option<Point3>) -> Svg {
    let mut svg = LIVE.figure.sheet(SIZE.y);
    draw_lamp(&mut svg);
    svg.circle("sphere area", PLANE.point(BALL), PLANE.scale * RADIUS);
    svg.label("sphere", PLANE.point(BALL), Middle, "ball");
    draw_pane(&mut svg, square);
    let end = hit.unwrap_or(ray.at(2.9));
    if let Some(point) = hit
        && is_lit(point)
    {
        svg.arrow("normal line", PLANE.point(LAMP), PLANE.point(point));
    }
    svg.arrow("ray bold", PLANE.point(ray.origin), PLANE.point(end));
    svg.dot("ink", PLANE.point(ray.origin), Below, "eye");
    svg
}

/// Returns true if light from the lamp reaches a point of the ball: no nearer point of the ball is
/// in the way.
fn is_lit(point: Point3) -> bool {
    let light = Ray::new(LAMP, point - LAMP);
    hit_sphere(BALL, RADIUS, &light).is_some_and(|t| t > 1.0 - 1e-9)
}

/// Draws the lamp and some ways of its light, which end at the ball or at the rim of the drawing.
fn draw_lamp(svg: &mut Svg) {
    let lamp = PLANE.point(LAMP);
    for n in 0..20 {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(n) / 20.0).sin_cos();
        let light = Ray::new(LAMP, xy(cos, sin));
        let rim = PLANE.on_sheet(&light, SIZE).map_or(0.0, |(_, last)| last);
        let end = hit_sphere(BALL, RADIUS, &light).filter(|&t| t > 0.0);
        svg.line("grid thin", lamp, PLANE.point(light.at(end.unwrap_or(rim))));
    }
    svg.circle("normal solid", lamp, 9.0);
    svg.label("normal", lamp, UpperRight, "lamp");
}

/// Draws the squares of the pane: filled where the ray meets the ball, and with a mark at `chosen`.
fn draw_pane(svg: &mut Svg, chosen: f64) {
    let (wide, high) = (10.0, PLANE.scale * SIDE);
    for square in (1..=SQUARES).map(f64::from) {
        let corner = PLANE.point(middle(square)) - 0.5 * spot(wide, high);
        let class = match seen(square).1 {
            Some(_) => "sphere wash",
            None => "paper",
        };
        svg.rect(class, corner, spot(wide, high));
        let class = if square == chosen {
            "viewport bold"
        } else {
            "viewport thin"
        };
        svg.rect(class, corner, spot(wide, high));
    }
    let below = PLANE.point(xy(AHEAD, TOP - f64::from(SQUARES) * SIDE));
    svg.label("viewport", below.down(18.0), Middle, "pane");
}
