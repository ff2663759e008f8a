//! Live figures answer whatever they are asked, and live pictures are those of the chapters
//! and of the slips. What a reader does to them in a browser is in `tests/browser`.

use std::fmt::Write;

use ::live::picture::{self, PICTURES, Painting};
use common::rtweekend::*;
use figures::number::{spoken, three_digits};
use figures::{Movable, Number, live_figures};
use glam::DVec2;
use hittable_list::{Hittable, HittableList, Sphere};
use insta::assert_snapshot;
use slips::{Chapter, Slip};
use speed_vs_accuracy::Random;

/// At the beginning, after each button, and for each choice.
#[test]
fn the_snapshot_has_what_each_live_figure_says() {
    let mut said = String::new();
    for live in live_figures() {
        let _ = writeln!(said, "{}", live.name());
        let mut tell = |when: &str, numbers: &[f64]| {
            let answer = live.answer(numbers);
            let _ = writeln!(said, "  {when}: {}\n    {:?}", answer.sentence, answer.says);
        };
        tell("as on the page", &live.defaults());
        for (n, action) in live.actions().into_iter().enumerate() {
            let mut numbers = live.defaults();
            live.act(n, &mut numbers);
            tell(action, &numbers);
        }
        for (n, number) in live.numbers().iter().enumerate() {
            for (choice, value) in number.choices.iter().zip(0_u8..).skip(1) {
                let mut numbers = live.defaults();
                numbers[n] = value.into();
                tell(choice, &numbers);
            }
        }
    }
    assert_snapshot!(said);
}

#[test]
fn the_snapshot_has_what_is_said_of_a_live_picture() {
    let said = [
        (Chapter::Normals, None, 400, 0),
        (Chapter::Normals, Some("far-root"), 400, 13_000),
        (Chapter::Normals, Some("header-swapped"), 400, 1),
        (Chapter::RedSphere, Some("radius-doubled"), 1, 0),
        (Chapter::HittableList, Some("first-hit-wins"), 400, 0),
        (Chapter::RedSphere, Some("oc-reversed"), 400, 0),
    ]
    .map(|(chapter, slip, width, different)| {
        let live = PICTURES.iter().find(|live| live.chapter == chapter);
        let slip = slip.map(|name| slips::find(name).expect("a slip"));
        picture::verdict(live.expect("a live picture"), slip, width, different)
    });
    assert_snapshot!(said.join("\n\n"));
}

#[test]
fn a_live_figure_has_an_answer_to_everything() {
    for live in live_figures() {
        for numbers in questions(live, 60) {
            let answer = live.answer(&numbers);
            let text = live.text(&numbers);
            assert!(
                !text.contains("NaN") && !text.contains("inf"),
                "{} {numbers:?}",
                live.name()
            );
            roxmltree::Document::parse(&answer.drawing.finish()).expect("an SVG");
            assert_eq!(answer.handles.len(), live.handles().len());
            assert!(answer.sentence.ends_with(['.', '!']), "{}", answer.sentence);
        }
    }
}

/// What stands beside the last line of a listing is what the chapter itself answers.
#[test]
fn the_values_beside_a_listing_end_with_the_chapters_own_answer() {
    let said = |t: Option<f64>| t.map_or(String::new(), |t| format!("Some({})", spoken(t)));
    for (name, hit_sphere) in [
        ("normal", normals::hit_sphere as fn(_, _, &_) -> _),
        ("projection", half_b_sphere::hit_sphere),
    ] {
        let live = figures::find_live(name).expect("a live figure");
        for numbers in questions(live, 60) {
            let (center, radius, ray) = match (name, &numbers[..]) {
                ("normal", &[q_x, q_y, d_x, d_y]) => (
                    Point3::ZERO,
                    1.6,
                    Ray::new(Point3::new(q_x, q_y, 0.0), Vec3::new(d_x, d_y, 0.0)),
                ),
                (_, &[c_x, c_y, length]) => (
                    Point3::new(c_x, c_y, 0.0),
                    1.0,
                    Ray::new(Point3::ZERO, length * Vec3::X),
                ),
                _ => unreachable!("their numbers"),
            };
            let says = live.answer(&numbers).says;
            let result = says
                .iter()
                .find(|(of, _)| *of == "result")
                .map(|(_, it)| it);
            assert_eq!(
                result,
                Some(&said(hit_sphere(center, radius, &ray))),
                "{name} {numbers:?}"
            );
        }
    }
}

/// The figure goes through the list turn by turn, and ends where chapter 5's own list does.
#[test]
fn the_nearest_hit_of_the_figure_is_that_of_the_list() {
    let live = figures::find_live("nearest").expect("a live figure");
    for mut numbers in questions(live, 60) {
        numbers[10] = 3.0;
        let place = |n: usize| Point3::new(numbers[n], numbers[n + 1], 0.0);
        let mut list = HittableList::default();
        for (n, radius) in [(0, 0.7), (2, 0.6), (4, 0.5)] {
            list.add(Sphere::new(place(n), radius));
        }
        let ray = Ray::new(place(8), place(6));
        let nearest = list.hit(&ray, 0.0, f64::INFINITY);
        let expected = nearest.map_or("∞".to_owned(), |record| three_digits(record.t));
        let (_, held) = &live.answer(&numbers).says[0];
        assert_eq!(held.split(", ").last(), Some(&expected[..]), "{numbers:?}");
    }
}

#[test]
fn a_handle_comes_to_where_it_is_dragged() {
    for live in live_figures() {
        for (n, _) in live.handles().iter().enumerate() {
            let mut numbers = live.defaults();
            let before = live.answer(&numbers).handles[n];
            // Inwards, and by more than half of a pixel of the grid, which is its least step.
            let to = before + 24.0 * (DVec2::new(200.0, 150.0) - before).signum();
            live.drag(n, &mut numbers, to);
            let after = live.answer(&numbers).handles[n];
            assert!(after != before, "{} stays", live.name());
            let (near, far) = ((after - to).length(), (before - to).length());
            assert!(
                near < far,
                "{}: handle {n} is {near} from where it was dragged",
                live.name()
            );
        }
    }
}

#[test]
fn what_is_no_number_is_put_right_and_what_is_out_of_range_is_cut_off() {
    for live in live_figures() {
        for nonsense in [f64::NAN, f64::INFINITY] {
            let mut numbers = vec![nonsense; live.numbers().len()];
            live.confine(&mut numbers);
            assert_eq!(numbers, live.defaults());
        }
        let mut numbers = vec![1e9; live.numbers().len()];
        live.confine(&mut numbers);
        let most: Vec<f64> = live.numbers().iter().map(|number| number.most).collect();
        assert_eq!(numbers, most);
    }
}

#[test]
fn a_live_picture_is_what_its_chapter_draws_and_what_a_slip_draws() {
    for live in PICTURES {
        let right = Painting::right((live.picture)(97));
        assert!(
            right.flatten().eq(opaque(&live.chapter.picture(97))),
            "{:?}",
            live.chapter
        );
        for slip in slips_in(live.chapter) {
            let drawn = slip.program(live.chapter).run(97).picture();
            let painting = Painting::slipped(slip, live.chapter, 97);
            assert!(painting.flatten().eq(opaque(&drawn)), "{}", slip.name);
        }
    }
}

/// The slips that can be made in a chapter.
fn slips_in(chapter: Chapter) -> impl Iterator<Item = &'static Slip> {
    slips::all().filter(move |slip| slip.chapters.contains(&chapter))
}

/// The bytes of a picture as a canvas has them: four a pixel.
fn opaque(picture: &Picture) -> Vec<u8> {
    let (pixels, _) = picture.rgb().as_chunks();
    pixels
        .iter()
        .flat_map(|&[red, green, blue]| [red, green, blue, 255])
        .collect()
}

/// `count` questions to a figure: first that of the page, then numbers over the whole of
/// their ranges, on steps and between them, always the same.
fn questions(live: &dyn Movable, count: usize) -> Vec<Vec<f64>> {
    let mut random = Random::new(1);
    let mut question = || {
        let value = |number: &Number| {
            let value = random.between(number.least, number.most);
            let is_on_a_step = !number.choices.is_empty() || random.between(0.0, 1.0) < 0.5;
            if is_on_a_step {
                ((value * number.steps).round() / number.steps).clamp(number.least, number.most)
            } else {
                value
            }
        };
        let mut numbers: Vec<f64> = live.numbers().iter().map(value).collect();
        live.confine(&mut numbers);
        numbers
    };
    let mut questions = vec![live.defaults()];
    questions.extend((1..count).map(|_| question()));
    questions
}
