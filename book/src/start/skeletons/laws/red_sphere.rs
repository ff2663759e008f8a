//! Your function, under the laws: `cargo test`

use my_red_sphere::hit_sphere;

#[test]
fn hit_sphere_obeys_the_laws() {
    laws::runner::decision(&hit_sphere);
}
