//! A verdict: what a law says of a question, in words that teach.

use std::fmt;

/// Whether a law holds, and if not, how it is broken.
pub type Verdict = Result<(), Broken>;

/// A law that does not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// What should hold.
    pub law: &'static str,
    /// What was found instead.
    pub found: String,
    /// What the law allows.
    pub allowed: String,
    /// What makes it so where [no known mistake](crate::causes) does.
    pub usually: &'static str,
    /// Where to read about it.
    pub page: &'static str,
}

impl Broken {
    /// The same, where more is known of what makes it so.
    pub(crate) fn explained_by(&self, usually: &str) -> String {
        let Self {
            law,
            found,
            allowed,
            page,
            ..
        } = self;
        format!(
            "the law:  {law}\nfound:    {found}\nallowed:  {allowed}\nusually:  {usually}\nread:     {page}"
        )
    }
}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.explained_by(self.usually))
    }
}
