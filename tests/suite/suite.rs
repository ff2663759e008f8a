//! What stands on right chapters: cargo runs it once the tests of the program
//! `chapters` pass. A file tests what its name says; each begins by saying how.

mod anywhere;
mod bank;
mod bibliography;
mod blind_spots;
mod book;
mod browser;
mod camera;
mod campaign;
mod caught;
mod causes;
mod changes;
mod charts;
mod check;
mod check_command;
mod command_line;
mod compiler;
mod cpp_to_rust;
mod details;
mod drawn;
mod editions;
mod errata;
#[cfg(unix)]
mod faults;
mod figures;
mod folders;
mod hit_command;
mod leaving;
mod left_out;
mod lesson;
mod live;
mod measured;
mod methods;
mod nearest;
mod needs_command;
mod oracle;
mod pictures;
mod proofs;
mod reading;
mod shadow;
mod slips;
mod speed;
mod speed_vs_accuracy;
mod spoiled;
mod stability;
mod start;
#[cfg(unix)]
mod terminal;
mod told;
mod typed;
#[cfg(unix)]
mod watch;
mod weave;
mod witnesses;

/// The answers to the exercises of the book, which shows them.
mod exercises {
    mod build_test;
    mod gradient;
    mod half_b_sphere;
    mod hittable_list;
    mod normals;
    mod red_sphere;
    mod speed_vs_accuracy;
}
