//! Path discovery: the workspace is looked for when the program runs, so that a clone may
//! be moved and the companion installed.

use std::env;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// Finds the workspace that the reader is in, or else the one that cargo, or the place of this
/// program, leads to. The one that it was built in is the last resort: an installed program knows
/// no other. It is looked for once.
pub fn workspace() -> Option<&'static Path> {
    static WORKSPACE: LazyLock<Option<PathBuf>> = LazyLock::new(|| {
        let starts = [
            env::current_dir().ok(),
            env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from),
            env::current_exe().ok(),
            Some(env!("CARGO_MANIFEST_DIR").into()),
        ];
        let above = |start: PathBuf| start.ancestors().find(|it| is_one(it)).map(Path::to_owned);
        starts.into_iter().flatten().find_map(above)
    });
    WORKSPACE.as_deref()
}

/// Returns true if the folder has the parts that our pages and a reader's crates need.
fn is_one(folder: &Path) -> bool {
    ["common/Cargo.toml", "tests/laws/Cargo.toml", "book/notes"]
        .iter()
        .all(|part| folder.join(part).exists())
}
