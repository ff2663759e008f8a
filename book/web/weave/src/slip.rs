//! Pictures of slips and of editions, drawn while the book is woven.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use check::png;
use common::rtweekend::Picture;
use slips::{Chapter, Edition, Letters, Sight, Slip, Unseen, Words};

use crate::ground::{escaped, read, split};

/// The picture that a slip draws in a chapter, with the name of both below it.
pub(crate) fn slip(name: &str, chapter: &str) -> Result<String, String> {
    let slip = slips::find(name).ok_or_else(|| format!("there is no slip `{name}`"))?;
    let chapter = Chapter::find(chapter)
        .filter(|chapter| slip.chapters.contains(chapter))
        .ok_or_else(|| format!("`{name}` can't be made in a chapter `{chapter}`"))?;
    let picture = slip.program(chapter).run(chapter.book_width()).picture();
    let why = slip.words(Letters::Book(Edition::V4), chapter).why;
    Ok(format!(
        "<figure>{}<figcaption><a href=\"slips.html#{name}\">{name}</a> in <code>{}</code></figcaption></figure>",
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

/// The slips of a look with their pictures: `LOOK`, or `LOOK NAME NAME` for those that have one of
/// these names or are made in a chapter of that name, or `LOOK not NAME NAME` for the others. Those
/// of the look `Right` draw the right picture wherever they are made.
pub(crate) fn gallery(chosen: &str) -> Result<String, String> {
    if chosen == "Right" {
        return Ok(unseen().map(|slip| shown_by(slip) + "\n").collect());
    }
    Ok(sights(chosen)?.into_iter().map(tile).collect())
}

/// From each of the `pages` of slips, `PAGE:SLIP`, the picture of that slip, which leads there; and
/// each slip by its name.
pub(crate) fn symptoms(notes: &Path, pages: &str) -> Result<String, String> {
    let mut cards = String::new();
    let mut names = BTreeMap::new();
    for page in pages.split(' ') {
        let (page, shown) = page.split_once(':').unwrap_or((page, ""));
        let text = read(&notes.join(page).with_extension("md"))?;
        let title = text.lines().next().unwrap_or_default();
        let chosen = text.lines().filter_map(|line| {
            let line = line.strip_prefix("{{slips ")?;
            line.strip_suffix("}}").filter(|look| *look != "Right")
        });
        let seen = chosen.map(sights).collect::<Result<Vec<_>, _>>()?.concat();
        let has = |sight: &&&Sight| sight.slips.iter().any(|slip| slip.name == shown);
        let first = seen.iter().find(has);
        let first = first.ok_or_else(|| format!("{page} shows no slip `{shown}`"))?;
        cards += &format!(
            "<a class=\"symptom\" href=\"{page}.html\">{}<span>{}</span></a>",
            image(&first.picture, ""),
            escaped(title.trim_start_matches("# "))
        );
        for sight in seen {
            let address = |slip: &&Slip| (slip.name, format!("{page}.html#{}", id(slip, sight)));
            names.extend(sight.slips.iter().map(address));
        }
    }
    let in_full = |(name, address)| format!("<a id=\"{name}\" href=\"{address}\">{name}</a>");
    names.extend(unseen().map(|slip| (slip.name, format!("slips_right.html#{}", slip.name))));
    let names: Vec<String> = names.into_iter().map(in_full).collect();
    Ok(format!(
        "<div class=\"symptoms\">{cards}</div>\n\n## By name\n\n<p>{}</p>",
        names.join(" · ")
    ))
}

static SIGHTS: LazyLock<Vec<Sight>> = LazyLock::new(slips::sights);

fn sights(chosen: &str) -> Result<Vec<&'static Sight>, String> {
    let (look, names) = split(chosen);
    let (is_not, names) = match names.strip_prefix("not ") {
        Some(names) => (true, names),
        None => (false, names),
    };
    let names: Vec<&str> = names.split_whitespace().collect();
    let has = |sight: &Sight, name: &&str| {
        sight.chapter.name() == *name || sight.slips.iter().any(|slip| slip.name == *name)
    };
    let of_look = SIGHTS.iter().filter(|it| format!("{:?}", it.look) == look);
    let of_look: Vec<&Sight> = of_look.collect();
    if let Some(name) = names
        .iter()
        .find(|name| !of_look.iter().any(|it| has(it, name)))
    {
        return Err(format!("no slip `{name}` has the look `{look}`"));
    }
    let is_chosen =
        |sight: &&Sight| names.is_empty() || names.iter().any(|name| has(sight, name)) != is_not;
    let chosen: Vec<&Sight> = of_look.into_iter().filter(is_chosen).collect();
    match chosen.is_empty() {
        true => Err(format!("no slip has the look `{look}`")),
        false => Ok(chosen),
    }
}

/// Those that draw the right picture in all their chapters.
fn unseen() -> impl Iterator<Item = &'static Slip> {
    let seen = SIGHTS.iter().flat_map(|sight| &sight.slips);
    let seen: Vec<&str> = seen.map(|slip| slip.name).collect();
    slips::all().filter(move |slip| !seen.contains(&slip.name))
}

/// A picture, and beside it the slips that draw it.
fn tile(sight: &Sight) -> String {
    let chapter = sight.chapter.name();
    let names: Vec<&str> = sight.slips.iter().map(|slip| slip.name).collect();
    let alt = format!("What {} draws in {chapter}", names.join(", "));
    let slips = sight.slips.iter();
    let items: String = slips
        .map(|slip| item(slip, &id(slip, sight)) + "\n")
        .collect();
    format!(
        "<div class=\"slip\">\n<figure>{}<figcaption>{chapter}</figcaption></figure>\n<div>\n\n{items}\n</div>\n</div>\n\n",
        image(&sight.picture, &alt)
    )
}

/// What a page calls the slip where it has this look: it may have several, in other chapters.
fn id(slip: &Slip, sight: &Sight) -> String {
    format!("{}-in-{}", slip.name, sight.chapter.name())
}

/// The slip in words, as an item of a list.
fn item(slip: &Slip, id: &str) -> String {
    let name = slip.name;
    let Words { wrong, right, why } = slip.words(Letters::Book(Edition::V4), slip.chapters[0]);
    let (page, heading) = slip.page_and_heading();
    format!(
        "* `{wrong}` should be `{right}`. {why} \
         <span id=\"{id}\">*{name}*</span>, see [{page}]({page}.md#{heading})"
    )
}

/// The same for a slip that the book's pictures do not show, and what does.
fn shown_by(slip: &Slip) -> String {
    let mut chapters = slip.chapters.iter();
    let shown = match slip.shown_by() {
        Some(probe) => format!("The probe *{probe}* shows it."),
        None => match chapters.find_map(|&chapter| slip.unseen_in(chapter)) {
            Some(Unseen::OnlyByLaw(law)) => format!("Only a law shows it: {law}"),
            Some(Unseen::Equivalent(why)) => format!("Nothing shows it: {why}"),
            None => String::new(),
        },
    };
    format!("{}. {shown}", item(slip, slip.name))
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
