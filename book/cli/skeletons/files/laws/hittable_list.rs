//! What you typed in each file, under the laws: `cargo test`

use std::convert::identity;

use laws::{ChapterScene, Trial, holds};

laws::functions_of_a_list!(my_chapter, common::rtweekend::Ray, identity, identity, identity);
