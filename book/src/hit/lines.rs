//! A line-buffered reader with limits: what reads rows from it is never farther than
//! the line in which its row ends, so that messages can name lines.

use std::io::{self, BufRead, Read};

/// The longest row, in bytes, with the empty lines before it. Ten numbers take less
/// than 11 000, even if each is as long as an `f64` can be in decimal digits.
const MOST_BYTES_OF_A_ROW: usize = 1 << 16;

/// The largest file, in bytes. A million rows of ten numbers with all their digits fit.
const MOST_BYTES: usize = 1 << 28;

/// A text that is handed on a line at a time, by whatever a line ends with.
pub(super) struct Lines<R> {
    input: R,
    /// How many bytes were handed on, in all and since the last row.
    bytes: usize,
    bytes_of_row: usize,
    last: u8,
    line: u64,
    line_of_row: Option<u64>,
}

impl<R: BufRead> Lines<R> {
    pub(super) fn of(input: R) -> Self {
        Self {
            input,
            bytes: 0,
            bytes_of_row: 0,
            last: 0,
            line: 1,
            line_of_row: None,
        }
    }

    /// Another row begins after what was handed on.
    pub(super) fn begin_row(&mut self) {
        self.bytes_of_row = 0;
        self.line_of_row = None;
    }

    /// The line in which the row begins, after empty ones.
    pub(super) fn line_of_row(&self) -> u64 {
        self.line_of_row.unwrap_or(self.line)
    }

    fn count(&mut self, bytes: usize) -> io::Result<()> {
        self.bytes += bytes;
        self.bytes_of_row += bytes;
        if self.bytes_of_row > MOST_BYTES_OF_A_ROW {
            return Err(io::Error::other(format!(
                "no row ends within {MOST_BYTES_OF_A_ROW} bytes: is a quotation mark left open, or is this no CSV file?"
            )));
        }
        if self.bytes > MOST_BYTES {
            return Err(io::Error::other(format!(
                "the file has more than {MOST_BYTES} bytes: split it"
            )));
        }
        Ok(())
    }
}

impl<R: BufRead> Read for Lines<R> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let ready = self.input.fill_buf()?;
        let line = line_at_start_of(&ready[..ready.len().min(out.len())]);
        let (Some(&first), Some(&last)) = (line.first(), line.last()) else {
            return Ok(0);
        };
        self.line += u64::from(ends_line(self.last, Some(first)));
        self.last = last;
        if !line.iter().all(|byte| b"\r\n".contains(byte)) {
            self.line_of_row.get_or_insert(self.line);
        }
        let length = line.len();
        out[..length].copy_from_slice(line);
        self.input.consume(length);
        self.count(length)?;
        Ok(length)
    }
}

/// The first line with its end, or as much of it as there is.
fn line_at_start_of(bytes: &[u8]) -> &[u8] {
    let end = (0..bytes.len()).find(|&at| ends_line(bytes[at], bytes.get(at + 1).copied()));
    end.map_or(bytes, |end| &bytes[..=end])
}

/// Whether a line ends between two bytes: after 10, after 13 and 10, or after 13 alone.
fn ends_line(byte: u8, next: Option<u8>) -> bool {
    byte == b'\n' || byte == b'\r' && next != Some(b'\n')
}
