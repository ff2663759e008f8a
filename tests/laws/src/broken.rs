//! A broken law, in words that teach.

use std::fmt;

/// Whether a law holds, and if not, how it is broken.
pub type Verdict = Result<(), Broken>;

/// A law that does not hold. In a test by proptest, `?` makes it the reason of the failure.
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

impl std::error::Error for Broken {}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            law,
            found,
            allowed,
            usually,
            page,
        } = self;
        write!(
            f,
            "the law:  {law}\nfound:    {found}\nallowed:  {allowed}\nusually:  {usually}\nread:     {page}"
        )
    }
}
