//! Pictures of slips and of editions, drawn while the book is woven.

use std::sync::LazyLock;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use check::png;
use common::rtweekend::Picture;
use slips::{Chapter, Edition, Letters, Sight, Slip, Unseen, Words};

use crate::ground::escaped;

/// The picture that a slip draws in a chapter, with the name of both below it.
pub(crate) fn slip(name: &str, chapter: &str) -> Result<String, String> {
    let slip = slips::find(name).ok_or_else(|| format!("there is no slip `{name}`"))?;
    let chapter = Chapter::find(chapter)
        .filter(|chapter| slip.chapters.contains(chapter))
        .ok_or_else(|| format!("`{name}` can't be made in a chapter `{chapter}`"))?;
    let picture = slip.program(chapter).run(chapter.book_width()).picture();
    let why = slip.words(Letters::Book(Edition::V4), chapter).why;
    Ok(format!(
        "<figure>{}<figcaption><a href=\"slips.html\">{name}</a> in <code>{}</code></figcaption></figure>",
        image(&picture, &format!("What {name} draws: {why}")),
        chapter.name()
    ))
}

/// What each edition of the book draws, and by what it differs.
pub(crate) fn editions() -> String {
    // To see the two programs of version 1 apart takes a comparison of bits.
    let mut editions = Edition::ALL.to_vec();
    editions.retain(|edition| *edition != Edition::V1InDouble);
    editions.sort();
    editions.into_iter().map(one_edition).collect()
}

fn one_edition(edition: Edition) -> String {
    let chapters = [Chapter::BuildTest, Chapter::Normals, Chapter::HittableList];
    let pictures = chapters.map(|chapter| {
        let picture = edition.program(chapter).run(EDITION_WIDTH).picture();
        image(&picture, &format!("{} by {edition}", chapter.name()))
    });
    let differs = match edition {
        Edition::V4 => String::new(),
        older => format!(": {}", older.differs_by().join("; in the build test ")),
    };
    format!(
        "<figure class=\"edition\">{}<figcaption><b>{edition}</b>{differs}</figcaption></figure>\n\n",
        pictures.concat()
    )
}

/// How wide the pictures of editions are, in pixels.
const EDITION_WIDTH: u32 = 144;

/// The slips of this look with their pictures; or those that draw the right picture wherever
/// they are made.
pub(crate) fn gallery(look: &str) -> Result<String, String> {
    static SIGHTS: LazyLock<Vec<Sight>> = LazyLock::new(slips::sights);
    if look == "Right" {
        let seen = SIGHTS.iter().flat_map(|sight| &sight.slips);
        let seen: Vec<&str> = seen.map(|slip| slip.name).collect();
        let unseen = slips::all().filter(|slip| !seen.contains(&slip.name));
        return Ok(unseen
            .map(|slip| format!("{} {}\n", item(slip), shown_by(slip)))
            .collect());
    }
    let has_look = |sight: &&Sight| format!("{:?}", sight.look) == look;
    let tiles: String = SIGHTS.iter().filter(has_look).map(tile).collect();
    if tiles.is_empty() {
        return Err(format!("no slip has the look `{look}`"));
    }
    Ok(tiles)
}

/// A picture, and beside it the slips that draw it.
fn tile(sight: &Sight) -> String {
    let chapter = sight.chapter.name();
    let names: Vec<&str> = sight.slips.iter().map(|slip| slip.name).collect();
    let alt = format!("What {} draws in {chapter}", names.join(", "));
    let items: String = sight.slips.iter().map(|slip| item(slip) + "\n").collect();
    format!(
        "<div class=\"slip\">\n<figure>{}<figcaption>{chapter}</figcaption></figure>\n<div>\n\n{items}\n</div>\n</div>\n\n",
        image(&sight.picture, &alt)
    )
}

/// The slip in words, as an item of a list.
fn item(slip: &Slip) -> String {
    let name = slip.name;
    let Words { wrong, right, why } = slip.words(Letters::Book(Edition::V4), slip.chapters[0]);
    let (page, heading) = slip.page_and_heading();
    format!(
        "* **[{name}](caught.md#{name})** · `{wrong}` should be `{right}`. {why} See [{page}]({page}.md#{heading})."
    )
}

/// What shows the slip where the book's pictures do not.
fn shown_by(slip: &Slip) -> String {
    if let Some(probe) = slip.shown_by() {
        return format!("The probe *{probe}* shows it.");
    }
    let mut chapters = slip.chapters.iter();
    match chapters.find_map(|&chapter| slip.unseen_in(chapter)) {
        Some(Unseen::OnlyByLaw(law)) => format!("Only a law shows it: {law}"),
        Some(Unseen::Equivalent(why)) => format!("Nothing shows it: {why}"),
        None => String::new(),
    }
}

/// The picture inside the page, pixel by pixel.
pub(crate) fn image(picture: &Picture, alt: &str) -> String {
    format!(
        "<img class=\"pixels\" width=\"{}\" height=\"{}\" alt=\"{}\" src=\"{}\">",
        picture.width(),
        picture.height(),
        escaped(alt),
        address(picture)
    )
}

/// An address that has the whole picture in it.
pub(crate) fn address(picture: &Picture) -> String {
    let png = BASE64_STANDARD.encode(png::encode(picture));
    format!("data:image/png;base64,{png}")
}
