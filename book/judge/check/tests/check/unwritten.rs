//! A right picture whose program has a `todo!()` in a function that no ray needs.

use check::answer::Answer;
use check::attempt::{Attempt, LawsStatus};
use check::context::Context;
use check::judge_file;
use check::task::Task;
use slips::{Chapter, ChapterCode, steps};

fn answer(text: &str, laws: &LawsStatus) -> Answer {
    let task = Task::of(Chapter::Gradient);
    let context = Context {
        steps: vec![false; steps::of_chapter(Chapter::Gradient).len()],
        ..Context::default()
    };
    let attempt = Attempt {
        laws: Some(laws),
        ..Attempt::new(task, &context)
    };
    attempt.answer(judge_file(&task, text.as_bytes(), 0, &context))
}

#[test]
fn a_picture_or_a_step_is_not_done_while_a_function_has_a_todo() {
    let mut right = Vec::new();
    let picture = Chapter::Gradient.picture(32);
    picture.write_p3(&mut right).expect("memory takes it");
    let right = String::from_utf8(right).expect("it is text");
    let white = format!("P3\n32 18\n255\n{}", "255 255 255\n".repeat(32 * 18));
    let place = "src/ray.rs:18:9";
    for text in [&right, &white] {
        let done = answer(text, &LawsStatus::Obeyed).done;
        assert!(!done.is_empty());
        for laws in [LawsStatus::UnwrittenPrelude, LawsStatus::NotWritten] {
            let unwritten = answer(text, &laws(place.to_owned()));
            assert!(!unwritten.is_right() && unwritten.done.is_empty());
            let headline = unwritten.headline.to_string();
            assert!(headline.contains(place), "{headline}");
        }
    }
}
