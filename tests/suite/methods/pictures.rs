//! Golden images of chapter 6: its own picture, and scenes in which a method fails, each
//! beside what it should look like.

use fixtures::drawn::assert_picture;
use measure::scene_file::find_scene;
use speed_vs_accuracy::{Arithmetic, Method};

const WIDTH: u32 = 200;

#[test]
fn chapter_6_draws_its_snapshot() {
    assert_picture("speed_vs_accuracy", &speed_vs_accuracy::picture(400));
}

#[test]
fn a_scene_in_which_a_method_fails_is_drawn_as_its_snapshot_by_that_method() {
    for (scene, method) in [
        ("telescope", Method::HALF_B),
        ("grazing", Method::HALF_B),
        ("shadows", Method::HALF_B_F32),
        ("neighbors", Method::HALF_B),
    ] {
        let scene = find_scene(scene).expect("it is one of the seven");
        let [wrong, right] =
            [Arithmetic::Method(method), Arithmetic::Exact].map(|it| scene.seen_by([it; 2], WIDTH));
        assert_ne!(wrong, right);
        assert_picture(&format!("{}_{}", scene.name, method.name), &wrong);
        assert_picture(&format!("{}_right", scene.name), &right);
    }
}

/// The first cure mends the star, and no digit of `t` mends the seams of `neighbors`.
#[test]
fn a_scene_is_drawn_as_its_snapshot_by_another_method() {
    for (scene, method) in [("telescope", Method::CROSS_Q), ("neighbors", Method::EXACT)] {
        let scene = find_scene(scene).expect("it is one of the seven");
        let seen = scene.seen_by([Arithmetic::Method(method); 2], WIDTH);
        assert_picture(&format!("{}_{}", scene.name, method.name), &seen);
    }
}
