//! Your functions, under the laws: `cargo test`

use laws::{ChapterScene, Trial, holds};
use my_chapter::{hit_sphere, ray_color};

#[test]
fn hit_sphere_obeys_the_laws() {
    holds(Trial::default().nearer_root(&hit_sphere));
}

#[test]
fn ray_color_obeys_the_laws() {
    holds(Trial::default().ray_color(ChapterScene::MyScene, &ray_color));
}
