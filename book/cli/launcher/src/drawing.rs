//! Subprocesses: a picture that a chapter's own program draws.

use std::error::Error;
use std::io::{self, BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdout, Command, Stdio};

use common::rtweekend::Picture;

/// A chapter's program at work: it prints a picture as P3, a text of numbers.
pub(crate) struct Drawing {
    program: Child,
    text: BufReader<ChildStdout>,
    /// The number of pixels in a row.
    pub width: u32,
    /// The number of rows.
    pub height: u32,
}

impl Drawing {
    /// Starts a chapter's program, and waits until it has printed the size of its picture, which is
    /// `width` pixels wide.
    ///
    /// # Errors
    /// If the program does not start, or ends before that.
    pub(crate) fn start(program: &Path, width: u32) -> Result<Self, Box<dyn Error>> {
        let mut command = Command::new(program);
        command.args(["--width", &width.to_string(), "-"]);
        let mut started = command.stdout(Stdio::piped()).spawn()?;
        let mut text = BufReader::new(started.stdout.take().ok_or("there is no pipe")?);
        let mut header = [(); 3].map(|()| String::new());
        for line in &mut header {
            text.read_line(line)?;
        }
        let size = header[1].trim_end().split_once(' ');
        let size =
            size.and_then(|(width, height)| Some((width.parse().ok()?, height.parse().ok()?)));
        let Some((width, height)) = size else {
            started.wait()?;
            return Err("it has printed no picture".into());
        };
        Ok(Self {
            program: started,
            text,
            width,
            height,
        })
    }

    /// Copies the picture to `out` as P3.
    ///
    /// # Errors
    /// If `out` can't be written to, or the program fails.
    pub(crate) fn copy(mut self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "P3\n{} {}\n255\n", self.width, self.height)?;
        io::copy(&mut self.text, out)?;
        self.end()
    }

    /// Reads the picture.
    ///
    /// # Errors
    /// If the program fails, or prints too few numbers.
    pub(crate) fn picture(mut self) -> io::Result<Picture> {
        let count = 3 * self.width as usize * self.height as usize;
        let mut levels = Vec::with_capacity(count);
        let mut level = 0;
        loop {
            let piece = self.text.fill_buf()?;
            for byte in piece {
                match byte {
                    b'0'..=b'9' => level = 10 * level + (byte - b'0'),
                    _ => levels.push(std::mem::take(&mut level)),
                }
            }
            let length = piece.len();
            if length == 0 {
                break;
            }
            self.text.consume(length);
        }
        let (width, height) = (self.width, self.height);
        self.end()?;
        Picture::from_rgb(width, height, levels)
            .ok_or_else(|| io::Error::other("it has not printed the whole picture"))
    }

    /// Waits until the program has ended.
    fn end(mut self) -> io::Result<()> {
        // A program that still prints is told that nobody reads any more.
        drop(self.text);
        match self.program.wait()? {
            status if status.success() => Ok(()),
            status => Err(io::Error::other(format!("it has ended with {status}"))),
        }
    }
}
