//! What `cargo rtrace check`, `probes` and `slips` say.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use check::png;
use check::reading::{MOST_PIXELS, read};
use check::workspace;
use common::rtweekend::Picture;
use slips::Chapter;
use slips::{self, PROBES};
use tempfile::TempDir;

use suite::command::{
    assert_refused, assert_success, in_any_system, names_in, path_of, program_with, run, text,
    transcript,
};
use suite::drawn::p3;
use suite::random::Random;

#[test]
fn a_right_picture_is_followed_by_what_it_can_not_show() {
    let folder = TempDir::new().expect("a folder");
    write(&folder, "mine.ppm", &p3(&normals::picture(400)));
    let output = run(&mut check_in(&folder, &["normals", "mine.ppm"]));
    assert_success(&output);
    insta::assert_snapshot!(text(&output.stdout));
}

#[test]
fn a_picture_in_another_encoding_is_judged_with_a_word_on_it() {
    let folder = TempDir::new().expect("a folder");
    let picture = text(&p3(&normals::picture(100)))
        .encode_utf16()
        .collect::<Vec<_>>();
    let bytes: Vec<u8> = picture.into_iter().flat_map(u16::to_le_bytes).collect();
    write(&folder, "mine.ppm", &bytes);
    let output = run(&mut check_in(&folder, &["normals", "mine.ppm"]));
    assert_success(&output);
    let said = text(&output.stdout);
    assert!(
        said.starts_with("mine.ppm is right") && said.contains("UTF-16"),
        "{said}"
    );
}

#[test]
fn what_comes_near_to_nothing_is_not_recognized_unless_a_chapter_is_named() {
    let folder = TempDir::new().expect("a folder");
    let mut random = Random(1);
    let mut noise = b"P6 64 36 255\n".to_vec();
    noise.extend((0..64 * 36 * 3).map(|_| random.below(256) as u8));
    write(&folder, "mine.ppm", &noise);
    let said = |words: &[&str]| text(&run(&mut check_in(&folder, words)).stdout);
    let (guessed, named) = (said(&["mine.ppm"]), said(&["normals", "mine.ppm"]));
    assert!(
        guessed.starts_with("mine.ppm is not recognized"),
        "{guessed}"
    );
    assert!(named.starts_with("mine.ppm is wrong"), "{named}");
}

#[test]
fn a_forgotten_change_is_told_before_anything_else() {
    let folder = TempDir::new().expect("a folder");
    write(&folder, "mine.ppm", &p3(&normals::picture(200)));
    let inside = ["normals", "mine.ppm", "--probe", "off-axis"];
    let output = run(&mut check_in(&folder, &inside));
    assert_eq!(output.status.code(), Some(1));
    insta::assert_snapshot!(text(&output.stdout));
}

#[test]
fn a_set_of_mistakes_is_shown_with_the_probe_that_tells_them_apart() {
    insta::assert_snapshot!(said_of("half_b_sphere", "minus-h", "mine.png", 1));
}

#[test]
fn a_single_level_is_told_apart_from_a_wrong_picture() {
    insta::assert_snapshot!(said_of("hittable_list", "rounded", "mine.png", 1));
}

#[test]
fn numbers_that_are_no_levels_are_shown_with_the_mistake() {
    insta::assert_snapshot!(said_of("normals", "normal-only-shifted", "mine.ppm", 2));
}

#[test]
fn a_wrong_shape_is_shown_with_the_mistake() {
    insta::assert_snapshot!(said_of("gradient", "integer-aspect-ratio", "mine.png", 1));
}

#[test]
fn a_picture_that_no_mistake_draws_is_described() {
    let folder = TempDir::new().expect("a folder");
    write(&folder, "mine.ppm", &p3(&hittable_list::picture(200)));
    let output = run(&mut check_in(&folder, &["normals", "mine.ppm"]));
    assert_eq!(output.status.code(), Some(1));
    insta::assert_snapshot!(text(&output.stdout));
}

#[test]
fn what_is_no_picture_is_refused_with_cause_and_fix() {
    let folder = TempDir::new().expect("a folder");
    let chatty = b"P3\n400 225\n255\nScanlines remaining: 224\n";
    // As a stream of text changes them on Windows.
    let swollen = [b"P6\n16 16\n255\n", build_test::picture(16).rgb()].concat();
    let swollen: Vec<u8> = swollen
        .into_iter()
        .flat_map(|byte| match byte {
            b'\n' => vec![b'\r', b'\n'],
            byte => vec![byte],
        })
        .collect();
    write(&folder, "chatty.ppm", chatty);
    write(&folder, "swollen.ppm", &swollen);
    insta::assert_snapshot!(transcript(
        &mut ["chatty.ppm", "swollen.ppm", "missing.ppm"]
            .map(|name| check_in(&folder, &["gradient", name]))
    ));
}

#[test]
fn a_picture_may_come_from_standard_input_or_from_a_program() {
    let mut child = program_with("rtrace", &["check", "red_sphere", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("it is piped");
    stdin
        .write_all(&p3(&red_sphere::picture(64)))
        .expect("it reads");
    drop(stdin);
    let output = child.wait_with_output().expect("the program ends");
    assert!(text(&output.stdout).starts_with("standard input is right"));

    let normals = path_of("normals").display().to_string();
    let output = run(&mut program_with(
        "rtrace",
        &["check", "half_b_sphere", "--", &normals],
    ));
    assert_success(&output);
    let output = run(&mut program_with(
        "rtrace",
        &["check", "gradient", "--", &normals, "-"],
    ));
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stdout).contains("rtrace check normals PICTURE"));

    for (words, problem) in [
        (&["no-such-program"][..], "does not start"),
        (&[&normals, "--option"], "ended with exit"),
    ] {
        let output = run(program_with("rtrace", &["check", "normals", "--"]).args(words));
        assert_eq!(output.status.code(), Some(2));
        assert!(
            text(&output.stdout).contains(problem),
            "{}",
            text(&output.stdout)
        );
    }
}

/// Programs that would keep a check waiting: a loop, one that hands its output to a
/// process that goes on, one that closes it and goes on, one that prints forever.
#[cfg(unix)]
#[test]
fn a_program_ends_within_its_time() {
    let gradient = path_of("gradient").display().to_string();
    for (script, seconds, code, words) in [
        ("exec sleep 60", "1", 2, "did not end within 1s"),
        (&format!("{gradient} -; sleep 9 &"), "600", 0, "is right"),
        ("exec >&-; exec sleep 60", "1", 2, "did not end within 1s"),
        ("exec yes", "600", 2, "has more than"),
    ] {
        let arguments = ["check", "gradient", "--timeout", seconds, "--", "sh", "-c"];
        let output = run(program_with("rtrace", &arguments).arg(script));
        assert_eq!(output.status.code(), Some(code), "{script}");
        let said = text(&output.stdout);
        assert!(said.contains(words), "{script}: {said}");
    }
}

/// What is checked has started another one. Both hold the pipe, which ends when they have.
#[cfg(unix)]
#[test]
fn ctrl_c_ends_what_is_checked_with_all_that_it_started() {
    use rustix::process::{Pid, Signal, kill_process_group};
    use std::io::{BufRead, BufReader, Read};
    use std::os::unix::process::{CommandExt, ExitStatusExt};
    use std::time::{Duration, Instant};

    let mut check = crate::terminal::hears_signals(path_of("rtrace"));
    // The inner one says that it runs, so that there is one to be ended.
    let script = "sh -c 'echo it runs >&2; exec sleep 60'; true";
    check.args(["check", "gradient", "--", "sh", "-c", script]);
    let piped = check.stdout(Stdio::null()).stderr(Stdio::piped());
    // A terminal sends it to the group that is in front.
    let mut child = piped.process_group(0).spawn().expect("the program starts");
    let mut pipe = BufReader::new(child.stderr.take().expect("it is piped"));
    let mut said = String::new();
    pipe.read_line(&mut said).expect("it runs");
    let start = Instant::now();
    kill_process_group(Pid::from_child(&child), Signal::INT).expect("it is running");
    let ended = child.wait().expect("it ends");
    assert_eq!(ended.signal(), Some(Signal::INT.as_raw()));
    pipe.read_to_string(&mut said).expect("the pipe ends");
    assert!(start.elapsed() < Duration::from_secs(30));
}

/// As many pixels as are accepted, in a file of a few kilobytes.
#[test]
#[ignore = "unpacks sixteen million pixels twice, without optimization"]
fn a_picture_of_an_absurd_shape_is_judged_by_its_shape() {
    let folder = TempDir::new().expect("a folder");
    for (width, height) in [(1, MOST_PIXELS as u32), (MOST_PIXELS as u32, 1)] {
        let black = Picture::from_rgb(width, height, vec![0; 3 * MOST_PIXELS as usize]);
        let file = png::encode(&black.expect("three bytes a pixel"));
        write(&folder, "mine.png", &file);
        let output = run(&mut check_in(&folder, &["normals", "mine.png"]));
        assert_eq!(output.status.code(), Some(1));
        let said = text(&output.stdout);
        let size = format!("is {width} × {height}, but");
        assert!(said.contains(&size) && said.lines().count() < 4, "{said}");
    }
}

#[test]
fn a_tolerance_accepts_what_it_says() {
    let folder = TempDir::new().expect("a folder");
    draw(&folder, "rounded", "hittable_list", "mine.png");
    let exit = |arguments: &[&str]| {
        let arguments = [&["hittable_list", "mine.png"], arguments].concat();
        run(&mut check_in(&folder, &arguments)).status.code()
    };
    assert_eq!(exit(&[]), Some(1));
    assert_eq!(exit(&["--tolerance", "1"]), Some(0));
    assert_eq!(exit(&["--tolerance", "256"]), Some(2));
}

#[test]
fn a_probe_is_checked_with_its_own_scene() {
    let folder = TempDir::new().expect("a folder");
    write(&folder, "mine.ppm", &p3(&hittable_list::picture(128)));
    let reversed = ["hittable_list", "mine.ppm", "--probe", "reversed"];
    assert_success(&run(&mut check_in(&folder, &reversed)));
    let inside = ["hittable_list", "mine.ppm", "--probe", "inside"];
    assert_eq!(run(&mut check_in(&folder, &inside)).status.code(), Some(1));
    let odd = run(&mut check_in(
        &folder,
        &["hittable_list", "mine.ppm", "--probe", "odd-width"],
    ));
    assert_eq!(odd.status.code(), Some(1));
    assert!(text(&odd.stdout).contains("image_width = 227"));
    assert_refused(
        &mut check_in(&folder, &["gradient", "mine.ppm", "--probe", "inside"]),
        &["no place", "cargo rtrace probes"],
    );
}

#[test]
fn a_report_is_a_page_that_needs_nothing_else() {
    let folder = TempDir::new().expect("a folder");
    // On Windows no name has brackets.
    let (name, escaped) = match cfg!(windows) {
        true => ("a&c.png", "a&amp;c.png"),
        false => ("a<b>&c.png", "a&lt;b&gt;&amp;c.png"),
    };
    draw(&folder, "minus-h", "half_b_sphere", name);
    let output = run(&mut check_in(
        &folder,
        &["half_b_sphere", name, "--report", "report/mine"],
    ));
    assert_eq!(output.status.code(), Some(1));
    let report = folder.path().join("report").join("mine");
    assert_eq!(
        names_in(&report),
        [
            ".rtrace-manifest",
            "difference.png",
            "expected.png",
            "index.html",
            "yours.png"
        ]
    );
    let shown = |name: &str| {
        read(&fs::read(report.join(name)).expect("the file"))
            .expect("a picture")
            .picture()
    };
    assert!(shown("expected.png") == half_b_sphere::picture(400));
    assert!(shown("yours.png") == gradient::picture(400));
    let page = fs::read_to_string(report.join("index.html")).expect("the page");
    for part in [
        escaped,
        "minus-h",
        "type=\"range\"",
        "(-h - sqrt(discriminant)) / a",
        "width=device-width",
        "light dark",
    ] {
        assert!(page.contains(part), "{part} is missing");
    }
    assert!(!page.contains("http"), "a page on a disk has no network");
    assert!(!page.contains("<b>"), "the name of a file is no markup");
}

#[test]
fn what_is_known_is_listed() {
    let said = |words: &[&str]| {
        let output = run(&mut program_with("rtrace", words));
        assert_success(&output);
        text(&output.stdout)
    };
    let probes = said(&["probes"]);
    for probe in PROBES {
        let lines = probe.lines(Chapter::HittableList);
        let mut parts = lines.lines().chain([probe.name]);
        assert!(parts.all(|part| probes.contains(part)), "{probes}");
    }
    assert!(!said(&["probes", "gradient"]).contains("sphere"));
    let all = said(&["slips"]);
    for slip in slips::all() {
        assert!(all.contains(slip.name), "{}", slip.name);
    }
    assert!(!said(&["slips", "build_test"]).contains("minus-h"));
    insta::assert_snapshot!(said(&["slips", "minus-h"]));
}

#[test]
fn a_slip_is_drawn_where_there_is_something_to_see() {
    let folder = TempDir::new().expect("a folder");
    let draw = |words: &[&str]| {
        let mut command = program_with("rtrace", &["slips", "draw"]);
        in_folder(&folder, command.args(words));
        command
    };
    let small = ["dot-with-swapped-letter", "--width", "32", "-o", "a.ppm"];
    assert_success(&run(&mut draw(&small)));
    let wrong = suite::slip("dot-with-swapped-letter").program(Chapter::HittableList);
    let drawn = fs::read_to_string(folder.path().join("a.ppm"));
    assert_eq!(drawn.expect("the file"), wrong.run(32).to_string());
    insta::assert_snapshot!(transcript(&mut [
        draw(&["minus-h", "--chapter", "gradient", "-o", "b.ppm"]),
        draw(&["minus-g", "-o", "b.ppm"]),
        draw(&["height-may-be-zero", "--width", "1", "-o", "b.png"]),
    ]));
}

/// What is said of the picture that a slip draws, under the name of that file.
fn said_of(chapter: &str, slip: &str, name: &str, code: i32) -> String {
    let folder = TempDir::new().expect("a folder");
    draw(&folder, slip, chapter, name);
    let output = run(&mut check_in(&folder, &[chapter, name]));
    assert_eq!(output.status.code(), Some(code), "{}", text(&output.stderr));
    assert_eq!(text(&output.stderr), "");
    in_any_workspace(&output)
}

/// What a program printed, with the paths of sources as they are everywhere, and no
/// pages: how one is named depends on whether the book was woven.
fn in_any_workspace(output: &Output) -> String {
    let workspace = workspace::workspace().expect("it is here");
    let workspace = in_any_system(&workspace.display().to_string());
    // In JSON each backslash is written twice.
    let printed = in_any_system(&text(&output.stdout).replace(r"\\", r"\"));
    let printed = printed.replace(&workspace, "WORKSPACE");
    let without_page = |line: &str| match line.starts_with("    read ") {
        true => "    read      PAGE\n".to_owned(),
        false => format!("{line}\n"),
    };
    printed.lines().map(without_page).collect()
}

fn draw(folder: &TempDir, slip: &str, chapter: &str, name: &str) {
    let arguments = [
        "slips",
        "draw",
        slip,
        "--chapter",
        chapter,
        "--output",
        name,
    ];
    assert_success(&run(in_folder(
        folder,
        &mut program_with("rtrace", &arguments),
    )));
}

fn check_in(folder: &TempDir, arguments: &[&str]) -> Command {
    let mut command = program_with("rtrace", &["check"]);
    in_folder(folder, command.args(arguments));
    command
}

fn in_folder<'a>(folder: &TempDir, command: &'a mut Command) -> &'a mut Command {
    command.current_dir(folder.path())
}

fn write(folder: &TempDir, name: &str, bytes: &[u8]) {
    let path: &Path = folder.path();
    fs::write(path.join(name), bytes).expect("a file");
}
