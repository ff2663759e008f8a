//! The judge: is every file read, every mistake known, and every mistake named?

mod answers;
mod blind_spots;
mod caught;
mod causes;
mod mutants;
mod named;
mod pictures;
mod prelude;
mod reading;
mod slips;
mod spoiled;
