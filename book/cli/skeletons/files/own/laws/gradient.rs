//! Your prelude and your function, under the laws: `cargo test`

use common::rtweekend as ours;
use laws::prelude::Prelude;
use laws::{Chapter, Trial, all_succeed};
use my_chapter::rtweekend::{Ray, Vec3};

#[test]
fn ray_color_obeys_the_laws() {
    let trial = Trial::of(Chapter::MyChapter);
    all_succeed([trial.ray_color(&ray_color)]);
}

fn ray_color(ray: &ours::Ray) -> ours::Color {
    our(my_chapter::ray_color(&own_ray(*ray)))
}
