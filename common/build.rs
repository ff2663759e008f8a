//! How programs are linked.

use std::env;
use std::path::Path;
use std::process::Command;

/// On Linux, with the unwinder in the program.
///
/// Rust's library asks for a shared library of GCC's, in case a program panics. To
/// find and load it at each start takes a twentieth of the time of a picture of the
/// book's size. GCC brings the same code to be linked into the program.
fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let target = |what: &str| env::var(format!("CARGO_CFG_TARGET_{what}")).unwrap_or_default();
    if target("OS") == "linux" && target("ENV") == "gnu" && linker_finds("libgcc_eh.a") {
        println!("cargo::rustc-link-lib=static:-bundle=gcc_eh");
    }
}

/// Whether the linker knows where `library` is: it says the whole path then.
fn linker_finds(library: &str) -> bool {
    let linker = env::var_os("RUSTC_LINKER").unwrap_or_else(|| "cc".into());
    Command::new(linker)
        .arg(format!("-print-file-name={library}"))
        .output()
        .is_ok_and(|said| Path::new(&*String::from_utf8_lossy(&said.stdout)).is_absolute())
}
