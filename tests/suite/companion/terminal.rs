//! A pseudo-terminal: what a program shows to somebody who sits before it.

use std::ffi::OsString;
use std::fs::File;
use std::io::Read;
use std::os::fd::OwnedFd;
use std::path::PathBuf;
use std::process::{Child, Command, Output, Stdio};
use std::sync::{Arc, LazyLock, Mutex};
use std::thread::{self, JoinHandle};

use rustix::fs::{Mode, OFlags};
use rustix::io::{FdFlags, fcntl_setfd};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{Winsize, tcsetwinsize};
use suite::command::{assert_success, path_of, program, text};

/// Opens a terminal of 80 columns and 24 lines. The first end shows what a program writes to the
/// second.
pub(crate) fn open() -> (File, OwnedFd) {
    let controller = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).expect("a terminal");
    // What is started may not hold it, too: it is closed when we close it.
    fcntl_setfd(&controller, FdFlags::CLOEXEC).expect("it is ours alone");
    grantpt(&controller).expect("access to the terminal");
    unlockpt(&controller).expect("the terminal is unlocked");
    let name = ptsname(&controller, Vec::new()).expect("the terminal has a name");
    let terminal = rustix::fs::open(name, OFlags::RDWR | OFlags::NOCTTY, Mode::empty())
        .expect("the terminal opens");
    let size = Winsize {
        ws_row: 24,
        ws_col: 80,
        ws_xpixel: 0,
        ws_ypixel: 0,
    };
    tcsetwinsize(&terminal, size).expect("the terminal has a size");
    (File::from(controller), terminal)
}

/// The bytes that have appeared on a terminal.
pub(crate) struct Screen {
    pub(crate) shown: Arc<Mutex<Vec<u8>>>,
    reader: JoinHandle<()>,
}

/// Starts `command` with a terminal of 80 columns and 24 lines as its standard output.
pub(crate) fn start(command: &mut Command) -> (Child, Screen) {
    let (mut controller, end) = open();
    forget_ours(command);
    let child = command.stdout(end).spawn().expect("the program starts");
    // The command holds the terminal too, and its end is read only when that is closed.
    command.stdout(Stdio::null());
    let shown = Arc::new(Mutex::new(Vec::new()));
    let screen = Arc::clone(&shown);
    let reader = thread::spawn(move || {
        let mut piece = [0; 4096];
        // When the other end is closed, some systems end the file and some
        // report an error; what was read until then counts.
        while let Ok(length @ 1..) = controller.read(&mut piece) {
            let mut screen = screen.lock().expect("the other thread only reads");
            screen.extend_from_slice(&piece[..length]);
        }
    });
    (child, Screen { shown, reader })
}

/// Removes the variables that tell which colors the terminal has in which the tests run.
fn forget_ours(command: &mut Command) {
    let said: Vec<OsString> = command.get_envs().map(|(name, _)| name.into()).collect();
    for name in ["COLORTERM", "NO_COLOR", "FORCE_COLOR", "CI"] {
        if !said.iter().any(|said| said == name) {
            command.env_remove(name);
        }
    }
    if !said.iter().any(|said| said == "TERM") {
        command.env("TERM", "xterm-256color");
    }
}

/// Makes a command that starts `program` as at a terminal: it hears Ctrl-C, which a shell has
/// programs in the background ignore, and perhaps these tests.
pub(crate) fn hears_signals(program: PathBuf) -> Command {
    const RESET: &str = "--default-signal=INT,TERM,HUP";
    static CAN_RESET: LazyLock<bool> = LazyLock::new(|| {
        let tried = Command::new("env").args([RESET, "true"]).output();
        tried.is_ok_and(|output| output.status.success())
    });
    if !*CAN_RESET {
        return Command::new(program);
    }
    let mut command = Command::new("env");
    command.arg(RESET).arg(program);
    command
}

#[test]
fn at_a_terminal_a_chapter_says_where_to_send_the_picture() {
    let (output, screen) = run_in_terminal(&mut program("normals", &[]));
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(screen, "", "no number reaches the terminal");
    let said = text(&output.stderr);
    assert!(
        said.contains("cargo run -p normals > normals.ppm"),
        "{said}"
    );
}

#[test]
fn a_picture_is_shown_in_the_colors_that_the_terminal_has() {
    // 16 × 9 pixels: four lines of two rows, and one with the last row.
    let sky = &red_sphere::picture(16).rgb()[..3].to_vec();
    let sky = format!("\x1b[38;2;{};{};{}m", sky[0], sky[1], sky[2]);
    for (variable, value, red) in [
        ("COLORTERM", "truecolor", "\x1b[48;2;255;0;0m"),
        ("TERM", "xterm-256color", "\x1b[48;5;196m"),
        ("TERM", "xterm", "\x1b[41m"),
    ] {
        let mut show = show("red_sphere");
        let (output, screen) = run_in_terminal(show.args(["--width", "16"]).env(variable, value));
        assert_success(&output);
        let lines: Vec<&str> = screen.lines().collect();
        assert_eq!(lines.len(), 5, "{screen}");
        assert!(lines.iter().all(|line| line.matches('▀').count() == 16));
        assert!(lines[2].contains(red), "{value}: {screen:?}");
        assert_eq!(lines[0].starts_with(&sky), value == "truecolor", "{screen}");
    }
}

#[test]
fn a_large_picture_is_reduced_to_fit_the_terminal() {
    let (_, screen) = run_in_terminal(&mut show("build_test"));
    let lines: Vec<&str> = screen.lines().collect();
    // A square in 80 columns and 24 lines, one of which is for the prompt.
    assert_eq!(lines.len(), 23, "{screen}");
    assert!(lines.iter().all(|line| line.matches('▀').count() == 46));
}

#[test]
fn nothing_is_colored_where_colors_are_not_wanted() {
    let wrong = || {
        let mut check = program("rtrace", &["check", "normals", "--"]);
        check.arg(path_of("gradient")).args(["--width", "16", "-"]);
        check
    };
    assert!(run_in_terminal(&mut wrong()).1.contains('\x1b'));
    let unwanted: [fn(&mut Command) -> &mut Command; 3] = [
        |command| command.env("TERM", "dumb"),
        |command| command.env("NO_COLOR", "1"),
        |command| command.env_remove("TERM"),
    ];
    for without in unwanted {
        let (_, screen) = run_in_terminal(without(&mut wrong()));
        assert!(!screen.contains('\x1b'), "{screen:?}");
        let (output, screen) = run_in_terminal(without(&mut show("normals")));
        assert_eq!((output.status.code(), &*screen), (Some(2), ""));
        assert!(text(&output.stderr).contains("--output"));
    }
}

fn show(chapter: &str) -> Command {
    program("rtrace", &["show", chapter])
}

/// Runs `command` to its end. Returns its output, and what appeared on its terminal.
fn run_in_terminal(command: &mut Command) -> (Output, String) {
    let (child, screen) = start(command.stderr(Stdio::piped()));
    let output = child.wait_with_output().expect("the program ends");
    screen.reader.join().expect("the screen was read");
    (
        output,
        text(&screen.shown.lock().expect("it")).replace("\r\n", "\n"),
    )
}
