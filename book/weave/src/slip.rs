//! Pictures of slips and of editions, drawn while the book is woven.

use std::sync::LazyLock;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use check::png;
use common::rtweekend::Picture;
use slips::{Chapter, Edition, Letters, Sight, Slip, Unseen, Words};

/// The picture that a slip draws in a chapter, with the name of both below it.
pub(crate) fn slip(name: &str, chapter: &str) -> Result<String, String> {
    let slip = slips::find(name).ok_or_else(|| format!("there is no slip `{name}`"))?;
    let chapter = Chapter::find(chapter)
        .filter(|chapter| slip.chapters.contains(chapter))
        .ok_or_else(|| format!("`{name}` can't be made in a chapter `{chapter}`"))?;
    let picture = slip.program(chapter).run(chapter.book_width()).picture();
    Ok(format!(
        "<figure>{}<figcaption><a href=\"slips.html\">{name}</a> in <code>{}</code></figcaption></figure>",
        image(
            &picture,
            &format!(
                "What {name} draws: {}",
                slip.words(Letters::Book(Edition::V4), chapter).why
            )
        ),
        chapter.name()
    ))
}

/// What each edition of the book draws, and by what it differs.
pub(crate) fn editions() -> String {
    let pictures = |edition: Edition| -> String {
        let chapters = [Chapter::BuildTest, Chapter::Normals, Chapter::HittableList];
        let picture = |chapter: Chapter| {
            let picture = edition.program(chapter).run(EDITION_WIDTH).picture();
            image(&picture, &format!("{} by {edition}", chapter.name()))
        };
        chapters.map(picture).concat()
    };
    // To see the two programs of version 1 apart takes a comparison of bits.
    let mut editions = Edition::ALL;
    editions.sort();
    editions
        .into_iter()
        .filter(|edition| *edition != Edition::V1InDouble)
        .map(|edition| {
            let differs = match edition {
                Edition::V4 => String::new(),
                older => format!(": {}", older.differs_by().join("; in the build test ")),
            };
            format!(
                "<figure class=\"edition\">{}<figcaption><b>{edition}</b>{differs}</figcaption></figure>\n\n",
                pictures(edition)
            )
        })
        .collect()
}

/// How wide the pictures of editions are, in pixels.
const EDITION_WIDTH: u32 = 144;

/// The slips of this look with their pictures; or those that draw the right picture wherever
/// they are made.
pub(crate) fn gallery(look: &str) -> Result<String, String> {
    static SIGHTS: LazyLock<Vec<Sight>> = LazyLock::new(slips::sights);
    if look == "Right" {
        let seen = |slip: &&Slip| {
            let mut all = SIGHTS.iter().flat_map(|sight| &sight.slips);
            all.any(|other| other.name == slip.name)
        };
        let unseen = |slip| format!("{} {}\n", item(slip), shown_by(slip));
        return Ok(slips::all()
            .filter(|slip| !seen(slip))
            .map(unseen)
            .collect());
    }
    let has_look = |sight: &&Sight| format!("{:?}", sight.look) == look;
    let tiles: String = SIGHTS.iter().filter(has_look).map(tile).collect();
    match tiles.is_empty() {
        true => Err(format!("no slip has the look `{look}`")),
        false => Ok(tiles),
    }
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
    let (name, Words { wrong, right, why }) = (
        slip.name,
        slip.words(Letters::Book(Edition::V4), slip.chapters[0]),
    );
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
    match slip
        .chapters
        .iter()
        .find_map(|&chapter| slip.unseen_in(chapter))
    {
        Some(Unseen::OnlyByLaw(law)) => format!("Only a law shows it: {law}"),
        Some(Unseen::Equivalent(why)) => format!("Nothing shows it: {why}"),
        None => String::new(),
    }
}

/// The picture inside the page, pixel by pixel.
pub(crate) fn image(picture: &Picture, alt: &str) -> String {
    format!(
        "<img class=\"pixels\" width=\"{}\" height=\"{}\" alt=\"{alt}\" src=\"data:image/png;base64,{}\">",
        picture.width(),
        picture.height(),
        BASE64_STANDARD.encode(png::encode(picture))
    )
}
