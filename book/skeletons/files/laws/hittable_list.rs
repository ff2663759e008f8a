//! Your sphere, its record, your list and `ray_color`, under the laws: `cargo test`

use std::convert::identity;

use laws::{Chapter, Trial, all_succeed};

#[test]
fn sphere_record_list_and_ray_color_obey_the_laws() {
    let trial = Trial::of(Chapter::MyChapter);
    all_succeed([
        trial.record(&record),
        trial.list(&nearest),
        trial.ray_color(&ray_color),
    ]);
}

laws::functions_of_a_list!(my_chapter, common::rtweekend::Ray, identity, identity, identity);
