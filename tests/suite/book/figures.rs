//! Every figure and chart is well made, and a figure shows what the code computes.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, LazyLock, Mutex};

use common::rtweekend::*;
use figures::cancellation::Numbers;
use figures::{
    CSS, FIGURES, digits, edge, nearest, normal, passing, red_sphere, roots, sphere_test,
    standalone, viewport_grid,
};
use glam::DVec2;
use hittable_list::{HitRecord, Hittable, HittableList, Sphere};
use insta::assert_binary_snapshot;
use roxmltree::{Document, Node};
use slips;
use slips::Chapter;
use speed_vs_accuracy::Method;

use crate::charts;

/// The drawings, each as a file that can be looked at.
const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes/figures");

#[test]
fn every_figure_is_its_snapshot() {
    println!("If you meant to change it: INSTA_UPDATE=always cargo test figure_is_its_snapshot");
    for figure in FIGURES {
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path(FOLDER);
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.bind(|| {
            let file = standalone(&(figure.draw)());
            assert_binary_snapshot!(&format!("{}.svg", figure.name), file.into_bytes());
        });
    }
}

#[test]
fn every_figure_has_its_own_name_and_all_its_words() {
    let names: BTreeSet<_> = FIGURES.iter().map(|figure| figure.name).collect();
    assert_eq!(names.len(), FIGURES.len());
    for figure in FIGURES {
        assert_eq!(
            figures::find(figure.name).map(|found| found.title),
            Some(figure.title)
        );
        for words in [figure.description, figure.caption] {
            assert!(words.ends_with('.'), "a sentence ends with a stop: {words}");
        }
    }
    assert!(figures::find("no such figure").is_none());
}

#[test]
fn a_figure_can_stand_in_a_page_of_markdown() {
    for (name, svg) in drawings() {
        assert!(
            svg.starts_with("<svg ") && svg.ends_with("</svg>"),
            "{name}"
        );
        assert!(!svg.contains('\n'), "{name} has more than one line");
    }
}

#[test]
fn every_id_of_a_page_with_all_drawings_is_unique_and_every_name_is_found() {
    let mut ids = BTreeSet::new();
    for (name, svg) in of_the_book() {
        let drawing = parse(&svg);
        let root = drawing.root_element();
        let mut own = BTreeSet::new();
        for id in root.descendants().filter_map(|node| node.attribute("id")) {
            own.insert(id);
            assert!(ids.insert(id.to_owned()), "{name} repeats the id {id}");
        }
        assert_eq!(root.attribute("role"), Some("img"));
        let labels = root.attribute("aria-labelledby").expect("it has a name");
        for label in labels.split(' ') {
            assert!(own.contains(label), "{name} has no {label}");
        }
    }
}

#[test]
fn the_style_sheet_has_every_class_that_is_used_and_no_other() {
    let mut used = BTreeSet::from(["paper".to_owned()]);
    for (_, svg) in drawings() {
        for node in parse(svg).descendants() {
            let classes = node.attribute("class").unwrap_or_default();
            used.extend(classes.split_whitespace().map(str::to_owned));
        }
    }
    let defined: BTreeSet<String> = CSS
        .lines()
        .filter(|line| line.starts_with('.'))
        .flat_map(|line| line.split('{').next().unwrap_or_default().split(['.', ' ']))
        .filter(|word| word.starts_with(|first: char| first.is_ascii_lowercase()))
        .map(str::to_owned)
        .collect();
    assert_eq!(used, defined);
}

#[test]
fn every_color_can_be_told_from_every_background() {
    let palette = palette();
    for (light, idea) in ["ink", "faint", "ray", "sphere", "normal", "viewport"]
        .into_iter()
        .flat_map(|idea| [(true, idea), (false, idea)])
    {
        let color = palette[idea][usize::from(!light)];
        for (theme, background) in backgrounds(light) {
            let contrast = contrast(color, background);
            assert!(
                contrast >= 4.5,
                "{idea} on {theme} has a contrast of {contrast:.2}, where text needs 4.5"
            );
        }
    }
}

#[test]
fn the_words_on_every_depth_of_heat_can_be_read() {
    let palette = palette();
    for (light, depth) in (1..=5).flat_map(|depth| [(true, depth), (false, depth)]) {
        let [ink, paper, heat] =
            ["ink", "paper", "ray"].map(|idea| palette[idea][usize::from(!light)]);
        let words = if depth > 3 { paper } else { ink };
        for (theme, background) in backgrounds(light) {
            let mixed = mix(heat, background, opacity(depth));
            let contrast = contrast(words, mixed);
            assert!(contrast >= 4.5, "depth {depth} on {theme}: {contrast:.2}");
        }
    }
}

#[test]
fn every_number_is_finite_and_lies_on_the_sheet() {
    for (name, svg) in drawings() {
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
        let drawing = parse(svg);
        let (width, height) = size(&drawing);
        for node in drawing.descendants() {
            for (x, y) in places(&node) {
                assert!(
                    (-0.01..=width + 0.01).contains(&x) && (-0.01..=height + 0.01).contains(&y),
                    "{name}: ({x}, {y}) is off the sheet of {width} × {height}: {node:?}"
                );
            }
        }
    }
}

#[test]
fn no_label_hides_another_or_leaves_the_sheet() {
    let faults: String = drawings()
        .iter()
        .map(|(name, svg)| faults(name, svg))
        .collect();
    assert!(faults.is_empty(), "{faults}");
}

#[test]
fn the_labels_of_the_grid_have_room_at_every_width_and_at_its_edges() {
    let mut all = String::new();
    let slip = slips::find("grid-not-inset").expect("a slip");
    let slipped = slip.program(Chapter::Gradient);
    for camera in (1..=40).flat_map(|width| [Camera::new(width), slipped.camera(width)]) {
        let width = camera.image_width;
        let height = camera.image_height;
        for i in [0, 1, width / 2, width - 1] {
            for j in [0, 1, height / 2, height - 1] {
                let pixel = [i.min(width - 1), j.min(height - 1)];
                let svg = viewport_grid::draw(&viewport_grid::Parameters { camera, pixel });
                all += &faults(&format!("{width} wide, {pixel:?}"), &svg);
            }
        }
    }
    assert!(all.is_empty(), "{all}");
}

/// The labels of a drawing that meet others, or leave the sheet.
fn faults(name: &str, svg: &str) -> String {
    let mut faults = String::new();
    let drawing = parse(svg);
    let (width, height) = size(&drawing);
    let labels: Vec<Label> = texts(&drawing).map(|text| Label::of(&text)).collect();
    for (n, label) in labels.iter().enumerate() {
        if !label.lies_within(width, height) {
            faults += &format!("{name}: {label:?} leaves the sheet\n");
        }
        for other in labels[n + 1..].iter().filter(|other| label.touches(other)) {
            faults += &format!("{name}: {label:?} meets {other:?}\n");
        }
    }
    faults
}

#[test]
fn a_label_says_what_it_was_told_to() {
    let svg = (figures::find("viewport_grid").expect("a figure").draw)();
    let labels: Vec<String> = texts(&parse(&svg)).map(|text| words(&text)).collect();
    for expected in [
        "Vu = (4, 0, 0)",
        "Vv = (0, −2, 0)",
        "Δu = (0.5, 0, 0)",
        "Δv = (0, −0.5, 0)",
        "Q = (−2, 1, −1)",
        "P0,0 = (−1.75, 0.75, −1)",
        "P5,2 = (0.75, −0.25, −1)",
        "8 : 4 = 2, where 16 : 9 = 1.78",
    ] {
        assert!(labels.iter().any(|label| label == expected), "{labels:?}");
    }
    let svg = (figures::find("roots").expect("a figure").draw)();
    assert!(svg.contains("&lt; 0"), "a sign is escaped");
    let svg = (figures::find("unit_sky").expect("a figure").draw)();
    assert!(svg.contains("= 0.853") && svg.contains("= 0.147"), "{svg}");
}

#[test]
fn the_roots_are_marked_on_the_circle_and_on_their_ray() {
    for y in [-0.9, -0.25, 0.0, 0.5, 0.75] {
        let parameters = roots::Parameters {
            rays: vec![Ray::new(Point3::new(0.0, y, 0.0), Vec3::X)],
            ..roots::Parameters::default()
        };
        let svg = roots::draw(&parameters);
        let drawing = parse(&svg);
        let sphere = one(&drawing, "circle", "sphere area");
        let ray = one(&drawing, "line", "ray line");
        let marks: Vec<Node> = all(&drawing, "circle", "ray hollow").collect();
        assert_eq!(marks.len(), 2, "a ray at height {y} has two roots");
        for mark in marks {
            let away = (f(&mark, "cx") - f(&sphere, "cx")).hypot(f(&mark, "cy") - f(&sphere, "cy"));
            assert!((away - f(&sphere, "r")).abs() < 0.02, "height {y}: {away}");
            assert!((f(&mark, "cy") - f(&ray, "y1")).abs() < 0.02);
        }
    }
}

#[test]
fn a_ray_that_misses_has_no_root_and_a_tangent_has_one() {
    let center = Point3::new(2.0, 0.0, 0.0);
    let ray = |y| Ray::new(Point3::new(0.0, y, 0.0), Vec3::X);
    assert_eq!(roots::roots(center, 1.0, &ray(1.5)), [0.0; 0]);
    assert_eq!(roots::roots(center, 1.0, &ray(1.0)), [2.0]);
    assert_eq!(roots::roots(center, 1.0, &ray(0.0)), [1.0, 3.0]);
}

#[test]
fn the_normal_starts_on_the_sphere_and_points_away_from_its_center() {
    let svg = normal::draw(&normal::Parameters::default());
    let drawing = parse(&svg);
    let sphere = one(&drawing, "circle", "sphere area");
    let arrow = one(&drawing, "line", "normal bold");
    let center = (f(&sphere, "cx"), f(&sphere, "cy"));
    let start = (f(&arrow, "x1") - center.0, f(&arrow, "y1") - center.1);
    let end = (f(&arrow, "x2") - center.0, f(&arrow, "y2") - center.1);
    assert!((start.0.hypot(start.1) - f(&sphere, "r")).abs() < 0.02);
    assert!(
        (start.0 * end.1 - start.1 * end.0).abs() < 3.0,
        "in line with the center"
    );
    assert!(end.0.hypot(end.1) > start.0.hypot(start.1), "outward");
}

#[test]
fn normals_point_outward_at_the_left_and_against_the_ray_at_the_right() {
    let svg = (figures::find("face_normal").expect("a figure").draw)();
    let drawing = parse(&svg);
    let vector = |line: Node| {
        (
            f(&line, "x2") - f(&line, "x1"),
            f(&line, "y2") - f(&line, "y1"),
        )
    };
    let rays = all(&drawing, "line", "ray line").map(vector);
    let normals = all(&drawing, "line", "normal bold").map(vector);
    let signs: Vec<bool> = rays
        .zip(normals)
        .map(|(ray, normal)| ray.0 * normal.0 + ray.1 * normal.1 < 0.0)
        .collect();
    assert_eq!(signs, [true, false, true, true]);
}

#[test]
fn a_pixel_has_a_full_dot_exactly_where_it_lies_inside_the_outline() {
    for width in [12, 24, 37] {
        let svg = red_sphere::draw(&red_sphere::Parameters { width });
        let drawing = parse(&svg);
        let outline = one(&drawing, "circle", "black line");
        for class in ["black solid", "black dot"] {
            let dots: Vec<Node> = all(&drawing, "circle", class).collect();
            assert!(dots.len() >= 8, "{width} wide: {} {class}", dots.len());
            for dot in dots {
                let away =
                    (f(&dot, "cx") - f(&outline, "cx")).hypot(f(&dot, "cy") - f(&outline, "cy"));
                assert_eq!(
                    away < f(&outline, "r"),
                    class == "black solid",
                    "{width} wide"
                );
            }
        }
    }
}

#[test]
fn the_passing_distance_and_half_of_the_way_inside_make_a_right_angle() {
    for (height, radius) in [(0.5, 1.15), (0.0, 1.0), (-0.6, 0.9)] {
        let svg = passing::draw(&passing::Parameters {
            center: Point3::new(2.75, height, 0.0),
            radius,
            ..passing::Parameters::default()
        });
        let drawing = parse(&svg);
        let sphere = one(&drawing, "circle", "sphere area");
        let distance = one(&drawing, "line", "faint dashed");
        let entry = one(&drawing, "circle", "ray hollow");
        let [center, foot, entry] = [
            (f(&sphere, "cx"), f(&sphere, "cy")),
            (f(&distance, "x2"), f(&distance, "y2")),
            (f(&entry, "cx"), f(&entry, "cy")),
        ];
        let away = |one: (f64, f64), other: (f64, f64)| (one.0 - other.0).hypot(one.1 - other.1);
        assert!(
            (away(center, entry) - f(&sphere, "r")).abs() < 0.02,
            "{svg}"
        );
        let (s, half) = (away(center, foot), away(entry, foot));
        assert!((s.hypot(half) - f(&sphere, "r")).abs() < 0.02, "{svg}");
    }
}

#[test]
fn the_cut_through_the_sphere_is_red_inside_the_circle() {
    let svg = sphere_test::draw(&sphere_test::Parameters::default());
    let drawing = parse(&svg);
    let circle = one(&drawing, "circle", "black line");
    // A run of pixels is a path: to its corner, so far across, so far down, and back.
    let is_red = |node: &Node| node.attribute("fill") == Some("#ff0000");
    let area_of = |node: Node| {
        let path = node.attribute("d").expect("a path leads somewhere");
        let sides: Vec<f64> = path
            .split(['h', 'v'])
            .skip(1)
            .flat_map(str::parse)
            .collect();
        sides[0] * sides[1]
    };
    let area: f64 = drawing.descendants().filter(is_red).map(area_of).sum();
    let expected = std::f64::consts::PI * f(&circle, "r").powi(2);
    assert!(
        (area / expected - 1.0).abs() < 0.03,
        "{area} and {expected}"
    );
}

#[test]
fn the_grid_has_a_dot_in_the_middle_of_each_pixel() {
    for (width, height) in [(7, 5), (4, 3), (16, 9)] {
        let svg = viewport_grid::draw(&viewport_grid::Parameters {
            camera: Camera::with_size(width, height),
            ..viewport_grid::Parameters::default()
        });
        let drawing = parse(&svg);
        let viewport = one(&drawing, "rect", "viewport wash");
        let side = f(&viewport, "width") / f64::from(width);
        let dots = places(&one(&drawing, "path", "faint"));
        assert_eq!(dots.len(), (width * height) as usize);
        for (x, y) in dots {
            for (center, corner) in [(x, "x"), (y, "y")] {
                let place = (center - f(&viewport, corner)) / side;
                assert!(
                    (place.fract() - 0.5).abs() < 0.001,
                    "{width} × {height}: {place}"
                );
            }
        }
    }
}

#[test]
fn what_cancels_grows_by_two_digits_with_each_factor_of_ten() {
    for tenths in (20..=70).step_by(5) {
        let parameters = digits::Parameters {
            tenths,
            ..digits::Parameters::default()
        };
        let agreeing = Numbers::of(&parameters.case()).agreeing();
        let expected = usize::from(tenths / 5);
        assert!(
            (expected - 2..=expected + 1).contains(&agreeing),
            "{agreeing} digits at {tenths} tenths"
        );
    }
}

#[test]
fn the_digits_shown_are_those_of_the_numbers_column_by_column() {
    for tenths in [0, 3, 45, 70, 82, 160] {
        let parameters = digits::Parameters {
            tenths,
            ..digits::Parameters::default()
        };
        let numbers = Numbers::of(&parameters.case());
        let svg = digits::draw(&parameters);
        let drawing = parse(&svg);
        let rows: Vec<String> = all(&drawing, "text", "digits label")
            .map(|row| words(&row))
            .collect();
        let mantissa = |x: f64| format!("{x:.16e}").split('e').next().map(str::to_owned);
        assert_eq!(mantissa(numbers.h_squared).as_ref(), rows.first());
        assert_eq!(numbers.exact_t.and_then(mantissa).as_ref(), rows.last());
        // In units of the last place the rows are whole numbers, and h² − ac is D. Each is
        // rounded to a unit, and D before by 2⁻⁵³ of less than 10¹⁷ units.
        let [h_squared, ac, discriminant] =
            [0, 1, 2].map(|n| rows[n].replace('.', "").parse::<i64>().expect("digits"));
        let left = (h_squared - ac).abs();
        assert!((left - discriminant).abs() <= 13, "{rows:?}");
        let struck = all(&drawing, "tspan", "faint struck").map(|span| words(&span));
        let struck: Vec<String> = struck.collect();
        let agreeing = usize::from(numbers.agreeing() > 0);
        assert_eq!(struck.len(), 2 * agreeing, "{struck:?}");
        assert_eq!(struck.first(), struck.last());
    }
}

#[test]
fn far_away_half_b_draws_another_star_and_certified_t_the_same() {
    let pixels = |tenths| {
        let svg = digits::draw(&digits::Parameters {
            tenths,
            ..digits::Parameters::default()
        });
        let drawing = parse(&svg);
        let of_group = |n| {
            let group = all(&drawing, "g", "pixels").nth(n).expect("two pictures");
            let pixel = |node: Node| {
                let [fill, place] =
                    ["fill", "d"].map(|name| node.attribute(name).expect("a pixel"));
                (color(fill), place.to_owned())
            };
            group.children().map(pixel).collect::<Vec<_>>()
        };
        [0, 1].map(of_group)
    };
    let [[plain, certified], [plain_far, certified_far]] = [pixels(60), pixels(80)];
    for ((near, place), (far, place_far)) in certified.iter().zip(&certified_far) {
        assert_eq!(place, place_far);
        let is_close = near
            .iter()
            .zip(far)
            .all(|(near, far)| near.abs_diff(*far) <= 1);
        assert!(is_close, "{near:?} and {far:?} at {place}");
    }
    assert_ne!(plain.len(), plain_far.len());
}

#[test]
fn the_edge_is_marked_where_half_b_is_not_what_exact_arithmetic_says() {
    for doublings in [0, 3, 20, 49] {
        let parameters = edge::Parameters {
            doublings,
            ..edge::Parameters::default()
        };
        let reach = -edge::REACH..=edge::REACH;
        let cells = reach.clone().rev().flat_map(|up| {
            reach
                .clone()
                .map(move |right| DVec2::new(right.into(), up.into()))
        });
        let (mut hits, mut wrong) = (0, 0);
        for (cell, decision) in cells.zip(parameters.decisions()) {
            let says = |method: &Method| {
                let case = parameters.case(cell);
                let t = case.put_to(method, f64::NEG_INFINITY, f64::INFINITY);
                t.is_some()
            };
            assert_eq!(decision.hits, says(&Method::EXACT));
            assert_eq!(decision.found, says(&Method::HALF_B));
            hits += usize::from(decision.hits);
            wrong += usize::from(decision.is_wrong());
        }
        assert!((100..500).contains(&hits), "{hits} hits at {doublings}");
        assert_eq!(wrong > 0, doublings < 7, "{wrong} wrong at {doublings}");
    }
}

#[test]
fn the_bars_of_the_nearest_are_what_the_list_asks_of_its_members() {
    let (all, slopes) = (nearest::Parameters::default(), [-0.4, -0.2, 0.0, 0.1, 0.3]);
    for (order, y) in [[0, 1, 2], [1, 2, 0], [2, 0, 1]]
        .into_iter()
        .flat_map(|order| slopes.map(|y| (order, y)))
    {
        let ray = Ray::new(Point3::ZERO, Vec3::new(1.0, y, 0.0));
        let asked = Arc::default();
        let mut world = HittableList::default();
        for (center, radius) in order.map(|place| all.spheres[place]) {
            let asked = Arc::clone(&asked);
            world.add(Telling(Sphere::new(center, radius), asked));
        }
        world.hit(&ray, 0.0, f64::INFINITY);
        let shown = nearest::Parameters { order, ray, ..all };
        let turns = shown.turns().into_iter();
        let turns: Vec<_> = turns.map(|it| (it.t_max, it.hit)).collect();
        assert_eq!(turns, *asked.lock().expect("no panic"), "{order:?} {y}");
    }
}

/// What a member of a list was asked, and its answer.
type Asked = Arc<Mutex<Vec<(Option<f64>, Option<f64>)>>>;

/// A sphere that writes down what it is asked.
struct Telling(Sphere, Asked);

impl Hittable for Telling {
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        let Self(sphere, asked) = self;
        let hit = sphere.hit(ray, t_min, t_max);
        let turn = (Some(t_max), hit.map(|it| it.t));
        asked.lock().expect("no panic").push(turn);
        hit
    }
}

#[test]
fn a_file_of_its_own_brings_its_style() {
    for (name, svg) in drawings() {
        let file = standalone(svg);
        let drawing = parse(&file);
        let style = drawing
            .descendants()
            .find(|node| node.has_tag_name("style"))
            .unwrap_or_else(|| panic!("{name} has no style"));
        assert!(style.text().is_some_and(|text| text.ends_with(CSS)));
    }
}

/// All figures and charts, and the charts of numbers that nobody measured.
fn drawings() -> &'static [(String, String)] {
    static DRAWINGS: LazyLock<Vec<(String, String)>> =
        LazyLock::new(|| of_the_book().chain(charts::of_invented_numbers()).collect());
    &DRAWINGS
}

/// All figures and charts.
fn of_the_book() -> impl Iterator<Item = (String, String)> {
    let figures = FIGURES
        .iter()
        .map(|figure| (figure.name.to_owned(), (figure.draw)()));
    figures.chain(charts::of_the_book())
}

pub(crate) fn parse(svg: &str) -> Document<'_> {
    Document::parse(svg).unwrap_or_else(|error| panic!("{error}:\n{svg}"))
}

fn size(drawing: &Document) -> (f64, f64) {
    let numbers: Vec<f64> = drawing
        .root_element()
        .attribute("viewBox")
        .expect("a drawing has a size")
        .split(' ')
        .map(|number| number.parse().expect("a number"))
        .collect();
    (numbers[2], numbers[3])
}

pub(crate) fn all<'a>(
    drawing: &'a Document,
    name: &'a str,
    class: &'a str,
) -> impl Iterator<Item = Node<'a, 'a>> {
    drawing
        .descendants()
        .filter(move |node| node.has_tag_name(name) && node.attribute("class") == Some(class))
}

fn one<'a>(drawing: &'a Document, name: &'a str, class: &'a str) -> Node<'a, 'a> {
    let found: Vec<Node> = all(drawing, name, class).collect();
    assert_eq!(found.len(), 1, "{name} of class {class}");
    found[0]
}

/// The number that is an attribute of `node`.
fn f(node: &Node, attribute: &str) -> f64 {
    let value = node
        .attribute(attribute)
        .unwrap_or_else(|| panic!("{node:?} has no {attribute}"));
    value
        .parse()
        .unwrap_or_else(|_| panic!("{attribute} is no number: {value}"))
}

/// The extreme points of a shape.
fn places(node: &Node) -> Vec<(f64, f64)> {
    match node.tag_name().name() {
        "line" => vec![
            (f(node, "x1"), f(node, "y1")),
            (f(node, "x2"), f(node, "y2")),
        ],
        "circle" => {
            let (x, y, r) = (f(node, "cx"), f(node, "cy"), f(node, "r"));
            vec![(x - r, y - r), (x + r, y + r)]
        }
        "rect" => {
            let (x, y) = (f(node, "x"), f(node, "y"));
            vec![(x, y), (x + f(node, "width"), y + f(node, "height"))]
        }
        "text" => vec![(f(node, "x"), f(node, "y"))],
        "path" => node
            .attribute("d")
            .expect("a path leads somewhere")
            .split(['M', 'L'])
            .filter(|step| !step.is_empty())
            .map(|step| {
                let (x, y) = step.split_once(' ').expect("a point has two numbers");
                let y = y.split('h').next().unwrap_or_default();
                (x.parse().expect("a number"), y.parse().expect("a number"))
            })
            .collect(),
        _ => Vec::new(),
    }
}

pub(crate) fn texts<'a>(drawing: &'a Document) -> impl Iterator<Item = Node<'a, 'a>> {
    drawing
        .descendants()
        .filter(|node| node.has_tag_name("text"))
}

pub(crate) fn words(text: &Node) -> String {
    text.descendants()
        .filter_map(|node| node.is_text().then(|| node.text()).flatten())
        .collect()
}

/// The place that a text takes, in the widest of the usual fonts.
#[derive(Debug)]
struct Label {
    #[expect(dead_code, reason = "it is printed when a test fails")]
    words: String,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

impl Label {
    fn of(text: &Node) -> Self {
        let size = |node: &Node| {
            node.has_attribute("font-size")
                .then(|| f(node, "font-size"))
        };
        let own = size(text).unwrap_or(14.0);
        let width: f64 = text
            .descendants()
            .filter(Node::is_text)
            .map(|piece| {
                let parent = piece.parent().expect("text is in an element");
                let size = size(&parent).unwrap_or(own);
                size * piece
                    .text()
                    .unwrap_or_default()
                    .chars()
                    .map(advance)
                    .sum::<f64>()
            })
            .sum();
        let (x, y) = (f(text, "x"), f(text, "y"));
        let left = match text.attribute("text-anchor") {
            Some("middle") => x - 0.5 * width,
            Some("end") => x - width,
            _ => x,
        };
        Self {
            words: words(text),
            left,
            right: left + width,
            top: y - 0.76 * own,
            bottom: y + 0.2 * own,
        }
    }

    fn lies_within(&self, width: f64, height: f64) -> bool {
        self.left >= 0.0 && self.right <= width && self.top >= 0.0 && self.bottom <= height
    }

    fn touches(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }
}

/// How wide a letter is, in sizes of the font: as in DejaVu Sans, rounded up.
fn advance(letter: char) -> f64 {
    match letter {
        'i' | 'j' | 'l' | ' ' | ',' | '.' | ':' | '|' => 0.34,
        'f' | 't' | 'r' | '(' | ')' | '-' | '·' => 0.42,
        'm' | 'w' | 'M' | 'W' | '−' | '<' | '>' | '=' | '+' | '×' | '∞' => 0.86,
        'A'..='Z' | 'Δ' => 0.74,
        _ => 0.64,
    }
}

/// The two colors of each idea, for light and for dark.
fn palette() -> BTreeMap<&'static str, [[u8; 3]; 2]> {
    CSS.lines()
        .filter_map(|line| {
            let (name, colors) = line
                .trim()
                .strip_prefix("--")?
                .split_once(": light-dark(")?;
            let (light, dark) = colors.strip_suffix(");")?.split_once(", ")?;
            Some((name, [light, dark].map(color)))
        })
        .collect()
}

fn color(hex: &str) -> [u8; 3] {
    [1, 3, 5].map(|at| u8::from_str_radix(&hex[at..at + 2], 16).expect("two digits"))
}

/// How much of its color a depth of heat has.
fn opacity(depth: usize) -> f64 {
    let rule = format!(".depth-{depth} {{ fill-opacity: ");
    let (_, rest) = CSS.split_once(&rule).expect("the depth has a rule");
    let (opacity, _) = rest.split_once(';').expect("a rule ends");
    opacity.parse().expect("a number")
}

/// A color over a background.
fn mix(color: [u8; 3], background: [u8; 3], opacity: f64) -> [u8; 3] {
    std::array::from_fn(|n| {
        let [over, under] = [color[n], background[n]].map(f64::from);
        (opacity * over + (1.0 - opacity) * under).round() as u8
    })
}

/// What the themes of mdBook put behind a drawing, and the paper of a file.
fn backgrounds(light: bool) -> Vec<(&'static str, [u8; 3])> {
    let paper = palette()["paper"][usize::from(!light)];
    if light {
        vec![
            ("paper", paper),
            ("light", [255; 3]),
            ("rust", [225, 225, 219]),
        ]
    } else {
        vec![
            ("paper", paper),
            ("coal", [19, 21, 22]),
            ("navy", [22, 25, 35]),
            ("ayu", [15, 20, 26]),
        ]
    }
}

/// How well two colors can be told apart, by WCAG 2: from 1 to 21.
fn contrast(one: [u8; 3], other: [u8; 3]) -> f64 {
    let (a, b) = (luminance(one), luminance(other));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

fn luminance(rgb: [u8; 3]) -> f64 {
    let [red, green, blue] = rgb.map(|level| {
        let level = f64::from(level) / 255.0;
        if level <= 0.04045 {
            level / 12.92
        } else {
            ((level + 0.055) / 1.055).powf(2.4)
        }
    });
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}
