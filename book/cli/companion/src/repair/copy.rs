//! The copy of a crate in which all edits are alternatives: one folder below `target`, which a run
//! writes anew.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::thread;
use std::time::Duration;

use toml::{Table, Value};

use super::own_crate::OwnCrate;

/// The time between two looks whether another search of the crate has ended.
const LOOK: Duration = Duration::from_millis(20);

/// The folders of a search. While this lives, no other search of the same crate begins.
pub(super) struct Copy {
    /// The folder of the copy.
    pub(super) folder: PathBuf,
    /// The folder in which cargo builds the reader's crates, and the copy.
    pub(super) target: PathBuf,
    /// An empty folder, in which the program runs.
    pub(super) empty: PathBuf,
    _lock: File,
}

impl Copy {
    /// Makes the copy of a crate beside `program`, its own, but for the files below `src`.
    ///
    /// # Errors
    /// If it can't be written, or `stop` is set while another search of this crate runs.
    pub(super) fn make(own: &OwnCrate, program: &Path, stop: &AtomicBool) -> io::Result<Self> {
        // Cargo keeps there what it knows of its compiler.
        let is_target = |it: &&Path| it.join(".rustc_info.json").is_file();
        let target = program.ancestors().find(is_target);
        let target = target.ok_or_else(|| io::Error::other("there is no folder of builds"))?;
        let name = unique_name(own);
        let folder = target.join("repair").join(&name);
        fs::create_dir_all(&folder)?;
        let lock = File::create(folder.join("lock"))?;
        // The search before this one may still be ending.
        while let Err(cause) = lock.try_lock() {
            match cause {
                TryLockError::WouldBlock if !stop.load(Relaxed) => thread::sleep(LOOK),
                cause => return Err(cause.into()),
            }
        }
        let copy = Self {
            target: target.to_owned(),
            empty: folder.join("empty"),
            folder,
            _lock: lock,
        };
        for part in ["src", "tests", "empty"] {
            let part = copy.folder.join(part);
            if part.exists() {
                fs::remove_dir_all(&part)?;
            }
        }
        fs::create_dir_all(&copy.empty)?;
        copy.write("Cargo.toml", &manifest(own, &name).to_string())?;
        let lock = fs::read(own.folder.join("Cargo.lock")).unwrap_or_default();
        fs::write(copy.folder.join("Cargo.lock"), lock)?;
        if !own.laws.is_empty() {
            copy.write("tests/laws.rs", &own.laws)?;
        }
        Ok(copy)
    }

    /// Writes one file of the copy.
    ///
    /// # Errors
    /// If that fails.
    pub(super) fn write(&self, name: &str, text: &str) -> io::Result<()> {
        let path = self.folder.join(name);
        fs::create_dir_all(path.parent().expect("a file is in a folder"))?;
        fs::write(path, text)
    }
}

/// Returns a name for the copy's package that no other crate's has, so that no program is written
/// over the reader's.
fn unique_name(own: &OwnCrate) -> String {
    let folder = own
        .folder
        .canonicalize()
        .unwrap_or_else(|_| own.folder.clone());
    // FNV-1a: any number that is the same for the same folder serves.
    let bytes = folder.as_os_str().as_encoded_bytes().iter();
    let number = bytes.fold(0xcbf2_9ce4_8422_2325, |number: u64, byte| {
        (number ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    });
    format!("repair_{number:016x}")
}

/// Returns the manifest of the copy: the package and its programs have other names, and the library
/// has the name by which they use it.
fn manifest(own: &OwnCrate, name: &str) -> Table {
    let mut new = own.manifest.clone();
    new.remove("lints");
    let table = |it: &mut Value| it.as_table_mut().map(std::mem::take).unwrap_or_default();
    let mut package = new.get_mut("package").map(table).unwrap_or_default();
    let old = package
        .get("name")
        .and_then(Value::as_str)
        .unwrap_or(name)
        .to_owned();
    package.insert("name".to_owned(), name.into());
    package.remove("default-run");
    package.remove("readme");
    new.insert("package".to_owned(), package.into());
    if own.files.iter().any(|it| it.0 == "src/lib.rs") {
        let mut library = new.get_mut("lib").map(table).unwrap_or_default();
        let name = || old.replace('-', "_").into();
        library.entry("name").or_insert_with(name);
        new.insert("lib".to_owned(), library.into());
    }
    let programs = new.get_mut("bin").and_then(Value::as_array_mut);
    for (n, program) in programs.into_iter().flatten().enumerate() {
        if let Some(program) = program.as_table_mut() {
            program.insert("name".to_owned(), format!("{name}_{n}").into());
        }
    }
    new.entry("workspace")
        .or_insert_with(|| Table::new().into());
    new
}
