//! The judge: is every file read, every mistake known, and every mistake named?

mod caught;
mod causes;
mod edits;
mod slips;
mod truth;
