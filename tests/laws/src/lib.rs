//! The laws: properties of a ray-sphere intersection, to be tested on any function that
//! computes one.
//!
//! A law is a plain function: it takes a function under test and a case, and says whether
//! the law holds. [`strategies`] make the cases and [`oracle`] knows their exact answers, so
//! a law is tested as any property is:
//!
//! ```
//! use laws::{config, nearer_root, strategies};
//! use proptest::prelude::*;
//! # fn hit_sphere(_: common::rtweekend::Point3, _: f64, _: &common::rtweekend::Ray) -> Option<f64> { None }
//!
//! proptest! {
//!     #![proptest_config(config())]
//!     # #[cfg(any())]
//!     #[test]
//!     fn the_point_lies_on_the_sphere(case in strategies::anywhere()) {
//!         nearer_root::the_point_lies_on_the_sphere(&hit_sphere, &case)?;
//!     }
//! }
//! ```
//!
//! A [`Trial`] puts a function of a reader's under all laws of its kind, by proptest's
//! `TestRunner`, and names the mistake where [`causes`] knows it.

pub mod answers;
mod broken;
pub mod camera;
pub mod causes;
mod functions;
pub mod intervals;
pub mod list;
pub mod nearer_root;
pub mod oracle;
pub mod prelude;
pub mod question;
pub mod ray_color;
pub mod record;
pub mod strategies;
pub mod trial;

pub use broken::{Broken, Verdict};
pub use common::rtweekend::{Color, Point3, Ray};
pub use intervals::WithInterval;
pub use slips::Chapter;
pub use speed_vs_accuracy::Case;
pub use strategies::config;
pub use trial::{Trial, all_succeed};
