//! The name by which the reader's companion can be called again.

use std::env;

/// `cargo rtrace` if cargo runs the program that asks, in this workspace by an alias and
/// elsewhere as a subcommand; else `rtrace`, which is installed then.
pub fn companion() -> &'static str {
    // Cargo tells all that it runs where cargo is.
    match env::var_os("CARGO") {
        Some(_) => "cargo rtrace",
        None => "rtrace",
    }
}
