//! The error bounds of chapter 6, checked by a program that does nothing else.
//!
//! Gappa (<https://gappa.gitlabpages.inria.fr>) reads the scripts in
//! `chapters/6_speed_vs_accuracy/proof` and accepts only what it can prove.

use std::path::PathBuf;
use std::process::{Command, Stdio};

#[test]
fn gappa_accepts_each_bound() {
    for script in ["coefficients.g", "discriminant.g"] {
        let text = read(script);
        match proves(&text) {
            Some(proven) => assert!(proven, "Gappa does not accept {script}"),
            None => println!("LEFT OUT: gappa is not installed, {script} was not checked"),
        }
    }
}

/// A checker that accepts everything would accept this too.
#[test]
fn gappa_refuses_a_bound_that_is_too_narrow() {
    let text = read("discriminant.g").replace("[-47b-54, 47b-54]", "[-1b-53, 1b-53]");
    assert_ne!(text, read("discriminant.g"));
    match proves(&text) {
        Some(proven) => assert!(!proven, "Gappa accepts 1u for the error of D"),
        None => println!("LEFT OUT: gappa is not installed, nothing was refused"),
    }
}

/// Whether Gappa proves the script; `None` if there is no Gappa.
fn proves(script: &str) -> Option<bool> {
    let mut gappa = Command::new("gappa")
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .ok()?;
    let mut input = gappa.stdin.take().expect("it was asked for");
    std::io::Write::write_all(&mut input, script.as_bytes()).expect("gappa reads");
    drop(input);
    Some(gappa.wait().expect("gappa ends").success())
}

fn read(script: &str) -> String {
    let folder = "../../chapters/6_speed_vs_accuracy/proof";
    let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), folder, script]
        .iter()
        .collect();
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
