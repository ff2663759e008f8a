//! `slips`: lists the known mistakes, and draws them on purpose.

use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;

use check::names::{self, companion};
use check::png;
use check::scene::Scene;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Subcommand, value_parser};
use common::engine::output;
use slips::Chapter;
use slips::{self, Edition, Letters, Slip, Unseen};

use crate::chapter::OneOf;
use crate::misuse::misuse;
use crate::save::Format;

/// What `cargo rtrace slips` is told.
#[derive(Args)]
#[command(args_conflicts_with_subcommands = true)]
pub(crate) struct Arguments {
    /// Only the mistakes that can be made in this chapter, or the one of that name
    #[arg(value_name = "CHAPTER|NAME", value_parser = which_parser(), hide_possible_values = true)]
    which: Option<Which>,

    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Clone, Copy)]
enum Which {
    Of(Chapter),
    One(&'static Slip),
}

#[derive(Subcommand)]
enum Command {
    /// Draw the wrong picture that a mistake makes
    Draw(Draw),
}

#[derive(Args)]
struct Draw {
    /// Which mistake
    #[arg(value_name = "NAME", value_parser = slip_parser(), hide_possible_values = true)]
    slip: &'static Slip,

    /// The chapter [default: the first one whose picture shows the mistake]
    #[arg(long, value_parser = OneOf(&Chapter::OF_THE_BOOK))]
    chapter: Option<Chapter>,

    /// Width in pixels [default: as in the book]
    #[arg(long, value_name = "N", value_parser = value_parser!(u32).range(1..=WIDEST))]
    width: Option<u32>,

    /// A .png file, or a .ppm file with the numbers that C++ prints: some
    /// mistakes print 256 or -107, and no viewer shows that
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,
}

/// The widest wrong picture, in pixels: some of them are higher than wide.
const WIDEST: i64 = 4096;

/// Lists the catalogue, or draws one of its mistakes.
pub(crate) fn slips(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    match &arguments.command {
        None => list(arguments.which),
        Some(Command::Draw(arguments)) => draw(arguments),
    }
}

fn list(which: Option<Which>) -> Result<(), Box<dyn Error>> {
    let mut text = String::new();
    let chapter = match which {
        Some(Which::Of(chapter)) => Some(chapter),
        _ => None,
    };
    let can_be_made = |slip: &&Slip| match which {
        None => true,
        Some(Which::Of(chapter)) => slip.chapters.contains(&chapter),
        Some(Which::One(one)) => slip.name == one.name,
    };
    for slip in slips::all().filter(can_be_made) {
        writeln!(text, "{}", slip.name)?;
        for (label, said) in slip.rows(
            Letters::Book(Edition::V4),
            chapter.unwrap_or(slip.chapters[0]),
        ) {
            writeln!(text, "  {label:<9}  {said}")?;
        }
        match chapter.and_then(|chapter| slip.unseen_in(chapter)) {
            Some(Unseen::Equivalent(why)) => text += &format!("  unseen     {why}\n"),
            Some(Unseen::OnlyByLaw(law)) => {
                text += &format!("  unseen     Only a law shows it: {law}\n");
            }
            None => {}
        }
        text.push('\n');
    }
    let count = match slips::all().filter(can_be_made).count() {
        1 => "1 mistake".to_owned(),
        count => format!("{count} mistakes"),
    };
    writeln!(
        text,
        "{count}. To see one: {} slips draw NAME --output FILE",
        companion()
    )?;
    Ok(output::to_stdout(|out| out.write_all(text.as_bytes()))?)
}

fn draw(arguments: &Draw) -> Result<(), Box<dyn Error>> {
    let slip = arguments.slip;
    let chapter = arguments.chapter.unwrap_or_else(|| first_seen(slip));
    if !slip.chapters.contains(&chapter) {
        return Err(misuse(&format!(
            "that mistake can't be made in that chapter: `{} slips CHAPTER` lists those that can",
            companion()
        )));
    }
    let width = arguments.width.unwrap_or(chapter.book_width());
    let drawn = slip.program(chapter).run(width);
    let path = &arguments.output;
    let (columns, rows) = drawn.size();
    match Format::of(path) {
        Some(Format::Ppm) => output::to_file(path, |out| write!(out, "{drawn}"))?,
        Some(Format::Png) if columns == 0 || rows == 0 => {
            return Err(misuse(
                "this mistake leaves no pixel at that width, and a PNG needs one: choose a .ppm file",
            ));
        }
        Some(Format::Png) => {
            let bytes = png::encode(&drawn.picture());
            output::to_file(path, |out| out.write_all(&bytes))?;
        }
        None => return Err(misuse("the name of the file must end in .png or .ppm")),
    }
    let said = format!(
        "{} in {}: {columns} × {rows} pixels in {}\n",
        slip.name,
        chapter.name(),
        names::spelled(path)
    );
    Ok(output::to_stdout(|out| out.write_all(said.as_bytes()))?)
}

/// The first chapter whose picture shows the mistake, or else the first in which
/// it can be made.
fn first_seen(slip: &Slip) -> Chapter {
    /// Wide enough to see it, and odd, so that a height that is not rounded
    /// down shows as well.
    const WIDTH: u32 = 101;
    let shows = |chapter: &&Chapter| {
        let right =
            Scene::new(**chapter, None).map(|scene| scene.program(&[]).run(WIDTH).picture());
        right.is_some_and(|right| right != slip.program(**chapter).run(WIDTH).picture())
    };
    *slip
        .chapters
        .iter()
        .find(shows)
        .unwrap_or(&slip.chapters[0])
}

fn which_parser() -> impl TypedValueParser<Value = Which> {
    let chapters = Chapter::OF_THE_BOOK.map(Chapter::name);
    let names = chapters
        .into_iter()
        .chain(slips::all().map(|slip| slip.name));
    PossibleValuesParser::new(names).map(|name| match Chapter::find(&name) {
        Some(chapter) => Which::Of(chapter),
        None => Which::One(slips::find(&name).expect("only names of slips are left")),
    })
}

fn slip_parser() -> impl TypedValueParser<Value = &'static Slip> {
    PossibleValuesParser::new(slips::all().map(|slip| slip.name))
        .map(|name| slips::find(&name).expect("only names of slips are accepted"))
}
