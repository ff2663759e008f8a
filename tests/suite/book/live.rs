//! Live figures begin as the page shows them, answer whatever they are asked; live pictures
//! are those of the chapters and of the slips; and the module of the pages answers as the
//! crate does. What a reader does to them in a browser is in `browser/dragged.rs` and
//! `browser/painted.rs`.

use ::live::picture::{PICTURES, Painting};
use ::live::{FIGURES, Live};
use common::rtweekend::Picture;
use glam::DVec2;
use slips::Chapter;
use slips::Slip;

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
