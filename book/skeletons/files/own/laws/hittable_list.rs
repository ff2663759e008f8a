//! Your prelude, sphere, record, list and `ray_color`, under the laws: `cargo test`

use common::rtweekend as ours;
use laws::prelude::Prelude;
use laws::{Chapter, Trial, all_succeed};
use my_chapter::rtweekend::{Ray, Vec3};

#[test]
fn prelude_sphere_record_list_and_ray_color_obey_the_laws() {
    let trial = Trial::of(Chapter::MyChapter);
    all_succeed([
        trial.prelude(&prelude()),
        trial.record(&record),
        trial.list(&nearest),
        trial.ray_color(&ray_color),
    ]);
}

laws::functions_of_a_list!(my_chapter, Ray, own, own_ray, our);
