//! Your functions, under the laws: `cargo test`

use laws::{Chapter, Trial, all_succeed};
use my_chapter::{hit_sphere, ray_color};

#[test]
fn hit_sphere_and_ray_color_obey_the_laws() {
    let trial = Trial::of(Chapter::MyChapter);
    all_succeed([
        trial.nearer_root(&hit_sphere),
        trial.ray_color(&ray_color),
    ]);
}
