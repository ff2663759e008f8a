//! Language detection by the words of a command: what is written in it, and in whose letters.

use std::ffi::OsString;
use std::path::Path;

use slips::{Edition, Letters};

/// The language of a program.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Language {
    Python,
    JavaScript,
    Awk,
    Rust,
    /// C++, or what is near to it: what its command doesn't say.
    Cpp,
}

impl Language {
    /// That of the source that the command names, or of what runs it.
    pub(super) fn of(words: &[OsString]) -> Self {
        let named = words
            .iter()
            .find_map(|word| Self::of_source(Path::new(word)));
        named.unwrap_or_else(|| {
            let runner = Path::new(&words[0]).file_stem().unwrap_or_default();
            match &*runner.to_string_lossy() {
                "node" | "deno" | "bun" => Self::JavaScript,
                "awk" | "gawk" | "mawk" => Self::Awk,
                "cargo" => Self::Rust,
                name if name.starts_with("python") => Self::Python,
                _ => Self::Cpp,
            }
        })
    }

    fn of_source(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()? {
            "py" => Some(Self::Python),
            "js" | "mjs" | "cjs" | "ts" => Some(Self::JavaScript),
            "awk" => Some(Self::Awk),
            "rs" => Some(Self::Rust),
            _ => None,
        }
    }

    /// In which mistakes are said.
    pub(super) fn letters(self) -> Letters {
        match self {
            Self::Python => Letters::Python(Edition::V4),
            Self::Rust => Letters::Rust,
            Self::JavaScript | Self::Awk | Self::Cpp => Letters::Book(Edition::V4),
        }
    }

    /// How a line is printed at once.
    pub(super) fn flushed(self) -> &'static str {
        match self {
            Self::Python => "read by for line in sys.stdin, and print(…, flush=True)",
            Self::JavaScript => "answer in the event 'line' of node:readline, by console.log",
            Self::Awk => "call fflush() after each print; mawk also needs -W interactive",
            Self::Rust => "read by lines(), and println!",
            Self::Cpp => "send each answer at once, in C++ by std::endl",
        }
    }

    /// How all digits are printed.
    pub(super) fn in_full(self) -> &'static str {
        match self {
            Self::Python => "print(t), and no format such as {t:.6f}",
            Self::JavaScript => "console.log(t), without toFixed",
            Self::Awk => "printf \"%.17g\\n\", t",
            Self::Rust => "println!(\"{t:?}\")",
            Self::Cpp => "in C++, std::cout << std::setprecision(17) << t",
        }
    }
}
