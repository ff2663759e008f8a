//! `slips`: lists the known mistakes, and draws one on purpose.

use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use check::names::{self, companion};
use check::png;
use clap::Args;
use clap::builder::TypedValueParser;
use common::engine::output;
use slips::{Chapter, Edition, Letters, Slip, Unseen};

use crate::chapter::named;
use crate::misuse::misuse;
use crate::save::Format;

/// The words behind `cargo rtrace slips`.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Only the mistakes that can be made in this chapter, or the one of that name
    #[arg(value_name = "CHAPTER|NAME", value_parser = which_parser(), hide_possible_values = true)]
    which: Option<Which>,

    /// Draw the mistake: a .png file, or a .ppm file with the numbers that C++ prints.
    /// Some mistakes print 256 or -107, and no viewer shows that
    #[arg(long, short, value_name = "FILE", requires = "which")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy)]
enum Which {
    Of(Chapter),
    One(&'static Slip),
}

/// Lists the catalogue, or draws one of its mistakes.
pub(crate) fn slips(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let said = match (arguments.which, &arguments.output) {
        (which, None) => list(which),
        (Some(Which::One(slip)), Some(file)) => draw(slip, file)?,
        _ => return Err(misuse("one mistake is drawn at a time: name it")),
    };
    Ok(output::to_stdout(|out| out.write_all(said.as_bytes()))?)
}

fn list(which: Option<Which>) -> String {
    let chapter = match which {
        Some(Which::Of(chapter)) => Some(chapter),
        _ => None,
    };
    let is_meant = |slip: &&Slip| match which {
        None => true,
        Some(Which::Of(chapter)) => slip.chapters.contains(&chapter),
        Some(Which::One(one)) => slip.name == one.name,
    };
    let listed: Vec<String> = slips::all()
        .filter(is_meant)
        .map(|slip| entry(slip, chapter))
        .collect();
    let count = match listed.len() {
        1 => "1 mistake".to_owned(),
        count => format!("{count} mistakes"),
    };
    let companion = companion();
    listed.concat() + &format!("{count}. To see one: {companion} slips NAME --output FILE\n")
}

/// What there is to say of a mistake, in this chapter or in any.
fn entry(slip: &Slip, chapter: Option<Chapter>) -> String {
    let mut text = format!("{}\n", slip.name);
    let letters = Letters::Book(Edition::V4);
    for (label, said) in slip.rows(letters, chapter.unwrap_or(slip.chapters[0])) {
        let _ = writeln!(text, "  {label:<9}  {said}");
    }
    match chapter.and_then(|chapter| slip.unseen_in(chapter)) {
        Some(Unseen::Equivalent(why)) => text += &format!("  unseen     {why}\n"),
        Some(Unseen::OnlyByLaw(law)) => {
            text += &format!("  unseen     Only a law shows it: {law}\n");
        }
        None => {}
    }
    text + "\n"
}

/// Draws it in the first chapter whose picture shows it.
fn draw(slip: &Slip, file: &Path) -> Result<String, Box<dyn Error>> {
    /// Wide enough to see it, and odd, so that a height that is not rounded
    /// down shows as well.
    const WIDTH: u32 = 101;
    let is_seen = |chapter: &&Chapter| {
        let wrong = slip.program(**chapter).run(WIDTH);
        wrong.picture() != chapter.picture(WIDTH)
    };
    let seen = slip.chapters.iter().find(is_seen);
    let chapter = *seen.unwrap_or(&slip.chapters[0]);
    let drawn = slip.program(chapter).run(chapter.book_width());
    match Format::of(file) {
        Some(Format::Ppm) => output::to_file(file, |out| write!(out, "{drawn}"))?,
        Some(Format::Png) => {
            let bytes = png::encode(&drawn.picture());
            output::to_file(file, |out| out.write_all(&bytes))?;
        }
        None => return Err(misuse("the name of the file must end in .png or .ppm")),
    }
    let (columns, rows) = drawn.size();
    Ok(format!(
        "{} in {}: {columns} × {rows} pixels in {}\n",
        slip.name,
        chapter.name(),
        names::spelled(file)
    ))
}

fn which_parser() -> impl TypedValueParser<Value = Which> {
    let chapters = Chapter::OF_THE_BOOK.map(|chapter| (chapter.name(), Which::Of(chapter)));
    let slips = slips::all().map(|slip| (slip.name, Which::One(slip)));
    named(chapters.into_iter().chain(slips))
}
