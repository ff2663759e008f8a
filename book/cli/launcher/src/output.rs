//! Atomic replacement: a file is written beside its place, and renamed when it is whole.
//!
//! One would use this wherever half a file is worse than an old one. An interrupted
//! program leaves the file as it was, and at most a `.NAME.….partial` to delete.

use std::fs::{self, File, OpenOptions, Permissions};
use std::hash::{BuildHasher, Hasher, RandomState};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Writes to standard output by calling `write`.
///
/// A reader that has seen enough and closes the pipe, as `head` does, is no error.
///
/// # Errors
/// Any other failure to write, such as a full disk behind `>`, with the fix.
pub fn to_stdout(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut stdout = BufWriter::new(io::stdout().lock());
    match write(&mut stdout).and_then(|()| stdout.flush()) {
        Err(cause) if cause.kind() == ErrorKind::BrokenPipe => Ok(()),
        written => written.map_err(|cause| named("standard output", &cause)),
    }
}

/// Prints `text` to standard output, as [`to_stdout`] does.
///
/// # Errors
/// As those of [`to_stdout`].
pub fn print(text: &str) -> io::Result<()> {
    to_stdout(|out| out.write_all(text.as_bytes()))
}

/// Writes the file at `path` by calling `write`. Afterwards the file is complete, or, after an
/// error, as it was.
///
/// A file that is replaced hands on its permissions; a link to it stays a link.
///
/// # Errors
/// Any failure to create, write or rename the file, with its name and the fix.
pub fn to_file(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let written = match fs::metadata(path) {
        Ok(old) if old.permissions().readonly() => Err(ErrorKind::PermissionDenied.into()),
        Ok(old) if old.is_file() => fs::canonicalize(path)
            .and_then(|target| replace(&target, Some(old.permissions()), write)),
        // Into a device or a pipe one writes. To open a folder is an error.
        Ok(_) => OpenOptions::new()
            .write(true)
            .open(path)
            .and_then(|device| fill(&device, write)),
        Err(cause) if path.is_symlink() => Err(cause),
        Err(_) => replace(path, None, write),
    };
    // As `Debug` has it, a terminal can only show the name, not obey it.
    written.map_err(|cause| named(&format!("{path:?}"), &cause))
}

/// Returns a path beside `target` for a file to be written and then renamed to `target`. Its name
/// has a random number, so nothing else has it.
///
/// # Errors
/// If `target` ends in `..` or is a root, and so has no name.
pub fn partial(target: &Path) -> io::Result<PathBuf> {
    let name = target.file_name().ok_or(ErrorKind::InvalidInput)?;
    Ok(target.with_file_name(format!(".{}.{:016x}.partial", name.display(), random())))
}

/// Returns a random number, for a name that nothing else has.
pub fn random() -> u64 {
    // The standard library asks the system for one to seed its hash tables.
    RandomState::new().build_hasher().finish()
}

/// Deletes the partial files and folders that interrupted programs have left beside `target`; one
/// that cannot be deleted stays.
pub fn forget_partials(target: &Path) {
    let is_partial = |path: &PathBuf| {
        let [name, own] =
            [path, target].map(|it| it.file_name().unwrap_or_default().to_string_lossy());
        let random = name.strip_prefix(&format!(".{own}."));
        let random = random.and_then(|it| it.strip_suffix(".partial"));
        random.is_some_and(|it| it.len() == 16 && u64::from_str_radix(it, 16).is_ok())
    };
    let folder = target.parent().filter(|it| !it.as_os_str().is_empty());
    let entries = fs::read_dir(folder.unwrap_or(Path::new(".")))
        .into_iter()
        .flatten();
    for path in entries.flatten().map(|it| it.path()).filter(is_partial) {
        // Of these two, one fits. Where neither can, it stays.
        let _ = fs::remove_file(&path).or_else(|_| fs::remove_dir_all(&path));
    }
}

fn replace(
    target: &Path,
    permissions: Option<Permissions>,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let partial = partial(target)?;
    let file = File::create_new(&partial)?;
    let done = permissions
        // Before anything is in it that is for nobody else's eyes.
        .map_or(Ok(()), |permissions| file.set_permissions(permissions))
        .and_then(|()| fill(&file, write))
        .and_then(|()| fs::rename(&partial, target));
    if done.is_err() {
        // The first failure is the one to report, whether or not this works.
        let _ = fs::remove_file(&partial);
    }
    done
}

fn fill(file: &File, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 16, file);
    write(&mut out)?;
    out.flush()
}

/// Returns an error that names the place that could not be written, and says what helps.
fn named(place: &str, cause: &io::Error) -> io::Error {
    let advice = when_full(cause).unwrap_or(if cfg!(windows) {
        // There nothing takes the place of what is open.
        "Name a file that you may write and that no program has open, in a folder that is there."
    } else {
        "Name a file that you may write, in a folder that is there."
    });
    let problem = format!("cannot write {place}: {cause}\n{advice}");
    io::Error::new(cause.kind(), problem)
}

/// Returns what helps if the disk is full; `None` for any other failure.
pub fn when_full(cause: &io::Error) -> Option<&'static str> {
    let is_full = matches!(
        cause.kind(),
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded
    );
    is_full.then_some("Free some space, or write to another disk.")
}
