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

/// A program that is asked.
pub(super) struct Dialogue {
    program: RunningProgram,
    /// Comes when all that it says beside its answers has been shown.
    said: Receiver<String>,
    answers: Receiver<String>,
    limit: Duration,
    start: Instant,
}

/// For all answers, a program may take so many times as long as for one.
const ALL: u32 = 20;

/// Why a program can't be asked any more.
pub(super) enum DialogueFailure {
    /// It did not answer in time, but after twice the time.
    Tardy,
    /// It did not answer in time, but when its input ended.
    Late,
    /// It did not answer in time, nor later.
    Silent,
    /// Not all answers came within this time.
    Slow(Duration),
    /// It ended, or runs with a closed output.
    Ended(Option<ExitStatus>),
    /// It said one more line than it was asked.
    TooMuch(String),
    /// It said what is no answer.
    NoAnswer(String, NoAnswer),
}

/// How long a program whose input has ended may take to say the rest, and to end.
const FAREWELL: Duration = Duration::from_secs(2);

/// An answer is a number. What is longer is cut off, and shown as far as this.
const MOST_BYTES: u64 = 200;

impl Dialogue {
    /// Starts the program, which may take so long for an answer.
    ///
    /// # Errors
    /// If it does not start.
    pub(super) fn start(words: &[OsString], limit: Duration) -> io::Result<Self> {
        let mut command = subprocess::reader_command(words);
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut program = RunningProgram::start(command.stderr(Stdio::piped()))?;
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

    /// Asks a line, and returns the line that it answers.
    ///
    /// # Errors
    /// If it does not answer as agreed.
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

    /// Ends its input.
    ///
    /// # Errors
    /// If it then says more than it was asked.
    pub(super) fn close_input(&mut self) -> Result<(), DialogueFailure> {
        // Its input ends.
        self.program.input = None;
        self.says_no_more(FAREWELL)
    }

    /// Waits so long for it to say nothing.
    ///
    /// # Errors
    /// The line that it says.
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

    /// Returns its status, if it ends soon.
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

/// Starts a thread that reads lines. A program that goes on and on has to wait.
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
