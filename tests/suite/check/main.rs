//! The judge: is every file read, every mistake known, and every mistake named?

mod answers;
mod caught;
mod causes;
mod prelude;
mod slips;
