//! Lowering: from syntax trees to code that runs. Each kind of syntax has one function here, which
//! returns the closure that does what the syntax says.

mod calls;
mod control;
mod expressions;
mod functions;
mod lowerer;
mod macros;
mod patterns;
mod places;

pub(crate) use functions::lower;
