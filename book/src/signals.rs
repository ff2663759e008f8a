//! Deferred signals: one that ends us waits until the program that we run has ended.
//!
//! A handler may do next to nothing, so it only raises a flag, which [`check`] looks at.

use std::io;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM};
use signal_hook::{flag, low_level};

/// While this exists, a signal is only noted. When it goes, we end as the signal would
/// have ended us.
pub(crate) struct Deferral(());

impl Deferral {
    /// Defers the signals from now on. There is one at a time.
    pub(crate) fn begin() -> Self {
        // If they can't be caught, they end us as before.
        let _ = *CAUGHT;
        AT_ONCE.store(false, Ordering::SeqCst);
        Self(())
    }
}

impl Drop for Deferral {
    fn drop(&mut self) {
        AT_ONCE.store(true, Ordering::SeqCst);
        let signal = NOTED.load(Ordering::SeqCst);
        if signal != 0 {
            let _ = low_level::emulate_default_handler(signal as i32);
        }
    }
}

/// Whether to go on.
///
/// # Errors
/// If a signal waits to end us.
pub(crate) fn check() -> io::Result<()> {
    match NOTED.load(Ordering::SeqCst) {
        0 => Ok(()),
        // Not `Interrupted`, after which one tries again.
        signal => Err(io::Error::other(format!("stopped by signal {signal}"))),
    }
}

/// Whether a signal ends us at once, as it does if it is not caught.
static AT_ONCE: AtomicBool = AtomicBool::new(true);

/// The signal that came meanwhile, or 0.
static NOTED: AtomicUsize = AtomicUsize::new(0);

/// Catches the signals, once: whether that went well.
static CAUGHT: LazyLock<bool> = LazyLock::new(|| {
    let caught = [SIGHUP, SIGINT, SIGQUIT, SIGTERM].map(|signal| {
        flag::register_conditional_default(signal, &AT_ONCE)
            .and_then(|_| flag::register_usize(signal, &NOTED, signal as usize))
    });
    caught.iter().all(Result::is_ok)
});
