//! Where a slip is explained in this workspace.

pub use course::workspace::workspace;

use slips::Slip;

use crate::names;

/// The page of the book that tells how it is right, with the heading, as seen from where
/// the reader is; `None` if it was not woven here.
pub fn page(slip: &Slip) -> Option<String> {
    let path = slip.page_in(workspace()?)?;
    Some(names::from_here(&path))
}

/// The file that has the line right, likewise.
pub fn source(slip: &Slip) -> Option<String> {
    let path = slip.source_in(workspace()?)?;
    Some(names::from_here(&path))
}
