//! Why some bytes are no picture.

use std::fmt;

use super::limits::{MOST_BYTES, MOST_PIXELS};

/// What keeps a file from being a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cause {
    /// What the cause is called, for programs. It never changes.
    pub name: &'static str,
    /// What is wrong, and where.
    pub problem: String,
    /// What to do about it.
    pub fix: String,
}

impl Cause {
    /// A cause by its name, the problem and the fix.
    pub fn new(name: &'static str, problem: impl Into<String>, fix: impl Into<String>) -> Self {
        Self {
            name,
            problem: problem.into(),
            fix: fix.into(),
        }
    }

    /// A file of more than [`MOST_BYTES`].
    pub fn too_large() -> Self {
        Self::new(
            "too-large",
            format!("the file has more than {MOST_BYTES} bytes"),
            "Draw a smaller picture: 400 pixels wide, as in the book.",
        )
    }

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

/// What to do when bytes have been changed as if they were text.
pub(super) const AS_BYTES: &str = "Print bytes as bytes. On Windows that is a file opened with \"wb\" in C and Python, or with \
     std::ios::binary in C++; for standard output _setmode(_fileno(stdout), _O_BINARY) in C and C++, \
     and sys.stdout.buffer in Python. A copy must be binary too: git may need *.ppm binary in .gitattributes.";
