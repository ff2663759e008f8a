//! Hostile input: how much memory each kind of it takes, and what lies just above a limit.

use std::fs;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use common::rtweekend::Picture;
use fixtures::command::text;
use fixtures::desk::Desk;
use fixtures::left_out::left_out;
use slips::{Chapter, ChapterCode};

/// Inputs that are accepted, and the command that takes each.
const INPUTS: &str = "\
the longest text of a picture | check normals wrong.ppm
the largest binary picture    | check normals wrong.ppm
the largest PNG file          | check normals wrong.png
output without an end         | check normals -- cat /dev/zero
answers without an end        | laws normals -- cat /dev/zero
errors without an end         | watch normals --once --timeout 1 -- sh flood.sh
";

/// Saves an input beside a wrong picture.
fn save(input: &str, desk: &Desk) {
    desk.write_picture("wrong.ppm", &Chapter::Gradient.picture(64));
    match input {
        "the longest text of a picture" => desk.write("wrong.ppm", large("P3", "255 255 255\r\n")),
        "the largest binary picture" => desk.write("wrong.ppm", large("P6", "\0\x01\x02")),
        "the largest PNG file" => {
            let levels = (0..3 * SIDE * SIDE).map(|n| (n ^ n >> 8) as u8).collect();
            let picture = Picture::from_rgb(SIDE, SIDE, levels);
            let picture = picture.expect("three bytes a pixel");
            desk.write("wrong.png", difference::png::encode(&picture));
        }
        "errors without an end" => desk.write("flood.sh", "exec yes aaaaaaaaaaaaaaaa >&2"),
        _ => {}
    }
}

/// The side of a square that has the most pixels that a picture may have.
const SIDE: u32 = 4096;

fn large(kind: &str, pixel: &str) -> String {
    let pixels = pixel.repeat((SIDE * SIDE) as usize);
    format!("{kind}\n{SIDE} {SIDE}\n255\n{pixels}")
}

#[test]
#[ignore = "judges six large inputs, some seconds each"]
fn whatever_is_accepted_takes_less_than_a_gibibyte() {
    if !cfg!(target_os = "linux") {
        return left_out("only Linux tells how much memory a program took at most");
    }
    let mut large = String::new();
    for (input, line) in INPUTS.lines().filter_map(|row| row.split_once(" | ")) {
        let desk = Desk::default();
        save(input.trim(), &desk);
        let (mebibytes, said) = peak(&mut desk.command(&format!("rtrace {line}")));
        println!("{input}  {mebibytes:>4} MiB");
        assert!(!said.is_empty(), "{input}: nothing is said");
        if mebibytes >= 1024 {
            large += &format!("{input}: {mebibytes} MiB\n");
        }
    }
    assert!(large.is_empty(), "{large}");
}

/// Runs the command to its end. Returns the most memory that it had, in mebibytes, and all that it
/// printed.
fn peak(command: &mut Command) -> (u64, String) {
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let child = child.spawn().expect("it starts");
    let status = format!("/proc/{}/status", child.id());
    let ended = thread::spawn(move || child.wait_with_output().expect("it ends"));
    let mut most = 0;
    while !ended.is_finished() {
        let status = fs::read_to_string(&status).unwrap_or_default();
        let mut peak = status.lines().filter_map(|it| it.strip_prefix("VmHWM:"));
        let peak = peak.next().and_then(|it| it.trim().strip_suffix(" kB"));
        most = most.max(peak.map_or(0, |it| it.parse().expect("a number")));
        thread::sleep(Duration::from_millis(1));
    }
    let output = ended.join().expect("it is read");
    assert!(output.status.code().is_some(), "{:?}", output.status);
    (most >> 10, text(&output.stdout) + &text(&output.stderr))
}

/// A file up to its limit is read, and one that is a byte longer is refused.
#[test]
fn a_file_that_is_longer_than_its_limit_is_not_read() {
    let desk = Desk::default();
    desk.run("rtrace start gradient");
    let lib = "mine/gradient/src/lib.rs";
    for (name, begin, most, line, shown) in [
        ("done.md", "- all", 1 << 22, "done --in .", "- all"),
        (
            lib,
            "fn f() {}",
            1 << 17,
            "start red_sphere",
            "It begins with",
        ),
    ] {
        for (length, is_read) in [(most, true), (most + 1, false)] {
            let _ = fs::remove_dir_all(desk.path("mine/red_sphere"));
            let blanks = " ".repeat(length - begin.len());
            desk.write(name, begin.to_owned() + &blanks);
            let output = desk.run(&format!("rtrace {line}"));
            let said = text(&output.stdout) + &text(&output.stderr);
            assert_eq!(said.contains(shown), is_read, "{name}: {length}: {said}");
            let refusal = format!("the file has more than {most} bytes");
            assert_eq!(said.contains(&refusal), !is_read, "{name}: {said}");
        }
    }
}
