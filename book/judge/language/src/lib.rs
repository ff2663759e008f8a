//! One syntax tree for the expressions and statements of ten languages.
//!
//! The lines of these chapters differ between languages by little but spelling: `r.direction()`,
//! `r.dir`, `direction(r)`. [`statements()`] reads those of a text, [`normal()`] gives most
//! expressions of one meaning one form, [`Pattern::find`] finds an expression under other names,
//! and [`Language::translate_line`] prints a line of Rust in another language.

mod normal;
mod parse;
mod pattern;
mod print;
mod statements;
mod tokens;
mod tree;

pub use normal::{canonical, normal, simplified};
pub use pattern::{Match, Pattern, Rename};
pub use statements::{Role, Statement, statements};
pub use tree::{Op, Tree};

/// A programming language in which readers of the book write their ray tracer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Language {
    /// Rust, the language of the chapters here; files that end in `.rs`.
    Rust,
    /// C++, the language of the book; files that end in `.cc`, `.cpp`, `.cxx`, and headers, also of
    /// C.
    Cpp,
    /// C; files that end in `.c`.
    C,
    /// Python; files that end in `.py`.
    Python,
    /// JavaScript and TypeScript; files that end in `.js`, `.mjs`, `.cjs`, `.ts`, `.mts`.
    JavaScript,
    /// Java; files that end in `.java`.
    Java,
    /// C#; files that end in `.cs`.
    CSharp,
    /// Go; files that end in `.go`.
    Go,
    /// Kotlin; files that end in `.kt`, `.kts`.
    Kotlin,
    /// Swift; files that end in `.swift`.
    Swift,
}

/// The name and the length, in tokens, of a function in Rust.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FunctionSize<'a> {
    /// The name of the function, without that of a type.
    pub name: &'a str,
    /// The number of tokens from the function's name to the next `fn` or the end of the text,
    /// comments not counted.
    pub tokens: usize,
}

/// Measures the functions of a source text in Rust, in the order of the text. Empty if it has none.
pub fn function_sizes(text: &str) -> Vec<FunctionSize<'_>> {
    let tokens = tokens::tokens(text, Language::Rust);
    let parts = tokens.split(|it| it.text == "fn").skip(1);
    let sizes = parts.filter_map(|part| {
        Some(FunctionSize {
            name: part.first()?.text,
            tokens: part.len(),
        })
    });
    sizes.collect()
}

/// The endings of file names, by language.
const ENDINGS: [(Language, &[&str]); 10] = [
    (Language::Rust, &["rs"]),
    (Language::Cpp, &["cc", "cpp", "cxx", "h", "hpp", "hxx"]),
    (Language::C, &["c"]),
    (Language::Python, &["py"]),
    (Language::JavaScript, &["js", "mjs", "cjs", "ts", "mts"]),
    (Language::Java, &["java"]),
    (Language::CSharp, &["cs"]),
    (Language::Go, &["go"]),
    (Language::Kotlin, &["kt", "kts"]),
    (Language::Swift, &["swift"]),
];

impl Language {
    /// Finds the language of a file by the ending of its name, as `rs` of `src/lib.rs`; `None` for
    /// an unknown ending or none.
    pub fn of_file(name: &str) -> Option<Self> {
        let (_, ending) = name.rsplit_once('.')?;
        let mut all = ENDINGS.iter();
        let found = all.find(|(_, endings)| endings.contains(&ending));
        found.map(|(language, _)| *language)
    }

    /// Returns true if a line's end may end a statement in this language.
    fn ends_at_lines(self) -> bool {
        use Language::{Go, JavaScript, Kotlin, Python, Swift};
        matches!(self, Python | JavaScript | Go | Kotlin | Swift)
    }

    /// Returns true if `if` and `while` want their condition in brackets.
    fn has_conditions_in_brackets(self) -> bool {
        use Language::{Go, Python, Rust, Swift};
        !matches!(self, Rust | Python | Go | Swift)
    }

    /// Returns true if a function returns the value of its last expression.
    fn returns_its_last(self) -> bool {
        matches!(self, Self::Rust | Self::Swift | Self::Kotlin)
    }

    /// Returns true if the quotient of two whole numbers is a whole number.
    fn divides_whole_numbers(self) -> bool {
        !matches!(self, Self::Python | Self::JavaScript)
    }
}
