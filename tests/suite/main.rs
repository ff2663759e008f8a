//! What stands on right chapters, and spans packages. Cargo runs this program after `chapters`, and
//! only if that passes.

mod book;
mod check;
mod methods;
mod promises;
