//! Verdicts as data: the law that a case breaks, and the outcome of all laws for one function.

use std::borrow::Cow;
use std::fmt;

use proptest::test_runner::TestCaseError;

use crate::answers::Answers;

/// The result of one law for one case: `Ok` if the law holds. In a property test, `?` turns the
/// broken law into the reason of the failure.
pub type LawResult = Result<(), BrokenLaw>;

/// A law that a function's answer breaks, with the answer, as plain text for the function's author.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BrokenLaw {
    /// The law, a property that every right answer has, as a sentence without a full stop:
    /// `the point of a hit is the one at its t`.
    pub law: Cow<'static, str>,
    /// The wrong answer of the function, in one line: `a miss`, `t = 0.5`, or more numbers.
    pub found: String,
    /// The answers that the law allows, in one line, with the bound of rounding where there is one.
    pub allowed: String,
    /// The chapter and the equation or function that explain the law, in one line, such as
    /// `chapter 5: closest_so_far`.
    pub read: Cow<'static, str>,
}

/// The result of all laws for one function: `Ok` if they hold.
pub type Outcome = Result<(), Complaint>;

/// A reason why a function is not right: it breaks a law, or is not written yet.
#[derive(Clone, Debug)]
pub enum Complaint {
    /// The function breaks a law.
    Broken(Box<Report>),
    /// The function comes upon a `todo!()` at this place: file, line and column, with colons
    /// between.
    NotWritten(String),
}

/// A report on a function that breaks a law: the smallest case found, and all answers up to it.
#[derive(Clone, Debug)]
pub struct Report {
    /// The law that the answer to the smallest case breaks, with that answer.
    pub broken: BrokenLaw,
    /// The recorded answers, in the order of the questions; the last is that to the smallest case.
    /// A list's own follow those of its spheres; in a report from a file, they follow those of all
    /// functions that were tried before. Empty if none is recorded.
    pub answers: Answers,
    /// One line of plain text for each known mistake that gives equal answers, then a line that
    /// says so. Empty until a judge fills it in: this package knows no mistakes.
    pub same_as: Vec<String>,
    /// The body of a `#[test]` that asks about the smallest case again, as Rust code in several
    /// lines; empty if there is none.
    pub test: String,
}

impl Complaint {
    /// Makes the complaint about a broken law, without known mistakes so far.
    pub(crate) fn of(broken: BrokenLaw, answers: Answers, test: String) -> Self {
        let same_as = Vec::new();
        Self::Broken(Box::new(Report {
            broken,
            answers,
            same_as,
            test,
        }))
    }
}

/// A row of a report: its label, such as `found`, empty if the row continues the one above, and one
/// line of plain text.
pub type ReportRow<'a> = (&'a str, &'a str);

impl BrokenLaw {
    /// Returns the result of a law that holds if `is_right`.
    pub(crate) fn unless(is_right: bool, broken: impl FnOnce() -> Self) -> LawResult {
        if is_right { Ok(()) } else { Err(broken()) }
    }

    /// Lists the rows about the law, in the order in which they are read; `between` them the known
    /// mistakes.
    fn rows<'a>(&'a self, between: impl Iterator<Item = ReportRow<'a>>) -> Vec<ReportRow<'a>> {
        let Self {
            law,
            found,
            allowed,
            read,
        } = self;
        let first = [("the law", &**law), ("found", found), ("allowed", allowed)];
        let first = first.into_iter().chain(between);
        first.chain([("read", &**read)]).collect()
    }
}

impl Report {
    /// Lists the rows of the report, in the order in which they are read: the law, the answer, the
    /// answers allowed, at most five lines of [`same_as`](Self::same_as), and the chapter. The test
    /// is not among them.
    pub fn rows(&self) -> Vec<ReportRow<'_>> {
        let lines = self.same_as.iter().map(String::as_str);
        self.broken
            .rows(["same as", "", "", "", ""].into_iter().zip(lines))
    }
}

/// Formats rows as plain text, one line for each, with all texts in one column and no newline at
/// the end.
pub fn rows_as_text<'a>(rows: impl IntoIterator<Item = ReportRow<'a>>) -> String {
    let line = |(label, text)| match label {
        "" => format!("          {text}"),
        _ => format!("{:<10}{text}", format!("{label}:")),
    };
    rows.into_iter().map(line).collect::<Vec<_>>().join("\n")
}

impl fmt::Display for BrokenLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&rows_as_text(self.rows(std::iter::empty())))
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", rows_as_text(self.rows()))?;
        if self.test.is_empty() {
            return Ok(());
        }
        let body = self.test.replace('\n', "\n    ");
        write!(
            f,
            "\n// Beside the test that failed:\n\
             #[test]\nfn this_case_is_right() {{\n    use common::rtweekend::*;\n    {body}\n}}"
        )
    }
}

impl fmt::Display for Complaint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Broken(report) => report.fmt(f),
            Self::NotWritten(place) => write!(f, "not written yet: todo!() at {place}"),
        }
    }
}

impl From<BrokenLaw> for TestCaseError {
    fn from(broken: BrokenLaw) -> Self {
        Self::fail(broken.to_string())
    }
}

/// Ends a test: panics with the text of the error if `outcome` is one, and else does nothing.
///
/// # Panics
/// If `outcome` is an error.
pub fn holds<E: fmt::Display>(outcome: Result<(), E>) {
    if let Err(complaint) = outcome {
        panic!("\n\n{complaint}\n");
    }
}
