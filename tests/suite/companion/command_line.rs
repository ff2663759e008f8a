//! Command lines: what is shown, what is refused, and in which words.

use std::fs;

use insta::assert_snapshot;
use slips::Chapter;
use suite::command::{picture_in, program_with, rtrace_alone, run, text, transcript, woven};
use suite::drawn::p3;

#[test]
fn a_chapter_explains_itself_when_asked_and_when_misunderstood() {
    let gradient = |words: &[&str]| program_with("gradient", words);
    let help = transcript(&mut [gradient(&["--help"])]);
    let (_, usage) = help.split_once('\n').expect("what it says");
    let said = transcript(&mut [
        gradient(&["picture.PNG"]),
        gradient(&["a.ppm", "b.ppm"]),
        gradient(&["a.ppm", "--width"]),
        gradient(&["--width", "0"]),
        gradient(&["--width=16385"]),
        gradient(&["--width", "-3"]),
        gradient(&["--width=four", "a.ppm"]),
        gradient(&["-w"]),
    ]);
    assert_snapshot!(help.clone() + &said.replace(usage, "(the same)\n"));
}

/// Each command of the companion is listed by the first command, which builds it.
#[test]
fn the_first_command_and_the_companion_have_the_same_help() {
    let help = |name| run(&mut program_with(name, &["--help"])).stdout;
    assert_eq!(text(&help("launcher")), text(&help("rtrace")));
}

/// Odd words, and words that only the companion knows: with the same output and exit code.
#[test]
fn the_first_command_hands_on_what_it_does_not_do_itself() {
    let here = tempfile::TempDir::new().expect("a folder");
    for words in [
        &["check", "--help"][..],
        &["help", "watch"],
        &["probes", "gradient"],
        &["check", "normals", "-"],
        &["check", "normals", "--", "echo", "--", "a b", "*", "\u{1b}"],
        &["slips", "no-such"],
        &["hit", "--origin", "-1,0,0"],
    ] {
        let [handed_on, itself] = ["launcher", "rtrace"].map(|name| {
            let mut command = program_with(name, words);
            run(command.current_dir(here.path()))
        });
        assert_eq!(handed_on, itself, "{words:?}");
    }
}

#[test]
fn the_companion_explains_itself_when_asked_and_when_misunderstood() {
    let rtrace = |words: &[&str]| program_with("rtrace", words);
    assert_snapshot!(transcript(&mut [
        rtrace(&["--help"]),
        rtrace(&["show", "--help"]),
        rtrace(&["sho"]),
        rtrace(&["show", "hitable-list"]),
        rtrace(&["show", "gradient"]),
        rtrace(&["show", "gradient", "--open", "--output", "-"]),
        rtrace(&["show", "gradient", "--output", "picture.jpg"]),
        rtrace(&["show", "gradient", "--output", ".png"]),
        rtrace(&["show", "gradient", "--output", "-", "--width", "0"]),
        rtrace(&["show", "gradient", "--output", "-", "--width", "-1"]),
        rtrace(&["show", "gradient", "--output", "-", "--width", "4294967296"]),
        rtrace(&["check", "gradient", "--timeout", "nan", "--", "true"]),
        rtrace(&["check", "gradient", "mine.ppm", "--probe", "inside"]),
        rtrace(&["watch", "gradient", "--in", "nowhere"]),
        rtrace(&["done", ""]),
        rtrace(&["book", "--source", "nowhere"]),
    ]));
}

/// A terminal obeys some characters, and others turn the order of letters. On Windows no
/// file can be called so.
#[cfg(unix)]
#[test]
fn names_are_shown_and_not_obeyed() {
    let here = tempfile::TempDir::new().expect("a folder");
    let odd = "\u{1b}[31m\u{9b}\u{202e}\u{200f}é";
    let [png, ppm, below] = ["odd.png", "odd.ppm", "/a.ppm"].map(|end| format!("{odd}{end}"));
    let mut commands = [
        &["gradient", &below][..],
        &["gradient", &png],
        &["gradient", &format!("--{odd}")],
        &["rtrace", odd],
        &["rtrace", "show", odd],
        &["rtrace", "show", "gradient", "--output", &ppm],
        &["rtrace", "check", "gradient", &ppm, "--report", odd],
        &["rtrace", "check", "normals", "--", odd],
        &["rtrace", "check", "normals", "--", "echo", odd],
        &["rtrace", "hit", "--csv", odd],
        &["rtrace", "book", "--source", odd],
    ]
    .map(|words| {
        let mut command = program_with(words[0], &words[1..]);
        command.current_dir(here.path());
        command
    });
    let said = transcript(&mut commands);
    assert!(
        !said.contains(['\u{1b}', '\u{9b}', '\u{202e}', '\u{200f}']),
        "{said:?}"
    );
    assert_snapshot!(said);
}

#[test]
#[ignore = "builds the weaver, and weaves the book"]
fn rtrace_alone_draws_every_picture_twice_and_then_weaves_the_book() {
    let report = rtrace_alone();
    let folder = suite::workspace().join("target/pictures");
    for chapter in Chapter::ALL {
        let expected = chapter.picture(chapter.book_width());
        let size = format!("{} × {}", expected.width(), expected.height());
        let mut lines = report.lines();
        assert!(lines.any(|line| line.contains(chapter.name()) && line.contains(&size)));
        let file = folder.join(chapter.name());
        assert!(fs::read(file.with_extension("ppm")).expect("it") == p3(&expected));
        assert!(picture_in(&file.with_extension("png")) == expected);
    }
    let [pictures, book] = ["The pictures are in", "The book is in"].map(|it| report.find(it));
    assert!(pictures < book, "{report}");
    assert!(woven().join("index.html").is_file());
}

/// Linux asks `xdg-open`, in the place of which there is a script that takes a copy.
#[cfg(target_os = "linux")]
#[test]
fn open_hands_the_picture_to_the_viewer() {
    use std::os::unix::fs::PermissionsExt;
    use std::time::{Duration, Instant};

    use suite::command::assert_success;

    let here = tempfile::TempDir::new().expect("a folder");
    let [viewer, seen, picture] =
        ["xdg-open", "seen", "picture.png"].map(|name| here.path().join(name));
    let script = format!(
        "#!/bin/sh\ncp \"$1\" '{0}.new' && mv '{0}.new' '{0}'\n",
        seen.display()
    );
    fs::write(&viewer, script).expect("a viewer");
    fs::set_permissions(&viewer, fs::Permissions::from_mode(0o755)).expect("the mode is set");
    let path = std::env::var("PATH").expect("a PATH");
    let mut show = program_with("rtrace", &["show", "normals", "--open", "-o"]);
    show.arg(&picture)
        .env("PATH", format!("{}:{path}", here.path().display()));
    let output = run(&mut show);
    assert_success(&output);
    assert!(text(&output.stdout).starts_with("400 × 225 pixels in "));
    let patience = Instant::now() + Duration::from_secs(10);
    while !seen.is_file() {
        assert!(Instant::now() < patience, "the viewer has not been asked");
        std::thread::sleep(Duration::from_millis(10));
    }
    assert!(fs::read(seen).expect("it") == fs::read(picture).expect("it"));
}
