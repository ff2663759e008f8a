//! Your prelude, under the laws: `cargo test`

use common::rtweekend as ours;
use laws::prelude::Prelude;
use my_gradient::rtweekend::{Ray, Vec3};

#[test]
fn prelude_obeys_the_laws() {
    laws::runner::prelude(&prelude());
}
