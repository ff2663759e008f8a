//! Where a slip is explained in this workspace.

pub use course::workspace::workspace;

use std::path::Path;

use slips::Slip;

use crate::names;

/// The page of the book that tells how it is right, with the heading, as seen from where
/// the reader is; `None` if it was not woven here.
pub fn page(slip: &Slip) -> Option<String> {
    let path = workspace()?.join("target/book").join(slip.address());
    let (file, _) = path.to_str()?.rsplit_once('#')?;
    Path::new(file)
        .is_file()
        .then(|| names::name_from_here(&path))
}

/// The file that has the line right, likewise.
pub fn source(slip: &Slip) -> Option<String> {
    let path = workspace()?.join(slip.source()?);
    path.is_file().then(|| names::name_from_here(&path))
}
