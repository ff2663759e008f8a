//! A report: the first law that is broken, why, and the simplest question that shows
//! it, as a test to paste.

use std::fmt;

use crate::causes::Cause;
use crate::shrinker::Simplify;
use crate::verdict::Broken;

/// What a trial found wrong with a function.
#[derive(Clone, Debug, PartialEq)]
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

impl Report {
    /// What makes it so, a line each: the mistakes that give these answers, if any is
    /// known that does.
    pub fn usually(&self) -> Vec<String> {
        self.cause.lines(&self.broken)
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Broken {
            law,
            found,
            allowed,
            page,
            ..
        } = &self.broken;
        let usually = self.usually().join("\n          ");
        writeln!(f, "the law:  {law}\nfound:    {found}\nallowed:  {allowed}")?;
        writeln!(f, "usually:  {usually}\nread:     {page}")?;
        match self.others {
            0 => {}
            1 => writeln!(f, "besides:  another law is broken too")?,
            others => writeln!(f, "besides:  {others} other laws are broken too")?,
        }
        write!(f, "\n{}", self.test)
    }
}

/// The test that asks `function` about this value, which is imported from `path`.
pub(crate) fn test(value: &impl Simplify, path: &str, function: &str) -> String {
    let body = value.as_test(function).replace('\n', "\n    ");
    format!(
        "#[test]\nfn this_case_is_right() {{\n    use common::rtweekend::*;\n    use {path};\n    {body}\n}}"
    )
}

/// Where a test imports the function from that has this type, and what it is called
/// there. A closure has no name, so one is imported that is `usually` there.
///
/// A test in the crate of the function can't call that crate by its name.
pub(crate) fn import(type_name: &str, usually: &str) -> (String, String) {
    let is_path = |letter: char| letter.is_alphanumeric() || "_:".contains(letter);
    let Some((module, function)) = type_name
        .rsplit_once("::")
        .filter(|_| type_name.chars().all(is_path))
    else {
        return (format!("super::{usually}"), usually.to_owned());
    };
    let (package, rest) = module.split_once("::").unwrap_or((module, ""));
    let program = std::env::current_exe().unwrap_or_default();
    let is_own = program
        .file_stem()
        .and_then(|stem| stem.to_str())
        .is_some_and(|stem| {
            stem.rsplit_once('-')
                .is_some_and(|(name, _)| name == package)
        });
    let package = if is_own { "crate" } else { package };
    let path = [package, rest, function]
        .into_iter()
        .filter(|part| !part.is_empty());
    (path.collect::<Vec<_>>().join("::"), function.to_owned())
}
