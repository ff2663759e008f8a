//! The judge: is every file read, and every mistake that is named the one that was made?

mod any_language;
mod blind_spots;
mod drawn;
mod pictures;
mod reading;
mod rules;
mod spoiled;
mod typed;
mod unwritten;
