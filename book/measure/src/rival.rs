//! A reference implementation: the book's five chapters in C++, compiled on demand.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};

/// Compiles a C++ program of a single source with `-O3` into `folder`, which is made if it is
/// missing, and returns the path of the program, named after its source. The variable `CXX` names
/// the compiler; without it, that is `c++`.
///
/// # Errors
/// If the compiler can't be started, or refuses the program: then with the compiler's messages.
pub fn compile(source: &Path, folder: &Path) -> io::Result<PathBuf> {
    let name = source.file_stem().unwrap_or_default();
    let compiler = env::var_os("CXX").unwrap_or_else(|| "c++".into());
    fs::create_dir_all(folder)?;
    let program = folder.join(name).with_extension(env::consts::EXE_EXTENSION);
    let compiled = Command::new(&compiler)
        .args(["-std=c++17", "-O3", "-o"])
        .args([program.as_os_str(), source.as_os_str()])
        .output()
        .map_err(|cause| {
            io::Error::new(cause.kind(), format!("{}: {cause}", compiler.display()))
        })?;
    if !compiled.status.success() {
        let said = String::from_utf8_lossy(&compiled.stderr).into_owned();
        return Err(io::Error::other(said));
    }
    Ok(program)
}
