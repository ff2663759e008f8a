//! Paths to the explanation of a slip in this workspace.

pub use course::workspace::workspace;

use std::path::Path;

use slips::Slip;

use crate::names;

/// Returns the path of the page that explains a slip (known mistake), with its heading as `#…`, as
/// seen from the current folder; `None` if there is no workspace, or the book was not woven in it.
pub fn page(slip: &Slip) -> Option<String> {
    let path = workspace()?.join("target/book").join(slip.page_link());
    let (file, _) = path.to_str()?.rsplit_once('#')?;
    Path::new(file)
        .is_file()
        .then(|| names::name_from_here(&path))
}
