//! A dialogue with a subprocess by pipes: each line that it is asked is answered by one line,
//! within its time.
//!
//! A thread reads, so that no program can keep us waiting. Another shows what is written to
//! standard error, as it comes.

use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{ChildStdout, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use check::any_language::NoAnswer;

use crate::subprocess::{self, RunningProgram};

/// A running program that answers each line that it is asked with one line.
pub(super) struct Dialogue {
    program: RunningProgram,
    /// Receives a value when all that the program wrote to standard error has been shown.
    said: Receiver<String>,
    answers: Receiver<String>,
    limit: Duration,
    start: Instant,
}

/// The time for all answers, in times of the limit for one.
const ALL: u32 = 20;

/// The reason why a program can't be asked any more.
pub(super) enum DialogueFailure {
    /// No answer within the limit, but one within twice the limit.
    Tardy,
    /// No answer within the limit, but one when the program's input ended: it reads all lines
    /// first.
    Late,
    /// No answer at all, neither within twice the limit nor when the program's input ended.
    Silent,
    /// Not all answers within this time, which is for all together.
    Slow(Duration),
    /// An end of the program without an answer, with its status; `None` if it runs on with a closed
    /// output.
    Ended(Option<ExitStatus>),
    /// More than one line in answer to one; this is the line too many.
    TooMuch(String),
    /// A line that is no answer, and why it is none.
    NoAnswer(String, NoAnswer),
}

/// The time that a program may take to print the rest and to end after its input has ended.
const FAREWELL: Duration = Duration::from_secs(2);

/// The greatest length of a line in bytes: an answer is a few numbers, and the rest of a longer one
/// counts as one more line.
const MOST_BYTES: u64 = 200;

impl Dialogue {
    /// Starts a program, given by its name and its arguments, which may take `limit` for an answer
    /// and twenty times `limit` for all.
    pub(super) fn start(words: &[OsString], limit: Duration) -> io::Result<Self> {
        let mut command = subprocess::reader_command(words);
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        command.stderr(Stdio::piped());
        let mut program = RunningProgram::start(command)?;
        let piped = "it is piped";
        let errors = program.errors.take().expect(piped);
        Ok(Self {
            said: subprocess::in_a_thread(move || subprocess::show_errors(errors)),
            answers: reader(program.printed.take().expect(piped)),
            program,
            limit,
            start: Instant::now(),
        })
    }

    /// Sends the program a line, and returns the line that it answers, without blanks around it.
    ///
    /// # Errors
    /// If the program has printed something before, answers too late, has ended, or has taken
    /// longer than it may for all answers.
    pub(super) fn ask(&mut self, line: &str) -> Result<String, DialogueFailure> {
        self.says_no_more(Duration::ZERO)?;
        if self.start.elapsed() > ALL * self.limit {
            return Err(DialogueFailure::Slow(ALL * self.limit));
        }
        if let Some(questions) = &mut self.program.input {
            // A pipe has room for a line, whether it is read or not; where nothing reads, nothing
            // answers.
            let _ = questions.write_all(format!("{line}\n").as_bytes());
        }
        match self.answers.recv_timeout(self.limit) {
            Ok(answer) => Ok(answer),
            Err(RecvTimeoutError::Timeout) => Err(self.late()),
            Err(RecvTimeoutError::Disconnected) => Err(DialogueFailure::Ended(self.status())),
        }
    }

    /// Closes the program's input.
    ///
    /// # Errors
    /// If the program then prints one more line.
    pub(super) fn close_input(&mut self) -> Result<(), DialogueFailure> {
        // Its input ends.
        self.program.input = None;
        self.says_no_more(FAREWELL)
    }

    /// Waits for `time`, in which the program should print nothing.
    ///
    /// # Errors
    /// If it prints a line.
    pub(super) fn says_no_more(&self, time: Duration) -> Result<(), DialogueFailure> {
        let more = self.answers.recv_timeout(time);
        more.map_or(Ok(()), |more| Err(DialogueFailure::TooMuch(more)))
    }

    fn late(&mut self) -> DialogueFailure {
        if self.answers.recv_timeout(self.limit).is_ok() {
            return DialogueFailure::Tardy;
        }
        // Its input ends.
        self.program.input = None;
        let late = self.answers.recv_timeout(FAREWELL);
        late.map_or(DialogueFailure::Silent, |_| DialogueFailure::Late)
    }

    /// Returns the status of the program, if it ends within [`FAREWELL`].
    fn status(&mut self) -> Option<ExitStatus> {
        const TICK: Duration = Duration::from_millis(2);
        let start = Instant::now();
        while start.elapsed() < FAREWELL {
            if let Some(status) = self.program.exit_status().ok()? {
                return Some(status);
            }
            thread::sleep(TICK);
        }
        None
    }
}

impl Drop for Dialogue {
    fn drop(&mut self) {
        self.program.kill();
        let _ = self.said.recv_timeout(FAREWELL);
    }
}

/// Starts a thread that reads lines. A program that prints on and on has to wait.
fn reader(output: ChildStdout) -> Receiver<String> {
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
