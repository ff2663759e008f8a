//! What the first command shares with all that judges: the list of chapters, the workspace
//! that they are in, and names as a terminal may show them.

pub mod chapter;
pub mod names;
pub mod workspace;
