//! The chapters run from their own texts, unchanged and changed.

use check::evidence::Known;
use check::mutants::unchanged;
use check::png;
use check::scene::Scene;
use check::verdict::check;
use slips::{Chapter, Program};

#[test]
fn a_chapter_that_is_run_from_its_text_draws_its_picture() {
    for chapter in [
        Chapter::Gradient,
        Chapter::RedSphere,
        Chapter::Normals,
        Chapter::HalfBSphere,
        Chapter::HittableList,
    ] {
        let picture = unchanged(chapter).run(64).picture();
        assert_eq!(picture, chapter.picture(64), "{chapter:?}");
    }
}

#[test]
fn a_mistake_that_is_in_no_catalogue_is_named_by_its_line() {
    let program = Program {
        discriminant: |a, b, c| b * b - 0.5 * a * c,
        ..Program::right(Chapter::Normals)
    };
    let scene = Scene::new(Chapter::Normals, None).expect("a chapter");
    let picture = png::encode(&program.run(100).picture());
    let answer = check(&scene, &picture, 0);
    let rows = answer
        .finding()
        .expect("it is wrong")
        .rows(&Known::default());
    assert_eq!(
        rows[..2],
        [
            ("probably", "discriminant = b * b - 0.5 * a * c".to_owned()),
            ("should be", "discriminant = b * b - 4.0 * a * c".to_owned()),
        ]
    );
}
