//! A picture with its verdict: what text, JSON and the page tell.

use check::diagnosis::Scene;
use check::judge::Check;

use super::input::Source;

/// A picture after it has been judged.
pub(crate) struct Judged<'a> {
    /// What it should show.
    pub(crate) scene: Scene,
    /// Where it came from.
    pub(crate) source: Source<'a>,
    /// What was found.
    pub(crate) check: Check,
}
