#![doc = include_str!("../README.md")]
#![expect(
    clippy::missing_errors_doc,
    reason = "an error is the broken law, or a function not written yet: see LawResult and Outcome"
)]

pub mod answers;
pub mod camera;
mod case;
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

pub use case::{Case, IntervalCase, RangeSolver};
pub use common::rtweekend::{Color, Point3, Ray, Vec3};
pub use question::Question;
pub use ray_color::ChapterScene;
pub use strategies::config;
pub use trial::Trial;
pub use verdict::{BrokenLaw, Complaint, LawResult, Outcome, Report, holds};
