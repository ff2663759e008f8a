//! One tree for expressions and statements of ten languages.
//!
//! What people type in these chapters differs between languages by little but spelling:
//! `r.direction()`, `r.dir`, `direction(r)`. [`statements`] reads a text, as far as its statements
//! go, [`normal`] brings what means the same into the same form, [`Pattern::find`] looks for it
//! under other names, and [`Language::spelled`] prints a line of Rust in another language.

mod normal;
mod parse;
mod pattern;
mod print;
mod statements;
mod tokens;
mod tree;

pub use normal::{canonical, normal, plain};
pub use pattern::{Match, Pattern};
pub use statements::{Role, Statement, statements};
pub use tree::{Op, Tree};

/// A language in which readers follow the book.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Language {
    /// Rust, as our chapters.
    Rust,
    /// C++, as the book.
    Cpp,
    /// C.
    C,
    /// Python.
    Python,
    /// JavaScript, and TypeScript.
    JavaScript,
    /// Java.
    Java,
    /// C#.
    CSharp,
    /// Go.
    Go,
    /// Kotlin.
    Kotlin,
    /// Swift.
    Swift,
}

/// Lists the functions of a text in Rust by their names, each with the number of its tokens. What
/// stands in comments is not counted.
pub fn functions(text: &str) -> Vec<(&str, usize)> {
    let tokens = tokens::tokens(text, Language::Rust);
    let parts = tokens.split(|it| it.text == "fn").skip(1);
    parts
        .filter_map(|part| Some((part.first()?.text, part.len())))
        .collect()
}

/// How the names of files end, by their language.
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
    /// Finds the language of a file by how its name ends.
    pub fn of_file(name: &str) -> Option<Self> {
        let (_, ending) = name.rsplit_once('.')?;
        let mut all = ENDINGS.iter();
        let found = all.find(|(_, endings)| endings.contains(&ending));
        found.map(|(language, _)| *language)
    }

    /// Returns true if the end of a line may end a statement.
    fn ends_at_lines(self) -> bool {
        use Language::{Go, JavaScript, Kotlin, Python, Swift};
        matches!(self, Python | JavaScript | Go | Kotlin | Swift)
    }

    /// Returns true if a condition stands in brackets.
    fn has_conditions_in_brackets(self) -> bool {
        use Language::{Go, Python, Rust, Swift};
        !matches!(self, Rust | Python | Go | Swift)
    }

    /// Returns true if a function returns what it ends with.
    fn returns_its_last(self) -> bool {
        matches!(self, Self::Rust | Self::Swift | Self::Kotlin)
    }

    /// Returns true if a quotient of whole numbers is a whole number.
    fn divides_whole_numbers(self) -> bool {
        !matches!(self, Self::Python | Self::JavaScript)
    }
}
