//! Mutants of the chapters: the mistakes that readers make, here called *slips*, each as a program
//! that makes it.
//!
//! [`all`] lists the slips, [`Slip::program`] makes the [`ChapterProgram`] with one of them, and a
//! [`Probe`] is a small change of scene that makes a slip visible where the book's picture hides
//! it:
//!
//! ```
//! use slips::{Chapter, ChapterCode, ChapterProgram};
//!
//! let chapter = Chapter::find("half_b_sphere").unwrap();
//! let slip = slips::find("minus-h").unwrap();
//! // The sign slip loses the sphere, and only the sky is left:
//! assert_eq!(slip.program(chapter).run(64).picture(), Chapter::Gradient.picture(64));
//!
//! // Behind the camera it finds a sphere where nothing should be:
//! let probe = slips::find_probe("behind").unwrap();
//! let [wrong, right] = [slip.program(chapter), ChapterProgram::right(chapter)]
//!     .map(|program| probe.applied_to(&program).unwrap().run(probe.width).picture());
//! assert_ne!(wrong, right);
//!
//! // Its intersection alone, to be put under a law:
//! let hit_sphere = |center, radius, ray: &_| slip.program(chapter).hit_sphere(center, radius, ray);
//! # use common::rtweekend::*;
//! let ahead = Ray::new(Point3::ZERO, Vec3::new(0.0, 0.0, -1.0));
//! assert_eq!(hit_sphere(Point3::new(0.0, 0.0, -1.0), 0.5, &ahead), Some(-1.5));
//! ```

mod asked;
mod catalogue;
mod code;
mod edit;
mod files;
mod output;
mod probes;
mod program;
mod shape;
mod slip;
pub mod steps;
mod trace;

use course::chapter;

pub use asked::Ball;
pub use catalogue::{all, find, unnamed, version_3};
pub use code::{ChapterCode, ChapterFile};
pub use course::chapter::{Chapter, SphereCount};
pub use edit::Edit;
pub use files::typed_files;
pub use output::Output;
pub use probes::{PROBES, Probe, find as find_probe, width_line};
pub use program::ChapterProgram;
pub use slip::{Languages, Slip, Unseen};
pub use trace::{TraceRow, trace_table};
