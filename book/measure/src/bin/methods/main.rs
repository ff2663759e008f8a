//! The commands `needs` and `hit`, which compare the methods of chapter 6. Their program is none of
//! the companion's, which hangs on no chapter.

mod hit;
mod needs;

use std::error::Error;
use std::process::ExitCode;

use launcher::command_line::Words;
use launcher::output;

fn main() -> ExitCode {
    launcher::main(run_command)
}

/// Runs a command that the launcher has handed on, and prints what it says.
fn run_command(words: &Words) -> Result<ExitCode, Box<dyn Error>> {
    let said = match words.command.name() {
        "hit" => hit::hit(words)?,
        "needs" => needs::needs(words)?,
        name => unreachable!("the command {name} is another program's"),
    };
    output::print(&said)?;
    Ok(ExitCode::SUCCESS)
}
