//! The loop from a save to a verdict, watched in a terminal as a reader sees it.

use std::fs;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use insta::assert_binary_snapshot;
use rustix::process::{Pid, Signal, kill_process};

use fixtures::command::{run, text};
use fixtures::desk::Desk;
use fixtures::drawn::shown_in;
use fixtures::left_out::left_out;
use fixtures::reader::TestReader;
use fixtures::terminal::{self, Screen, hears_signals};
use fixtures::typing::typings;
use fixtures::workspace;

/// Chapter 3 in a terminal, as the introduction shows it.
#[test]
#[ignore = "builds a reader's crate a dozen times"]
fn chapter_3_is_typed_step_by_step_with_three_mistakes() {
    let reader = TestReader::empty();
    reader.make("red_sphere", &[]);
    let started = reader.desk.run("rtrace start normals");
    keep("start", &text(&started.stdout));
    // The laws are built before: else the first screens come without them.
    reader.watch_once("normals");
    let mut watch = Watched::start(&reader.rtrace(&["watch", "normals"]));
    watch.see("Not written yet");

    let mut typed = typings(include_str!("programs/chapter_3.txt")).into_iter();
    let mut type_next = || reader.make_changes("normals", &typed.next().expect("the next"));
    type_next();
    watch.see("src/lib.rs:");
    type_next();
    let screen = watch.see("The program does not compile");
    assert!(plain(&screen).contains("src/lib.rs"), "{screen}");
    type_next();
    keep("step", &watch.see("Step 1 of 3 is right."));
    type_next();
    keep("gray", &watch.see("Step 2 of 3 is right."));
    type_next();
    watch.see("looking for the line that makes it right");
    keep("wrong", &watch.see("with this change"));
    type_next();
    watch.see("The laws hold.");
    type_next();
    let screen = plain(&watch.see("with this change"));
    assert!(screen.contains("should be  b = -2.0"), "{screen}");
    type_next();
    keep("right", &watch.see("The laws hold."));
    assert!(typed.next().is_none());

    for screen in watch.screens() {
        fits_a_terminal(&screen);
    }
    watch.leave();
    let list = fs::read_to_string(reader.path().join("done.md")).expect("the list");
    for done in ["step 1 shows", "the picture is right", "the laws hold"] {
        assert_eq!(list.matches(done).count(), 1, "{list}");
    }
    run(&mut reader.rtrace(&[
        "done",
        "the ball was inside out: n points away from the center",
    ]));
    let done = run(&mut reader.rtrace(&["done"]));
    keep("done", &text(&done.stdout));
}

/// A terminal of 80 columns and 24 lines, with a line for the cursor.
fn fits_a_terminal(screen: &str) {
    let screen = plain(screen);
    let lines = screen.lines().map(|line| line.chars().count());
    let rows: usize = lines.map(|length| length.div_ceil(80).max(1)).sum();
    assert!(rows <= 23, "there is no room for\n{screen}");
}

#[test]
#[ignore = "waits for the changes of files, some ten seconds"]
fn a_program_in_any_language_is_watched_with_its_folder() {
    let version = Command::new("python3").arg("--version").output();
    if !version.is_ok_and(|it| it.status.success()) {
        return left_out("there is no Python here to watch a program of");
    }
    let here = Desk::default();
    here.write("gradient.py", include_str!("programs/gradient.py"));
    let line = "rtrace watch gradient --timeout 60 -- python3 gradient.py";
    let mut watch = Watched::start(&here.command(line));
    watch.see("Right: all 64 × 36 pixels");

    let save = |old: &str, new: &str| {
        let source = here.read("gradient.py");
        assert!(source.contains(old));
        here.write("gradient.py", source.replace(old, new));
    };
    save("(1 - a) * 1 + a * 0.5", "(1 - a) * 1 + a * a * 0.5");
    watch.see("Wrong:");
    save("import math", "import maths");
    assert!(plain(&watch.see("ended with")).contains("maths"));
    save("import maths", "import math\nimport time\ntime.sleep(600)");
    // It hangs, and is not waited for once there is something newer.
    thread::sleep(Duration::from_millis(400));
    let writes = "open(str(time.time()), 'w').write('own')";
    save("time.sleep(600)", writes);
    watch.see("Wrong:");
    // A program that writes a new file on every run is not judged for ever.
    watch.see_no_more();
    save("(1 - a) * 1 + a * a * 0.5", "(1 - a) * 1 + a * 0.5");
    watch.see("Right:");
    fs::remove_dir_all(here.path("")).expect("the folder goes");
    assert!(!watch.ended().success());
}

#[test]
fn what_cannot_be_watched_is_said() {
    let here = Desk::default();
    // The terminal shows it, and does not obey.
    let bell = r"printf 'panicked at \007:\nnot yet implemented' >&2; exit 101";
    here.write("bell.sh", bell);
    let said = here.transcript(
        "rtrace watch normals
         rtrace watch gradient --once -- ./no-such-program
         rtrace watch gradient --once --timeout 0.2 -- sleep 60
         rtrace watch gradient --once -- echo hello
         rtrace watch gradient --once -- sh bell.sh",
    );
    let timed = |line: &str| match line.split_once("  judged in ") {
        Some((title, _)) => format!("{title}\n"),
        None => format!("{line}\n"),
    };
    insta::assert_snapshot!(said.lines().map(timed).collect::<String>());
}

/// A program that runs at a terminal.
struct Watched {
    child: Child,
    screen: Screen,
    /// The number of screens that were looked at.
    seen: usize,
}

/// The escapes that clear the screen.
const CLEAR: &str = "\x1b[2J\x1b[H";

impl Watched {
    fn start(wanted: &Command) -> Self {
        let mut command = hears_signals(wanted);
        command.env("COLORTERM", "truecolor").stderr(Stdio::null());
        let (child, screen) = terminal::start(&mut command);
        Self {
            child,
            screen,
            seen: 0,
        }
    }

    fn shown(&self) -> String {
        text(&self.screen.shown.lock().expect("it is only read")).replace("\r\n", "\n")
    }

    /// Returns all screens so far, each as it was before the next one replaced it.
    fn screens(&self) -> Vec<String> {
        let shown = self.shown();
        let screens = shown.split(CLEAR).skip(1);
        // What is said while the next one is made stays on the line of the cursor.
        let whole = screens.map(|screen| screen.trim_end_matches("judging …"));
        whole.map(str::to_owned).collect()
    }

    /// Waits for a new screen that has this text, and returns it.
    fn see(&mut self, what: &str) -> String {
        // The first one may have to build all that a crate stands on.
        let patience = Duration::from_secs(if self.seen == 0 { 300 } else { 30 });
        let patience = Instant::now() + patience;
        loop {
            let screens = self.screens();
            let new = screens.iter().skip(self.seen);
            let found = new
                .zip(self.seen..)
                .find(|(screen, _)| plain(screen).contains(what));
            if let Some((screen, at)) = found
                && screen.ends_with('\n')
            {
                self.seen = at + 1;
                return screen.clone();
            }
            assert!(
                Instant::now() < patience,
                "{what} is not said:\n{}",
                screens.join("\n---\n")
            );
            thread::sleep(Duration::from_millis(20));
        }
    }

    /// Waits a second, in which no new screen comes.
    fn see_no_more(&mut self) {
        let before = self.screens().len();
        thread::sleep(Duration::from_secs(1));
        assert_eq!(self.screens().len(), before, "it is judged for ever");
    }

    fn ended(&mut self) -> ExitStatus {
        let patience = Instant::now() + Duration::from_secs(20);
        loop {
            if let Some(status) = self.child.try_wait().expect("it can be asked") {
                return status;
            }
            assert!(Instant::now() < patience, "it does not end");
            thread::sleep(Duration::from_millis(20));
        }
    }

    /// Presses Ctrl-C. All that was switched on in the terminal has to be off again.
    fn leave(mut self) {
        kill_process(Pid::from_child(&self.child), Signal::INT).expect("it is running");
        assert!(!self.ended().success());
        let shown = self.shown();
        assert!(
            !shown.contains("\x1b[?"),
            "a mode of the terminal was changed"
        );
        let last = shown.rfind("\x1b[").map_or("", |at| &shown[at..]);
        assert!(last.starts_with("\x1b[0m"), "{last:?}");
    }
}

impl Drop for Watched {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Keeps a screen for the introduction, without what differs from run to run.
fn keep(name: &str, screen: &str) {
    let screen: String = screen
        .lines()
        .map(|line| undated(&unwoven(line)) + "\n")
        .collect();
    let svg = terminal::svg(&screen).into_bytes();
    shown_in("terminal").bind(|| assert_binary_snapshot!(&format!("{name}.svg"), svg));
}

/// Names a page in words, as where the book is not woven: it depends on what was run before.
fn unwoven(line: &str) -> String {
    let book = workspace().join("target/book/");
    let Some((label, page)) = line.split_once(&*book.to_string_lossy()) else {
        return line.to_owned();
    };
    let mut all = slips::all();
    let slip = all.find(|slip| slip.page_link() == page);
    label.to_owned() + &slip.expect("a page of a mistake").page_in_words()
}

/// Returns the line without what differs from run to run.
fn undated(line: &str) -> String {
    match (
        line.split_once("  \x1b[2mjudged "),
        line.split_at_checked(14),
    ) {
        (Some((title, _)), _) => title.to_owned(),
        (_, Some((date, thing))) if date.starts_with("  - 20") => format!("  - …{thing}"),
        _ => line.to_owned(),
    }
}

/// Returns the text without colors.
fn plain(screen: &str) -> String {
    let mut pieces = screen.split("\x1b[");
    let first = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(first, |text, piece| {
        let end = piece.find(|letter: char| letter.is_ascii_alphabetic());
        text + &piece[end.map_or(0, |end| end + 1)..]
    })
}
