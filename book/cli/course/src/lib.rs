//! The course: the list of its chapters, the workspace that they are in, and names as a terminal
//! may show them. The first command shares these with all that judges.

pub mod chapter;
pub mod names;
pub mod typed;
pub mod workspace;
