//! One syntax tree for the expressions and statements of ten languages.
//!
//! The lines of these chapters differ between languages by little but spelling: `r.direction()`,
//! `r.dir`, `direction(r)`. [`statements`] reads those of a text, [`normal`] gives expressions with
//! one meaning one form, [`Pattern::find`] finds an expression under other names, and
//! [`Language::spelled`] prints a line of Rust in another language.

mod normal;
mod parse;
mod pattern;
mod print;
mod statements;
mod tokens;
mod tree;

pub use normal::{canonical, normal, plain};
pub use pattern::{Match, Pattern, Rename};
pub use statements::{Role, Statement, statements};
pub use tree::{Op, Tree};

/// A language in which readers follow the book.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Language {
    /// Rust, the language of the chapters here; files that end in `.rs`.
    Rust,
    /// C++, the language of the book; `.cc`, `.cpp`, `.cxx`, and headers, of C too.
    Cpp,
    /// C; `.c`.
    C,
    /// Python; `.py`.
    Python,
    /// JavaScript and TypeScript; `.js`, `.mjs`, `.cjs`, `.ts`, `.mts`.
    JavaScript,
    /// Java; `.java`.
    Java,
    /// C#; `.cs`.
    CSharp,
    /// Go; `.go`.
    Go,
    /// Kotlin; `.kt`, `.kts`.
    Kotlin,
    /// Swift; `.swift`.
    Swift,
}

/// A function of a text in Rust, and how long it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FunctionSize<'a> {
    /// The name of the function, without that of a type.
    pub name: &'a str,
    /// The number of its tokens, from its name to the next `fn`; comments are not counted.
    pub tokens: usize,
}

/// Measures the functions of a text in Rust, in their order; none are found in other texts.
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
    /// Finds the language of a file by the ending of its name; `None` for another ending or none.
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
