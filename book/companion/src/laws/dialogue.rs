//! A dialogue with a subprocess by pipes: each line that it is asked is answered by one line,
//! within its time.
//!
//! A thread reads and another one writes, so that no program can keep us waiting: not one that
//! never reads, nor one that never ends a line.

use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use crate::subprocess;

/// A program that is asked.
pub(super) struct Dialogue {
    child: Child,
    /// Where questions go; without it, the input of the program has ended.
    questions: Option<Sender<String>>,
    answers: Receiver<String>,
    errors: Errors,
    start: Instant,
    limit: Duration,
}

/// Why a program can't be asked any more.
pub(super) enum Failure {
    /// It did not answer in time, but when its input ended.
    Late,
    /// It did not answer in time, nor later.
    Silent,
    /// It answers, but all questions together would take too long.
    Slow,
    /// It ended, with these last words on standard error.
    Ended(ExitStatus, String),
    /// It runs, but its output is closed.
    Closed,
    /// It said one more line than it was asked.
    TooMuch(String),
    /// It said what is no answer.
    NoAnswer(String),
}

/// All questions together may take as often as long as one: some six thousand are asked, and a
/// program that starts slowly answers the others in an instant.
const MOST_OF_ALL: u32 = 24;

/// How long a program that is told to end may take, or to say the rest.
const FAREWELL: Duration = Duration::from_secs(2);

/// An answer is a number. What is longer is cut off, and shown as far as this.
const MOST_BYTES: u64 = 200;

impl Dialogue {
    /// Starts the program, which may take so long for an answer.
    ///
    /// # Errors
    /// If it does not start.
    pub(super) fn start(words: &[OsString], limit: Duration) -> io::Result<Self> {
        let mut command = subprocess::command(words);
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.stderr(Stdio::piped()).spawn()?;
        let piped = "all three are piped";
        let errors = Errors::of(child.stderr.take().expect(piped));
        let questions = Some(writer(child.stdin.take().expect(piped)));
        let answers = reader(child.stdout.take().expect(piped));
        Ok(Self {
            child,
            questions,
            answers,
            errors,
            start: Instant::now(),
            limit,
        })
    }

    /// What it answers to the line.
    pub(super) fn ask(&mut self, line: &str) -> Result<String, Failure> {
        self.says_no_more(Duration::ZERO)?;
        if self.start.elapsed() > MOST_OF_ALL * self.limit {
            return Err(Failure::Slow);
        }
        if let Some(questions) = &self.questions {
            // Where nothing reads, nothing answers.
            let _ = questions.send(format!("{line}\n"));
        }
        let failed = match self.answers.recv_timeout(self.limit) {
            Ok(answer) => return Ok(answer),
            Err(RecvTimeoutError::Timeout) => self.late(),
            Err(RecvTimeoutError::Disconnected) => self.ended(),
        };
        Err(failed)
    }

    /// Ends its input, and says whether it had said more than it was asked.
    pub(super) fn end(&mut self) -> Result<(), Failure> {
        self.questions = None;
        self.says_no_more(FAREWELL)
    }

    /// Whether it says nothing for so long.
    pub(super) fn says_no_more(&self, time: Duration) -> Result<(), Failure> {
        let more = self.answers.recv_timeout(time);
        more.map_or(Ok(()), |more| Err(Failure::TooMuch(more)))
    }

    fn late(&mut self) -> Failure {
        self.questions = None;
        let late = self.answers.recv_timeout(FAREWELL);
        // It may never end by itself.
        let _ = self.child.kill();
        late.map_or(Failure::Silent, |_| Failure::Late)
    }

    fn ended(&mut self) -> Failure {
        let ended = || self.child.try_wait().ok().flatten();
        match within(FAREWELL, ended) {
            Some(status) => Failure::Ended(status, self.errors.last()),
            None => Failure::Closed,
        }
    }
}

impl Drop for Dialogue {
    fn drop(&mut self) {
        self.questions = None;
        // Most programs end when their input does.
        if within(FAREWELL, || self.child.try_wait().ok().flatten()).is_none() {
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
    }
}

/// The first value that there is within the time.
fn within<T>(time: Duration, mut value: impl FnMut() -> Option<T>) -> Option<T> {
    const TICK: Duration = Duration::from_millis(2);
    let start = Instant::now();
    loop {
        let found = value();
        if found.is_some() || start.elapsed() > time {
            return found;
        }
        thread::sleep(TICK);
    }
}

fn writer(mut input: ChildStdin) -> Sender<String> {
    let (sender, questions) = mpsc::channel::<String>();
    thread::spawn(move || {
        for question in questions {
            if input.write_all(question.as_bytes()).is_err() {
                break;
            }
        }
    });
    sender
}

/// The lines that are read. A program that goes on and on has to wait.
fn reader(output: impl Read + Send + 'static) -> Receiver<String> {
    let (sender, answers) = mpsc::sync_channel(1);
    thread::spawn(move || {
        let mut output = BufReader::new(output);
        loop {
            let mut line = Vec::new();
            let read = (&mut output).take(MOST_BYTES).read_until(b'\n', &mut line);
            let answer = String::from_utf8_lossy(&line).trim().to_owned();
            if !read.is_ok_and(|length| length > 0) || sender.send(answer).is_err() {
                break;
            }
        }
    });
    answers
}

/// What a program says on standard error.
struct Errors {
    last: Arc<Mutex<String>>,
    reader: JoinHandle<()>,
}

impl Errors {
    fn of(errors: impl Read + Send + 'static) -> Self {
        let last = Arc::new(Mutex::new(String::new()));
        let kept = Arc::clone(&last);
        let reader = thread::spawn(move || {
            let lines = BufReader::new(errors).split(b'\n').map_while(Result::ok);
            for line in lines.filter(|line| says_something(line)) {
                let line = String::from_utf8_lossy(&line).trim_end().to_owned();
                *kept.lock().expect("the other thread only reads") = line;
            }
        });
        Self { last, reader }
    }

    /// The last line that says something.
    fn last(&self) -> String {
        within(FAREWELL, || self.reader.is_finished().then_some(()));
        let last = self.last.lock().expect("the other thread only writes");
        last.clone()
    }
}

/// Not the calls that led there, nor the version of Node.js, nor what Rust says of backtraces.
fn says_something(line: &[u8]) -> bool {
    let idle = [&b" "[..], b"\t", b"\r", b"Node.js v", b"note: "];
    !line.is_empty() && !idle.iter().any(|start| line.starts_with(start))
}
