//! A reference implementation: the book's five chapters in C++, compiled on demand.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};

/// Compiles a program whose source is a single file, as the book does and optimized with `-O3`,
/// into `folder`. The program is named after its source.
///
/// The compiler is the one that the variable `CXX` names, or else `c++`.
///
/// # Errors
/// If the compiler cannot be started, or cannot compile the program.
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
