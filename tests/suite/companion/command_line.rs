//! Command lines: what is shown, what is refused, and in which words.

use std::fs;
#[cfg(unix)]
use std::{fs::Permissions, os::unix::fs::PermissionsExt};

use check::reading;
use insta::assert_snapshot;
use suite::command::{assert_success, path_of, program, run, text};
use suite::desk::Desk;
use suite::drawn::{p3, pictures};

#[test]
fn a_chapter_explains_itself_when_asked_and_when_misunderstood() {
    let desk = Desk::default();
    let help = desk.transcript("gradient --help");
    let (_, usage) = help.split_once('\n').expect("what it says");
    let said = desk.transcript(
        "gradient picture.PNG
         gradient /dev/null
         gradient a.ppm b.ppm
         gradient a.ppm --width
         gradient --width 0
         gradient --width=16385
         gradient --width -3
         gradient --width=four a.ppm
         gradient -w",
    );
    let usage = usage.trim_end();
    assert_snapshot!(help.clone() + &said.replace(usage, "(the same)"));
}

/// The first command builds the companion, and hands on odd words, and words whose meaning only
/// the companion knows. What nobody understands it refuses itself.
#[test]
fn the_first_command_hands_on_what_it_does_not_do_itself() {
    let desk = Desk::default();
    for line in [
        "help watch",
        "watch --help",
        "watch --onec",
        "check normals -- echo -- * \u{1b}",
        "probes no-such",
        "hit --origin -1,0,0",
    ] {
        let [handed_on, itself] =
            ["launcher", "rtrace"].map(|name| desk.run(&format!("{name} {line}")));
        assert_eq!(handed_on, itself, "{line}");
    }
}

/// The cargo of this test builds all chapters but one, and no companion.
#[cfg(unix)]
#[test]
fn while_a_chapter_does_not_compile_the_others_are_drawn_and_the_last_companion_answers() {
    let desk = Desk::default();
    desk.write_picture("mine.ppm", &normals::picture(100));
    let programs = pictures().map(|(chapter, _)| path_of(chapter.name()));
    let built = programs.iter().filter(|path| !path.ends_with("normals"));
    let said: String = built
        .map(|path| {
            format!(
                "echo '{{\"executable\":\"{}\",\"fresh\":true}}'\n",
                path.display()
            )
        })
        .collect();
    desk.write("cargo", format!("#!/bin/sh\n{said}exit 101\n"));
    fs::set_permissions(desk.path("cargo"), Permissions::from_mode(0o755)).expect("it may run");
    let run_with_it = |line| run(desk.command(line).env("CARGO", desk.path("cargo")));

    let drawn = run_with_it("launcher");
    assert_eq!(drawn.status.code(), Some(1));
    let said = text(&drawn.stdout);
    assert!(
        said.contains("normals           does not compile"),
        "{said}"
    );
    assert_eq!(said.matches("ms to draw").count(), 5, "{said}");
    assert!(text(&drawn.stderr).contains("a picture is missing"));

    let checked = run_with_it("launcher check normals mine.ppm");
    assert!(text(&checked.stderr).contains("the last one answers"));
    assert!(text(&checked.stdout).starts_with("mine.ppm is right"));
    let shown = run_with_it("launcher show normals --output -");
    assert_eq!((shown.status.code(), shown.stdout.len()), (Some(1), 0));
}

#[test]
fn the_companion_explains_itself_when_asked_and_when_misunderstood() {
    assert_snapshot!(Desk::default().transcript(
        "rtrace --help
         rtrace show --help
         rtrace help check
         rtrace needs -h
         rtrace sho
         rtrace help unicorn
         rtrace show
         rtrace show gradient red_sphere
         rtrace show gradient --widht 3
         rtrace show gradient --width
         rtrace show gradient --open=yes
         rtrace show gradient --width 3 --width 4
         rtrace check
         rtrace check gradient
         rtrace check gradient mine.ppm -- true
         rtrace check gradient mine.ppm --timeout 3
         rtrace check gradient mine.ppm --probe insde
         rtrace check gradient mine.ppm --tolerance 256
         rtrace laws normals
         rtrace show hitable-list
         rtrace show gradient
         rtrace show gradient --open --output -
         rtrace show gradient --output picture.jpg
         rtrace show gradient --output .png
         rtrace show gradient --output - --width 0
         rtrace check gradient --timeout nan -- true
         rtrace check gradient mine.ppm --probe inside
         rtrace watch gradient --in nowhere
         rtrace done \"\""
    ));
}

#[test]
#[ignore = "builds the weaver, and weaves the book"]
fn rtrace_alone_draws_every_picture_twice_and_then_weaves_the_book() {
    let output = run(&mut program("rtrace", &[]));
    assert_success(&output);
    let report = text(&output.stdout);
    let folder = suite::workspace().join("target/pictures");
    for (chapter, picture) in pictures() {
        let expected = picture(chapter.book_width());
        let size = format!("{} × {}", expected.width(), expected.height());
        let mut lines = report.lines();
        assert!(lines.any(|line| line.contains(chapter.name()) && line.contains(&size)));
        let file = folder.join(chapter.name());
        assert!(fs::read(file.with_extension("ppm")).expect("it") == p3(&expected));
        let png = fs::read(file.with_extension("png")).expect("it");
        assert!(reading::read(&png).expect("a picture").picture() == expected);
    }
    let [pictures, book] = ["The pictures are in", "The book is in"].map(|it| report.find(it));
    assert!(pictures < book, "{report}");
    assert!(suite::workspace().join("target/book/index.html").is_file());
}
