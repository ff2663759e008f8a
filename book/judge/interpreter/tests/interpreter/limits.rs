//! Limits: what takes too much is stopped, and what is nested too deep is refused.

use std::thread;
use std::time::{Duration, Instant};

use interpreter::SourceFile;

/// Returns the fault of a text in words, also of its function `run`; empty if there is none.
fn said(text: &str) -> String {
    let program = interpreter::read(&[SourceFile::new("src/lib.rs", text)]);
    let ran = program.and_then(|program| match program.parameters("run") {
        Some(_) => program.call("run", &mut []).map(drop),
        None => Ok(()),
    });
    ran.map_or_else(|fault| fault.to_string(), |()| String::new())
}

#[test]
fn what_is_nested_too_deep_is_refused_with_its_line_at_once() {
    let refused = "line 2: this page cannot read what is nested more than 200 deep";
    let read = move || {
        for row in include_str!("texts/nested.txt").lines().skip(1) {
            let [open, inside, close, most] = *row.split(" ¦ ").collect::<Vec<_>>() else {
                panic!("{row} is no row");
            };
            let is_refused = |n: usize| {
                let nested = open.repeat(n) + inside + &close.repeat(n);
                said(&format!("pub fn f(x: f64) -> f64 {{\n{nested}\n}}\n")).starts_with(refused)
            };
            let most: usize = most.parse().expect("a number");
            assert!(!is_refused(most) && is_refused(most + 1), "{row}");
            let start = Instant::now();
            assert!(is_refused(9_000), "{row}");
            assert!(
                start.elapsed() < Duration::from_secs(5),
                "{row} takes too long"
            );
        }
        let many = "(".repeat(120_000) + &")".repeat(120_000);
        assert!(said(&format!("fn f() {{\n{many}\n}}")).starts_with(refused));
    };
    // The stack of a program, and not the small one of a test.
    let read = thread::Builder::new().stack_size(1 << 26).spawn(read);
    read.expect("a thread").join().expect("no panic");
}

#[test]
fn what_takes_too_much_is_stopped() {
    for row in include_str!("texts/stopped.txt").lines().skip(1) {
        let (body, expected) = row.split_once(" ¦ ").expect("a row");
        let text = format!(
            "struct Link {{ next: Option<Box<Link>> }}\n\
             fn link(next: Option<Link>) -> Link {{ Link {{ next }} }}\n\
             fn endless(n: f64) -> f64 {{ endless(n + 1.0) }}\nfn run() {{\n    {body}\n}}\n"
        );
        let start = Instant::now();
        let said = said(&text);
        let said = said.split_once(": ").map_or("", |(_, said)| said);
        assert_eq!(said, expected, "{body}");
        assert!(
            start.elapsed() < Duration::from_secs(5),
            "{body} takes too long"
        );
    }
}

/// What is typed in the middle of a line, and no Rust.
#[test]
fn what_is_no_rust_is_refused() {
    let text = "'\\é' ¦ \u{202e}\u{0} <script>alert(1)</script> ¦ ½ ¦ )))) ¦ (((( ¦ \" ¦ /*";
    for wrong in text.split(" ¦ ") {
        let said = said(&format!("fn f() {{\n    {wrong}\n}}\n"));
        assert!(said.starts_with("line "), "{wrong}: {said}");
    }
}
