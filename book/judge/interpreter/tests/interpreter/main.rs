//! The interpreter: does it run what is typed as the compiler does, and stop what takes too much?

mod compiled;
mod limits;
