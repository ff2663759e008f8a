//! The real programs, with good input and bad.

use std::io::Read;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::{env, fs, thread};
use suite::command::{
    assert_failed, assert_refused, assert_success, names_in, path_of, picture_in, program,
    program_with, rtrace_alone, run, text,
};

use slips::Chapter;
use tempfile::TempDir;

use suite::command::woven;
use suite::drawn::p3;

#[test]
fn a_chapter_prints_its_picture() {
    for chapter in Chapter::ALL {
        let output = run(&mut program(chapter.name()));
        assert_success(&output);
        assert!(
            output.stdout == p3(&chapter.picture(chapter.book_width())),
            "{} prints something else than its library draws",
            chapter.name()
        );
        let dash = run(program(chapter.name()).arg("-"));
        assert!(output.stdout == dash.stdout, "- is standard output");
    }
}

#[test]
fn a_chapter_draws_any_width() {
    for chapter in Chapter::ALL {
        let output = run(program(chapter.name()).args(["--width", "37", "-"]));
        assert_success(&output);
        assert!(output.stdout == p3(&chapter.picture(37)), "{chapter:?}");
    }
}

#[test]
fn a_chapter_writes_the_file_that_it_is_told_to_and_nothing_else() {
    let folder = TempDir::new().expect("a folder");
    let path = folder.path().join("normals.PPM");
    for _first_then_again in 0..2 {
        assert_success(&run(program("normals").arg(&path)));
        assert!(fs::read(&path).expect("the file is there") == p3(&normals::picture(400)));
        assert_eq!(names_in(folder.path()), ["normals.PPM"]);
    }
}

#[test]
fn a_chapter_explains_itself_when_asked_and_when_misunderstood() {
    for option in ["-h", "--help"] {
        let help = run(program("gradient").arg(option));
        assert_success(&help);
        assert!(text(&help.stdout).contains("cargo run -p gradient > gradient.ppm"));
    }

    let folder = TempDir::new().expect("a folder");
    for name in ["picture.PNG", "picture.tiff"] {
        let path = folder.path().join(name);
        assert_refused(program("gradient").arg(&path), &[name, ".ppm"]);
    }
    assert_failed(
        program("gradient").arg(""),
        &["cannot write", "another file"],
    );
    assert_refused(
        program("gradient").args(["a.ppm", "b.ppm"]),
        &["one file name"],
    );
    for (arguments, word) in [
        (&["--width"][..], "missing argument"),
        (&["a.ppm", "--width"], "missing argument"),
        (&["a.ppm", "--width", "0"], "from 1 to 16384"),
        (&["--width=16385"], "from 1 to 16384"),
        (&["--width", "-3"], "from 1 to 16384"),
        (&["--width=four", "a.ppm"], "from 1 to 16384"),
        (&["--height", "3"], "--height"),
        (&["-w"], "-w"),
    ] {
        assert_refused(
            program("gradient")
                .args(arguments)
                .current_dir(folder.path()),
            &[word, "--width 1001", "cargo rtrace"],
        );
    }
    assert_eq!(names_in(folder.path()), [""; 0]);
}

#[test]
fn rtrace_saves_any_width_as_ppm_png_or_text() {
    let folder = TempDir::new().expect("a folder");
    for chapter in Chapter::ALL {
        let expected = chapter.picture(37);
        let printed = run(show(chapter.name()).args(["--width", "37", "--output", "-"]));
        assert_success(&printed);
        assert!(
            printed.stdout == p3(&expected),
            "{} as text",
            chapter.name()
        );

        let ppm = folder.path().join("picture.ppm");
        assert_success(&run(show(chapter.name())
            .args(["--width", "37", "-o"])
            .arg(&ppm)));
        assert!(
            fs::read(&ppm).expect("the file") == p3(&expected),
            "{} as .ppm",
            chapter.name()
        );

        let png = folder.path().join("picture.png");
        assert_success(&run(show(chapter.name())
            .args(["--width", "37", "--output"])
            .arg(&png)));
        let decoded = picture_in(&png);
        assert!(decoded == expected, "{} as .png", chapter.name());
    }
    assert_eq!(names_in(folder.path()), ["picture.png", "picture.ppm"]);
}

#[test]
fn rtrace_alone_draws_every_picture_twice_weaves_the_book_and_says_where() {
    let report = rtrace_alone();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/pictures");
    assert!(report.contains("The book is in"), "{report}");
    assert!(woven().join("index.html").is_file());
    for chapter in Chapter::ALL {
        let expected = chapter.picture(chapter.book_width());
        let size = format!("{} × {}", expected.width(), expected.height());
        assert!(
            report
                .lines()
                .any(|line| line.contains(chapter.name()) && line.contains(&size)),
            "{} is missing from\n{report}",
            chapter.name()
        );
        let file = folder.join(chapter.name());
        let ppm = fs::read(file.with_extension("ppm")).expect("the .ppm file");
        assert!(ppm == p3(&expected), "{}.ppm", chapter.name());
        assert!(
            picture_in(&file.with_extension("png")) == expected,
            "{}.png",
            chapter.name()
        );
    }
}

#[test]
fn rtrace_explains_itself() {
    let help = run(program("rtrace").arg("--help"));
    assert_success(&help);
    assert!(text(&help.stdout).contains("show"));
    let help = run(program("rtrace").args(["show", "--help"]));
    assert_success(&help);
    for word in ["CHAPTER", "--width", "--output", "--open", "hittable_list"] {
        assert!(text(&help.stdout).contains(word), "{word} is missing");
    }
}

#[test]
fn rtrace_refuses_a_width_that_is_none_or_too_large() {
    for width in [
        "0",
        "-1",
        "-",
        "four",
        "4.5",
        "",
        "16385",
        "4294967296",
        "99999999999999999999",
    ] {
        assert_refused(
            show("gradient").args(["--output", "-", "--width", width]),
            &["--width", "from 1 to 16384"],
        );
    }
}

#[test]
fn rtrace_suggests_the_chapter_that_was_meant() {
    assert_refused(&mut show("normal"), &["'normal'", "similar", "'normals'"]);
    assert_refused(&mut show("hitable-list"), &["similar", "'hittable_list'"]);
    assert_refused(
        &mut program_with("rtrace", &["sho"]),
        &["similar", "'show'"],
    );
}

#[test]
fn rtrace_refuses_a_format_that_it_does_not_write() {
    for name in ["picture.jpg", "picture", ".png", ""] {
        assert_refused(
            show("gradient").args(["--output", name]),
            &["--output", ".png or .ppm"],
        );
    }
}

#[test]
fn without_a_terminal_rtrace_wants_to_know_where_the_picture_goes() {
    assert_refused(&mut show("gradient"), &["--output"]);
    assert_refused(
        show("gradient").args(["--open", "--output", "-"]),
        &["--open needs a file"],
    );
}

#[test]
fn a_missing_folder_is_named() {
    let folder = TempDir::new().expect("a folder");
    let missing = folder.path().join("missing");
    let path = missing.join("picture.ppm");
    let missing = missing.display().to_string();
    assert_failed(
        program("normals").arg(&path),
        &["picture.ppm", &missing, "Create it"],
    );
    assert_failed(
        show("normals").arg("-o").arg(&path),
        &["picture.ppm", &missing, "Create it"],
    );
    assert_eq!(names_in(folder.path()), [""; 0]);
}

#[test]
fn a_folder_is_no_file() {
    let folder = TempDir::new().expect("a folder");
    let path = folder.path().join("folder.ppm");
    fs::create_dir(&path).expect("a folder");
    assert_failed(
        program("normals").arg(&path),
        &["folder.ppm", "name a file inside it"],
    );
    assert_eq!(names_in(&path), [""; 0]);
}

#[test]
fn a_file_that_may_not_be_changed_is_not_changed() {
    let folder = TempDir::new().expect("a folder");
    let path = folder.path().join("kept.ppm");
    fs::write(&path, "kept").expect("a file");
    let mut permissions = fs::metadata(&path).expect("the file").permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&path, permissions).expect("a read-only file");
    assert_failed(program("normals").arg(&path), &["kept.ppm", "may write"]);
    assert_eq!(fs::read(&path).expect("the file"), b"kept");
}

/// What needs pipes, devices, limits or terminals as Unix has them.
#[cfg(unix)]
mod on_unix {
    use std::fs::{File, Permissions};
    use std::io::{BufRead, BufReader};
    use std::os::unix::fs::PermissionsExt;
    use std::os::unix::process::CommandExt;
    use std::time::Duration;

    use super::*;
    use crate::terminal;
    #[cfg(target_os = "linux")]
    use suite::small_book::Book;

    #[test]
    fn a_closed_pipe_is_a_quiet_end() {
        for command in [
            &mut program("hittable_list"),
            show("hittable_list").args(["--output", "-"]),
        ] {
            let mut child = command
                .stdout(Stdio::piped())
                .stderr(Stdio::piped())
                .spawn()
                .expect("the program starts");
            let mut line = String::new();
            BufReader::new(child.stdout.take().expect("a pipe"))
                .read_line(&mut line)
                .expect("a first line");
            assert_eq!(line, "P3\n");
            assert_success(&child.wait_with_output().expect("the program ends"));
        }
    }

    /// Linux has a device that is always full.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_reported() {
        let full = || {
            File::options()
                .write(true)
                .open("/dev/full")
                .expect("a device")
        };
        for command in [
            program("normals").stdout(full()),
            program("normals").arg("-").stdout(full()),
            program("normals").arg("--help").stdout(full()),
            program("rtrace").stdout(full()),
            show("normals").args(["-o", "-"]).stdout(full()),
        ] {
            assert_failed(
                command,
                &["standard output", "No space left", "Free some space"],
            );
        }
    }

    #[test]
    fn a_pipe_with_a_name_is_written_to_and_stays_a_pipe() {
        let folder = TempDir::new().expect("a folder");
        let pipe = folder.path().join("pipe.ppm");
        let made = Command::new("mkfifo").arg(&pipe).status();
        assert!(made.expect("mkfifo starts").success());
        // Held open here, so that the reader need not wait for a program that
        // opens it too; when all have closed it, the reader sees the end.
        let held = File::options()
            .read(true)
            .write(true)
            .open(&pipe)
            .expect("the pipe");
        let mut reading = File::open(&pipe).expect("the pipe");
        let reader = thread::spawn(move || {
            let mut text = Vec::new();
            reading.read_to_end(&mut text).expect("the pipe is read");
            text
        });
        let output = run(program("normals").arg(&pipe));
        drop(held);
        assert_success(&output);
        assert!(reader.join().expect("the pipe was read") == p3(&normals::picture(400)));
        let kind = fs::metadata(&pipe).expect("the pipe").file_type();
        assert!(!kind.is_file());
    }

    #[test]
    fn a_picture_that_memory_cannot_hold_is_refused_as_png_and_printed_as_text() {
        let limited = |output: &str| {
            let mut shell = Command::new("sh");
            shell
                .args(["-c", "ulimit -v 60000; exec \"$0\" \"$@\""])
                .arg(path_of("rtrace"))
                .args(["show", "gradient", "--width", "6000", "--output", output]);
            shell
        };
        if cfg!(target_os = "linux") {
            let folder = TempDir::new().expect("a folder");
            let png = folder.path().join("picture.png");
            assert_refused(
                &mut limited(&png.to_string_lossy()),
                &["no memory for 60 MB", "smaller width", ".ppm"],
            );
            assert_success(&run(limited("-").stdout(Stdio::null())));
        }
    }

    #[test]
    fn what_was_there_stays_when_writing_fails_half_way() {
        let folder = TempDir::new().expect("a folder");
        let path = folder.path().join("kept.ppm");
        fs::write(&path, "kept").expect("a file");
        // A file may grow to 64 blocks, far less than the picture. The signal
        // that the system sends is ignored, so that the write itself fails.
        let limited = "ulimit -f 64; trap '' XFSZ; exec \"$0\" \"$@\"";
        for program_and_arguments in [
            vec![path_of("normals").into_os_string(), path.clone().into()],
            vec![
                path_of("rtrace").into_os_string(),
                "show".into(),
                "normals".into(),
                "-o".into(),
                path.clone().into(),
            ],
        ] {
            let mut shell = Command::new("sh");
            shell.args(["-c", limited]).args(program_and_arguments);
            assert_failed(&mut shell, &["kept.ppm", "large"]);
            assert_eq!(fs::read(&path).expect("the file"), b"kept");
            assert_eq!(names_in(folder.path()), ["kept.ppm"]);
        }
    }

    /// So small that it waits in a buffer until the end.
    #[test]
    fn a_disk_that_is_full_at_the_very_end_is_noticed() {
        let folder = TempDir::new().expect("a folder");
        let mut shell = Command::new("sh");
        shell
            .args(["-c", "ulimit -f 1; trap '' XFSZ; exec \"$0\" \"$@\""])
            .arg(path_of("rtrace"))
            .args(["show", "normals", "--width", "30", "-o"])
            .arg(folder.path().join("small.ppm"));
        assert_failed(&mut shell, &["small.ppm", "large"]);
        assert_eq!(names_in(folder.path()), [""; 0]);
    }

    #[test]
    fn any_failure_of_standard_output_is_reported() {
        let folder = TempDir::new().expect("a folder");
        let path = folder.path().join("redirected.ppm");
        let mut shell = Command::new("sh");
        shell
            .args(["-c", "ulimit -f 64; trap '' XFSZ; exec \"$0\" > \"$1\""])
            .arg(path_of("normals"))
            .arg(&path);
        assert_failed(&mut shell, &["standard output", "large"]);
    }

    /// The new file takes the place of the old one in one step, and is written
    /// in the same folder, because a step can't lead to another disk.
    #[test]
    fn a_file_is_replaced_not_rewritten() {
        let folder = TempDir::new().expect("a folder");
        let path = folder.path().join("normals.ppm");
        fs::write(&path, "old").expect("a file");
        let mut old = File::open(&path).expect("the old file");
        assert_success(&run(program("normals")
            .arg(&path)
            .env("TMPDIR", "/nonexistent")));
        let mut still_old = String::new();
        old.read_to_string(&mut still_old).expect("the old file");
        assert_eq!(still_old, "old");
    }

    #[test]
    fn a_folder_that_may_not_be_written_to_is_named() {
        let folder = TempDir::new().expect("a folder");
        let closed = folder.path().join("closed");
        fs::create_dir(&closed).expect("a folder");
        let copy = folder.path().join("normals");
        fs::copy(path_of("normals"), &copy).expect("a copy that anyone can reach");
        for (path, mode) in [(folder.path(), 0o755), (&closed, 0o555)] {
            fs::set_permissions(path, Permissions::from_mode(mode)).expect("the mode is set");
        }
        let mut command = Command::new(copy);
        command.arg(closed.join("picture.ppm"));
        if rustix::process::geteuid().is_root() {
            // Nothing is closed to root: be nobody.
            command.uid(65534).gid(65534);
        }
        assert_failed(
            &mut command,
            &["picture.ppm", "Permission denied", "may write to"],
        );
        assert_eq!(names_in(&closed), [""; 0]);
    }

    #[test]
    fn a_link_is_followed_and_stays() {
        let folder = TempDir::new().expect("a folder");
        let target = folder.path().join("target.ppm");
        let link = folder.path().join("link.ppm");
        fs::write(&target, "old").expect("a file");
        std::os::unix::fs::symlink(&target, &link).expect("a link");
        fs::set_permissions(&target, Permissions::from_mode(0o640)).expect("the mode is set");
        assert_success(&run(program("normals").arg(&link)));
        let mode = fs::metadata(&target)
            .expect("the file")
            .permissions()
            .mode();
        assert_eq!(mode & 0o777, 0o640, "the file keeps its permissions");
        assert!(
            fs::read(&target)
                .expect("the file")
                .starts_with(b"P3\n400 225\n")
        );
        assert!(fs::symlink_metadata(&link).expect("the link").is_symlink());
    }

    #[test]
    fn a_link_to_nothing_is_named_and_stays() {
        let folder = TempDir::new().expect("a folder");
        let link = folder.path().join("link.ppm");
        std::os::unix::fs::symlink(folder.path().join("nothing"), &link).expect("a link");
        assert_failed(
            program("normals").arg(&link),
            &["link.ppm", "link to nothing"],
        );
        assert!(link.is_symlink());
    }

    #[test]
    fn at_a_terminal_a_chapter_says_where_to_send_the_picture() {
        let (output, screen) = run_in_terminal(&mut program("normals"));
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(screen, "", "no number reaches the terminal");
        let said = text(&output.stderr);
        for words in ["megabyte", "cargo run -p normals > normals.ppm"] {
            assert!(said.contains(words), "{words:?} is missing from\n{said}");
        }
    }

    #[test]
    fn at_a_terminal_rtrace_shows_the_picture_in_color() {
        let mut command = show("red_sphere");
        let (output, screen) = run_in_terminal(
            command
                .args(["--width", "16"])
                .env("COLORTERM", "truecolor"),
        );
        assert_success(&output);
        let lines: Vec<&str> = screen.lines().collect();
        // 16 × 9 pixels: four lines of two rows, and one with the last row.
        assert_eq!(lines.len(), 5, "{screen}");
        assert!(
            lines.iter().all(|line| line.matches('▀').count() == 16),
            "{screen}"
        );
        let first: Vec<u8> = red_sphere::picture(16).rgb()[..3].to_vec();
        let color = format!("\x1b[38;2;{};{};{}m", first[0], first[1], first[2]);
        assert!(lines[0].starts_with(&color), "{screen}");
        assert!(
            lines[2].contains("\x1b[48;2;255;0;0m"),
            "the sphere is red: {screen}"
        );
    }

    #[test]
    fn a_terminal_with_fewer_colors_gets_the_nearest_that_it_has() {
        for (term, code) in [("xterm-256color", "\x1b[48;5;196m"), ("xterm", "\x1b[41m")] {
            let mut command = show("red_sphere");
            command.args(["--width", "16"]).env("TERM", term);
            let (output, screen) = run_in_terminal(&mut command);
            assert_success(&output);
            assert!(screen.contains(code), "{term}: {screen:?}");
            assert!(!screen.contains("8;2;"), "{term}: {screen:?}");
        }
    }

    #[test]
    fn at_a_terminal_without_colors_rtrace_wants_a_file() {
        for unwanted in [
            &mut *show("red_sphere").env("TERM", "dumb"),
            show("red_sphere").env("NO_COLOR", "1"),
            show("red_sphere").env_remove("TERM"),
        ] {
            let (output, screen) = run_in_terminal(unwanted);
            assert_eq!(output.status.code(), Some(2));
            assert_eq!(screen, "");
            assert!(text(&output.stderr).contains("--output"));
        }
    }

    #[test]
    fn a_verdict_has_no_escape_characters_where_they_are_not_wanted() {
        let wrong = || {
            let mut command = program_with("rtrace", &["check", "normals", "--"]);
            command.arg(path_of("gradient")).arg("-");
            command
        };
        let (_, colored) = run_in_terminal(&mut wrong());
        assert!(colored.contains('\x1b'), "{colored:?}");
        for unwanted in [
            &mut *wrong().env("TERM", "dumb"),
            wrong().env("NO_COLOR", "1"),
            wrong().env_remove("TERM"),
        ] {
            let (_, plain) = run_in_terminal(unwanted);
            assert!(!plain.contains('\x1b'), "{plain:?}");
        }
    }

    #[test]
    fn a_large_picture_is_reduced_to_fit_the_terminal() {
        let (output, screen) = run_in_terminal(&mut show("build_test"));
        assert_success(&output);
        let lines: Vec<&str> = screen.lines().collect();
        // A square in 80 columns and 24 lines, one of which is for the prompt.
        assert_eq!(lines.len(), 23, "{screen}");
        assert!(
            lines.iter().all(|line| line.matches('▀').count() == 46),
            "{screen}"
        );
    }

    /// Elsewhere the system's opener can't be replaced by one of ours.
    #[cfg(target_os = "linux")]
    #[test]
    fn open_hands_the_picture_to_the_viewer() {
        let folder = TempDir::new().expect("a folder");
        let picture = folder.path().join("picture.png");
        let mut command = show("normals");
        command.args(["--open", "-o"]).arg(&picture);
        assert_opens(&mut command, &picture);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn open_hands_the_first_page_to_the_browser() {
        let folder = TempDir::new().expect("a folder");
        let book = Book::new("A page to open.");
        let mut command = book.command();
        command.args(["--open", "--output"]).arg(folder.path());
        assert_opens(&mut command, &folder.path().join("index.html"));
    }

    /// Runs `command` with a viewer that takes a copy, and expects one of `file`.
    #[cfg(target_os = "linux")]
    fn assert_opens(command: &mut Command, file: &Path) {
        let folder = TempDir::new().expect("a folder");
        let viewer = folder.path().join("xdg-open");
        let seen = folder.path().join("seen");
        let script = format!("#!/bin/sh\ncp \"$1\" '{}'\n", seen.display());
        fs::write(&viewer, script).expect("a viewer");
        fs::set_permissions(&viewer, Permissions::from_mode(0o755)).expect("the mode is set");
        let path = env::var("PATH").expect("a PATH");
        let path = format!("{}:{path}", folder.path().display());
        assert_success(&run(command.env("PATH", path)));
        let saved = fs::read(file).expect("the file");
        let opened = (0..100).any(|_| {
            thread::sleep(Duration::from_millis(50));
            fs::read(&seen).is_ok_and(|seen| seen == saved)
        });
        assert!(
            opened,
            "the viewer has not seen the file after five seconds"
        );
    }

    /// Runs `command` with a terminal of 80 columns and 24 lines as its standard
    /// output. Returns what it did, and what appeared on that terminal.
    fn run_in_terminal(command: &mut Command) -> (Output, String) {
        let (mut controller, end) = terminal::open();
        terminal::forget_ours(command);
        let reader = thread::spawn(move || {
            let mut screen = Vec::new();
            // When the other end is closed, some systems end the file and some
            // report an error; what was read until then counts.
            let _ = controller.read_to_end(&mut screen);
            text(&screen).replace("\r\n", "\n")
        });
        let child = command
            .stdout(end)
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        // The command holds the terminal too; only when nobody does, the reader
        // sees the end.
        command.stdout(Stdio::null());
        let output = child.wait_with_output().expect("the program ends");
        (output, reader.join().expect("the screen was read"))
    }
}

fn show(chapter: &str) -> Command {
    program_with("rtrace", &["show", chapter])
}
