//! Your prelude and what you typed in each file, under the laws: `cargo test`

use common::rtweekend as ours;
use laws::prelude::Prelude;
use laws::{ChapterScene, Trial, holds};
use my_chapter::rtweekend::{Ray, Vec3};

laws::functions_of_a_list!(my_chapter, Ray, own, own_ray, our);
