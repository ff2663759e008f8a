//! A pseudo-terminal: what a program shows to somebody who sits before it.

use std::ffi::OsString;
use std::fs::File;
use std::os::fd::OwnedFd;
use std::process::Command;

use rustix::fs::{Mode, OFlags};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{Winsize, tcsetwinsize};

/// A terminal of 80 columns and 24 lines: what it shows can be read from the first end,
/// and a program writes to the second.
pub(crate) fn open() -> (File, OwnedFd) {
    let controller = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).expect("a terminal");
    grantpt(&controller).expect("access to the terminal");
    unlockpt(&controller).expect("the terminal is unlocked");
    let name = ptsname(&controller, Vec::new()).expect("the terminal has a name");
    let terminal = rustix::fs::open(name, OFlags::RDWR | OFlags::NOCTTY, Mode::empty())
        .expect("the terminal opens");
    let size = Winsize {
        ws_row: 24,
        ws_col: 80,
        ws_xpixel: 0,
        ws_ypixel: 0,
    };
    tcsetwinsize(&terminal, size).expect("the terminal has a size");
    (File::from(controller), terminal)
}

/// Takes nothing from whoever runs the tests that says which colors a terminal has.
pub(crate) fn forget_ours(command: &mut Command) {
    let said: Vec<OsString> = command.get_envs().map(|(name, _)| name.into()).collect();
    for name in ["COLORTERM", "NO_COLOR", "FORCE_COLOR", "CI"] {
        if !said.iter().any(|said| said == name) {
            command.env_remove(name);
        }
    }
    if !said.iter().any(|said| said == "TERM") {
        command.env("TERM", "xterm-256color");
    }
}
