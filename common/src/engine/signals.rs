//! Deferred signals: one that ends the program waits until a file is tidied away, or a
//! program that it runs has ended.
//!
//! A handler may do next to nothing, least of all remove a file. Here it only
//! raises a flag, which whoever writes the file looks at. This takes no thread,
//! and nothing at all in a program that writes no file and runs no program.

use std::fs;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{LazyLock, Mutex, PoisonError};
use std::{io, process};

use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
use signal_hook::{flag, low_level};

/// While one of these exists, a signal is only noted. When the last one goes,
/// the program ends as the signal would have ended it.
///
/// A second signal changes nothing: `timeout`, and a terminal that is closed, send
/// two of them at once. So whoever defers must look often, with [`check`].
pub struct Deferral(());

impl Deferral {
    /// Defers the signals from now on.
    #[expect(clippy::new_without_default, reason = "it is not a value, but a time")]
    pub fn new() -> Self {
        // If they can't be caught, they end the program as before.
        let _ = *CAUGHT;
        let mut deferrals = DEFERRALS.lock().unwrap_or_else(PoisonError::into_inner);
        if *deferrals == 0 {
            AT_ONCE.store(false, Ordering::SeqCst);
        }
        *deferrals += 1;
        Self(())
    }
}

impl Drop for Deferral {
    fn drop(&mut self) {
        let mut deferrals = DEFERRALS.lock().unwrap_or_else(PoisonError::into_inner);
        *deferrals -= 1;
        if *deferrals == 0 {
            AT_ONCE.store(true, Ordering::SeqCst);
            end_if_noted();
        }
    }
}

/// Whether to go on.
///
/// # Errors
/// If a signal waits to end the program.
pub fn check() -> io::Result<()> {
    match NOTED.load(Ordering::SeqCst) {
        0 => Ok(()),
        // Not `Interrupted`, after which one tries again.
        signal => Err(io::Error::other(format!("stopped by signal {signal}"))),
    }
}

/// Whether a signal ends the program at once, as it does if it is not caught.
static AT_ONCE: AtomicBool = AtomicBool::new(true);

/// The signal that came meanwhile, or 0.
static NOTED: AtomicUsize = AtomicUsize::new(0);

static DEFERRALS: Mutex<usize> = Mutex::new(0);

/// Catches the signals, once: whether that went well.
static CAUGHT: LazyLock<bool> = LazyLock::new(|| {
    let ignored = ignored();
    [SIGHUP, SIGINT, SIGTERM]
        .into_iter()
        .filter(|signal| ignored >> (signal - 1) & 1 == 0)
        .try_for_each(|signal| {
            flag::register_conditional_default(signal, &AT_ONCE)?;
            flag::register_usize(signal, &NOTED, signal as usize).map(drop)
        })
        .is_ok()
});

/// A bit for each signal that the program was started to ignore, as `nohup` does:
/// these are to stay ignored.
fn ignored() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status
        .lines()
        .find_map(|line| line.strip_prefix("SigIgn:"))
        .and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    // Only Linux says. Elsewhere `nohup` matters more than what it leaves behind.
    mask.unwrap_or(1 << (SIGHUP - 1))
}

fn end_if_noted() {
    let signal = NOTED.load(Ordering::SeqCst) as i32;
    if signal == 0 {
        return;
    }
    if process::id() == 1 {
        // The first process of a container can't end itself by a signal.
        process::exit(128 + signal);
    }
    let _ = low_level::emulate_default_handler(signal);
}
