//! The command line of both programs, stated once: it is generic over the types that hold
//! the arguments of the companion's commands.

use clap::{Args, Parser, Subcommand};
use course::names::companion_command;

use crate::{book, show};

/// The pictures of Ray Tracing in One Weekend, chapter by chapter.
///
/// Without a command: draws all of them into target/pictures, as PNG and as
/// PPM files, and weaves the book into target/book.
#[derive(Parser)]
#[command(name = "rtrace", bin_name = companion_command())]
pub struct CommandLine<C: ArgumentTypes> {
    /// The command with its arguments; `None` if the reader has named no command.
    #[command(subcommand)]
    pub command: Option<Command<C>>,
}

/// The types that hold the arguments of the companion's commands. The companion has one for each
/// command; the launcher hands all arguments on without reading them.
pub trait ArgumentTypes {
    /// The arguments of `check`.
    type Check: Args;
    /// The arguments of `start`.
    type Start: Args;
    /// The arguments of `watch`.
    type Watch: Args;
    /// The arguments of `laws`.
    type Laws: Args;
    /// The arguments of `done`.
    type Done: Args;
    /// The arguments of `hit`.
    type Hit: Args;
    /// The arguments of `needs`.
    type Needs: Args;
    /// The arguments of `probes`.
    type Probes: Args;
}

/// A command of `cargo rtrace`, with its arguments.
#[derive(Subcommand)]
pub enum Command<C: ArgumentTypes> {
    /// Weave the book: the notes with the code, the pictures and the figures
    Book(book::Arguments),
    /// Draw one picture: in the terminal, into a file, or into a viewer
    Show(show::Arguments),
    /// Check your own picture, and learn which mistake draws it
    Check(C::Check),
    /// Make a crate of your own for a chapter, ready to be typed into
    Start(C::Start),
    /// Judge your crate or program whenever you save it
    Watch(C::Watch),
    /// Put a function of any program, in any language, under the laws
    Laws(C::Laws),
    /// Show the list of what you have done, or add a line to it
    Done(C::Done),
    /// Look at one ray and one sphere through every method of chapter 6
    Hit(C::Hit),
    /// Find the cheapest method of chapter 6 that draws a scene of your own right
    Needs(C::Needs),
    /// List the small scenes that show what the book's picture can't
    Probes(C::Probes),
}
