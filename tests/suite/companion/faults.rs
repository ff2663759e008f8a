//! The real programs on bad days: interrupted, in company, and refused by the system.

use std::fs::{self, Permissions};
use std::io::{BufRead, BufReader, Read};
use std::os::unix::fs::{MetadataExt, PermissionsExt, chown, symlink};
use std::os::unix::process::{CommandExt, ExitStatusExt};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::LazyLock;
use std::time::{Duration, Instant};
use std::{env, iter, thread};

use rustix::process::{Pid, Signal, geteuid, kill_process};
use tempfile::TempDir;

use suite::command::{
    assert_failed, assert_refused, assert_success, names_in, path_of, program, run, text,
};
use suite::drawn::p3;
use suite::left_out::left_out;

#[test]
fn a_signal_ends_the_program_and_its_partial_file_goes() {
    for signal in [Signal::INT, Signal::TERM, Signal::HUP] {
        for times in [1, 2] {
            let desk = Desk::new();
            let child = desk.start_largest();
            send(&child, signal, times);
            assert_eq!(ended(child).signal(), Some(signal.as_raw()), "{signal:?}");
            assert_eq!(desk.names(), [FILE]);
            assert_eq!(desk.read(), KEPT);
        }
    }
}

/// The program that is checked has started another one. Both hold the pipe, which ends
/// when they have.
#[test]
fn a_signal_ends_the_program_that_is_checked_and_what_that_started() {
    let script = "sleep 60 & echo it runs >&2; exec sleep 60";
    for signal in [Signal::INT, Signal::TERM, Signal::HUP] {
        for times in [1, 2] {
            let mut command = hears_signals(path_of("rtrace"));
            command.args(["check", "gradient", "--", "sh", "-c", script]);
            let piped = command.stdout(Stdio::null()).stderr(Stdio::piped());
            let mut child = piped.spawn().expect("the program starts");
            let mut pipe = BufReader::new(child.stderr.take().expect("it is piped"));
            let mut said = String::new();
            pipe.read_line(&mut said).expect("it starts");
            assert_eq!(said, "it runs\n");
            let start = Instant::now();
            send(&child, signal, times);
            assert_eq!(ended(child).signal(), Some(signal.as_raw()), "{signal:?}");
            pipe.read_to_string(&mut said).expect("the pipe ends");
            assert!(start.elapsed() < Duration::from_secs(30), "{signal:?}");
            assert_eq!(said, "it runs\n");
        }
    }
}

/// What `nohup` does: the program is not to hear of the signal.
#[test]
fn a_signal_that_is_ignored_stays_ignored() {
    if cfg!(not(target_os = "linux")) {
        left_out("only Linux says which signals a program was started to ignore");
        return;
    }
    let desk = Desk::new();
    let mut shell = shell("trap '' HUP; exec \"$0\" \"$@\"");
    let large = shell
        .arg(path_of("gradient"))
        .args(LARGE)
        .arg(desk.file())
        .spawn();
    let child = large.expect("the program starts");
    desk.wait_for_partial();
    kill_process(Pid::from_child(&child), Signal::HUP).expect("it is running");
    assert!(ended(child).success());
    assert_eq!(desk.names(), [FILE]);
    assert!(desk.read().starts_with("P3\n4000 "));
}

#[test]
fn what_a_kill_leaves_is_named_after_its_file_and_goes_next_time() {
    let desk = Desk::new();
    let mut child = desk.start_largest();
    child.kill().expect("it is running");
    assert!(!ended(child).success());
    assert_eq!(desk.read(), KEPT);
    let [partial] = &desk.partials()[..] else {
        panic!("a killed program tidies nothing: {:?}", desk.names());
    };
    assert!(partial.starts_with(".kept.ppm."), "{partial}");

    // A reader's files, however similar their names.
    let similar = [
        ".7.partial",
        ".kept.ppm.0123456789abcdeF.partial",
        ".kept.ppm.notes.partial",
        ".kept.ppm.partial",
        ".other.ppm.0123456789abcdef.partial",
    ];
    for name in similar {
        fs::write(desk.path(name), "mine").expect("a file");
    }
    assert_success(&run(program("gradient").arg(desk.file())));
    let names: Vec<&str> = similar.into_iter().chain([FILE]).collect();
    assert_eq!(desk.names(), names);
    assert_eq!(desk.read().as_bytes(), p3(&gradient::picture(400)));
}

#[test]
fn what_another_program_is_writing_is_left_alone() {
    let desk = Desk::new();
    let slow = desk.start_largest();
    let partials = desk.partials();
    assert_success(&run(program("gradient")
        .args(["--width", "20"])
        .arg(desk.file())));
    assert!(desk.read().starts_with("P3\n20 "), "the quick one is done");
    assert_eq!(desk.partials(), partials, "the slow one goes on");
    kill_process(Pid::from_child(&slow), Signal::TERM).expect("it is running");
    ended(slow);
    assert_eq!(desk.names(), [FILE]);
}

/// In a container each program takes itself for number 1.
#[test]
fn programs_with_the_same_process_id_do_not_meet() {
    if !can(unshare("--pid").args(["--fork", "true"])) {
        left_out("there is no unshare here that gives a program the process id 1");
        return;
    }
    let desk = Desk::new();
    let company: Vec<(PathBuf, Child)> = (0..6)
        .map(|n| {
            // Three of them write the same file.
            let file = desk.path(&format!("{}.ppm", n.max(3)));
            let mut command = unshare("--pid");
            command.arg("--fork").arg(path_of("gradient"));
            let started = command.args(["--width", "2000"]).arg(&file).spawn();
            (file, started.expect("the program starts"))
        })
        .collect();
    let expected = p3(&gradient::picture(2000));
    for (file, child) in company {
        assert!(ended(child).success());
        assert!(fs::read(&file).expect("the file") == expected);
    }
    assert_eq!(desk.names(), ["3.ppm", "4.ppm", "5.ppm", FILE]);
}

#[test]
fn a_private_file_is_private_at_every_moment() {
    let desk = Desk::new();
    let private = Permissions::from_mode(0o600);
    fs::set_permissions(desk.file(), private).expect("the mode is set");
    let mut shell = shell("umask 0; exec \"$0\" \"$@\"");
    let large = shell.arg(path_of("gradient")).args(LARGE).arg(desk.file());
    let mut child = large.spawn().expect("the program starts");
    let mut seen = 0;
    while child.try_wait().expect("it can be asked").is_none() {
        for name in desk.names() {
            // Meanwhile it may have taken its place.
            if let Ok(about) = fs::metadata(desk.path(&name)) {
                assert_eq!(about.mode() & 0o777, 0o600, "{name}");
                seen += u32::from(name != FILE);
            }
        }
    }
    assert!(seen > 0, "no partial file was seen");
    assert!(ended(child).success());
    assert_eq!(desk.about().mode() & 0o777, 0o600);
    assert!(desk.read().starts_with("P3\n4000 "), "it was replaced");
}

#[test]
fn a_file_that_is_replaced_keeps_its_owner_and_group() {
    if !geteuid().is_root() {
        left_out("only root can own the file of another user");
        return;
    }
    let desk = Desk::new();
    chown(desk.file(), Some(65534), Some(65533)).expect("the owner is set");
    fs::set_permissions(desk.file(), Permissions::from_mode(0o640)).expect("the mode is set");
    assert_success(&run(program("gradient").arg(desk.file())));
    let about = desk.about();
    assert_eq!((about.uid(), about.gid()), (65534, 65533));
    assert_eq!(about.mode() & 0o777, 0o640);
}

#[test]
fn a_name_of_standard_output_means_it() {
    let desk = Desk::new();
    let link = desk.path("link.ppm");
    symlink("/dev/stdout", &link).expect("a link");
    let picture = text(&p3(&gradient::picture(400)));
    for name in [
        Path::new("/dev/stdout"),
        Path::new("/dev/fd/1"),
        Path::new("/proc/self/fd/1"),
        &link,
    ] {
        if !name.exists() {
            left_out(&format!("there is no {} here", name.display()));
            continue;
        }
        for (script, expected) in [
            (
                "{ echo before; \"$0\" \"$1\"; echo after; } > \"$2\"",
                format!("before\n{picture}after\n"),
            ),
            ("\"$0\" \"$1\" >> \"$2\"", format!("{KEPT}{picture}")),
            ("\"$0\" \"$1\" > \"$2\"", picture.clone()),
        ] {
            fs::write(desk.file(), KEPT).expect("the file");
            let mut shell = shell(script);
            shell.arg(path_of("gradient")).arg(name).arg(desk.file());
            assert_success(&run(&mut shell));
            assert!(desk.read() == expected, "{script} with {}", name.display());
            assert_eq!(desk.names(), [FILE, "link.ppm"]);
        }
    }
}

#[test]
fn what_the_shell_has_opened_is_appended_to_and_not_replaced() {
    let desk = Desk::new();
    let mut shell = shell("\"$0\" /dev/fd/3 3>> \"$1\"");
    assert_success(&run(shell.arg(path_of("gradient")).arg(desk.file())));
    assert!(desk.read() == KEPT.to_owned() + &text(&p3(&gradient::picture(400))));
    assert_eq!(desk.names(), [FILE]);
}

#[test]
fn without_more_threads_the_picture_is_drawn_by_one() {
    // A limit that holds for root too: on what a process may do who is nobody.
    let copy = TempDir::new().expect("a folder");
    let program = copy.path().join("gradient");
    fs::copy(path_of("gradient"), &program).expect("a copy that anyone can reach");
    fs::set_permissions(copy.path(), Permissions::from_mode(0o755)).expect("the mode is set");
    let limited = |script: &str| {
        // dash and bash call the limit by different letters.
        let mut shell = shell(&format!("ulimit -p 0 2>/dev/null || ulimit -u 0; {script}"));
        if geteuid().is_root() {
            shell.uid(65534).gid(65534);
        }
        shell
    };
    let a_process_is_refused = !can(&mut limited("(true)"));
    if !a_process_is_refused || thread::available_parallelism().map_or(1, usize::from) == 1 {
        left_out("no limit on threads holds here, or none would be started");
        return;
    }
    let output = run(limited("exec \"$0\" --width 2000").arg(program));
    assert_success(&output);
    assert!(output.stdout == p3(&gradient::picture(2000)));
}

#[test]
fn a_name_is_shown_and_not_obeyed() {
    let name = "\u{1b}[31m\u{202e}é";
    let shown = "\\u{1b}[31m\\u{202e}é";
    let missing = format!("missing {name}/a.ppm");
    for (arguments, code) in [
        ([missing.as_str()], 1),
        ([&format!("{name}.png")], 2),
        ([&format!("--{name}")], 2),
    ] {
        let mut command = program("gradient");
        match code {
            1 => assert_failed(command.args(arguments), &[shown]),
            _ => assert_refused(command.args(arguments), &[shown]),
        }
        let said = text(&run(&mut command).stderr);
        assert!(!said.contains(['\u{1b}', '\u{202e}']), "{said:?}");
    }
}

/// Whatever is typed comes back in what is said, or in a report of it.
#[test]
fn what_a_terminal_would_obey_is_spelled_out_by_every_command() {
    let odd = "\u{1b}[31m\u{9b}\u{202e}é";
    let shown = "\\u{1b}[31m\\u{9b}\\u{202e}é";
    let [ppm, png, report] = ["o.ppm", "o.png", "report"].map(|end| format!("{odd}{end}"));
    let desk = Desk::new();
    for (arguments, code) in [
        (&["show", "gradient", "--output", &png][..], 0),
        (
            &["show", "gradient", "--output", &format!("{odd}/a.ppm")],
            1,
        ),
        (&["show", odd], 2),
        (&["slips", "draw", "minus-h", "--output", &ppm], 0),
        (&["slips", odd], 2),
        (&["check", "normals", &ppm], 1),
        (&["check", "normals", &ppm, "--report", &report], 1),
        (
            &["check", "normals", &ppm, "--json", "--report", &report],
            1,
        ),
        (&["check", "gradient", &ppm, "--report", &png], 2),
        (&["check", "normals", "--", odd], 2),
        (&["check", "normals", "--", "echo", odd], 2),
        (&["check", "normals", odd], 2),
        (&["hit", "--csv", odd], 1),
        (&["hit", "--csv", &ppm], 1),
        (&["hit", "--origin", odd], 2),
        (&["hit", "--csv", odd, "--method", odd], 2),
        (&["book", "--output", &ppm], 2),
        (&["book", "--output", "book", "--source", odd], 1),
        (&[odd], 2),
    ] {
        let output = run(program("rtrace").args(arguments).current_dir(desk.0.path()));
        let said = text(&output.stdout) + &text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said}");
        assert!(!said.contains(['\u{1b}', '\u{9b}', '\u{202e}']), "{said:?}");
        // As JSON, what is spelled out is spelled out once more.
        let said = said.replace("\\\\", "\\");
        assert!(said.contains(shown), "{arguments:?}: {said}");
    }
}

#[test]
fn a_workspace_that_was_moved_is_not_made_again() {
    let advice = ["not there any more", "cargo clean --package rtrace"];
    for arguments in [&[][..], &["book"], &["show", "normals", "--open"]] {
        // It was copied, and cargo runs it in the copy.
        let elsewhere = TempDir::new().expect("a folder");
        let mut command = program("rtrace");
        command.env("CARGO_PKG_NAME", "rtrace").args(arguments);
        command.env("CARGO_MANIFEST_DIR", elsewhere.path());
        assert_failed(&mut command, &advice);

        // It is gone: something empty hides it, and stays empty.
        let hidden = "mount -t tmpfs none \"$0\"";
        let Some((_copy, mut command)) = with_mounts(hidden, "! \"$@\" && find \"$0\"") else {
            return;
        };
        let output = run(command.args(arguments));
        let said = text(&output.stderr);
        assert!(advice.iter().all(|words| said.contains(words)), "{said}");
        let left = text(&output.stdout);
        assert_eq!(left.trim_end(), workspace().to_string_lossy());
    }
}

#[test]
fn a_workspace_that_cannot_be_written_to_is_named() {
    let read_only = "mount --bind \"$0\" \"$0\" && mount -o remount,bind,ro \"$0\"";
    let Some((_copy, mut command)) = with_mounts(read_only, "exec \"$@\"") else {
        return;
    };
    let pictures = workspace().join("target/pictures");
    assert_failed(
        &mut command,
        &[
            &pictures.to_string_lossy(),
            "Read-only",
            "show CHAPTER --output FILE",
        ],
    );
}

/// A short part of the campaign that the README describes: `KILLS` says how many
/// times.
#[test]
fn an_interrupted_program_leaves_the_old_file_or_the_new_one() {
    let kills = env::var("KILLS")
        .ok()
        .and_then(|number| number.parse().ok());
    let kills: u64 = kills.unwrap_or(6);
    let mut counts = [0; 4];
    let signals = [Signal::KILL, Signal::INT, Signal::TERM, Signal::HUP];
    let campaigns = [
        Campaign::new(
            "png",
            &["rtrace", "show", "gradient", "--width", "3840", "--output"],
        ),
        Campaign::new(
            "ppm",
            &["rtrace", "show", "gradient", "--width", "3840", "--output"],
        ),
        Campaign::new("ppm", &["gradient", "--width", "3840"]),
    ];
    let mut turns = iter::repeat(()).flat_map(|()| campaigns.iter());
    for n in 0..kills {
        let campaign = turns.next().expect("they go round");
        // The golden ratio: moments that are spread evenly, however many they are.
        let moment = (n as f64 * 0.618_033_988_75).fract();
        let signal = signals[(n / 3 % 4) as usize];
        counts[campaign.interrupt(signal, moment) as usize] += 1;
    }
    let [old, left, new, done] = counts;
    println!(
        "{kills} signals: {old} left the old file, {left} the old file and a partial one beside it, \
         {new} the new file, and {done} came after the end"
    );
}

/// How an interrupted program left its folder.
enum Outcome {
    Old,
    OldAndPartial,
    New,
    Done,
}

/// A command that writes a file, which is then named after its arguments.
struct Campaign {
    arguments: &'static [&'static str],
    desk: Desk,
    file: PathBuf,
    new: Vec<u8>,
    takes: Duration,
}

impl Campaign {
    fn new(extension: &str, arguments: &'static [&'static str]) -> Self {
        let desk = Desk::new();
        let file = desk.path("picture").with_extension(extension);
        let mut campaign = Self {
            arguments,
            desk,
            file,
            new: Vec::new(),
            takes: Duration::ZERO,
        };
        // The first time, some of it waits for the disk.
        let times = [(); 3].map(|()| {
            let child = campaign.start();
            let start = Instant::now();
            assert!(ended(child).success());
            start.elapsed()
        });
        campaign.takes = times.into_iter().min().expect("three");
        campaign.new = fs::read(&campaign.file).expect("the file");
        campaign
    }

    fn start(&self) -> Child {
        let mut command = hears_signals(path_of(self.arguments[0]));
        command.args(&self.arguments[1..]).arg(&self.file);
        command
            .stdout(Stdio::null())
            .spawn()
            .expect("the program starts")
    }

    /// Sends `signal` when that part of the time has passed, looks at what is
    /// left, and runs the command again.
    fn interrupt(&self, signal: Signal, moment: f64) -> Outcome {
        fs::write(&self.file, "old").expect("a file");
        let mut child = self.start();
        thread::sleep(self.takes.mul_f64(moment));
        let done = child.try_wait().expect("it can be asked").is_some();
        if !done {
            kill_process(Pid::from_child(&child), signal).expect("it is running");
        }
        let status = ended(child);
        let clean = status.success() || status.signal() == Some(signal.as_raw());
        assert!(clean, "{status} after {signal:?}");

        let found = fs::read(&self.file).expect("the file");
        let old = found == b"old";
        assert!(old || found == self.new, "half a file after {signal:?}");
        let left = !self.desk.partials().is_empty();
        assert!(!left || signal == Signal::KILL, "left by {signal:?}");

        assert!(ended(self.start()).success(), "the next time");
        assert!(fs::read(&self.file).expect("the file") == self.new);
        let name = self.file.file_name().expect("a name").to_string_lossy();
        assert_eq!(self.desk.names(), [FILE, &name]);
        assert_eq!(self.desk.read(), KEPT);
        match (done, old) {
            (true, _) => Outcome::Done,
            (false, false) => Outcome::New,
            (false, true) if left => Outcome::OldAndPartial,
            (false, true) => Outcome::Old,
        }
    }
}

/// A folder with a file that someone wants to keep.
struct Desk(TempDir);

const FILE: &str = "kept.ppm";
const KEPT: &str = "kept\n";

/// So large that it takes a while to write: a tenth of a second, and seconds.
const LARGE: [&str; 2] = ["--width", "4000"];
const LARGEST: [&str; 2] = ["--width", "16384"];

impl Desk {
    fn new() -> Self {
        let desk = Self(TempDir::new().expect("a folder"));
        fs::write(desk.file(), KEPT).expect("a file");
        desk
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn file(&self) -> PathBuf {
        self.path(FILE)
    }

    fn read(&self) -> String {
        fs::read_to_string(self.file()).expect("the file is there")
    }

    fn about(&self) -> fs::Metadata {
        fs::metadata(self.file()).expect("the file is there")
    }

    fn names(&self) -> Vec<String> {
        names_in(self.0.path())
    }

    fn partials(&self) -> Vec<String> {
        let mut names = self.names();
        names.retain(|name| name.ends_with(".partial"));
        names
    }

    /// A program that is in the middle of replacing the file.
    fn start_largest(&self) -> Child {
        let mut command = hears_signals(path_of("gradient"));
        let child = command.args(LARGEST).arg(self.file()).spawn();
        let child = child.expect("the program starts");
        self.wait_for_partial();
        child
    }

    fn wait_for_partial(&self) {
        let soon = Instant::now() + Duration::from_secs(10);
        while self.partials().is_empty() {
            assert!(Instant::now() < soon, "no partial file in ten seconds");
        }
    }
}

/// Sends a signal, or two of them as `timeout` does, and a terminal that is closed.
fn send(child: &Child, signal: Signal, times: usize) {
    for _ in 0..times {
        kill_process(Pid::from_child(child), signal).expect("it is there until we wait for it");
    }
}

fn ended(mut child: Child) -> ExitStatus {
    child.wait().expect("the program ends")
}

fn shell(script: &str) -> Command {
    let mut shell = Command::new("sh");
    shell.args(["-c", script]);
    shell
}

fn can(command: &mut Command) -> bool {
    let output = command.stdin(Stdio::null()).output();
    output.is_ok_and(|output| output.status.success())
}

/// `program` as someone starts it at a terminal. What a shell starts in the
/// background, as these tests may be, ignores the signal of Ctrl-C.
pub(crate) fn hears_signals(program: PathBuf) -> Command {
    const RESET: &str = "--default-signal=INT,TERM,HUP";
    static CAN_RESET: LazyLock<bool> =
        LazyLock::new(|| can(Command::new("env").args([RESET, "true"])));
    if !*CAN_RESET {
        return Command::new(program);
    }
    let mut command = Command::new("env");
    command.arg(RESET).arg(program);
    command
}

fn workspace() -> PathBuf {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
    tests.ancestors().nth(2).expect("tests/suite").to_owned()
}

/// A shell that runs `script` after `mounts`, which change what it sees at the
/// place of the workspace. To both, `$0` is that place, and `$@` a copy of `rtrace`
/// in the folder that is returned too, with what arguments follow.
fn with_mounts(mounts: &str, script: &str) -> Option<(TempDir, Command)> {
    let unshare = |script: &str| {
        let mut command = unshare("--mount");
        command.args(["sh", "-c", script]).arg(workspace());
        command
    };
    if !can(&mut unshare(mounts)) {
        left_out("there is no unshare here that lets the workspace be hidden");
        return None;
    }
    let folder = TempDir::new().expect("a folder");
    let copy = folder.path().join("rtrace");
    fs::copy(path_of("rtrace"), &copy).expect("a copy that is not hidden");
    let mut command = unshare(&format!("{mounts} && cd / && {script}"));
    command.arg(copy);
    Some((folder, command))
}

/// Runs a program with its own `kind` of system resources, as a container does.
fn unshare(kind: &str) -> Command {
    let mut command = Command::new("unshare");
    if !geteuid().is_root() {
        command.args(["--user", "--map-root-user"]);
    }
    command.arg(kind);
    command
}
