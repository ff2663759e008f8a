//! What is written, and where: nobody loses a file, and none is half there.

use std::fs;
use std::path::Path;
use std::process::Command;

use insta::assert_snapshot;
use slips::Chapter;
use suite::command::{assert_success, names_in, program, program_with, run, text, transcript};
use suite::drawn::p3;
use tempfile::TempDir;

#[test]
fn a_chapter_prints_its_picture_or_writes_the_file_that_is_named() {
    let here = TempDir::new().expect("a folder");
    for chapter in Chapter::ALL {
        let expected = p3(&chapter.picture(37));
        let wide = |name: &str| {
            let mut command = program_with(chapter.name(), &["--width", "37", name]);
            run(command.current_dir(here.path()))
        };
        let printed = wide("-");
        assert_success(&printed);
        assert!(printed.stdout == expected, "{chapter:?}");
        for _first_then_again in 0..2 {
            assert_success(&wide("a.PPM"));
            assert!(fs::read(here.path().join("a.PPM")).expect("it") == expected);
        }
    }
    assert_eq!(names_in(here.path()), ["a.PPM"], "and nothing beside");
    let book_width = run(&mut program("normals"));
    assert!(book_width.stdout == p3(&normals::picture(400)));
}

/// In a folder with the page of an earlier report, the files `lost` or `odd` of somebody
/// make it somebody's.
#[test]
fn a_folder_with_a_file_of_somebody_is_refused_by_its_name() {
    for somebodys in [
        "thesis.txt",
        ".git/HEAD",
        "drafts/",
        "new\nline.txt",
        "yours.png/thesis.txt",
        ".thesis.txt.0123456789abcdef.partial",
    ] {
        // On Windows a name is on one line.
        if cfg!(windows) && somebodys.contains('\n') {
            continue;
        }
        let desk = Desk::new();
        desk.report();
        let _ = fs::remove_file(desk.path("page/yours.png"));
        desk.write(&format!("page/{somebodys}"), "mine");
        let before = contents(desk.0.path());
        let output = run(&mut desk.check("page"));
        let first = somebodys.split_inclusive('/').next().expect("a name");
        let named = format!("{:?}", first.trim_end_matches('/'));
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(&named), "{named} is missing from {said}");
        assert_eq!(contents(desk.0.path()), before);
    }
}

#[test]
fn a_folder_is_filled_if_it_is_new_or_empty_or_holds_what_was_there_last() {
    let desk = Desk::new();
    desk.write("empty/", "");
    desk.write("empty/.DS_Store", "the system's");
    for folder in ["new", "deep/er", "slash/", "./dot", "empty", "empty/../up"] {
        for _first_then_again in 0..2 {
            assert_eq!(run(&mut desk.check(folder)).status.code(), Some(1));
            let page = desk.path(folder).join("difference.png");
            assert!(page.is_file(), "{folder}");
        }
    }
    // Of this there is nothing to show, so the pictures of the last one go.
    desk.write("mine.ppm", "no picture");
    run(&mut desk.check("new"));
    assert_eq!(names_in(&desk.path("new")), [LIST, "index.html"]);
}

/// Interrupted while it replaced a page: new files have their names, others not yet, and
/// one was being written.
#[test]
fn what_an_interrupted_program_left_is_put_in_order_by_the_next() {
    let desk = Desk::new();
    desk.report();
    let whole = names_in(&desk.path("page"));
    fs::remove_file(desk.path("page/yours.png")).expect("it was not there yet");
    for partial in ["index.html", LIST] {
        desk.write(&format!("page/.{partial}.0123456789abcdef.partial"), "half");
    }
    desk.report();
    assert_eq!(names_in(&desk.path("page")), whole);
    // Before even the list was there.
    desk.write(&format!("new/.{LIST}.0123456789abcdef.partial"), "half");
    assert_eq!(run(&mut desk.check("new")).status.code(), Some(1));
    assert_eq!(names_in(&desk.path("new")), whole);
}

/// A list is only asked for names that were found, so it can't send anybody elsewhere.
#[test]
fn a_list_that_was_tampered_with_leads_nowhere() {
    let desk = Desk::new();
    desk.report();
    let list = fs::read_to_string(desk.path("page").join(LIST)).expect("the list");
    desk.write(
        &format!("page/{LIST}"),
        &(list + "\"../thesis.txt\"\n\"..\"/\n"),
    );
    desk.write("thesis.txt", "mine");
    desk.report();
    assert_eq!(fs::read(desk.path("thesis.txt")).expect("it"), b"mine");
}

#[test]
fn what_can_not_be_written_is_said_with_what_helps() {
    let desk = Desk::new();
    desk.write("folder.ppm/", "");
    desk.write("file", "mine");
    desk.write("kept.ppm", "mine");
    let mut permissions = fs::metadata(desk.path("kept.ppm"))
        .expect("it")
        .permissions();
    permissions.set_readonly(true);
    fs::set_permissions(desk.path("kept.ppm"), permissions).expect("it is read-only");
    let before = contents(desk.0.path());
    let said = transcript(&mut [
        desk.run(&["normals", "missing/a.ppm"]),
        desk.run(&["normals", "folder.ppm"]),
        desk.run(&["normals", "kept.ppm"]),
        desk.run(&["normals", ""]),
        desk.run(&["rtrace", "show", "normals", "--output", "missing/a.png"]),
        desk.check("file"),
        desk.check("."),
    ]);
    // Of Windows alone.
    let said = said.replace(" and that no program has open", "");
    assert_snapshot!(said);
    assert_eq!(contents(desk.0.path()), before);
}

#[cfg(unix)]
mod on_unix {
    use std::fs::{File, Permissions};
    use std::io::{BufRead, BufReader};
    use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
    use std::process::Stdio;
    use std::thread;
    use std::time::{Duration, Instant};

    use suite::command::assert_failed;

    use super::*;

    #[test]
    fn a_closed_pipe_is_a_quiet_end() {
        for words in [
            &["hittable_list"][..],
            &["rtrace", "show", "hittable_list", "--output", "-"],
        ] {
            let mut command = program_with(words[0], &words[1..]);
            let piped = command.stdout(Stdio::piped()).stderr(Stdio::piped());
            let mut child = piped.spawn().expect("the program starts");
            let mut line = String::new();
            let pipe = child.stdout.take().expect("a pipe");
            let read = BufReader::new(pipe).read_line(&mut line);
            assert_eq!((read.expect("a first line"), &*line), (3, "P3\n"));
            assert_success(&child.wait_with_output().expect("the program ends"));
        }
    }

    /// Linux has a device that is always full.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_behind_standard_output_is_reported() {
        for words in [
            &["normals"][..],
            &["normals", "--help"],
            &["rtrace", "show", "normals", "-o", "-"],
        ] {
            let full = File::options().write(true).open("/dev/full");
            let mut command = program_with(words[0], &words[1..]);
            let words = ["standard output", "No space left", "Free some space"];
            assert_failed(command.stdout(full.expect("a device")), &words);
        }
    }

    #[test]
    fn what_was_there_stays_when_writing_fails_half_way_or_at_the_very_end() {
        let desk = Desk::new();
        desk.report();
        desk.write("kept.ppm", "mine");
        let before = contents(desk.0.path());
        // No file may be larger than so many blocks, as at the end of a disk. The signal
        // that the system sends is ignored, so that the write itself fails.
        let limited = |blocks: u32, command: &Command| {
            let script = format!("ulimit -f {blocks}; trap '' XFSZ; exec \"$0\" \"$@\"");
            let mut shell = Command::new("sh");
            shell.args(["-c", &script]).arg(command.get_program());
            shell.args(command.get_args()).current_dir(desk.0.path());
            shell
        };
        let show = ["rtrace", "show", "normals", "-o"];
        for (blocks, mut command) in [
            (64, desk.run(&["normals", "kept.ppm"])),
            (64, desk.run(&[&show[..], &["kept.ppm"]].concat())),
            // So small that it waits in a buffer until the end.
            (
                1,
                desk.run(&[&show[..], &["kept.ppm", "--width", "30"]].concat()),
            ),
        ]
        .map(|(blocks, command)| (blocks, limited(blocks, &command)))
        {
            assert_failed(&mut command, &["\"kept.ppm\"", "large"]);
            assert_eq!(contents(desk.0.path()), before, "{blocks}");
        }
    }

    /// The new file takes the place of the old one in one step, and is written beside it,
    /// because a step can't lead to another disk.
    #[test]
    fn a_file_is_replaced_with_its_permissions_and_a_link_to_it_stays() {
        let desk = Desk::new();
        desk.write("target.ppm", "old");
        let (target, link) = (desk.path("target.ppm"), desk.path("link.ppm"));
        symlink(&target, &link).expect("a link");
        fs::set_permissions(&target, Permissions::from_mode(0o640)).expect("the mode is set");
        let mut old = File::open(&target).expect("the old file");
        assert_success(&run(&mut desk.run(&["normals", "link.ppm"])));
        assert_eq!(std::io::read_to_string(&mut old).expect("it"), "old");
        assert!(link.is_symlink() && !target.is_symlink());
        assert!(fs::read(&target).expect("it") == p3(&normals::picture(400)));
        let mode = fs::metadata(&target).expect("it").permissions().mode();
        assert_eq!(mode & 0o777, 0o640);

        fs::remove_file(target).expect("now it is a link to nothing");
        assert_failed(&mut desk.run(&["normals", "link.ppm"]), &["link.ppm"]);
        assert!(link.is_symlink());
    }

    #[test]
    fn a_pipe_with_a_name_is_written_to_and_stays_a_pipe() {
        let desk = Desk::new();
        let pipe = desk.path("pipe.ppm");
        let made = Command::new("mkfifo").arg(&pipe).status();
        assert!(made.expect("mkfifo starts").success());
        let reading = thread::spawn({
            let pipe = pipe.clone();
            move || fs::read(pipe).expect("the pipe is read")
        });
        assert_success(&run(&mut desk.run(&["normals", "pipe.ppm"])));
        assert!(reading.join().expect("it was read") == p3(&normals::picture(400)));
        let kind = fs::metadata(&pipe).expect("the pipe").file_type();
        assert!(kind.is_fifo());
    }

    #[test]
    fn a_link_among_our_files_is_somebodys_and_a_link_to_our_folder_is_followed() {
        let desk = Desk::new();
        desk.report();
        symlink("page", desk.path("link")).expect("a link");
        assert_eq!(run(&mut desk.check("link")).status.code(), Some(1));
        assert!(desk.path("link").is_symlink());
        desk.write("thesis.txt", "mine");
        fs::remove_file(desk.path("page/yours.png")).expect("it goes");
        symlink("../thesis.txt", desk.path("page/yours.png")).expect("a link");
        assert_eq!(run(&mut desk.check("page")).status.code(), Some(2));
        assert_eq!(fs::read(desk.path("thesis.txt")).expect("it"), b"mine");
    }

    /// `KILLS=200 cargo test killed -- --ignored` for a long campaign.
    #[test]
    #[ignore = "kills programs for half a minute"]
    fn programs_that_are_killed_leave_nothing_to_repair() {
        let kills = std::env::var("KILLS").map_or(30, |said| said.parse().expect("a number"));
        let desk = Desk::new();
        let chapter = ["gradient", "--width", "3840", "kept.ppm"];
        let report = [
            "rtrace",
            "check",
            "half_b_sphere",
            "mine.ppm",
            "--report",
            "page",
        ];
        for words in [&chapter[..], &report] {
            let start = Instant::now();
            run(&mut desk.run(words));
            let (takes, whole) = (start.elapsed(), contents(desk.0.path()));
            for n in 0..kills {
                desk.write("kept.ppm", "old");
                let silent = desk
                    .run(words)
                    .stdout(Stdio::null())
                    .stderr(Stdio::null())
                    .spawn();
                let mut child = silent.expect("the program starts");
                // The golden ratio: moments that are spread evenly, however many.
                let moment = (f64::from(n) * 0.618_033_988_75).fract();
                thread::sleep(takes.mul_f64(moment).max(Duration::from_millis(1)));
                child.kill().expect("it is there until we wait for it");
                child.wait().expect("it ends");
                let kept = fs::read(desk.path("kept.ppm")).expect("it is always there");
                assert!(kept == b"old" || Some(&Some(kept)) == whole.get("kept.ppm"));
                run(&mut desk.run(words));
                for (name, bytes) in &whole {
                    assert!(name == "kept.ppm" || fs::read(desk.path(name)).ok() == *bytes);
                }
            }
        }
    }
}

/// The list of the files that a folder of ours holds.
const LIST: &str = ".rtrace-manifest";

/// A folder with a picture that is wrong.
struct Desk(TempDir);

impl Desk {
    fn new() -> Self {
        let desk = Self(TempDir::new().expect("a folder"));
        let wrong = suite::slip("minus-h").program(Chapter::HalfBSphere);
        let wrong = p3(&wrong.run(100).picture());
        fs::write(desk.path("mine.ppm"), wrong).expect("a file");
        desk
    }

    fn path(&self, name: &str) -> std::path::PathBuf {
        self.0.path().join(name)
    }

    /// A file, or with a slash at the end of its name a folder.
    fn write(&self, name: &str, text: &str) {
        let path = self.path(name);
        let folder = if name.ends_with('/') {
            &*path
        } else {
            path.parent().expect("one")
        };
        fs::create_dir_all(folder).expect("a folder");
        if !name.ends_with('/') {
            fs::write(path, text).expect("a file");
        }
    }

    /// A program with its arguments, to be run here.
    fn run(&self, words: &[&str]) -> Command {
        let mut command = program_with(words[0], &words[1..]);
        command.current_dir(self.0.path());
        command
    }

    fn check(&self, folder: &str) -> Command {
        self.run(&[
            "rtrace",
            "check",
            "half_b_sphere",
            "mine.ppm",
            "--report",
            folder,
        ])
    }

    /// Reports on the picture into the folder `page`.
    fn report(&self) {
        assert_eq!(run(&mut self.check("page")).status.code(), Some(1));
        assert!(self.path("page/index.html").is_file());
    }
}

/// What each file below `folder` holds; `None` for a folder or a link.
fn contents(folder: &Path) -> std::collections::BTreeMap<String, Option<Vec<u8>>> {
    let mut found = std::collections::BTreeMap::new();
    for name in names_in(folder) {
        let path = folder.join(&name);
        if path.is_dir() && !path.is_symlink() {
            let inside = contents(&path).into_iter();
            found.extend(inside.map(|(below, bytes)| (format!("{name}/{below}"), bytes)));
        }
        let is_file = path.is_file() && !path.is_symlink();
        found.insert(name, is_file.then(|| fs::read(&path).expect("a file")));
    }
    found
}
