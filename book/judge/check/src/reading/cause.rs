//! A fault of a file or a picture: its name, the problem and the fix.

use std::fmt;

use super::limits::{MOST_BYTES, MOST_PIXELS};

/// The fault of a file that is no picture, or of a picture that is refused, with its fix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cause {
    /// The name of the cause for programs, such as `too-few-numbers`; it never changes.
    pub name: &'static str,
    /// A sentence on what is wrong and where, without capital and full stop.
    pub problem: String,
    /// Sentences on what to do about the problem, in plain text.
    pub fix: String,
}

impl Cause {
    /// Makes a cause from its name for programs, the problem without capital and full stop, and the
    /// sentences of the fix; the texts are taken as they are.
    pub fn new(name: &'static str, problem: impl Into<String>, fix: impl Into<String>) -> Self {
        Self {
            name,
            problem: problem.into(),
            fix: fix.into(),
        }
    }

    /// Makes the cause, `too-large`, for refusing a file of more than [`MOST_BYTES`] bytes.
    pub fn too_large() -> Self {
        Self::new(
            "too-large",
            format!("the file has more than {MOST_BYTES} bytes"),
            "Draw a smaller picture: 400 pixels wide, as in the book.",
        )
    }

    /// Refuses a picture whose header promises more than [`MOST_PIXELS`], with its width and height
    /// as they stand there.
    pub(super) fn absurd_size([width, height]: [String; 2]) -> Self {
        Self::new(
            "absurd-size",
            format!(
                "the header promises {width} × {height} pixels, and no more than {MOST_PIXELS} are read"
            ),
            "The book's pictures are 400 pixels wide. If yours should be, look at the first two numbers of the header.",
        )
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n{}", self.problem, self.fix)
    }
}

/// The fix for bytes that have been changed as if they were text.
pub(super) const AS_BYTES: &str = "Print bytes as bytes. On Windows that is a file opened with \"wb\" in C and Python, or with \
     std::ios::binary in C++; for standard output _setmode(_fileno(stdout), _O_BINARY) in C and C++, \
     and sys.stdout.buffer in Python. A copy must be binary too: git may need *.ppm binary in .gitattributes.";
