//! Live figures begin as the page shows them, answer whatever they are asked; live pictures
//! are those of the chapters and of the slips; and the module of the pages answers as the
//! crate does. What a reader does to them in a browser is in `browser/dragged.rs` and
//! `browser/painted.rs`.

use std::io::Read;
use std::iter;

use ::live::picture::{self, PICTURES, Painting};
use ::live::{FIGURES, Live};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use common::rtweekend::Picture;
use flate2::read::GzDecoder;
use glam::DVec2;
use slips::Chapter;
use slips::{self, Slip};
use wasmi::{Engine, Instance, Module, Store, TypedFunc, WasmParams, WasmResults};

/// What the pages load.
const MODULE: &str = include_str!("../../../book/notes/live/module.js");

/// What to do when the figures are changed, or a chapter that they show.
const STALE: &str =
    "book/notes/live/module.js is not made of these sources. Build it anew: .ci/live";

#[test]
fn a_live_figure_begins_as_the_page_shows_it() {
    for live in FIGURES {
        let figure = figures::find(live.name).expect("a figure of that name");
        assert_eq!((live.answer)(&live.defaults()).svg, (figure.draw)());
    }
}

#[test]
fn a_figure_that_was_moved_describes_what_it_shows_now() {
    for live in FIGURES {
        let described = |numbers: &[f64]| {
            let text = live.text(numbers);
            let svg = text.lines().next().expect("a drawing").to_owned();
            let drawing = roxmltree::Document::parse(&svg).expect("an SVG");
            let mut all = drawing.descendants();
            let description = all
                .find(|it| it.has_tag_name("desc"))
                .expect("a description");
            description.text().expect("words").to_owned()
        };
        let figure = figures::find(live.name).expect("a figure of that name");
        assert_eq!(described(&live.defaults()), figure.description);
        let moved = &questions(live, 2)[1];
        let sentence = (live.answer)(moved).sentence.replace('*', "");
        assert_eq!(described(moved), sentence);
    }
}

#[test]
fn a_live_figure_has_an_answer_to_everything() {
    for live in FIGURES {
        for numbers in questions(live, 300) {
            let answer = (live.answer)(&numbers);
            let text = live.text(&numbers);
            assert!(
                !text.contains("NaN") && !text.contains("inf"),
                "{} {numbers:?}",
                live.name
            );
            roxmltree::Document::parse(&answer.svg).expect("an SVG");
            assert_eq!(answer.handles.len(), live.handles.len());
            assert!(answer.sentence.ends_with(['.', '!']), "{}", answer.sentence);
        }
    }
}

#[test]
fn a_handle_comes_to_where_it_is_dragged() {
    for live in FIGURES {
        for (n, handle) in live.handles.iter().enumerate() {
            let mut numbers = live.defaults();
            let before = (live.answer)(&numbers).handles[n];
            // Inwards, and by more than half of a pixel of the grid, which is its least step.
            let to = before + 24.0 * (DVec2::new(200.0, 150.0) - before).signum();
            live.drag(handle, &mut numbers, to);
            let after = (live.answer)(&numbers).handles[n];
            assert!(after != before, "{} stays", live.name);
            let (near, far) = ((after - to).length(), (before - to).length());
            assert!(
                near < far,
                "{}: handle {n} is {near} from where it was dragged",
                live.name
            );
        }
    }
}

#[test]
fn in_the_figure_of_the_nearest_each_search_lets_another_sphere_win() {
    let live = ::live::find("nearest").expect("a live figure");
    for (search, winner) in [(0.0, 2), (1.0, 1), (2.0, 3)] {
        let mut numbers = live.defaults();
        *numbers.last_mut().expect("the choice of a search") = search;
        let sentence = (live.answer)(&numbers).sentence;
        assert!(
            sentence.contains(&format!("Sphere {winner} wins")),
            "{sentence}"
        );
    }
}

#[test]
fn the_text_beside_a_broken_figure_tells_what_that_shows() {
    let told = |name, numbers: &[f64]| {
        let live = ::live::find(name).expect("a live figure");
        (live.answer)(numbers).says.remove(0).1
    };
    let roots = told("discriminant", &[0.0, 0.0, 1.0, 0.0, 3.0, 0.6, 1.2, 2.0]);
    assert_eq!(roots, "the roots are −4.04 and −1.96");
    let mut numbers = ::live::find("nearest").expect("a live figure").defaults();
    for (search, held) in [(0.0, "∞, 2.27, 1.3, 1.3"), (2.0, "∞, 2.27, 1.3, 3.34")] {
        numbers[12] = search;
        assert_eq!(told("nearest", &numbers), held);
    }
}

#[test]
fn what_a_slip_makes_of_the_roots_is_told_of_those_that_are_off() {
    let live = ::live::find("discriminant").expect("a live figure");
    for (numbers, sentence) in [
        (
            [0.0, -0.55, 1.0, 0.0, 3.0, 0.6, 1.2, 3.0],
            "The roots should be 2.66 and 3.34, but none comes out.",
        ),
        (
            [1.8, 0.6, 1.0, 0.0, 3.0, 0.6, 1.2, 1.0],
            "The roots should be 0 and 2.4, but −2.4 and 0 come out. At −2.4 the line is not on \
             the sphere.",
        ),
        (
            [0.0, 0.0, 1.0, 0.0, 3.0, 0.6, 1.2, 2.0],
            "The roots should be 1.96 and 4.04, but −4.04 and −1.96 come out. These places are not \
             on the sphere. What is missing on the axis is farther off.",
        ),
        // These differ from the right ones in their last bits.
        (
            [2.1, 0.9, 0.3, 0.9, 3.0, 0.6, 1.2, 1.0],
            "Here the slip does no harm: the roots are the right ones. Change something, the radius \
             too.",
        ),
    ] {
        assert_eq!((live.answer)(&numbers).sentence, sentence);
    }
}

#[test]
fn a_ray_from_the_surface_and_a_root_without_an_error_are_told_as_such() {
    let sentence = |name, numbers: &[f64]| {
        let live = ::live::find(name).expect("a live figure");
        (live.answer)(numbers).sentence
    };
    for from in [[1.0, 0.0], [0.6, 0.8]] {
        let said = sentence("face_normal", &from);
        assert!(said.starts_with("This ray starts on the sphere"), "{said}");
    }
    let said = sentence("face_normal", &[1.2, 0.0]);
    assert!(said.starts_with("This ray does not meet"), "{said}");
    let digits = ::live::find("digits").expect("a live figure");
    let said: Vec<String> = questions(digits, 300)
        .iter()
        .map(|numbers| sentence("digits", numbers))
        .collect();
    assert!(
        said.iter()
            .any(|it| it.contains("No digit of *t* is wrong"))
    );
    assert!(!said.iter().any(|it| it.contains("off by 0 radii")));
}

#[test]
fn what_is_no_number_or_out_of_range_is_put_right() {
    for live in FIGURES {
        let mut numbers = vec![f64::NAN; live.numbers.len()];
        live.confine(&mut numbers);
        assert_eq!(numbers, live.defaults());
        numbers.fill(f64::INFINITY);
        live.confine(&mut numbers);
        assert_eq!(numbers, live.defaults());
        numbers.fill(1e9);
        live.confine(&mut numbers);
        assert!(
            numbers
                .iter()
                .zip(live.numbers)
                .all(|(&it, number)| it == number.most)
        );
        numbers.fill(0.6);
        live.confine(&mut numbers);
        let mut whole = numbers.iter().zip(live.numbers);
        assert!(whole.all(|(it, number)| number.steps > 1.0 || it.fract() == 0.0));
    }
}

#[test]
fn a_button_leaves_every_number_in_its_range() {
    for live in FIGURES {
        for mut numbers in questions(live, 100) {
            for action in live.actions {
                (action.act)(&mut numbers);
                let mut confined = numbers.clone();
                live.confine(&mut confined);
                assert_eq!(numbers, confined, "{}: {}", live.name, action.name);
            }
        }
    }
}

/// Only twenty questions, because an interpreter is slow. Browsers are asked a thousand:
/// see `browser/dragged.rs`.
#[test]
fn the_module_of_the_pages_answers_as_this_crate_does() {
    let mut module = Interpreted::new();
    for (place, live) in FIGURES.iter().enumerate() {
        for numbers in questions(live, 20) {
            let said = module.answer(place, &numbers);
            assert_eq!(
                said,
                live.text(&numbers),
                "{} {numbers:?}\n{STALE}",
                live.name
            );
        }
    }
}

#[test]
fn the_module_drags_and_acts_as_this_crate_does() {
    let mut module = Interpreted::new();
    for (place, live) in FIGURES.iter().enumerate() {
        for numbers in questions(live, 20) {
            for (n, handle) in live.handles.iter().enumerate() {
                let to = 0.9 * (live.answer)(&numbers).handles[n] + DVec2::ONE;
                let mut dragged = numbers.clone();
                live.drag(handle, &mut dragged, to);
                module.set(&numbers);
                module.call::<_, ()>("drag", (place as u32, n as u32, to.x, to.y));
                assert_eq!(module.get(numbers.len()), dragged, "{}\n{STALE}", live.name);
            }
            for (n, action) in live.actions.iter().enumerate() {
                let mut changed = numbers.clone();
                (action.act)(&mut changed);
                module.set(&numbers);
                module.call::<_, ()>("act", (place as u32, n as u32));
                assert_eq!(module.get(numbers.len()), changed, "{}\n{STALE}", live.name);
            }
        }
    }
}

#[test]
fn a_live_picture_is_what_its_chapter_draws_and_what_a_slip_draws() {
    for live in PICTURES {
        for width in [1, 2, 97, live.chapter.book_width()] {
            let drawn = live.chapter.picture(width);
            let painting = Painting::right((live.picture)(width));
            assert_eq!(painting.size(), (drawn.width(), drawn.height()));
            assert!(painting.flatten().eq(opaque(&drawn)), "{:?}", live.chapter);
        }
        for (_, slip) in slips_in(live.chapter) {
            let drawn = slip.program(live.chapter).run(97).picture();
            let painting = Painting::slipped(slip, live.chapter, 97);
            assert_eq!(painting.size(), (drawn.width(), drawn.height()));
            assert!(painting.flatten().eq(opaque(&drawn)), "{}", slip.name);
        }
    }
}

#[test]
fn the_module_paints_as_this_crate_does() {
    let mut module = Interpreted::new();
    for (place, live) in (0..).zip(PICTURES) {
        let width = live.chapter.book_width();
        let drawn = live.chapter.picture(width);
        let painted = module.painting(place, RIGHT, width);
        assert!(painted == opaque(&drawn), "{:?}\n{STALE}", live.chapter);
        for (slip_place, slip) in slips_in(live.chapter) {
            let drawn = slip.program(live.chapter).run(21).picture();
            let painted = module.painting(place, slip_place, 21);
            assert!(painted == opaque(&drawn), "{}\n{STALE}", slip.name);
        }
    }
}

#[test]
fn a_live_picture_says_what_is_wrong_and_how_much_is_seen() {
    let verdict = |chapter, slip: Option<&str>, width, different| {
        let live = PICTURES.iter().find(|live| live.chapter == chapter);
        let slip = slip.map(|name| slips::find(name).expect("a slip"));
        picture::verdict(live.expect("a live picture"), slip, width, different)
    };
    let right = verdict(Chapter::Normals, None, 400, 0);
    assert!(right.starts_with("400 × 225 pixels"), "{right}");
    let wrong = verdict(Chapter::Normals, Some("far-root"), 400, 13_000);
    assert!(wrong.contains("13000 of 90000 pixels differ"), "{wrong}");
    let turned = verdict(Chapter::Normals, Some("header-swapped"), 400, 1);
    assert!(
        turned.contains("It is 225 × 400, and should be 400 × 225."),
        "{turned}"
    );
    let narrow = verdict(Chapter::RedSphere, Some("radius-added"), 1, 0);
    assert!(narrow.contains("the probe"), "{narrow}");
    let hidden = verdict(Chapter::HittableList, Some("first-hit-wins"), 400, 0);
    assert!(hidden.contains("the probe reversed shows it"), "{hidden}");
    let unseen = verdict(Chapter::RedSphere, Some("oc-reversed"), 400, 0);
    assert!(unseen.contains("no pixel differs"), "{unseen}");
}

#[test]
fn the_module_is_small_enough_to_be_on_a_page() {
    assert!(MODULE.len() <= 165_000, "{} bytes", MODULE.len());
}

/// The slips that can be made in a chapter, with their places in the catalogue.
pub(crate) fn slips_in(chapter: Chapter) -> impl Iterator<Item = (u32, &'static Slip)> {
    (0..)
        .zip(slips::all())
        .filter(move |(_, slip)| slip.chapters.contains(&chapter))
}

/// The bytes of a picture as a canvas has them: four a pixel.
pub(crate) fn opaque(picture: &Picture) -> Vec<u8> {
    let (pixels, _) = picture.rgb().as_chunks();
    pixels
        .iter()
        .flat_map(|&[red, green, blue]| [red, green, blue, 255])
        .collect()
}

/// In place of a slip: none.
const RIGHT: u32 = u32::MAX;

/// `count` questions to a figure: first that of the page, then numbers over the whole of
/// their ranges, on steps and between them, always the same.
pub(crate) fn questions(live: &Live, count: usize) -> Vec<Vec<f64>> {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut question = || {
        let value = |number: &::live::Number| {
            let value = number.least + (number.most - number.least) * random.next();
            let is_on_a_step = !number.choices.is_empty() || random.next() < 0.5;
            match is_on_a_step {
                true => {
                    ((value * number.steps).round() / number.steps).clamp(number.least, number.most)
                }
                false => value,
            }
        };
        let mut numbers: Vec<f64> = live.numbers.iter().map(value).collect();
        live.confine(&mut numbers);
        numbers
    };
    let mut questions = vec![live.defaults()];
    questions.extend((1..count).map(|_| question()));
    questions
}

/// A linear congruential generator: Knuth's constants (TAOCP 2, 3.3.4), the high bits.
struct Random(u64);

impl Random {
    /// From 0 to 1.
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// The module in an interpreter, which needs no browser.
struct Interpreted {
    store: Store<()>,
    instance: Instance,
}

impl Interpreted {
    fn new() -> Self {
        let text = MODULE.split('"').nth(1).expect("a text in quotes");
        let compressed = BASE64_STANDARD.decode(text).expect("base64");
        let mut bytes = Vec::new();
        let mut stream = GzDecoder::new(&compressed[..]);
        stream.read_to_end(&mut bytes).expect("gzip");
        let engine = Engine::default();
        let module = Module::new(&engine, &bytes).expect("WebAssembly");
        let mut store = Store::new(&engine, ());
        let instance = Instance::new(&mut store, &module, &[]).expect("it needs nothing");
        Self { store, instance }
    }

    fn call<P: WasmParams, R: WasmResults>(&mut self, name: &str, parameters: P) -> R {
        let function: TypedFunc<P, R> = self
            .instance
            .get_typed_func(&self.store, name)
            .expect("a function");
        let result = function.call(&mut self.store, parameters);
        result.unwrap_or_else(|cause| panic!("{name}: {cause}"))
    }

    fn set(&mut self, numbers: &[f64]) {
        for (&value, place) in numbers.iter().zip(0_u32..) {
            self.call::<_, ()>("set", (place, value));
        }
    }

    fn get(&mut self, count: usize) -> Vec<f64> {
        (0..count)
            .map(|place| self.call("get", place as u32))
            .collect()
    }

    fn answer(&mut self, figure: usize, numbers: &[f64]) -> String {
        self.set(numbers);
        let length = self.call("answer", figure as u32);
        String::from_utf8(self.bytes(length)).expect("UTF-8")
    }

    fn painting(&mut self, picture: u32, slip: u32, width: u32) -> Vec<u8> {
        self.call::<_, ()>("paint", (picture, slip, width));
        let piece = || {
            let length = self.call("piece", ());
            Some(self.bytes(length)).filter(|bytes| !bytes.is_empty())
        };
        iter::from_fn(piece).flatten().collect()
    }

    fn bytes(&mut self, length: u32) -> Vec<u8> {
        let at: u32 = self.call("place", ());
        let memory = self
            .instance
            .get_memory(&self.store, "memory")
            .expect("memory");
        memory.data(&self.store)[at as usize..][..length as usize].to_vec()
    }
}
