//! The chapters run from their own texts, unchanged and changed.

use check::mutants::unchanged;
use check::png;
use check::scene::Scene;
use check::verdict::check;
use slips::Chapter;

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
fn a_change_that_is_in_no_catalogue_is_named_by_its_line() {
    let mut program = slips::Program::right(Chapter::Normals);
    program.shade =
        |_, normal| 0.5 * (normal.z * common::rtweekend::Vec3::ONE + common::rtweekend::Vec3::ONE);
    let scene = Scene::new(Chapter::Normals, None).expect("a chapter");
    let picture = program.run(100).picture();
    let answer = check(&scene, &png::encode(&picture), 0);
    println!("{answer:?}");
}
