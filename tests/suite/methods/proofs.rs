//! The error bounds of chapter 6: one table, wherever they stand, and checked by a program that does
//! nothing else.
//!
//! Gappa (<https://gappa.gitlabpages.inria.fr>) reads the scripts in
//! `chapters/6_speed_vs_accuracy/proof` and accepts only what it can prove.

use std::path::PathBuf;
use std::process::{Command, Stdio};

use fixtures::left_out::left_out;
use laws::nearer_root;
use speed_vs_accuracy::bounds::{BOUNDS, Bound, C, D, T, U};

/// The scripts of the proofs, each with a bound in it, and with one that is too narrow.
const SCRIPTS: [(&str, &str, &str); 5] = [
    ("coefficients.g", "[-15b-54, 15b-54]", "[-6b-54, 6b-54]"),
    ("discriminant.g", "[-47b-54, 47b-54]", "[-1b-53, 1b-53]"),
    ("roots.g", "[-68b-54, 68b-54]", "[-10b-53, 10b-53]"),
    ("residual.g", "[-13b-74, 13b-74]", "[-1b-74, 1b-74]"),
    ("correction.g", "[-3b-57, 3b-57]", "[-1b-57, 1b-57]"),
];

#[test]
fn each_script_proves_the_bound_of_the_table() {
    for (Bound { by_gappa, .. }, (script, proven, _)) in [C, D, T].iter().zip(SCRIPTS) {
        let in_halves = 2.0 * by_gappa.expect("Gappa has a script");
        assert_eq!(
            proven,
            format!("[-{in_halves}b-54, {in_halves}b-54]"),
            "{script}"
        );
    }
}

#[test]
fn each_bound_covers_what_is_proved_of_it_and_lies_inside_its_band() {
    for bound in BOUNDS {
        let proved = bound.by_hand.max(bound.by_gappa.unwrap_or(0.0));
        assert!(
            proved <= bound.stated && bound.stated < bound.band,
            "{bound:?}"
        );
    }
    assert_eq!(
        [C.band, D.band],
        [T.band; 2],
        "the filter has one band for the three"
    );
}

#[test]
fn the_laws_and_the_pages_have_the_numbers_of_the_table() {
    assert_eq!(nearer_root::BAND, D.stated * U);
    let proofs = include_str!("../../../book/notes/proofs.md");
    let table = BOUNDS.map(row).concat();
    assert!(
        proofs.contains(&table),
        "the table of proofs.md should be\n{table}"
    );
    assert!(proofs.contains(&format!("$B = {}u$", T.band)));
    let lesson = include_str!("../../../book/notes/speed_vs_accuracy.md");
    let methods = include_str!("../../../book/notes/methods.md");
    for (page, formula) in [(lesson, "u("), (lesson, "uk^2 = 1"), (methods, "uM}/r")] {
        let expected = format!("{}{formula}", D.stated);
        assert!(page.contains(&expected), "{expected}");
    }
}

/// Writes the row of a bound in the table of the page.
fn row(bound: Bound) -> String {
    let Bound {
        letter,
        formulas: [error, unit],
        by_hand,
        by_gappa,
        stated,
        band,
    } = bound;
    let by_gappa = by_gappa.map_or("–".to_owned(), |found| found.to_string());
    format!("| {letter} | ${error}$ | ${unit}$ | {by_hand} | {by_gappa} | {stated} | {band} |\n")
}

/// A checker that accepts everything would accept what is too narrow, too.
#[test]
#[ignore = "Gappa takes seconds"]
fn gappa_accepts_each_bound_and_refuses_a_narrower_one() {
    for (script, proven, too_narrow) in SCRIPTS {
        let text = read(script);
        let narrowed = text.replace(proven, too_narrow);
        assert_ne!(text, narrowed);
        let Some(accepted) = proves(&text) else {
            return left_out("Gappa is not installed, the proofs of chapter 6 were not checked");
        };
        assert!(accepted, "Gappa does not accept {script}");
        let refused = proves(&narrowed) == Some(false);
        assert!(refused, "Gappa accepts {too_narrow} in {script}");
    }
}

/// Returns true if Gappa proves the script; `None` if there is no Gappa.
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
