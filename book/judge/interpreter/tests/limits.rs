//! Limits: a text that is nested deeper than any reader's is refused, and takes no stack.

use std::thread;

use interpreter::SourceFile;

/// Texts that nest: the opening of a level, the innermost text, the closing of a level, and how
/// many levels are read.
const NESTED: [(&str, &str, &str, usize); 19] = [
    ("(", "x", ")", 194),
    ("", "x", " + x", 194),
    ("-", "x", "", 194),
    ("", "x", ".abs()", 97),
    ("", "x", " as f64", 97),
    ("f64::max(x, ", "x", ")", 194),
    ("{", "x", "}", 194),
    ("if x < 1.0 { x } else ", "{ x }", "", 48),
    ("if x < 2.0 { ", "x", " } else { x }", 48),
    ("match x { _ => ", "x", " }", 48),
    ("loop { break ", "x", " }", 97),
    ("*&", "x", "", 97),
    ("vec![", "x", "][0]", 64),
    ("(x, ", "x", ").1", 97),
    ("return ", "x", "", 194),
    ("(|a: f64, b: f64| ", "x", ")(x, x)", 48),
    ("{ let y: Vec<", "f64", "> = Vec::new(); x }", 48),
    ("{ let y: Vec<fn(f64) -> ", "f64", "> = Vec::new(); x }", 27),
    ("{ fn f<A, B: Fn(A) -> ", "f64", ">() {} x }", 32),
];

/// A count of levels for which no stack has room.
const MANY: usize = 120_000;

#[test]
fn what_is_nested_too_deep_is_refused_with_its_line() {
    // That of a program, and not the small one of a test.
    let read = thread::Builder::new().stack_size(1 << 26).spawn(|| {
        for (open, inside, close, most) in NESTED {
            let said = |n: usize| {
                let nested = open.repeat(n) + inside + &close.repeat(n);
                let text = format!("pub fn f(x: f64) -> f64 {{\n    {nested}\n}}\n");
                let read = interpreter::read(&[SourceFile::new("src/lib.rs", &*text)]);
                read.map_or_else(|faults| faults[0].to_string(), |_| String::new())
            };
            let refused = "line 2: this page does not read what is nested more than 200 deep";
            assert!(
                !said(most).starts_with(refused),
                "{open}: {most} are too many"
            );
            for n in [most + 1, MANY] {
                assert!(said(n).starts_with(refused), "{open}: {n}: {}", said(n));
            }
        }
    });
    read.expect("a thread").join().expect("no panic");
}

/// Returns the message at which a function with that body stops; empty if it does not.
fn stopped(body: &str) -> String {
    let text = format!(
        "use common::rtweekend::*;\n\nstruct Link {{ next: Option<Box<Link>> }}\n\n\
         pub fn hit_sphere(_: Point3, _: f64, _: &Ray) -> Option<f64> {{\n    {body}\n}}\n\n\
         pub fn picture(_: u32) -> String {{\n    \
         let _ = hit_sphere(Vec3::ONE, 1.0, &Ray::new(Vec3::ONE, Vec3::ONE));\n    \
         String::from(\"P3\\n1 1\\n255\\n0 0 0\")\n}}\n"
    );
    let program =
        interpreter::read(&[SourceFile::new("src/lib.rs", &*text)]).unwrap_or_else(|faults| {
            panic!("{body}: {}", faults[0]);
        });
    program
        .draw(1)
        .map_or_else(|fault| fault.message, |_| String::new())
}

#[test]
fn what_takes_too_much_is_stopped_before_it_is_made() {
    let memory = "this takes too much memory";
    let turns = "this takes too many turns of loops and calls";
    let deep = "this value is nested too deeply";
    let stops = [
        (
            "let mut t = String::from(\"a\"); for _ in 0..60 { t = format!(\"{t}{t}\"); } None",
            memory,
        ),
        (
            "let mut t = String::from(\"a\"); for _ in 0..60 { let u = t.clone(); t += &u; } None",
            memory,
        ),
        ("let v = vec![1.0; 100_000_000]; Some(v[0])", memory),
        ("let mut v = Vec::new(); loop { v.push(1.0); }", turns),
        (
            "let mut v = Vec::new(); for _ in 0..40_000 { v.push(1.0); } None",
            "",
        ),
        (
            "let mut n = Link { next: None }; \
             for _ in 0..200 { n = Link { next: Some(Box::new(n)) }; } None",
            deep,
        ),
        (
            "let mut n = Link { next: None }; \
             for _ in 0..30 { n = Link { next: Some(Box::new(n)) }; } None",
            "",
        ),
    ];
    for (body, said) in stops {
        assert_eq!(stopped(body), said, "{body}");
    }
}
