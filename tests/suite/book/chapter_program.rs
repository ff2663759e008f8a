//! The program of a chapter: what it prints, what it writes, and what it refuses. It is that of
//! chapter 5, under the name `chapter`.

use std::fs;

use common::rtweekend::Picture;
use fixtures::command::{names_in, run, text};
use fixtures::desk::Desk;
use fixtures::drawn::p3;
use insta::assert_snapshot;

fn picture(width: u32) -> Picture {
    hittable_list::picture(width)
}

#[test]
fn it_prints_its_picture_or_writes_the_file_that_is_named() {
    let desk = Desk::default();
    let expected = p3(&picture(37));
    assert!(desk.run("chapter --width 37 -").stdout == expected);
    for _first_then_again in 0..2 {
        desk.run("chapter --width 37 a.PPM");
        assert!(fs::read(desk.path("a.PPM")).expect("it") == expected);
    }
    assert_eq!(names_in(&desk.path("")), ["a.PPM"], "and nothing beside");
}

#[test]
fn it_explains_itself_when_asked_and_when_misunderstood() {
    let desk = Desk::default();
    let help = desk.transcript("chapter --help");
    let (_, usage) = help.split_once('\n').expect("what it says");
    let said = desk.transcript(
        "chapter picture.PNG
         chapter /dev/null
         chapter a.ppm b.ppm
         chapter a.ppm --width
         chapter --width 0
         chapter --width=16385
         chapter --width -3
         chapter --width=four a.ppm
         chapter -w",
    );
    let usage = usage.trim_end();
    assert_snapshot!(help.clone() + &said.replace(usage, "(the same)"));
}

#[test]
fn what_can_not_be_written_is_said_with_what_helps() {
    let desk = Desk::default();
    desk.write("folder.ppm/", "");
    desk.write("file", "mine");
    desk.write("kept.ppm", "mine");
    let mut permissions = fs::metadata(desk.path("kept.ppm"))
        .expect("it")
        .permissions();
    permissions.set_readonly(true);
    fs::set_permissions(desk.path("kept.ppm"), permissions).expect("it is read-only");
    let before = desk.contents();
    let said = desk.transcript(
        "chapter missing/a.ppm
         chapter folder.ppm
         chapter kept.ppm",
    );
    // Of Windows alone.
    assert_snapshot!(said.replace(" and that no program has open", ""));
    assert_eq!(desk.contents(), before);
}

#[cfg(unix)]
mod on_unix {
    use std::fs::File;
    use std::io::{BufRead, BufReader};
    use std::os::unix::fs::symlink;
    use std::process::{Command, Stdio};

    use fixtures::command::{assert_success, program};
    use fixtures::terminal::run_in_terminal;

    use super::*;

    #[test]
    fn a_closed_pipe_is_a_quiet_end() {
        let desk = Desk::default();
        let mut chapter = desk.command("chapter");
        chapter.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = chapter.spawn().expect("it starts");
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
        let desk = Desk::default();
        for line in ["chapter", "chapter --help"] {
            let full = File::options().write(true).open("/dev/full");
            let output = run(desk.command(line).stdout(full.expect("a device")));
            let said = text(&output.stderr);
            assert_eq!(output.status.code(), Some(1));
            assert!(said.contains("Free some space"), "{said}");
        }
    }

    #[test]
    fn what_was_there_stays_when_writing_fails_half_way_or_at_the_very_end() {
        let desk = Desk::default();
        desk.write("kept.ppm", "mine");
        // No file may be larger than so many blocks, as at the end of a disk. The signal
        // that the system sends is ignored, so that the write itself fails. One block is so
        // small that it waits in a buffer until the end.
        for (blocks, line) in [(64, "chapter kept.ppm"), (1, "chapter kept.ppm --width 30")] {
            let script = format!("ulimit -f {blocks}; trap '' XFSZ; exec \"$0\" \"$@\"");
            let command = desk.command(line);
            let mut shell = Command::new("sh");
            shell.args(["-c", &script]).arg(command.get_program());
            let output = run(shell.args(command.get_args()).current_dir(desk.path("")));
            assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
            assert_eq!(names_in(&desk.path("")), ["kept.ppm"]);
            assert_eq!(desk.read("kept.ppm"), "mine");
        }
    }

    #[test]
    fn a_link_to_a_file_stays_a_link() {
        let desk = Desk::default();
        desk.write("target.ppm", "old");
        let [target, link] = ["target.ppm", "link.ppm"].map(|name| desk.path(name));
        symlink(&target, &link).expect("a link");
        desk.run("chapter link.ppm --width 30");
        assert!(link.is_symlink() && !target.is_symlink());
        assert!(fs::read(&target).expect("it") == p3(&picture(30)));
    }

    #[test]
    fn at_a_terminal_it_says_where_to_send_the_picture() {
        let (output, screen) = run_in_terminal(&mut program("chapter", &[]));
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(screen, "", "no number reaches the terminal");
        let said = text(&output.stderr);
        assert!(
            said.contains("cargo run -p chapter > chapter.ppm"),
            "{said}"
        );
    }
}
