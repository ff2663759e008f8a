//! Your function, under the laws: `cargo test`

use my_chapter::hit_sphere;

#[test]
fn hit_sphere_obeys_the_laws() {
    laws::runner::nearer_root(&hit_sphere);
}
