//! Files: what is written whole or not at all, and what is never written over.

use std::fs;

use insta::assert_snapshot;
use suite::command::{names_in, run, text};
use suite::desk::Desk;
use suite::drawn::{p3, pictures};

#[test]
fn a_chapter_prints_its_picture_or_writes_the_file_that_is_named() {
    let desk = Desk::default();
    for (chapter, picture) in pictures() {
        let (name, expected) = (chapter.name(), p3(&picture(37)));
        let printed = desk.run(&format!("{name} --width 37 -"));
        assert!(printed.stdout == expected, "{chapter:?}");
        for _first_then_again in 0..2 {
            desk.run(&format!("{name} --width 37 a.PPM"));
            assert!(fs::read(desk.path("a.PPM")).expect("it") == expected);
        }
    }
    assert_eq!(names_in(&desk.path("")), ["a.PPM"], "and nothing beside");
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
        "normals missing/a.ppm
         normals folder.ppm
         normals kept.ppm
         rtrace show normals --output missing/a.png",
    );
    // Of Windows alone.
    assert_snapshot!(said.replace(" and that no program has open", ""));
    assert_eq!(desk.contents(), before);
}

#[cfg(unix)]
mod on_unix {
    use std::fs::{File, Permissions};
    use std::io::{BufRead, BufReader};
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::process::{Command, Stdio};

    use super::*;

    #[test]
    fn a_closed_pipe_is_a_quiet_end() {
        for line in ["hittable_list", "rtrace show hittable_list --output -"] {
            let mut command = Desk::default().command(line);
            let piped = command.current_dir(".").stdout(Stdio::piped());
            let mut child = piped.stderr(Stdio::piped()).spawn().expect("it starts");
            let mut first = String::new();
            let pipe = child.stdout.take().expect("a pipe");
            let read = BufReader::new(pipe).read_line(&mut first);
            assert_eq!((read.expect("a first line"), &*first), (3, "P3\n"));
            let output = child.wait_with_output().expect("the program ends");
            assert!(output.status.success() && output.stderr.is_empty());
        }
    }

    /// Linux has a device that is always full.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_behind_standard_output_is_reported() {
        let desk = Desk::default();
        for line in ["normals", "normals --help", "rtrace show normals -o -"] {
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
        for (blocks, line) in [
            (64, "normals kept.ppm"),
            (64, "rtrace show normals -o kept.ppm"),
            (1, "rtrace show normals -o kept.ppm --width 30"),
        ] {
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

    /// The new file takes the place of the old one in one step, and is written beside it,
    /// because a step can't lead to another disk.
    #[test]
    fn a_file_is_replaced_with_its_permissions_and_a_link_to_it_stays() {
        let desk = Desk::default();
        desk.write("target.ppm", "old");
        let (target, link) = (desk.path("target.ppm"), desk.path("link.ppm"));
        symlink(&target, &link).expect("a link");
        fs::set_permissions(&target, Permissions::from_mode(0o640)).expect("the mode is set");
        let mut old = File::open(&target).expect("the old file");
        desk.run("rtrace show normals -o link.ppm");
        assert_eq!(std::io::read_to_string(&mut old).expect("it"), "old");
        assert!(link.is_symlink() && !target.is_symlink());
        assert!(fs::read(&target).expect("it") == p3(&normals::picture(400)));
        let mode = fs::metadata(&target).expect("it").permissions().mode();
        assert_eq!(mode & 0o777, 0o640);
        // A chapter asks for no permissions, but a link stays a link there, too.
        desk.run("gradient link.ppm");
        assert!(link.is_symlink() && !target.is_symlink());
        assert!(fs::read(&target).expect("it") == p3(&gradient::picture(400)));
    }
}
