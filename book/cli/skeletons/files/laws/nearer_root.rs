//! Your functions, under the laws: `cargo test`

use laws::{Chapter, Trial, all_succeed};
use my_chapter::{hit_sphere, ray_color};

#[test]
fn hit_sphere_obeys_the_laws() {
    let trial = Trial::of(Chapter::MyChapter);
    all_succeed([trial.nearer_root(&hit_sphere)]);
}

#[test]
fn ray_color_obeys_the_laws() {
    let trial = Trial::of(Chapter::MyChapter);
    all_succeed([trial.ray_color(&ray_color)]);
}
