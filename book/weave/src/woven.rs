//! The result of a directive or a formula: inline or block, as Markdown has it.

/// What stands in a page in place of what was written.
pub(crate) enum Woven {
    /// Part of a line.
    Inline(String),
    /// Markdown that needs lines of its own.
    Block(String),
}
