//! `cargo rtrace` outside of the workspace: cargo starts what is named `cargo-rtrace`,
//! and this starts the `rtrace` that was installed beside it.
//!
//! Inside the workspace the alias `rtrace` goes first, so that a reader who has installed
//! nothing can type the same, and one who has sees what the sources are now. Cargo then
//! warns, in three lines, that the alias shadows this program. To be rid of that, leave
//! this program out: `cargo install --path book --bin rtrace`.

use std::env;
use std::io;
use std::process::{Command, ExitCode};

fn main() -> ExitCode {
    match rtrace().and_then(run) {
        Ok(code) => code,
        Err(cause) => {
            eprintln!("cargo-rtrace: the rtrace beside it does not start: {cause}");
            ExitCode::FAILURE
        }
    }
}

/// The program beside this one, with the arguments that follow `rtrace`: that is what
/// cargo puts first.
fn rtrace() -> io::Result<Command> {
    let mut arguments = env::args_os().skip(1).peekable();
    arguments.next_if(|first| first == "rtrace");
    let mut command = Command::new(env::current_exe()?.with_file_name("rtrace"));
    command.args(arguments);
    Ok(command)
}

/// Becomes that program, so that signals reach nobody else.
#[cfg(unix)]
fn run(mut rtrace: Command) -> io::Result<ExitCode> {
    Err(std::os::unix::process::CommandExt::exec(&mut rtrace))
}

#[cfg(not(unix))]
fn run(mut rtrace: Command) -> io::Result<ExitCode> {
    let code = rtrace
        .status()?
        .code()
        .and_then(|code| u8::try_from(code).ok());
    Ok(code.map_or(ExitCode::FAILURE, ExitCode::from))
}
