//! Vector arithmetic in five small drawings: two arrows, sum, difference, multiples, and the dot
//! product as a shadow. Both arrows move, and all drawings follow.

use crate::prelude::*;

parameters! {
    u: Vec3 =
        Parameter::new("u, to the right", -1.5, 1.5, 1.5),
        Parameter::new("u, upwards", -1.0, 1.0, 0.5);
    v: Vec3 =
        Parameter::new("v, to the right", -1.5, 1.5, 0.5),
        Parameter::new("v, upwards", -1.0, 1.0, 1.0);
}

/// The live figure: two arrows to be dragged, with their sum, difference, multiples and dot
/// product.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: figure!("arrows"),
    handles: &[point!(BOTH, u), point!(BOTH, v)],
    actions: &[
        ("A right angle", |chosen| {
            (chosen.u, chosen.v) = (xy(1.5, 0.5), xy(-0.25, 0.75));
        }),
        ("Apart", |it| (it.u, it.v) = (xy(1.5, 0.5), xy(-1.0, 0.25))),
        ("v on u", |it| (it.u, it.v) = (xy(1.5, 0.5), xy(1.5, 0.5))),
    ],
    answer,
};

/// The plane in which the two arrows are dragged, at the upper left.
const BOTH: Plane = Plane::new(100.0, 92.0, SCALE);

/// The length of an arrow of length 1 on the sheet.
const SCALE: f64 = 40.0;

/// Makes a plane for arrows from the origin to `points`, so that their middle is at (x, y) of the
/// sheet.
fn around(x: f64, y: f64, points: &[Vec3]) -> Plane {
    let all = || points.iter().copied().chain([Vec3::ZERO]);
    let least = all().fold(Vec3::ZERO, Vec3::min);
    let most = all().fold(Vec3::ZERO, Vec3::max);
    let middle = 0.5 * (least + most);
    Plane::new(x - SCALE * middle.x, y + SCALE * middle.y, SCALE)
}

/// Draws the figure and says what the dot product comes to.
fn answer(&Parameters { u, v }: &Parameters) -> DrawnFigure {
    let (product, length) = (u.dot(v), u.length());
    let [product_said, length_said] = [product, length].map(spoken);
    let shadow = spoken((product / length).abs());
    let sentence = if length == 0.0 {
        "**u** has no length, so it has no line to throw a shadow on.".to_owned()
    } else if product == 0.0 {
        "**u**·**v** = 0: the two make a right angle, and there is no shadow.".to_owned()
    } else {
        let side = if product < 0.0 {
            "behind the start"
        } else {
            "ahead"
        };
        format!(
            "The shadow of **v** is {shadow} long, {side}, and **u** is {length_said} long: \
             **u**·**v** = {product_said}."
        )
    };
    DrawnFigure::new(draw(u, v), sentence, [("product", product_said)])
}

fn draw(u: Vec3, v: Vec3) -> Svg {
    let mut svg = LIVE.figure.sheet(472.0);
    start(&mut svg, &BOTH, spot(100.0, 22.0), "**u** and **v**");
    named(&mut svg, u, "ray bold", "**u**");
    named(&mut svg, v, "sphere bold", "**v**");
    let sum = around(300.0, 92.0, &[u, u + v]);
    start(&mut svg, &sum, spot(300.0, 22.0), "**u** + **v**");
    svg.arrow("ray thin", sum.origin, sum.point(u));
    svg.arrow("sphere thin", sum.point(u), sum.point(u + v));
    svg.arrow("normal bold", sum.origin, sum.point(u + v));
    let difference = around(100.0, 252.0, &[u, v]);
    start(&mut svg, &difference, spot(100.0, 182.0), "**v** − **u**");
    svg.arrow("ray thin", difference.origin, difference.point(u));
    svg.arrow("sphere thin", difference.origin, difference.point(v));
    svg.arrow("normal bold", difference.point(u), difference.point(v));
    let multiples = around(300.0, 252.0, &[2.0 * u, -u]);
    start(
        &mut svg,
        &multiples,
        spot(300.0, 182.0),
        "2**u** and −**u**",
    );
    svg.arrow("ray line", multiples.origin, multiples.point(2.0 * u));
    svg.arrow("normal bold", multiples.origin, multiples.point(-u));
    draw_shadow(&mut svg, u, v);
    draw_numbers(&mut svg, u, v);
    svg
}

/// Writes the title of one small drawing, and a dot where its arrows start.
fn start(svg: &mut Svg, plane: &Plane, title: DVec2, words: &str) {
    svg.label("ink", title, Middle, words);
    svg.circle("ink solid", plane.origin, 2.5);
}

/// Draws an arrow from the start of both, and its name beyond the tip.
fn named(svg: &mut Svg, arrow: Vec3, class: &str, name: &str) {
    let (tip, along) = (BOTH.point(arrow), BOTH.vector(arrow).normalize_or_zero());
    svg.arrow(class, BOTH.origin, tip);
    let idea = class.split(' ').next().unwrap_or_default();
    svg.label(idea, (tip + 20.0 * along).down(5.0), Middle, name);
}

/// Draws the shadow of v on the line of u, with light at a right angle to u.
fn draw_shadow(svg: &mut Svg, u: Vec3, v: Vec3) {
    let panel = around(100.0, 400.0, &[u, v]);
    start(svg, &panel, spot(100.0, 330.0), "the shadow of **v**");
    let line = ray(Point3::ZERO, u);
    let foot = panel.point(line.at(nearest(&line, v)));
    let reach = 64.0 * panel.vector(u).normalize_or_zero();
    svg.line("grid thin", panel.origin - reach, panel.origin + reach);
    svg.line("faint dashed", panel.point(v), foot);
    svg.arrow("ray line", panel.origin, panel.point(u));
    svg.arrow("sphere line", panel.origin, panel.point(v));
    svg.line("normal bold", panel.origin, foot);
    svg.circle("normal solid", foot, 4.0);
}

/// Writes the coordinates of both arrows and the sum of products, beside the shadow.
fn draw_numbers(svg: &mut Svg, u: Vec3, v: Vec3) {
    let pair = |it: Vec3| format!("({}, {})", spoken(it.x), spoken(it.y));
    let product = |one: f64, other: f64| format!("{} · {}", spoken(one), bracketed(other));
    let lines = [
        format!("**u** = {}", pair(u)),
        format!("**v** = {}", pair(v)),
        format!("**u**·**v** = {}", product(u.x, v.x)),
        format!("   + {}", product(u.y, v.y)),
        format!("   = {}", spoken(u.dot(v))),
    ];
    svg.readout(spot(232.0, 352.0), &lines);
}

/// Writes a factor of a product: a negative one in brackets.
fn bracketed(value: f64) -> String {
    let said = spoken(value);
    if value < 0.0 {
        format!("({said})")
    } else {
        said
    }
}
