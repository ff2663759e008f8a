//! The picture of which room knows which, in CONTRIBUTING, is what cargo says.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;
use std::{env, fs};

use serde_json::Value;

use crate::book::whole::WORKSPACE;

/// The rooms that each room depends on.
type Arrows = BTreeMap<String, BTreeSet<String>>;

#[test]
fn the_arrows_between_rooms_are_those_of_cargo() {
    let drawn = drawn(&arrows());
    let path = Path::new(WORKSPACE).join(".github/CONTRIBUTING.md");
    let page = fs::read_to_string(path).expect("the page");
    let picture = page.split("```\n").find(|block| block.contains(" -> "));
    assert!(
        picture == Some(&drawn),
        "CONTRIBUTING has to have this picture:\n{drawn}"
    );
}

/// Asks cargo which package of the workspace depends on which, but for tests and benchmarks.
fn arrows() -> Arrows {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let said = Command::new(cargo)
        .args([
            "metadata",
            "--offline",
            "--no-deps",
            "--format-version",
            "1",
        ])
        .current_dir(WORKSPACE)
        .output()
        .expect("cargo can be started");
    let all: Value = serde_json::from_slice(&said.stdout).expect("cargo says JSON");
    let root = all["workspace_root"].as_str().expect("a folder");
    let packages = all["packages"].as_array().expect("a list");
    let room_of = |package: &Value| room(root, package);
    let name = |it: &Value| it["name"].as_str().expect("a name").to_owned();
    let rooms: BTreeMap<String, String> =
        packages.iter().map(|it| (name(it), room_of(it))).collect();
    let mut arrows = Arrows::new();
    for package in packages {
        let all = package["dependencies"].as_array().expect("a list").iter();
        let used = all.filter(|it| it["kind"].is_null());
        let used = used.filter_map(|it| rooms.get(&name(it)).cloned());
        let of_room = arrows.entry(room_of(package)).or_default();
        of_room.extend(used.filter(|used| *used != room_of(package)));
    }
    arrows
}

/// Returns the name of a package's room: the lesson is one, and a room of tests is named after its
/// folder.
fn room(root: &str, package: &Value) -> String {
    let [name, manifest] =
        ["name", "manifest_path"].map(|it| package[it].as_str().expect("a text"));
    let folder = Path::new(manifest)
        .parent()
        .and_then(|it| it.strip_prefix(root).ok());
    let folder = folder
        .expect("a package of the workspace")
        .to_string_lossy()
        .replace('\\', "/");
    match folder.split_once('/') {
        Some(("chapters", chapter)) if chapter.starts_with('6') => "chapter 6".to_owned(),
        Some(("chapters", _)) => "chapters 0 to 5".to_owned(),
        Some(("tests", _)) => folder,
        _ => name.to_owned(),
    }
}

/// Draws the arrows, without those that others lead to: first the rooms that know the least, and in
/// one line those that know the same.
fn drawn(arrows: &Arrows) -> String {
    let mut lines: Vec<(usize, BTreeSet<&str>, BTreeSet<&str>)> = Vec::new();
    for (room, known) in arrows {
        let is_led_to = |one: &&String| {
            known
                .iter()
                .any(|other| reached(arrows, other).contains(*one))
        };
        let known: BTreeSet<&str> = known
            .iter()
            .filter(|one| !is_led_to(one))
            .map(String::as_str)
            .collect();
        let depth = reached(arrows, room).len();
        match lines.iter_mut().find(|(.., same)| *same == known) {
            Some((_, rooms, _)) => _ = rooms.insert(room),
            None => lines.push((depth, [room.as_str()].into(), known)),
        }
    }
    lines.retain(|(.., known)| !known.is_empty());
    lines.sort_by_key(|(depth, ..)| *depth);
    let joined = |rooms: &BTreeSet<&str>| rooms.iter().copied().collect::<Vec<_>>().join(", ");
    let line = |(_, rooms, known): &_| format!("{} -> {}\n", joined(rooms), joined(known));
    lines.iter().map(line).collect()
}

/// Returns all rooms that a room's arrows lead to.
fn reached(arrows: &Arrows, room: &str) -> BTreeSet<String> {
    let known = arrows[room].iter();
    known
        .flat_map(|one| reached(arrows, one).into_iter().chain([one.clone()]))
        .collect()
}
