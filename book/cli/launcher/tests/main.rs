//! The first command: what it does itself, and what it hands to the companion.

#![cfg(unix)]

mod clone;

use std::fs::{self, File, Permissions};
use std::io::{BufRead, BufReader};
use std::os::unix::fs::{PermissionsExt, symlink};
use std::process::{Command, Stdio};

use fixtures::command::{assert_success, names_in, run, text};
use fixtures::drawn::p3;
use fixtures::terminal::run_in_terminal;
use slips::{Chapter, ChapterCode};

use clone::Clone;

#[test]
fn alone_it_draws_every_picture_twice_and_then_weaves_the_book() {
    let clone = Clone::without(None);
    let output = clone.run("");
    assert_success(&output);
    let said = text(&output.stdout);
    for chapter in Chapter::OF_THE_BOOK {
        let right = chapter.picture(chapter.book_width());
        let size = format!("{} × {}", right.width(), right.height());
        let mut lines = said.lines();
        assert!(lines.any(|line| line.contains(chapter.name()) && line.contains(&size)));
        let file = clone.0.path("target/pictures").join(chapter.name());
        assert!(fs::read(file.with_extension("ppm")).expect("it") == p3(&right));
        let png = fs::read(file.with_extension("png")).expect("it");
        assert!(check::reading::read(&png).expect("a picture").picture() == right);
    }
    let order = ["The pictures are in", "speed_vs_accuracy", "The book is in"];
    let order = order.map(|it| said.find(it).expect("it is said"));
    assert!(order.is_sorted(), "{said}");
    assert_eq!(clone.0.read("target/book/index.html"), "woven\n");
}

#[test]
fn while_a_chapter_does_not_compile_the_others_are_drawn() {
    let clone = Clone::without(Some("normals"));
    let drawn = clone.run("");
    assert_eq!(drawn.status.code(), Some(1));
    let said = text(&drawn.stdout);
    let broken = "normals           does not compile";
    assert!(said.contains(broken), "{said}");
    assert_eq!(said.matches("ms to draw").count(), 5, "{said}");
    assert!(text(&drawn.stderr).contains("a picture is missing"));
    assert!(!clone.0.path("target/book").exists());

    let shown = clone.run("show normals --output -");
    assert_eq!((shown.status.code(), shown.stdout.len()), (Some(1), 0));
}

/// Also odd words, and words whose meaning only the companion knows. What nobody understands it
/// refuses itself.
#[test]
fn what_it_does_not_do_itself_it_hands_on_word_by_word() {
    let clone = Clone::without(None);
    for (line, printed, code) in [
        (
            "check normals -- echo -- * \u{1b}",
            "<check><normals><--><echo><--><*><\u{1b}>",
            3,
        ),
        ("needs no-such", "<needs><no-such>", 3),
        ("hit --origin -1,0,0", "<hit><--origin><-1,0,0>", 3),
        ("watch --onec", "", 2),
        ("unicorn", "", 2),
    ] {
        let output = clone.run(line);
        assert_eq!(text(&output.stdout), printed);
        assert_eq!(output.status.code(), Some(code), "{line}");
        assert_eq!(output.stderr.is_empty(), code == 3, "{line}");
    }
}

#[test]
fn a_picture_that_can_not_be_written_is_said_with_what_helps() {
    let clone = Clone::without(None);
    let output = clone.run("show normals --output missing/a.png");
    assert_eq!(output.status.code(), Some(1));
    let said = text(&output.stderr);
    for words in [
        "cannot write \"missing/a.png\"",
        "Name a file that you may write",
    ] {
        assert!(said.contains(words), "{said}");
    }
    assert!(!clone.0.path("missing").exists());
}

#[test]
fn a_closed_pipe_is_a_quiet_end() {
    let clone = Clone::without(None);
    let mut show = clone.command("show hittable_list --output -");
    show.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = show.spawn().expect("it starts");
    let mut first = String::new();
    let pipe = child.stdout.take().expect("a pipe");
    let read = BufReader::new(pipe).read_line(&mut first);
    assert_eq!((read.expect("a first line"), &*first), (3, "P3\n"));
    assert_success(&child.wait_with_output().expect("the program ends"));
}

/// Linux has a device that is always full.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_behind_standard_output_is_reported() {
    let clone = Clone::without(None);
    let full = File::options().write(true).open("/dev/full");
    let mut show = clone.command("show normals -o -");
    let output = run(show.stdout(full.expect("a device")));
    assert_eq!(output.status.code(), Some(1));
    let said = text(&output.stderr);
    assert!(said.contains("Free some space"), "{said}");
}

/// No file may be larger than so many blocks, as at the end of a disk. The signal that the system
/// sends is ignored, so that the write itself fails. One block is so small that it waits in a buffer
/// until the end.
#[test]
fn what_was_there_stays_when_writing_fails_half_way_or_at_the_very_end() {
    let clone = Clone::without(None);
    clone.0.write("mine/kept.ppm", "mine");
    for (blocks, width) in [(64, 400), (1, 30)] {
        let show = clone.command(&format!("show normals -o kept.ppm --width {width}"));
        let script = format!("ulimit -f {blocks}; trap '' XFSZ; exec \"$0\" \"$@\"");
        let mut shell = Command::new("sh");
        shell
            .args(["-c", &script])
            .arg(show.get_program())
            .args(show.get_args());
        shell.env("CARGO", clone.0.path("target/debug/cargo"));
        let output = run(shell.current_dir(clone.0.path("mine")));
        assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
        assert_eq!(names_in(&clone.0.path("mine")), ["kept.ppm"]);
        assert_eq!(clone.0.read("mine/kept.ppm"), "mine");
    }
}

/// The new file takes the place of the old one in one step, and is written beside it, because a step
/// can't lead to another disk.
#[test]
fn a_file_is_replaced_with_its_permissions_and_a_link_to_it_stays() {
    let clone = Clone::without(None);
    clone.0.write("target.ppm", "old");
    let [target, link] = ["target.ppm", "link.ppm"].map(|name| clone.0.path(name));
    symlink(&target, &link).expect("a link");
    fs::set_permissions(&target, Permissions::from_mode(0o640)).expect("the mode is set");
    let old = File::open(&target).expect("the old file");
    assert_success(&clone.run("show normals --width 30 -o link.ppm"));
    assert_eq!(std::io::read_to_string(old).expect("it is open"), "old");
    assert!(link.is_symlink() && !target.is_symlink());
    assert!(fs::read(&target).expect("it") == p3(&Chapter::Normals.picture(30)));
    let mode = fs::metadata(&target).expect("it").permissions().mode();
    assert_eq!(mode & 0o777, 0o640);
}

#[test]
fn a_picture_is_shown_in_the_colors_that_the_terminal_has() {
    let clone = Clone::without(None);
    // 16 × 9 pixels: four lines of two rows, and one with the last row.
    let sky = &Chapter::RedSphere.picture(16).rgb()[..3].to_vec();
    let sky = format!("\x1b[38;2;{};{};{}m", sky[0], sky[1], sky[2]);
    for (variable, value, red) in [
        ("COLORTERM", "truecolor", "\x1b[48;2;255;0;0m"),
        ("TERM", "xterm-256color", "\x1b[48;5;196m"),
        ("TERM", "xterm", "\x1b[41m"),
    ] {
        let mut show = clone.command("show red_sphere --width 16");
        let (output, screen) = run_in_terminal(show.env(variable, value));
        assert_success(&output);
        let lines: Vec<&str> = screen.lines().collect();
        assert_eq!(lines.len(), 5, "{screen}");
        assert!(lines.iter().all(|line| line.matches('▀').count() == 16));
        assert!(lines[2].contains(red), "{value}: {screen:?}");
        assert_eq!(lines[0].starts_with(&sky), value == "truecolor", "{screen}");
    }
}

#[test]
fn a_large_picture_is_reduced_to_fit_the_terminal() {
    let clone = Clone::without(None);
    let mut show = clone.command("show build_test");
    let (_, screen) = run_in_terminal(&mut show);
    let lines: Vec<&str> = screen.lines().collect();
    // A square in 80 columns and 24 lines, one of which is for the prompt.
    assert_eq!(lines.len(), 23, "{screen}");
    assert!(lines.iter().all(|line| line.matches('▀').count() == 46));
}

#[test]
fn where_there_are_no_colors_no_picture_is_shown() {
    let clone = Clone::without(None);
    let unwanted: [fn(&mut Command) -> &mut Command; 3] = [
        |command| command.env("TERM", "dumb"),
        |command| command.env("NO_COLOR", "1"),
        |command| command.env_remove("TERM"),
    ];
    for without in unwanted {
        let (output, screen) = run_in_terminal(without(&mut clone.command("show normals")));
        assert_eq!((output.status.code(), &*screen), (Some(2), ""));
        assert!(text(&output.stderr).contains("--output"));
    }
}
