//! How the program is linked.

use std::env;

/// On Linux, for one place in memory.
///
/// A program that may be put anywhere has its addresses adjusted whenever it
/// starts. In this one they are thirty thousand, nearly all in tables of mdBook:
/// as much time as it takes to draw a picture of the book's size.
fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let target = |what: &str| env::var(format!("CARGO_CFG_TARGET_{what}")).unwrap_or_default();
    if target("OS") == "linux" && target("ENV") == "gnu" {
        println!("cargo::rustc-link-arg-bins=-no-pie");
    }
}
