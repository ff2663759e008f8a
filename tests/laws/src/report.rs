//! A report: the first law that is broken, why, and the simplest question that shows
//! it, as a test to paste.

use std::fmt;

use crate::causes::Cause;
use crate::question::Question;
use crate::verdict::Broken;

/// What a trial found wrong with a function.
#[derive(Clone, Debug)]
pub struct Report {
    /// The law, as the simplest question that was found breaks it.
    pub broken: Broken,
    /// What makes it so.
    pub cause: Cause,
    /// How many of the laws that follow are broken as well.
    pub others: usize,
    /// The test that asks this question again.
    pub test: String,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let usually = self.cause.lines(&self.broken).join("\n          ");
        writeln!(f, "{}", self.broken.explained_by(&usually))?;
        match self.others {
            0 => {}
            1 => writeln!(f, "besides:  another law is broken too")?,
            others => writeln!(f, "besides:  {others} other laws are broken too")?,
        }
        write!(f, "\n{}", self.test)
    }
}

/// The test that asks about this value again. It stands where the function has its
/// name, so it need not guess from where to import it.
pub(crate) fn test<Q: Question>(value: &Q) -> String {
    let body = value.as_test(Q::FUNCTION).replace('\n', "\n    ");
    format!(
        "// Beside the test that failed:\n\
         #[test]\nfn this_case_is_right() {{\n    use common::rtweekend::*;\n    {body}\n}}"
    )
}
