//! What judges a picture, ours or a reader's.
//!
//! In the order in which a file passes through it: [`reading`] makes a picture of
//! bytes that may be anything, [`judge`] compares it with the right one by
//! [`comparison`], [`diagnosis`] looks for the mistake among the known slips (package `slips`),
//! and [`report`] shows both pictures on a page. If it is right, [`blind_spots`] says
//! what it can't show.

pub mod blind_spots;
pub mod comparison;
pub mod diagnosis;
pub mod judge;
pub mod names;
pub mod png;
pub mod reading;
pub mod report;
pub mod workspace;
