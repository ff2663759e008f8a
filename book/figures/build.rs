//! Source instrumentation: copies of the chapters' own functions that note the value of each
//! `let`, so that a page can show it beside the line.

use std::path::Path;
use std::{env, fs};

/// The name of each copy, the file of its chapter, and how the function begins there and here.
const FUNCTIONS: [[&str; 4]; 4] = [
    ["red_sphere", "2_red_sphere/src/lib.rs", HIT_SPHERE, "("],
    ["normals", "3_normals/src/lib.rs", HIT_SPHERE, "("],
    [
        "half_b_sphere",
        "4_half_b_sphere/src/lib.rs",
        HIT_SPHERE,
        "(",
    ],
    [
        "sphere",
        "5_hittable_list/src/sphere.rs",
        "    fn hit(&self",
        "(sphere: &Ball",
    ],
];
const HIT_SPHERE: &str = "pub fn hit_sphere(";

fn main() {
    // Asked for when this runs: the clone may have been moved since it was compiled.
    let here = env::var_os("CARGO_MANIFEST_DIR").expect("cargo names the package");
    let chapters = Path::new(&here).join("../../chapters");
    let mut copies = String::new();
    for [name, file, begins, parameters] in FUNCTIONS {
        let path = chapters.join(file);
        println!("cargo::rerun-if-changed={}", path.display());
        let source = fs::read_to_string(&path).expect("a source of a chapter");
        let function = function(&source, begins)
            .unwrap_or_else(|| panic!("{} has no `{begins}`", path.display()));
        copies += &traced(name, &function.replacen(begins, parameters, 1));
    }
    let folder = env::var_os("OUT_DIR").expect("cargo names a folder");
    fs::write(Path::new(&folder).join("traced.rs"), copies).expect("the folder takes it");
}

/// The function that begins so, up to the brace below its first letter.
fn function<'a>(source: &'a str, begins: &str) -> Option<&'a str> {
    let from = &source[source.find(begins)?..];
    let indent = begins.len() - begins.trim_start().len();
    let end = format!("\n{}}}\n", " ".repeat(indent));
    Some(&from[..from.find(&end)? + end.len()])
}

/// The names of its lines, in order, and the function with a note behind each of them.
fn traced(name: &str, function: &str) -> String {
    let mut names = String::new();
    let mut copy = String::new();
    for line in function.replace("self.", "sphere.").lines() {
        copy += line;
        match line.trim_start() {
            it if it.starts_with("let ") && it.ends_with(';') => {
                let name = it[4..].split(' ').next().unwrap_or_default();
                names += &format!("\"{name}\", ");
                copy += &format!(" trace.note(\"{name}\", &{name});");
            }
            "return None;" => names += "\"none\", ",
            _ => {}
        }
        copy.push('\n');
    }
    let copy = copy.replacen('(', &format!("fn {name}(trace: &mut Trace, "), 1);
    format!(
        "const {}: &[&str] = &[{names}\"result\"];\n\n{copy}\n",
        name.to_uppercase()
    )
}
