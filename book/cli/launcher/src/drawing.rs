//! Subprocesses: a picture that a chapter's own program draws.

use std::error::Error;
use std::io::{self, BufRead, BufReader};
use std::mem;
use std::path::Path;
use std::process::{Command, Stdio};

use common::rtweekend::Picture;

/// Returns the picture that a chapter's program draws, `width` pixels wide.
pub(crate) fn drawn_by(program: &Path, width: u32) -> Result<Picture, Box<dyn Error>> {
    let mut command = Command::new(program);
    command.args(["--width", &width.to_string(), "-"]);
    let mut drawing = command.stdout(Stdio::piped()).spawn()?;
    let printed = drawing.stdout.take().ok_or("there is no pipe")?;
    let picture = read_p3(BufReader::new(printed));
    let status = drawing.wait()?;
    if !status.success() {
        return Err(format!("it has ended with {status}").into());
    }
    picture?.ok_or_else(|| "it has not printed a whole picture".into())
}

/// Reads a picture as chapters print it: as P3, a text of numbers, of which the first four give the
/// size and the greatest level. Returns `None` if that is not printed, or not to its end.
fn read_p3(mut text: impl BufRead) -> io::Result<Option<Picture>> {
    let mut header = [(); 3].map(|()| String::new());
    for line in &mut header {
        text.read_line(line)?;
    }
    let [_, size, _] = header;
    let size = size.trim_end().split_once(' ');
    let size = size.and_then(|(width, height)| Some((width.parse().ok()?, height.parse().ok()?)));
    let Some((width, height)) = size else {
        return Ok(None);
    };
    let (mut levels, mut level) = (Vec::new(), 0);
    loop {
        let piece = text.fill_buf()?;
        for byte in piece {
            match byte {
                b'0'..=b'9' => level = 10 * level + (byte - b'0'),
                _ => levels.push(mem::take(&mut level)),
            }
        }
        let length = piece.len();
        if length == 0 {
            return Ok(Picture::from_rgb(width, height, levels));
        }
        text.consume(length);
    }
}
