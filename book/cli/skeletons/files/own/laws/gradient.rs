//! Your prelude and your function, under the laws: `cargo test`

use common::rtweekend as ours;
use laws::prelude::Prelude;
use laws::{ChapterScene, Trial, holds};
use my_chapter::rtweekend::{Ray, Vec3};

#[test]
fn ray_color_obeys_the_laws() {
    holds(Trial::default().ray_color(ChapterScene::MyScene, &ray_color));
}

fn ray_color(ray: &ours::Ray) -> ours::Color {
    our(my_chapter::ray_color(&own_ray(*ray)))
}
