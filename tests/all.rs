//! All tests, in the order in which a mistake is best understood.

mod camera;
mod command_line;
mod slips;
mod pictures;
mod quadratic;
