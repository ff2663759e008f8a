//! Live figures answer whatever they are asked. What a reader does to them in a browser is in
//! `tests/browser`.

use std::fmt::Write;

use common::rtweekend::*;
use figures::number::{spoken, three_digits};
use figures::{Movable, Parameter, figures};
use hittable_list::{Hittable, HittableList, Sphere};
use insta::assert_snapshot;
use speed_vs_accuracy::Random;

/// The texts of each figure at the beginning, after each button, and for each choice.
#[test]
fn the_snapshot_has_what_each_live_figure_says() {
    let mut said = String::new();
    for live in figures() {
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
        for (n, number) in live.parameters().iter().enumerate() {
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
fn a_live_figure_has_an_answer_to_everything() {
    for live in figures() {
        for numbers in questions(live, 60) {
            let (name, text) = (live.name(), live.text(&numbers));
            let is_a_number = !text.contains("NaN") && !text.contains("inf");
            assert!(is_a_number, "{name} {numbers:?}");
            let answer = live.answer(&numbers);
            assert_eq!(answer.handles.len(), live.handles().len());
            assert!(answer.sentence.ends_with(['.', '!']), "{}", answer.sentence);
        }
    }
}

/// The value beside the last line of a listing is the chapter's own answer.
#[test]
fn the_values_beside_a_listing_end_with_the_chapters_own_answer() {
    let normal = |numbers: &[f64]| {
        let &[q_x, q_y, d_x, d_y] = numbers else {
            panic!("its numbers: {numbers:?}");
        };
        let ray = Ray::new(Point3::new(q_x, q_y, 0.0), Vec3::new(d_x, d_y, 0.0));
        normals::hit_sphere(Point3::ZERO, 1.6, &ray)
    };
    let walk = |numbers: &[f64]| {
        let &[c_x, c_y, radius, length] = numbers else {
            panic!("its numbers: {numbers:?}");
        };
        let ray = Ray::new(Point3::ZERO, length * Vec3::X);
        half_b_sphere::hit_sphere(Point3::new(c_x, c_y, 0.0), radius, &ray)
    };
    type Hit<'a> = &'a dyn Fn(&[f64]) -> Option<f64>;
    for (name, hit) in [("normal", &normal as Hit), ("walk", &walk)] {
        let live = figure(name);
        for numbers in questions(live, 60) {
            let says = live.answer(&numbers).says;
            let expected = hit(&numbers).map(|t| format!("Some({})", spoken(t)));
            assert_eq!(
                says["result"],
                expected.unwrap_or_default(),
                "{name} {numbers:?}"
            );
        }
    }
}

/// The figure goes through the list turn by turn, and ends where chapter 5's own list does.
#[test]
fn the_nearest_hit_of_the_figure_is_that_of_the_list() {
    let live = figure("nearest");
    for numbers in questions(live, 60) {
        let place = |n: usize| Point3::new(numbers[n], numbers[n + 1], 0.0);
        let mut list = HittableList::default();
        for (n, radius) in [(0, 0.7), (2, 0.6), (4, 0.5)] {
            list.add(Sphere::new(place(n), radius));
        }
        let ray = Ray::new(place(8), place(6));
        let nearest = list.hit(&ray, 0.0, f64::INFINITY);
        let expected = nearest.map_or("∞".to_owned(), |record| three_digits(record.t));
        let held = &live.answer(&numbers).says["held"];
        assert_eq!(held.split(", ").last(), Some(&expected[..]), "{numbers:?}");
    }
}

fn figure(name: &str) -> &'static dyn Movable {
    let mut figures = figures();
    figures.find(|it| it.name() == name).expect("a figure")
}

/// Makes `count` questions to a figure: first that of the page, then numbers over the whole of
/// their ranges, on steps and between them; the same in each run.
fn questions(live: &dyn Movable, count: usize) -> Vec<Vec<f64>> {
    let mut random = Random::new(1);
    let mut value = |number: &Parameter| {
        let value = random.between(number.least, number.most);
        if number.choices.is_empty() && random.between(0.0, 1.0) < 0.5 {
            return value;
        }
        ((value * number.steps).round() / number.steps).clamp(number.least, number.most)
    };
    let mut question = || {
        let mut numbers: Vec<f64> = live.parameters().iter().map(&mut value).collect();
        live.confine(&mut numbers);
        numbers
    };
    let mut questions = vec![live.defaults()];
    questions.extend((1..count).map(|_| question()));
    questions
}
