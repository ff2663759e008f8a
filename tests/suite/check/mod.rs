//! The judge: are its texts right, is each mistake another program, and is it named?

mod caught;
mod causes;
mod edits;
mod slips;
mod truth;
