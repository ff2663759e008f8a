//! The real programs, with good and bad input.
