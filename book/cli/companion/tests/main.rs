//! The companion: what does each command do with good input and bad?

mod anywhere;
#[cfg(unix)]
mod broken_off;
mod check_command;
mod command_line;
mod commands;
mod compiler;
#[cfg(unix)]
mod hostile;
mod laws_command;
mod repairs;
mod start;
#[cfg(unix)]
mod stops;
#[cfg(unix)]
mod terminal;
mod typed;
#[cfg(unix)]
mod watch;
