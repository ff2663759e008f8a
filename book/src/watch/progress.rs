//! A progress counter: how much of what a crate stands on is built, from cargo's messages.

use std::collections::HashSet;
use std::path::Path;
use std::process::Command;

use common::engine::output;

use super::build::{cargo, messages};
use super::screen;

/// How far a build has come.
pub(super) struct Progress<'a> {
    /// Where the crate is.
    folder: &'a Path,
    /// Which of its dependencies are built, as `cargo tree` calls them.
    edges: &'static str,
    /// How many bytes of cargo's messages were looked at.
    read: usize,
    /// The packages that are built, but for the crate itself.
    built: HashSet<String>,
    /// How many there will be: asked for once one of them has to be built.
    all: Option<usize>,
}

impl<'a> Progress<'a> {
    pub(super) fn new(folder: &'a Path, has_test: bool) -> Self {
        Self {
            folder,
            edges: match has_test {
                true => "normal,build,dev",
                false => "normal,build",
            },
            read: 0,
            built: HashSet::new(),
            all: None,
        }
    }

    /// Says how far it is, after all that cargo has printed so far. Where only the crate
    /// itself is built there is nothing to say.
    pub(super) fn show(&mut self, said: &[u8]) {
        let whole = said.iter().rposition(|&byte| byte == b'\n');
        let end = whole.map_or(self.read, |end| end + 1);
        let mut is_news = false;
        for message in messages(&said[self.read..end]) {
            let package = message["package_id"].as_str().unwrap_or_default();
            if message["reason"] == "compiler-artifact" && !package.contains("#my_") {
                self.built.insert(package.to_owned());
                is_news |= message["fresh"] == false;
            }
        }
        self.read = end;
        if is_news {
            self.say();
        }
    }

    fn say(&mut self) {
        let is_first = self.all.is_none();
        let all = *self
            .all
            .get_or_insert_with(|| packages(self.folder, self.edges));
        let what = "Building what your crates stand on, once for all";
        let said = match screen::replaces_the_last() {
            true => format!("\r{what}: {} of {all} packages", self.built.len()),
            false if is_first => format!("{what}: {all} packages\n"),
            false => return,
        };
        // If it can't be written, then the verdict can't, and that is told.
        let _ = output::to_stdout(|out| out.write_all(said.as_bytes()));
    }
}

/// How many packages the crate stands on.
fn packages(folder: &Path, edges: &str) -> usize {
    let mut tree = Command::new(cargo());
    tree.args(["tree", "--quiet", "--prefix", "none", "--edges", edges]);
    let tree = tree.current_dir(folder).output();
    let lines = tree.map_or(Vec::new(), |tree| tree.stdout);
    let lines = String::from_utf8_lossy(&lines);
    // The first one is the crate, and what was shown before has a mark.
    let packages = lines
        .lines()
        .skip(1)
        .map(|line| line.trim_end_matches(" (*)"));
    packages.collect::<HashSet<_>>().len()
}
