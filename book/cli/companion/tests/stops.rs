//! Stops: whatever ends a program of a reader's, or us, nothing of it runs on and no file is left.

use std::fs;
use std::os::unix::process::CommandExt;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};

use fixtures::desk::Desk;
use fixtures::drawn::p3;
use fixtures::terminal::{self, hears_signals};
use slips::{Chapter, ChapterCode};

/// A script that starts all that a shell can start: children, orphans, programs that ignore
/// signals, and one that leaves its group.
const TREE: &str = "sleep 600 &
(sleep 600 &)
setsid sleep 600 &
nohup sleep 600 >/dev/null 2>&1 &
sh -c 'trap \"\" INT TERM HUP; sleep 600; sleep 600' &
yes >/dev/null &
";

/// How a program is stopped, if it does not stop by itself, and how it is run: in a second.
const QUICK: &str = "\
it ends                  | itself   | check normals --timeout 5 -- sh draws.sh
Ctrl-C                   | INT      | check normals --timeout 5 -- sh waits.sh
";

/// All other ways, some of which take their time.
const SLOW: &str = "\
its time is over         | itself   | check normals --timeout 5 -- sh waits.sh
it prints too much       | itself   | check normals --timeout 5 -- sh floods.sh
it is judged once        | itself   | watch normals --once --timeout 5 -- sh waits.sh
it does not answer       | itself   | laws normals --timeout 3 -- sh waits.sh
SIGTERM                  | TERM     | watch normals --timeout 5 -- sh waits.sh
SIGTERM in a dialogue    | TERM     | laws normals --timeout 5 -- sh waits.sh
SIGHUP                   | HUP      | check normals --timeout 5 -- sh waits.sh
SIGKILL                  | KILL     | watch normals --timeout 5 -- sh waits.sh
a newer save             | saves    | watch normals --timeout 5 -- sh waits.sh
nobody reads             | closed   | watch normals --timeout 5 -- sh draws.sh
the terminal is closed   | terminal | watch normals --timeout 5 -- sh waits.sh
";

#[test]
fn nothing_runs_on_and_nothing_is_left() {
    assert_nothing_is_left(QUICK);
}

#[test]
#[ignore = "starts and kills a hundred programs"]
fn nothing_runs_on_whatever_ends_it() {
    assert_nothing_is_left(SLOW);
}

fn assert_nothing_is_left(stops: &str) {
    if !cfg!(target_os = "linux") {
        return fixtures::left_out::left_out("only Linux shows what runs by its environment");
    }
    let left: String = thread::scope(|scope| {
        let stop = |row| scope.spawn(move || left_behind(row));
        let stops: Vec<_> = stops.lines().map(stop).collect();
        let left = stops
            .into_iter()
            .map(|it| it.join().expect("it is stopped"));
        left.collect()
    });
    assert!(left.is_empty(), "{left}");
}

/// Describes what one stop leaves behind; empty if nothing.
fn left_behind(row: &str) -> String {
    let cells: Vec<&str> = row.split('|').map(str::trim).collect();
    let [name, how, line] = cells[..] else {
        panic!("{row} has other cells");
    };
    let desk = Desk::default();
    desk.write("tmp/", "");
    desk.write("n.ppm", p3(&Chapter::Normals.picture(64)));
    // That it has started is shown by a file.
    for (file, then) in [
        ("waits.sh", "sleep 600"),
        ("draws.sh", "cat n.ppm"),
        ("floods.sh", "cat /dev/zero"),
    ] {
        desk.write(file, format!("{TREE}touch started\n{then}\n"));
    }
    let mut command = hears_signals(&desk.command(&format!("rtrace {line}")));
    command.env("TMPDIR", desk.path("tmp"));
    // Ours, all of them: the environment says whose they are.
    command.env("STOPPED_BY", desk.path(""));
    stopped(&desk, &mut command, how);
    let patience = Instant::now() + Duration::from_secs(5);
    let mut running = marked(&desk);
    while !running.is_empty() && Instant::now() < patience {
        thread::sleep(Duration::from_millis(20));
        running = marked(&desk);
    }
    for process in &running {
        let _ = kill_process(*process, Signal::KILL);
    }
    let files = fs::read_dir(desk.path("tmp")).expect("a folder").count();
    match (running.len(), files) {
        (0, 0) => String::new(),
        (running, files) => format!("{name}: {running} programs and {files} files\n"),
    }
}

/// Runs the command until it is stopped, once its program has started.
fn stopped(desk: &Desk, command: &mut Command, how: &str) {
    command.stdin(Stdio::null()).stderr(Stdio::null());
    if how == "terminal" {
        let (controller, end) = terminal::open();
        let mut child = command.stdout(end).spawn().expect("it starts");
        command.stdout(Stdio::null());
        wait_for(|| desk.path("started").exists());
        drop(controller);
        return ended(&mut child);
    }
    command.stdout(Stdio::piped()).process_group(0);
    let mut child = command.spawn().expect("it starts");
    wait_for(|| desk.path("started").exists());
    thread::sleep(Duration::from_millis(100));
    let pid = Pid::from_child(&child);
    let send = |signal| kill_process(pid, signal).expect("it runs");
    match how {
        "itself" => {}
        "closed" => drop(child.stdout.take()),
        "saves" => {
            for n in 0..3 {
                fs::remove_file(desk.path("started")).expect("it is there");
                desk.write("new.py", "#".repeat(n + 1));
                wait_for(|| desk.path("started").exists());
            }
            send(Signal::TERM);
        }
        "INT" => send(Signal::INT),
        "TERM" => send(Signal::TERM),
        "HUP" => send(Signal::HUP),
        "KILL" => send(Signal::KILL),
        how => panic!("nothing is stopped by {how}"),
    }
    ended(&mut child);
}

fn ended(child: &mut Child) {
    // What it prints is not looked at, but read.
    let printed = child.stdout.take();
    let read = printed.map(|it| thread::spawn(move || std::io::read_to_string(it)));
    child.wait().expect("it ends");
    if let Some(read) = read {
        let _ = read.join().expect("it is read");
    }
}

fn wait_for(is_there: impl Fn() -> bool) {
    let patience = Instant::now() + Duration::from_secs(60);
    while !is_there() {
        assert!(Instant::now() < patience, "it has not started");
        thread::sleep(Duration::from_millis(10));
    }
}

/// Lists all processes that this desk has started, directly or not.
fn marked(desk: &Desk) -> Vec<Pid> {
    let mark = format!("STOPPED_BY={}\0", desk.path("").display());
    let entries = fs::read_dir("/proc").into_iter().flatten().flatten();
    let has_mark = |pid: &Pid| {
        let environment = fs::read(format!("/proc/{}/environ", pid.as_raw_nonzero()));
        let environment = environment.unwrap_or_default();
        environment
            .windows(mark.len())
            .any(|it| it == mark.as_bytes())
    };
    let pids = entries.filter_map(|it| it.file_name().to_str()?.parse().ok());
    pids.filter_map(Pid::from_raw).filter(has_mark).collect()
}
