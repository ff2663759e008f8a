//! Fault injection: each system call of what writes is the last one once, and fails once.
//!
//! Whatever happens, what was there stays or is replaced as a whole, nothing beside it is touched,
//! and the next run leaves no trace of the one before.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;
use std::thread;
use std::time::{Duration, Instant};

use fixtures::command::{cargo, path_of, run, text};
use fixtures::desk::Desk;
use fixtures::left_out::left_out;
use fixtures::workspace;

/// All that is in a folder by its path: files with their bytes, and `None` for folders and links.
type There = BTreeMap<PathBuf, Option<Vec<u8>>>;

/// A command that writes, and what it writes to.
#[derive(Clone, Copy)]
struct Writer {
    line: &'static str,
    /// The file or folder that the command writes.
    target: &'static str,
    /// Returns true if all that is there now was there before, or is there after a whole run.
    is_whole: fn(&There, &There, &There) -> bool,
}

const WRITERS: [Writer; 3] = [
    Writer {
        line: "rtrace start red_sphere --into mine",
        target: "mine/red_sphere",
        // Each crate has a number of its own.
        is_whole: |before, now, after| now.keys().eq(before.keys()) || now.keys().eq(after.keys()),
    },
    Writer {
        line: "rtrace done --in list hello",
        target: "list",
        is_whole: |before, now, after| {
            let lines = |it: &There| {
                it.values()
                    .flatten()
                    .flatten()
                    .filter(|it| **it == b'\n')
                    .count()
            };
            let ends = |it: &There| it.values().flatten().all(|it| it.ends_with(b"  hello\n"));
            let (before, after) = (lines(before), lines(after));
            ends(now) && (before..=after).contains(&lines(now))
        },
    },
    Writer {
        line: "weave source target/book",
        target: "target/book",
        // Between two renames there is no book.
        is_whole: |before, now, after| now.is_empty() || now == before || now == after,
    },
];

/// The system calls that change files, and may fail.
const CHANGES: [&str; 11] = [
    "openat",
    "write",
    "mkdir",
    "rename",
    "unlink",
    "unlinkat",
    "rmdir",
    "fchmod",
    "chmod",
    "copy_file_range",
    "ftruncate",
];

/// Others that may fail.
const READS: [&str; 7] = [
    "read",
    "statx",
    "getdents64",
    "close",
    "lseek",
    "readlink",
    "fcntl",
];

/// The way in which a run is broken off.
#[derive(Clone, Debug)]
enum Break {
    /// By a fault that strace injects, in its words.
    Injected(String),
    /// By a kill after that time.
    Killed(Duration),
}

/// The weaver, a program of another package.
static WEAVE: LazyLock<PathBuf> = LazyLock::new(|| {
    let mut build = cargo();
    build.args(["build", "--quiet", "--package", "weave"]);
    let built = run(build.current_dir(workspace()));
    assert!(built.status.success(), "{}", text(&built.stderr));
    path_of("rtrace").with_file_name("weave")
});

#[test]
#[ignore = "runs three commands some thousand times"]
fn what_is_broken_off_leaves_old_or_new_and_nothing_half() {
    let version = Command::new("strace").arg("-V").output();
    if !version.is_ok_and(|it| it.status.success()) {
        return left_out("there is no strace here to have system calls fail");
    }
    let wrong: String = thread::scope(|scope| {
        let all = WRITERS.map(|it| scope.spawn(move || it.wrong()));
        all.map(|it| it.join().expect("it is tried")).concat()
    });
    assert!(wrong.is_empty(), "{wrong}");
}

impl Writer {
    /// Lists the breaks that leave something wrong, one per line.
    fn wrong(self) -> String {
        let desk = Desk::default();
        desk.write("precious", "mine");
        self.turn(&desk, 0);
        desk.run("rtrace start gradient --into mine");
        let start = Instant::now();
        run(&mut self.command(&desk));
        let took = start.elapsed();
        self.turn(&desk, 0);
        let breaks = self.breaks(&self.calls(&desk), took);
        let breaks = breaks.into_iter().zip(1..);
        breaks
            .filter_map(|(it, n)| self.wrong_after(&desk, &it, n))
            .collect()
    }

    /// Sees to it that there is something else to be written than the time before.
    fn turn(self, desk: &Desk, n: usize) {
        // As in the book's own: mdBook would write a page that it can't see anew.
        let settings = "book.src = \".\"\nbuild.create-missing = false\n";
        desk.write("source/book.toml", settings);
        desk.write("source/SUMMARY.md", "- [Page](page.md)\n");
        desk.write("source/page.md", format!("# Page {}\n", n % 3));
        if self.line.starts_with("rtrace start") {
            let _ = fs::remove_dir_all(desk.path(self.target));
        }
    }

    fn command(self, desk: &Desk) -> Command {
        match self.line.strip_prefix("weave ") {
            None => desk.command(self.line),
            Some(words) => {
                let mut weave = Command::new(&*WEAVE);
                weave.args(words.split(' ')).current_dir(desk.path(""));
                weave
            }
        }
    }

    /// Counts how often each system call is made in a whole run.
    fn calls(self, desk: &Desk) -> BTreeMap<String, usize> {
        run(&mut self.traced(desk, &[]));
        let mut calls = BTreeMap::new();
        for line in desk.read("calls").lines() {
            let call = line
                .split_whitespace()
                .nth(1)
                .and_then(|it| it.split_once('('));
            if let Some((name, _)) = call {
                *calls.entry(name.to_owned()).or_default() += 1;
            }
        }
        calls
    }

    fn traced(self, desk: &Desk, more: &[&str]) -> Command {
        let command = self.command(desk);
        let mut strace = Command::new("strace");
        strace
            .args(["-f", "-qq", "-o"])
            .arg(desk.path("calls"))
            .args(more);
        strace.arg(command.get_program()).args(command.get_args());
        strace.current_dir(desk.path("")).stdin(Stdio::null());
        strace
    }

    /// Lists the breaks to try: a call is the last one, or fails if it can; and fifty kills at any
    /// time. Of calls that change no file some twenty of each kind are tried.
    fn breaks(self, calls: &BTreeMap<String, usize>, took: Duration) -> Vec<Break> {
        let mut breaks = Vec::new();
        for (name, count) in calls {
            let step = match CHANGES.contains(&&**name) {
                true => 1,
                false => count.div_ceil(20).max(1),
            };
            for n in (1..=*count).step_by(step) {
                breaks.push(Break::Injected(format!(
                    "inject={name}:signal=KILL:when={n}"
                )));
                if CHANGES.contains(&&**name) || READS.contains(&&**name) {
                    breaks.push(Break::Injected(format!(
                        "inject={name}:error=ENOSPC:when={n}"
                    )));
                }
            }
        }
        let killed = (0..50).map(|n| Break::Killed(took * (n * 37 % 50) / 50));
        breaks.into_iter().chain(killed).collect()
    }

    /// Says what is wrong after a run that was broken off, and a whole one.
    fn wrong_after(self, desk: &Desk, how: &Break, n: usize) -> Option<String> {
        self.turn(desk, n);
        let [before, outside] = self.there(desk);
        match how {
            Break::Injected(injected) => drop(run(&mut self.traced(desk, &["-e", injected]))),
            Break::Killed(after) => {
                let mut command = self.command(desk);
                command.stdout(Stdio::null()).stderr(Stdio::null());
                let mut child = command.spawn().expect("it starts");
                thread::sleep(*after);
                child.kill().expect("it can be killed");
                child.wait().expect("it has ended");
            }
        }
        let [now, outside_now] = self.there(desk);
        let whole = run(&mut self.command(desk));
        let [after, outside_after] = self.there(desk);
        let said = text(&whole.stderr);
        let is_there = said.contains("is there already");
        let problem = if !whole.status.success() && !is_there {
            format!("the next run fails: {said}")
        } else if outside != outside_now || outside != outside_after {
            "something beside it has changed".to_owned()
        } else if !(self.is_whole)(&before, &now, &after) {
            "half of it is there".to_owned()
        } else if desk.contents().iter().any(|it| is_partial(&it.0)) {
            "the next run leaves what is half".to_owned()
        } else {
            return None;
        };
        Some(format!("{}, {how:?}: {problem}\n", self.line))
    }

    /// Reads all that is in the target, and all outside of it, but for half-written files.
    fn there(self, desk: &Desk) -> [There; 2] {
        let target = desk.path(self.target);
        let is_seen = |path: &PathBuf| !is_partial(path) && !path.ends_with("calls");
        let all = desk.contents().into_iter().filter(|it| is_seen(&it.0));
        let (inside, outside) = all.partition(|it| it.0.starts_with(&target));
        [inside, outside]
    }
}

/// Returns true for a path in what is moved to its place when it is whole.
fn is_partial(path: &Path) -> bool {
    path.components()
        .any(|it| it.as_os_str().to_string_lossy().ends_with(".partial"))
}
