//! Path discovery: the workspace is looked for when the program runs, so that a clone may
//! be moved and the companion installed.

use std::env;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// Finds the folder of this project: the first folder with its parts, such as `book/notes`, among
/// the current one, the package that cargo runs, the running program, and the place where this
/// program was compiled, and all folders above each of these. Returns `None` if none of them has
/// these parts. The answer of the first call is kept.
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
