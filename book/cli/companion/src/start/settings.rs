//! Settings: the parts of a new crate that depend on its place or its chapter.

use std::path::{MAIN_SEPARATOR, Path, PathBuf};

use slips::{Chapter, steps};

use crate::wrap::filled;

/// Returns the path of the workspace as a crate in `folder` names it: relative if the crate lies in
/// the workspace and so moves with it, and else absolute.
pub(super) fn workspace_from_crate(folder: &Path, workspace: &Path) -> PathBuf {
    let real = |folder: &Path| folder.canonicalize().ok();
    let mine = folder.parent().and_then(real);
    let below = mine
        .as_deref()
        .and_then(|it| it.strip_prefix(real(workspace)?).ok());
    below.map_or(workspace.to_owned(), |below| {
        Path::new("..").join(below.iter().map(|_| "..").collect::<PathBuf>())
    })
}

/// Writes `.cargo/config.toml` of a reader's crate. All such crates share what was built once, and
/// `cargo rtrace` means in them what it means in the workspace. Cargo merges the alias with the
/// workspace's only if it is one text; so there is none where a path has a space in it. The alias
/// runs wherever the reader is in the crate, and so its paths are absolute.
pub(super) fn cargo_config(from_crate: &Path, workspace: &Path) -> String {
    let shared = with_slashes(&from_crate.join("target/mine"));
    let target = format!("[build]\ntarget-dir = {shared:?}\n");
    let paths = ["Cargo.toml", "target"].map(|name| with_slashes(&workspace.join(name)));
    if paths.iter().any(|path| path.contains(char::is_whitespace)) {
        return target;
    }
    let [manifest, built] = paths;
    let alias =
        format!("run --manifest-path {manifest} --target-dir {built} --package launcher --");
    format!("{target}\n[alias]\nrtrace = {alias:?}\n")
}

/// Writes the comment at the top of a chapter's `src/lib.rs`: its title and its steps.
pub(super) fn chapter_head(chapter: Chapter) -> String {
    let number = chapter as usize;
    let mut about = format!(
        "//! Chapter {number}, {}, typed by hand.\n//!\n",
        chapter.name()
    );
    for (number, step) in (1..).zip(steps::of_chapter(chapter)) {
        about += &filled(step.instruction, 79, &format!("//! {number}. "), "//!    ");
        about.push('\n');
    }
    about + "\n"
}

/// Writes the path with slashes, as cargo reads it on every system: a crate may be built on two of
/// them.
pub(super) fn with_slashes(path: &Path) -> String {
    path.display().to_string().replace(MAIN_SEPARATOR, "/")
}
