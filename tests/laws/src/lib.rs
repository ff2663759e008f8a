//! The laws: properties of a ray-sphere intersection, to be tested on any function that
//! computes one.
//!
//! A law is a plain function: it takes a function under test and a case, and says whether the law
//! holds, or else what was found and what is allowed. [`strategies`] make the cases and [`oracle`]
//! knows their exact answers, so a law is tested as any property is:
//!
//! ```
//! use laws::{config, nearer_root, strategies};
//! use proptest::prelude::*;
//! # use laws::{Point3, Ray};
//! # fn hit_sphere(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
//! #     speed_vs_accuracy::half_b(center, radius, ray, f64::NEG_INFINITY, f64::INFINITY)
//! # }
//!
//! proptest! {
//!     #![proptest_config(config())]
//!     # /*
//!     #[test]
//!     # */
//!     fn the_point_lies_on_the_sphere(case in strategies::any_case()) {
//!         nearer_root::the_point_lies_on_the_sphere(&hit_sphere, &case)?;
//!     }
//! }
//! # the_point_lies_on_the_sphere();
//! ```
//!
//! A [`Trial`] puts a function of a reader's under all laws of its kind, by proptest's
//! `TestRunner`. Its [`Report`] names no known mistakes: a program that shows it looks them up,
//! so that a reader's own crate builds this package and no judge.

pub mod answers;
pub mod camera;
pub mod face;
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
pub mod verdict;

pub use answers::Mismatch;
pub use common::rtweekend::{Color, Point3, Ray};
pub use question::{Functions, IntervalCase, Question};
pub use ray_color::ChapterScene;
pub use speed_vs_accuracy::Case;
pub use strategies::config;
pub use trial::Trial;
pub use verdict::{BrokenLaw, Complaint, LawResult, Outcome, Report, holds};
