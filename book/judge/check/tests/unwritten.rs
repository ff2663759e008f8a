//! A picture that is right says nothing of a function that no ray of it needs.

use check::known::Known;
use check::scene::Scene;
use check::whole::{Evidence, Laws, Verdict};
use slips::{Chapter, steps};

fn verdict(text: &str, laws: &Laws) -> Verdict {
    let scene = Scene::new(Chapter::Gradient, None).expect("it is a scene");
    let known = Known {
        steps: vec![false; steps::of(Chapter::Gradient).len()],
        ..Known::default()
    };
    let evidence = Evidence {
        scene: &scene,
        known: &known,
        laws: Some(laws),
        watch: &|_| String::new(),
        start: &|_| String::new(),
    };
    evidence.of_picture(text.as_bytes())
}

#[test]
fn a_picture_or_a_step_is_not_done_while_the_prelude_has_a_todo() {
    let mut right = Vec::new();
    let picture = Chapter::Gradient.picture(32);
    picture.write_p3(&mut right).expect("memory takes it");
    let right = String::from_utf8(right).expect("it is text");
    let white = format!("P3\n32 18\n255\n{}", "255 255 255\n".repeat(32 * 18));
    let place = "src/ray.rs:18:9";
    for text in [&right, &white] {
        let done = verdict(text, &Laws::Obeyed).done;
        assert!(!done.is_empty());
        let unwritten = verdict(text, &Laws::UnwrittenPrelude(place.to_owned()));
        assert!(!unwritten.is_right && unwritten.done.is_empty());
        assert!(unwritten.headline.contains(place), "{}", unwritten.headline);
    }
}
