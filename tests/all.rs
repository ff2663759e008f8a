//! All tests. A file tests what its name says; each begins by saying how.

mod camera;
mod color;
mod command_line;
mod oracle;
mod pictures;
mod quadratic;
mod slips;
mod speed;
mod stability;
