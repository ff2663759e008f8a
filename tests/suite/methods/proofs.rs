//! The error bounds of chapter 6, checked by a program that does nothing else.
//!
//! Gappa (<https://gappa.gitlabpages.inria.fr>) reads the scripts in
//! `chapters/6_speed_vs_accuracy/proof` and accepts only what it can prove.

use std::path::PathBuf;
use std::process::{Command, Stdio};

/// Each script, a bound in it, and one that is too narrow.
const SCRIPTS: [(&str, &str, &str); 6] = [
    ("coefficients.g", "[-15b-54, 15b-54]", "[-6b-54, 6b-54]"),
    ("discriminant.g", "[-47b-54, 47b-54]", "[-1b-53, 1b-53]"),
    ("roots.g", "[-34b-53, 34b-53]", "[-10b-53, 10b-53]"),
    ("residual.g", "[-13b-74, 13b-74]", "[-1b-74, 1b-74]"),
    ("running.g", "[-17b-53, 17b-53]", "[-8b-53, 8b-53]"),
    ("correction.g", "[-3b-57, 3b-57]", "[-1b-57, 1b-57]"),
];

#[test]
fn gappa_accepts_each_bound() {
    for (script, ..) in SCRIPTS {
        match proves(&read(script)) {
            Some(proven) => assert!(proven, "Gappa does not accept {script}"),
            None => println!("LEFT OUT: gappa is not installed, {script} was not checked"),
        }
    }
}

/// A checker that accepts everything would accept these too.
#[test]
fn gappa_refuses_a_bound_that_is_too_narrow() {
    for (script, proven, too_narrow) in SCRIPTS {
        let text = read(script).replace(proven, too_narrow);
        assert_ne!(text, read(script));
        match proves(&text) {
            Some(proven) => assert!(!proven, "Gappa accepts {too_narrow} in {script}"),
            None => println!("LEFT OUT: gappa is not installed, nothing was refused"),
        }
    }
}

/// The sums that the page leaves to the reader, in its order: what it says is less stands
/// at the left. Logarithms are to base two.
#[test]
fn the_sums_on_the_page_of_the_proofs_are_right() {
    let u = f64::EPSILON / 2.0;
    let single = f64::from(f32::EPSILON) / 2.0;
    let two = f64::exp2;
    let less = [
        // E
        ("roots", 1.0 + 450.0, 451.0),
        ("underflow in a", -1070.0 + 450.0, -620.0),
        ("underflow in D", -1070.0 + 900.0, -170.0),
        ("64uM", -497.0, 6.0 - 53.0 - 450.0),
        ("the sharper bound of c", -522.0, 1.0 - 53.0 - 20.0 - 450.0),
        ("the sharper bound of D", -1001.0, 5.0 - 106.0 - 900.0),
        // C: 8uM̂ with M̂ off by 6u, less the error of c.
        ("c > 1.9uM", 1.9, 8.0 * (1.0 - 6.0 * u) - 6.0),
        // D
        ("the parts of D", 8.0 + 1.0 + 6.0 + 3.0 + 1.0 + 1.0, 20.0),
        ("24uâM̂", 23.9, 24.0 * (1.0 - 10.0 * u)),
        ("D ≥ D̂/2", 20.1, 0.5 * 48.0 * (1.0 - 10.0 * u)),
        // T
        ("w / (w + √D)", 2_f64.sqrt() / (2_f64.sqrt() + 1.0), 0.59),
        ("the root of D", 20.1 * 0.59, 12.0),
        ("the sum", 12.0 + 1.0 + 4.0 + 2.1, 19.1),
        ("q/a", 19.1 + 8.1, 27.2),
        ("√D / w", 1.5_f64.sqrt(), 1.23),
        (
            "the part of D where √D > w",
            1.5_f64.sqrt() / (1.0 + 1.5_f64.sqrt()),
            0.56,
        ),
        (
            "the error of q in c/q",
            12.0 + 1.23 * (1.0 + 4.0 + 2.1),
            20.8,
        ),
        ("c/q", 6.0 + 20.8 + 1.5, 28.3),
        (
            "|h| where the sign is lost",
            4.0 * u / (24.0 * u).sqrt(),
            1e-8,
        ),
        (
            "the factor of a lost sign",
            (1.0 + 1e-8) / (1.0 - 1e-8),
            1.0 + 3e-8,
        ),
        ("the claim", 28.3 * (1.0 + 3e-8), 34.0),
        // R
        ("t̂", 34.0 * u * two(15.0), two(-32.0)),
        ("t₀", two(-25.0) + two(-32.0), two(-24.9)),
        (
            "the divisor",
            1.3 * u * (6.5 * two(8.0) + 6.0 * two(16.0)),
            two(-33.9),
        ),
        ("g", two(-24.9) * 1.42 * 1.01 * two(8.0), two(-16.0)),
        ("the first two", two(-33.9 - 24.9), two(-58.0)),
        (
            "the size of the rest",
            4.0 * 3_f64.sqrt() * two(-22.9) + two(-24.0),
            two(-19.9),
        ),
        (
            "what enters it",
            4.0 * 3_f64.sqrt() * two(-21.8),
            two(-19.0),
        ),
        ("the rest", two(-19.0) + 7.0 * two(-19.9), two(-16.7)),
        ("what F moves", two(-16.7 + 15.0) / 1.63, 0.2),
        ("all of R", 0.5 + 0.2 + 0.04, 0.8),
        // S
        (
            "the rest of c",
            4.0 * 3_f64.sqrt() * two(-25.99) + two(-24.0),
            two(-22.5),
        ),
        (
            "what enters c",
            4.0 * 3_f64.sqrt() * two(-25.99),
            two(-23.1),
        ),
        ("c", two(-23.1) + 4.0 * two(-22.5), two(-20.0)),
        ("w² from w", 4.0 * 2_f64.sqrt(), 5.7),
        ("w for ŵ", 5.7 * 2.9, 17.0),
        ("second order of D", 9.0 + 17.0, 32.0),
        ("the root of D", 1.0 / (1.0 + (15_f64 / 16.0).sqrt()), 0.51),
        ("16e where w is large", 90.0, 16.0 * 8.0 * 0.5_f64.sqrt()),
        ("q to a 30th", 0.51 / 16.0, 0.032),
        (
            "all of q",
            0.032 + 4.0 * u.sqrt() / 9.0 + 2.0 * u,
            1.0 / 30.0,
        ),
        ("a lost |oc|²", -1022.0 + 450.0, -570.0),
        ("a lost w²", 3.0 - 53.0 - 511.0, -561.0),
        ("4u²s² where s is larger", -561.0, 2.0 - 106.0 - 457.0),
        ("t̂ for t", 30.0 / 29.0, 17.0 / 16.0),
        ("16u² beside 240u", 4.0 * (u / 240.0).sqrt(), 1e-8),
        // W
        ("digits of c", 2.0 * 121.0 + 2.0, 255.0),
        ("digits of D", 2.0 * 244.0 + 1.0, 512.0),
        ("√D", 0.5 * 2.0 + 8.0, 9.0),
        ("q", 9.0 + 3.0, 12.0),
        ("a root", 2.0 + 12.0 + 20.0, 34.0),
        ("the pair of a root", 700.0 + 245.0 + 106.0, 1074.0),
        // L, where u is that of f32, and lengths are counted in r or in |C|
        ("a few uρ", 22.0 * single, 1e-4),
        ("s", 15.4 + 6.5 + 22e-4, 22.0),
        ("s, of |C|", 0.9 + 1.0 + 22e-4, 2.0),
        ("the farthest", 22.0 + 6.5 + 22e-4, 29.0),
        ("the farthest, of |C|", 2.0 + 1.0 + 22e-4, 3.1),
        ("|c|/M", 15.3, 15.4 * (1.0 - 15.4 * single)),
        ("8uM̂", 8.0 * (1.0 + 6.0 * single), 15.3 - 6.0),
        ("η", 3.0 + 1.0 + 1.0 + 22e-4, 5.1),
        ("η²", single * (5.1 * 5.1 + 2.0 * 5.1 * 1.1), 0.01),
        (
            "η², of |C|",
            1.1 * 1.1 / 4.0 + single * 2.0 * 5.1 * 1.1,
            0.31,
        ),
        ("2rs", 30.0, 2.0 * 15.4),
        ("2rs, of |C|", 1.8, 2.0 * 0.9),
        ("ĥ", 5.1 + 4.0 + 22e-4, 9.2),
        ("ĥ²", single * (9.2 * 9.2 + 2.0 * 9.2 * 1.2), 0.01),
        (
            "ĥ², of |C|",
            1.2 * 1.2 / 4.0 + single * 2.0 * 9.2 * 1.2,
            0.37,
        ),
        ("a quarter of ac", 0.37, 1.8 / 4.0),
        ("âĉ", 0.6, 9.3 / 15.3 * (1.0 - 4.0 * single)),
        ("the root of D̂", 3.0 * 1.01, 9.0),
    ];
    for (what, left, right) in less {
        // The decimals of the page are rounded to binary before they are added.
        let rounding = 1e-9 * right.abs();
        assert!(
            left <= right + rounding,
            "{what}: {left} is not at most {right}"
        );
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
