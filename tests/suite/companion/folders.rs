//! Folders that are replaced as a whole: nobody loses a file, whatever happens.
//!
//! The real programs weave small books, and report on small pictures, into folders
//! that hold what they should not, or that other programs fill at the same time, and
//! are killed while they do.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::hash::{BuildHasher, Hasher, RandomState};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};
use std::{env, thread};

use check::diagnosis::Scene;
use check::{judge, report};
use common::engine::folder;
use slips::Chapter;
use tempfile::TempDir;

use suite::command::woven;
use suite::command::{assert_refused, assert_success, names_in, program_with, run, text};
use suite::drawn::p3;
use suite::small_book::Book;

const MANIFEST: &str = ".rtrace-manifest";

#[test]
fn a_book_replaces_the_last_one_and_leaves_nothing_beside() {
    let book = Book::new("One.");
    book.write("other.md", "# Other\n");
    book.write("SUMMARY.md", "- [Page](page.md)\n- [Other](other.md)\n");
    assert_success(&book.weave(&book.output()));
    assert!(book.output().join("other.html").is_file());
    book.write("page.md", "# Page\n\nTwo.\n");
    book.write("SUMMARY.md", "- [Page](page.md)\n");
    assert_success(&book.weave(&book.output()));
    assert!(!book.output().join("other.html").exists(), "it is stale");
    assert!(page_in(&book.output()).contains("Two."));
    assert_eq!(names_beside(&book), ["book.toml", "notes", "woven"]);
}

#[test]
fn a_folder_with_a_strangers_file_is_refused_by_its_name() {
    for (stranger, named) in [
        ("thesis.txt", "\"thesis.txt\""),
        (".git/HEAD", "\".git\"/"),
        ("css/mine.css", "\"css/mine.css\""),
        ("drafts/", "\"drafts\"/"),
        ("new\nline.txt", "\"new\\nline.txt\""),
        ("page.html/thesis.txt", "\"page.html\"/"),
    ] {
        let book = Book::new("Text.");
        assert_success(&book.weave(&book.output()));
        let path = book.output().join(stranger);
        let _ = fs::remove_file(book.output().join("page.html"));
        match stranger.ends_with('/') {
            true => fs::create_dir(&path).expect("a folder"),
            false => write(&path, "mine"),
        }
        assert_nothing_changes(&book.output(), || {
            assert_book_is_refused(&book, &book.output(), &[named, "Nothing was changed"]);
        });
        assert_eq!(names_beside(&book), ["book.toml", "notes", "woven"]);
    }
}

/// As before there were manifests: whatever has a `print.html` looks like a book.
#[test]
fn a_folder_that_only_looks_like_ours_is_refused() {
    let book = Book::new("Text.");
    let kept = book.folder.path().join("kept");
    for name in [
        "print.html",
        "index.html",
        ".git/HEAD",
        "a.txt",
        "b.txt",
        "c.txt",
    ] {
        write(&kept.join(name), "mine");
    }
    write(&book.folder.path().join("mine.ppm"), "P3 1 1 255 0 0 0");
    assert_nothing_changes(&kept, || {
        assert_book_is_refused(&book, &kept, &["\".git\"/", "\"a.txt\"", "and 1 more"]);
        assert_report_is_refused(book.folder.path(), "kept", &["\".git\"/", "as a report"]);
    });
}

#[test]
fn a_book_is_no_report_and_a_report_is_no_book() {
    let book = Book::new("Text.");
    assert_success(&book.weave(&book.output()));
    write_wrong_picture(book.folder.path());
    assert_nothing_changes(&book.output(), || {
        assert_report_is_refused(book.folder.path(), "woven", &["404.html", "as a report"]);
    });
    report_in(book.folder.path());
    let page = book.folder.path().join("page");
    assert_nothing_changes(&page, || {
        assert_book_is_refused(&book, &page, &["yours.png", "as a book"]);
    });
}

/// A list is only asked what it knows, so it can't send anybody elsewhere.
#[test]
fn a_list_that_was_tampered_with_leads_nowhere() {
    let book = Book::new("Text.");
    assert_success(&book.weave(&book.output()));
    write(&book.folder.path().join("thesis.txt"), "mine");
    let list = book.output().join(MANIFEST);
    let thesis = book.folder.path().join("thesis.txt");
    let lines = format!("\"../thesis.txt\"\n../thesis.txt\n{thesis:?}\n\"..\"/\n");
    let tampered = fs::read_to_string(&list).expect("the list") + &lines;
    fs::write(&list, tampered).expect("the list is written");
    assert_success(&book.weave(&book.output()));
    assert_eq!(fs::read(&thesis).expect("the file"), b"mine");
}

#[test]
fn any_new_or_empty_folder_will_do_however_it_is_named() {
    let book = Book::new("Text.");
    let here = book.folder.path();
    fs::create_dir(here.join("empty")).expect("a folder");
    for name in [
        "empty",
        "new",
        "deep/er/new",
        "slash/",
        "./dot",
        "empty/../up",
    ] {
        let mut command = book.command();
        command.args(["--output", name]).current_dir(here);
        for _first_then_again in 0..2 {
            assert_success(&run(&mut command));
        }
        assert!(page_in(&here.join(name)).contains("Text."), "{name}");
    }
    assert_eq!(names_in(&here.join("deep/er")), ["new"]);
}

#[test]
fn what_a_file_manager_leaves_is_no_stranger() {
    let book = Book::new("Text.");
    write(&book.output().join(".DS_Store"), "the system's");
    for _first_then_again in 0..2 {
        assert_success(&book.weave(&book.output()));
        write(&book.output().join("css/.DS_Store"), "the system's");
    }
    assert_eq!(names_beside(&book), ["book.toml", "notes", "woven"]);
}

#[test]
fn what_is_no_folder_to_replace_is_refused_with_the_reason() {
    let book = Book::new("Text.");
    let here = book.folder.path();
    write(&here.join("file"), "mine");
    assert_nothing_changes(here, || {
        for (name, reason) in [
            ("file", "is a file"),
            ("notes/woven", "lies among the pages"),
            ("notes", "SUMMARY.md"),
            ("/", "name a folder in it"),
        ] {
            let mut command = book.command();
            command.args(["--output", name]).current_dir(here);
            assert_refused(&mut command, &[reason]);
        }
    });
}

/// Its shell would be in a folder that is gone.
#[test]
fn the_current_folder_is_not_replaced() {
    let book = Book::new("Text.");
    assert_success(&book.weave(&book.output()));
    for (here, name) in [("woven", "."), ("woven", "../woven"), ("woven/css", "..")] {
        let mut command = book.command();
        command.args(["--output", name]);
        command.current_dir(book.folder.path().join(here));
        assert_nothing_changes(&book.output(), || {
            assert_refused(&mut command, &["current folder", "elsewhere"]);
        });
    }
}

#[test]
fn a_full_disk_leaves_the_old_book_and_nothing_beside() {
    if !cfg!(unix) {
        return;
    }
    let book = Book::new("The old text.");
    assert_success(&book.weave(&book.output()));
    book.write("page.md", "# Page\n\nThe new text.\n");
    let mut shell = Command::new("sh");
    // No file may be larger than 64 blocks, as at the end of a disk.
    shell.args(["-c", "ulimit -f 64; trap '' XFSZ; exec \"$0\" \"$@\""]);
    let weave = book.command();
    shell.arg(weave.get_program()).args(weave.get_args());
    shell.arg("--output").arg(book.output());
    assert_nothing_changes(&book.output(), || {
        let output = run(&mut shell);
        assert_eq!(output.status.code(), Some(1));
        assert!(text(&output.stderr).contains("too large"));
    });
    assert_eq!(names_beside(&book), ["book.toml", "notes", "woven"]);
}

/// Between two renames: the old book is in the staging folder, the new one not yet
/// in its place.
#[test]
fn an_old_book_that_was_on_its_way_out_is_put_back() {
    let book = Book::new("The old text.");
    assert_success(&book.weave(&book.output()));
    let staging = book.folder.path().join(".woven.0123456789abcdef.partial");
    write(&staging.join("lock"), "");
    write(&staging.join("new/page.html"), "half a p");
    fs::rename(book.output(), staging.join("old")).expect("a new name");
    // This one fails, so what is there afterwards was put back.
    book.write("page.md", "# Page\n\n{{figure unicorn}}\n");
    assert_eq!(book.weave(&book.output()).status.code(), Some(1));
    assert!(page_in(&book.output()).contains("The old text."));
    assert_eq!(names_beside(&book), ["book.toml", "notes", "woven"]);
}

#[test]
fn what_was_abandoned_is_removed_and_nothing_else() {
    let book = Book::new("Text.");
    let here = book.folder.path();
    let abandoned = here.join(".woven.0123456789abcdef.partial");
    write(&abandoned.join("lock"), "");
    write(&abandoned.join("new/page.html"), "half a p");
    fs::create_dir(here.join(".woven.1123456789abcdef.partial")).expect("a folder");
    let in_use = here.join(".woven.2123456789abcdef.partial");
    write(&in_use.join("new/page.html"), "half a p");
    let lock = File::create_new(in_use.join("lock")).expect("a file");
    lock.lock().expect("the lock");
    for stranger in [
        ".woven.3123456789abcdef.partial/thesis.txt",
        ".woven.0123.partial/lock",
        ".other.0123456789abcdef.partial/lock",
        ".woven.notes/lock",
        ".woven.4123456789abcdef.partial.old/lock",
    ] {
        write(&here.join(stranger), "mine");
    }
    assert_success(&book.weave(&book.output()));
    assert_eq!(
        names_beside(&book),
        [
            ".other.0123456789abcdef.partial",
            ".woven.0123.partial",
            ".woven.2123456789abcdef.partial",
            ".woven.3123456789abcdef.partial",
            ".woven.4123456789abcdef.partial.old",
            ".woven.notes",
            "book.toml",
            "notes",
            "woven"
        ]
    );
    assert!(in_use.join("new/page.html").is_file());
    drop(lock);
    assert_success(&book.weave(&book.output()));
    assert!(!in_use.exists(), "now nobody uses it");
}

/// A reader's file that came while an earlier program was killed.
#[test]
fn a_strangers_file_in_an_abandoned_folder_stays() {
    let book = Book::new("Text.");
    assert_success(&book.weave(&book.output()));
    let old = book
        .folder
        .path()
        .join(".woven.0123456789abcdef.partial/old");
    write(&old.with_file_name("lock"), "");
    fs::rename(book.output(), &old).expect("a new name");
    assert_success(&book.weave(&book.output()));
    let staging = book.folder.path().join(".woven.1123456789abcdef.partial");
    write(&staging.join("lock"), "");
    write(&staging.join("old/thesis.txt"), "mine");
    assert_success(&book.weave(&book.output()));
    assert_eq!(names_in(&staging.join("old")), ["thesis.txt"]);
}

/// Two seldom meet between two renames: `KILLS=200 cargo test folders` is long
/// enough for that.
#[test]
fn many_at_once_into_one_folder_all_succeed() {
    let output = TempDir::new().expect("a folder");
    let target = output.path().join("woven");
    // Books of different files, so that no list fits the folder of another.
    let books: Vec<Book> = (0..4).map(book_of_pages).collect();
    thread::scope(|scope| {
        for book in &books {
            scope.spawn(|| {
                for _ in 0..kills() {
                    assert_success(&book.weave(&target));
                }
            });
        }
    });
    assert_eq!(names_in(output.path()), ["woven"]);
    assert_success(&books[0].weave(&target));
    assert_eq!(pages_in(&target), ["page.html"]);
}

/// What earlier versions wove into target/book has no list.
#[test]
fn what_has_no_list_is_set_aside_under_a_name_that_is_free() {
    let here = TempDir::new().expect("a folder");
    let book = here.path().join("book");
    assert!(!folder::is_unlisted(&book), "there is none");
    write(&here.path().join("book.unlisted-1/print.html"), "older");
    write(&book.join("print.html"), "old");
    assert!(folder::is_unlisted(&book));
    let aside = folder::set_aside(&book).expect("it is renamed");
    assert_eq!(aside, Some(here.path().join("book.unlisted-2")));
    assert_eq!(
        names_in(here.path()),
        ["book.unlisted-1", "book.unlisted-2"]
    );
    assert_eq!(folder::set_aside(&book).expect("nothing to do"), None);
    assert!(!folder::is_unlisted(woven()), "our own has a list");
}

#[test]
fn a_report_replaces_the_last_one_and_nothing_else() {
    let here = TempDir::new().expect("a folder");
    write_wrong_picture(here.path());
    report_in(here.path());
    assert!(here.path().join("page/difference.png").is_file());
    // Of this there is nothing to show.
    fs::write(here.path().join("mine.ppm"), "no picture").expect("a file");
    report_in(here.path());
    let page = here.path().join("page");
    assert_eq!(names_in(&page), [MANIFEST, "index.html"]);
    write(&page.join("thesis.txt"), "mine");
    assert_nothing_changes(&page, || {
        assert_report_is_refused(here.path(), "page", &["thesis.txt", "as a report"]);
    });
}

#[cfg(unix)]
#[test]
fn a_folder_for_a_report_is_refused_before_a_program_is_run() {
    let here = TempDir::new().expect("a folder");
    write(&here.path().join("page/thesis.txt"), "mine");
    assert_nothing_changes(here.path(), || {
        let mut command = check_in(here.path(), "page");
        command.args(["gradient", "--", "touch", "it-was-run"]);
        assert_refused(&mut command, &["thesis.txt", "as a report"]);
    });
}

#[test]
fn a_report_links_to_the_pages_of_the_book_that_are_there() {
    let here = TempDir::new().expect("a folder");
    write_wrong_picture(here.path());
    woven();
    report_in(here.path());
    let html = fs::read_to_string(here.path().join("page/index.html")).expect("a page");
    let links: Vec<&str> = html.split("href=\"file://").skip(1).collect();
    assert!(!links.is_empty(), "{html}");
    for link in links {
        let (address, rest) = link.split_once('"').expect("its end");
        let (file, heading) = address.split_once('#').expect("a heading");
        assert!(rest.starts_with(">target/book/"), "{link}");
        let page = fs::read_to_string(file.replace("%20", " ")).expect("a page of the book");
        assert!(page.contains(&format!("id=\"{heading}\"")), "{address}");
    }
}

#[test]
fn a_report_without_a_book_only_names_the_pages() {
    let wrong = wrong_picture();
    let scene = Scene::new(Chapter::HalfBSphere, None).expect("a scene");
    let check = judge::check(&scene, &wrong, 0);
    let nowhere = Path::new("/nonexistent");
    let html = report::remarks(&scene, check.finding().expect("it is wrong"), nowhere);
    assert!(
        html.contains(", on the page half_b_sphere of the book</dd>"),
        "{html}"
    );
    assert!(!html.contains("href"), "{html}");
}

#[test]
fn braces_in_the_name_of_a_picture_are_only_braces() {
    let here = TempDir::new().expect("a folder");
    fs::write(here.path().join("{remarks}{title}.ppm"), wrong_picture()).expect("a file");
    let mut command = check_in(here.path(), "page");
    command.args(["half_b_sphere", "{remarks}{title}.ppm"]);
    assert_eq!(run(&mut command).status.code(), Some(1));
    let html = fs::read_to_string(here.path().join("page/index.html")).expect("a page");
    assert!(html.contains("{remarks}{title}.ppm"), "{html}");
}

/// `KILLS=200 cargo test folders` for the long trial.
#[test]
fn weaving_that_is_killed_leaves_nothing_to_repair() {
    let book = Book::new("Round 0.");
    let mine = ["mine/thesis.txt", ".woven.notes/lock", "woven.txt"];
    for name in mine {
        write(&book.folder.path().join(name), "mine");
    }
    let mut weave = book.command();
    weave.arg("--output").arg(book.output());
    let round = |n| book.write("page.md", &format!("# Page\n\nRound {n}.\n"));
    let whole = whole_time(&mut weave, 0);
    let files = files_of(&book.output());
    let beside = names_beside(&book);
    let mut counts = Counts::default();
    for n in 1..=kills() {
        round(n);
        counts.add(kill(&mut weave, whole), book.output().exists());
        if book.output().exists() {
            let page = page_in(&book.output());
            let rounds = [n - 1, n].map(|n| format!("Round {n}."));
            assert!(rounds.iter().any(|round| page.contains(round)), "{page}");
            assert_eq!(files_of(&book.output()), files, "it is whole");
        }
        assert_success(&run(&mut weave));
        assert!(page_in(&book.output()).contains(&format!("Round {n}.")));
        assert_eq!(files_of(&book.output()), files);
        assert_eq!(names_beside(&book), beside, "nothing is left");
    }
    for name in mine {
        assert_eq!(
            fs::read(book.folder.path().join(name)).expect("it"),
            b"mine"
        );
    }
    println!("rtrace book: {counts:?}");
}

/// `KILLS=200 cargo test folders` for the long trial.
#[test]
fn reporting_that_is_killed_leaves_nothing_to_repair() {
    let here = TempDir::new().expect("a folder");
    write_wrong_picture(here.path());
    write(&here.path().join("mine/thesis.txt"), "mine");
    let mut check = check_in(here.path(), "page");
    check.args(["half_b_sphere", "mine.ppm"]);
    let whole = whole_time(&mut check, 1);
    let page = here.path().join("page");
    let before = contents(here.path());
    let mut counts = Counts::default();
    for _ in 0..kills() {
        counts.add(kill(&mut check, whole), page.exists());
        assert_eq!(run(&mut check).status.code(), Some(1));
        assert!(
            contents(here.path()) == before,
            "as if nothing had happened"
        );
    }
    println!("rtrace check --report: {counts:?}");
}

/// What needs links, permissions or another disk.
#[cfg(unix)]
mod on_unix {
    use std::fs::Permissions;
    use std::io::Write;
    use std::os::unix::fs::{PermissionsExt, symlink};

    use super::*;

    /// The book waits for its page, which is a pipe, and meanwhile a file arrives.
    #[test]
    fn a_file_that_comes_while_the_book_is_woven_stays() {
        let book = Book::new("The old text.");
        assert_success(&book.weave(&book.output()));
        let page = book.folder.path().join("notes/page.md");
        fs::remove_file(&page).expect("the page goes");
        let made = Command::new("mkfifo").arg(&page).status();
        assert!(made.expect("mkfifo starts").success());
        let mut weave = book.command();
        weave.arg("--output").arg(book.output());
        let child = weave.stderr(Stdio::piped()).spawn().expect("it starts");
        // Opened for writing when the program has opened it for reading: by then it
        // has looked into the folder, and found nothing.
        let mut pipe = File::options().write(true).open(&page).expect("the pipe");
        write(&book.output().join("thesis.txt"), "mine");
        let before = contents(&book.output());
        pipe.write_all(b"# Page\n\nThe new text.\n")
            .expect("a page");
        drop(pipe);
        let output = child.wait_with_output().expect("it ends");
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains("thesis.txt"));
        assert!(contents(&book.output()) == before, "the old book is there");
        assert_eq!(names_beside(&book), ["book.toml", "notes", "woven"]);
    }

    #[test]
    fn a_link_to_a_folder_stays_and_leads_to_the_new_book() {
        let book = Book::new("Text.");
        let here = book.folder.path();
        fs::create_dir_all(here.join("far/away")).expect("a folder");
        symlink("far/away", here.join("link")).expect("a link");
        for name in ["link", "link/", "link"] {
            assert_success(&book.weave(&here.join(name)));
        }
        assert!(here.join("link").is_symlink());
        assert!(page_in(&here.join("far/away")).contains("Text."));
        assert_eq!(names_in(&here.join("far")), ["away"]);
    }

    #[test]
    fn a_link_in_a_woven_folder_is_a_stranger_and_is_not_followed() {
        for name in ["mine", "page.html", "css"] {
            let book = Book::new("Text.");
            assert_success(&book.weave(&book.output()));
            let there = book.folder.path().join("there");
            fs::rename(book.output().join(name), &there)
                .or_else(|_| fs::write(&there, "mine"))
                .expect("something to link to");
            symlink(&there, book.output().join(name)).expect("a link");
            assert_nothing_changes(book.folder.path(), || {
                assert_book_is_refused(&book, &book.output(), &[&format!("{name:?}@")]);
            });
        }
    }

    #[test]
    fn a_link_to_nothing_is_named_and_stays() {
        let book = Book::new("Text.");
        let link = book.folder.path().join("link");
        symlink("nothing", &link).expect("a link");
        assert_book_is_refused(&book, &link, &["link to nothing"]);
        assert!(link.is_symlink());
    }

    #[test]
    fn a_private_folder_stays_private() {
        let book = Book::new("Text.");
        fs::create_dir(book.output()).expect("a folder");
        fs::set_permissions(book.output(), Permissions::from_mode(0o700)).expect("the mode");
        assert_success(&book.weave(&book.output()));
        let found = fs::metadata(book.output()).expect("the folder");
        assert_eq!(found.permissions().mode() & 0o777, 0o700);
    }

    /// Linux keeps one in memory.
    #[test]
    fn a_folder_on_another_disk_is_replaced_too() {
        let Ok(disk) = TempDir::new_in("/dev/shm") else {
            return;
        };
        let book = Book::new("Text.");
        let link = book.folder.path().join("link");
        let there = disk.path().join("woven");
        fs::create_dir(&there).expect("a folder");
        symlink(&there, &link).expect("a link");
        for _first_then_again in 0..2 {
            assert_success(&book.weave(&link));
        }
        assert!(page_in(&there).contains("Text."));
        assert_eq!(names_in(disk.path()), ["woven"]);
    }
}

/// How the programs that were to be killed ended.
#[derive(Debug, Default)]
struct Counts {
    killed: u32,
    done_before: u32,
    without_folder_until_the_next: u32,
}

impl Counts {
    fn add(&mut self, was_killed: bool, has_folder: bool) {
        self.killed += u32::from(was_killed);
        self.done_before += u32::from(!was_killed);
        self.without_folder_until_the_next += u32::from(!has_folder);
    }
}

/// How many programs to kill: a handful, or what the variable `KILLS` says.
fn kills() -> u32 {
    let said = env::var("KILLS").ok();
    said.map_or(5, |said| said.parse().expect("KILLS is a number"))
}

/// How long the command takes; it ends with that exit code.
fn whole_time(command: &mut Command, code: i32) -> Duration {
    // The first time the program may have to be built.
    run(command);
    let start = Instant::now();
    assert_eq!(run(command).status.code(), Some(code));
    start.elapsed()
}

/// Kills the command at a random moment of the time that it takes. Returns whether it
/// was still running.
fn kill(command: &mut Command, whole: Duration) -> bool {
    let random = RandomState::new().build_hasher().finish() % 1000;
    let quiet = command.stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = quiet.spawn().expect("the program starts");
    thread::sleep(whole * random as u32 / 1000);
    let still_running = child.try_wait().expect("its state").is_none();
    child.kill().expect("it can be killed");
    child.wait().expect("it ends");
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    still_running
}

/// A book of `n` pages besides the first.
fn book_of_pages(n: usize) -> Book {
    let book = Book::new("Text.");
    let mut summary = String::from("- [Page](page.md)\n");
    for n in 0..n {
        book.write(&format!("{n}/other.md"), "# Other\n");
        summary += &format!("- [Other]({n}/other.md)\n");
    }
    book.write("SUMMARY.md", &summary);
    book
}

fn pages_in(folder: &Path) -> Vec<String> {
    let mut names = names_in(folder);
    names.retain(|name| name == "page.html" || name.parse::<usize>().is_ok());
    names
}

/// All files of a book. The name of the index says which words are in it.
fn files_of(folder: &Path) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = contents(folder).into_keys().collect();
    files.retain(|file| !file.to_string_lossy().contains("searchindex"));
    files
}

fn page_in(folder: &Path) -> String {
    fs::read_to_string(folder.join("page.html")).expect("a page")
}

fn names_beside(book: &Book) -> Vec<String> {
    names_in(book.folder.path())
}

fn assert_book_is_refused(book: &Book, output: &Path, words: &[&str]) {
    assert_refused(book.command().arg("--output").arg(output), words);
}

/// The slip `minus-h`, small.
fn wrong_picture() -> Vec<u8> {
    let slip = slips::find("minus-h").expect("a slip");
    p3(&slip.program(Chapter::HalfBSphere).run(100).picture())
}

fn write_wrong_picture(folder: &Path) {
    fs::write(folder.join("mine.ppm"), wrong_picture()).expect("a file");
}

fn check_in(here: &Path, folder: &str) -> Command {
    let mut command = program_with("rtrace", &["check", "--report", folder]);
    command.current_dir(here);
    command
}

/// Reports on `mine.ppm` into the folder `page`.
fn report_in(here: &Path) -> Output {
    let output = run(check_in(here, "page").args(["half_b_sphere", "mine.ppm"]));
    assert_eq!(text(&output.stderr), "");
    assert!(here.join("page/index.html").is_file());
    output
}

fn assert_report_is_refused(here: &Path, folder: &str, words: &[&str]) {
    let mut command = check_in(here, folder);
    assert_refused(command.args(["half_b_sphere", "mine.ppm"]), words);
}

/// Everything in the folder is afterwards as it was before.
fn assert_nothing_changes(folder: &Path, during: impl FnOnce()) {
    let before = contents(folder);
    during();
    assert!(contents(folder) == before, "{} changed", folder.display());
}

/// What each file below `folder` holds; `None` for a folder or a link.
fn contents(folder: &Path) -> BTreeMap<PathBuf, Option<Vec<u8>>> {
    let mut found = BTreeMap::new();
    for name in names_in(folder) {
        let path = folder.join(name);
        if path.is_dir() && !path.is_symlink() {
            found.extend(contents(&path));
        }
        let file = path.is_file() && !path.is_symlink();
        let bytes = file.then(|| fs::read(&path).expect("a file"));
        found.insert(path, bytes);
    }
    found
}

fn write(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    fs::write(path, text).expect("a file");
}
