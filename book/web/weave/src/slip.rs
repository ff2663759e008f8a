//! Pictures of slips, drawn while the book is woven.

use std::path::Path;
use std::sync::LazyLock;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use common::rtweekend::Picture;
use difference::png;
use rayon::prelude::*;
use slips::{Chapter, Edit, Languages, PROBES, Probe, Slip, Unseen, WrongPicture};

use crate::ground::{escaped, read, split};

/// Returns the picture that the slip `name` draws in a chapter, with both names below.
///
/// # Errors
/// If there is no such slip, or it cannot be made in the chapter.
pub(crate) fn slip(name: &str, chapter: &str) -> Result<String, String> {
    let slip = slips::find(name).ok_or_else(|| format!("there is no slip `{name}`"))?;
    let chapter = Chapter::find(chapter)
        .filter(|chapter| slip.is_possible_in(*chapter))
        .ok_or_else(|| format!("`{name}` can't be made in a chapter `{chapter}`"))?;
    let picture = slip.program(chapter).run(chapter.book_width()).picture();
    Ok(format!(
        "<figure>{}<figcaption><a href=\"{PAGE}.html#{name}\">{name}</a> in <code>{}</code></figcaption></figure>",
        image(&picture, &format!("What {name} draws: {}", slip.why)),
        chapter.name()
    ))
}

/// Returns a list of all probes (other scenes, which show what a chapter's own picture hides): of
/// each its name, what it shows, and what a reader changes in the last chapter to draw it.
pub(crate) fn probes() -> String {
    let item = |probe: &Probe| {
        let change = probe.instructions(Chapter::HittableList, Languages::Both);
        let change = change.replace('\n', "; ");
        format!("- `{}`: {} Change: {change}\n", probe.name, probe.shows)
    };
    PROBES.iter().map(item).collect()
}

/// Returns the slips of a look (a kind of wrong picture), with their pictures. `chosen` is `LOOK`;
/// `LOOK NAME NAME` for only the slips with these names or made in chapters with these names; or
/// `LOOK not NAME NAME` for all others. The slips of the look `Right` draw the right picture in all
/// chapters.
///
/// # Errors
/// If there is no such look, slip or chapter.
pub(crate) fn gallery(chosen: &str) -> Result<String, String> {
    if chosen == "Right" {
        return Ok(unseen().map(|slip| shown_by(slip) + "\n").collect());
    }
    Ok(wrong_pictures(chosen)?.into_par_iter().map(tile).collect())
}

/// Returns a card for each part of the page of slips in the folder `notes`, with the picture of the
/// slip at its place in the list `shown`.
///
/// # Errors
/// If the page cannot be read, has other than one part for each slip of the list, or a part that
/// lacks its slip.
pub(crate) fn symptoms(notes: &Path, shown: &str) -> Result<String, String> {
    let text = read(&notes.join(PAGE).with_extension("md"))?;
    let parts = text.split("\n## ").filter(|part| part.contains(GALLERY));
    let shown: Vec<&str> = shown.split(' ').collect();
    let parts: Vec<&str> = parts.collect();
    if parts.len() != shown.len() {
        return Err(format!("{PAGE} has {} parts with slips", parts.len()));
    }
    let cards: Result<String, String> = parts.into_iter().zip(shown).map(card).collect();
    Ok(format!("<div class=\"symptoms\">{}</div>", cards?))
}

/// Returns a link to each slip by its name, in the order of the alphabet.
pub(crate) fn names() -> String {
    let mut names: Vec<&str> = slips::all().map(|slip| slip.name).collect();
    names.sort_unstable();
    let links = names
        .iter()
        .map(|name| format!("<a href=\"#{name}\">{name}</a>"));
    let links: Vec<String> = links.collect();
    format!("<p>{}</p>", links.join(" · "))
}

/// The page of slips, and the beginning of its lines that ask for the slips of a look.
const PAGE: &str = "slips";
const GALLERY: &str = "{{slips ";

/// Returns the card of a part of the page: the picture of the slip `shown`, which links to the
/// part.
fn card((part, shown): (&str, &str)) -> Result<String, String> {
    let (title, rest) = part.split_once(" {#").unwrap_or((part, ""));
    let (id, _) = rest.split_once('}').unwrap_or_default();
    let galleries = part.lines().filter_map(|line| line.strip_prefix(GALLERY));
    let galleries = galleries.filter_map(|line| line.strip_suffix("}}"));
    let seen = galleries
        .filter(|look| *look != "Right")
        .map(wrong_pictures)
        .collect::<Result<Vec<_>, _>>()?
        .concat();
    let has = |wrong: &&&WrongPicture| wrong.slips.iter().any(|slip| slip.name == shown);
    let first = seen.iter().find(has);
    let first = first.ok_or_else(|| format!("\"{title}\" shows no slip `{shown}`"))?;
    Ok(format!(
        "<a class=\"symptom\" href=\"#{id}\">{}<span>{}</span></a>",
        image(first.picture(), ""),
        escaped(title)
    ))
}

static WRONG_PICTURES: LazyLock<Vec<WrongPicture>> = LazyLock::new(slips::wrong_pictures);

fn wrong_pictures(chosen: &str) -> Result<Vec<&'static WrongPicture>, String> {
    let (look, names) = split(chosen);
    let (is_not, names) = match names.strip_prefix("not ") {
        Some(names) => (true, names),
        None => (false, names),
    };
    let names: Vec<&str> = names.split_whitespace().collect();
    let has = |wrong: &WrongPicture, name: &&str| {
        wrong.chapter.name() == *name || wrong.slips.iter().any(|slip| slip.name == *name)
    };
    let of_look = WRONG_PICTURES.iter().filter(|it| it.look == look);
    let of_look: Vec<&WrongPicture> = of_look.collect();
    if let Some(name) = names
        .iter()
        .find(|name| !of_look.iter().any(|it| has(it, name)))
    {
        return Err(format!("no slip `{name}` has the look `{look}`"));
    }
    let is_chosen = |wrong: &&WrongPicture| {
        names.is_empty() || names.iter().any(|name| has(wrong, name)) != is_not
    };
    let chosen: Vec<&WrongPicture> = of_look.into_iter().filter(is_chosen).collect();
    match chosen.is_empty() {
        true => Err(format!("no slip has the look `{look}`")),
        false => Ok(chosen),
    }
}

/// Returns the slips that draw the right picture in all their chapters.
fn unseen() -> impl Iterator<Item = &'static Slip> {
    let seen = WRONG_PICTURES.iter().flat_map(|wrong| &wrong.slips);
    let seen: Vec<&str> = seen.map(|slip| slip.name).collect();
    slips::all().filter(move |slip| !seen.contains(&slip.name))
}

/// Returns a wrong picture, and beside it the slips that draw it.
fn tile(wrong: &WrongPicture) -> String {
    let chapter = wrong.chapter.name();
    let names: Vec<&str> = wrong.slips.iter().map(|slip| slip.name).collect();
    let alt = format!("What {} draws in {chapter}", names.join(", "));
    let slips = wrong.slips.iter();
    let items: String = slips
        .map(|slip| item(slip, &id(slip, wrong)) + "\n")
        .collect();
    format!(
        "<div class=\"slip\">\n<figure>{}<figcaption>{chapter}</figcaption></figure>\n<div>\n\n{items}\n</div>\n</div>\n\n",
        image(wrong.picture(), &alt)
    )
}

/// Returns the anchor of a slip on the page: its name, where its first picture stands, and else its
/// name with the chapter's.
fn id(slip: &Slip, wrong: &WrongPicture) -> String {
    let has = |wrong: &&WrongPicture| wrong.slips.iter().any(|it| it.name == slip.name);
    match WRONG_PICTURES.iter().find(has) {
        Some(first) if std::ptr::eq(first, wrong) => slip.name.to_owned(),
        _ => format!("{}-in-{}", slip.name, wrong.chapter.name()),
    }
}

/// Returns the slip in words, as an item of a list.
fn item(slip: &Slip, id: &str) -> String {
    let name = slip.name;
    let first = slip.chapters().next().unwrap_or(Chapter::HittableList);
    let lines = slip.lines_in(Languages::Both, first).into_iter();
    let begun = ["", "; in Rust "].into_iter().zip(lines);
    let lines = begun.map(|(begin, Edit { right, wrong })| match &*wrong {
        "" => format!("{begin}`{right}` is left out"),
        _ => format!("{begin}`{wrong}` should be `{right}`"),
    });
    let (lines, why) = (lines.collect::<String>(), slip.why);
    let (page, heading) = slip.page_and_heading();
    format!(
        "* {lines}. {why} \
         <span id=\"{id}\">*{name}*</span>, see [{page}]({page}.md#{heading})"
    )
}

/// Returns a sentence on what shows a slip that the book's pictures hide.
fn shown_by(slip: &Slip) -> String {
    let mut chapters = slip.chapters();
    let shown = match slip.first_revealing_probe() {
        Some(probe) => format!("The probe *{probe}* shows it."),
        None => match chapters.find_map(|chapter| slip.why_unseen_in(chapter)) {
            Some(Unseen::OnlyByLaw(law)) => format!("Only a law shows it: {law}"),
            Some(Unseen::Equivalent(why)) => format!("Nothing shows it: {why}"),
            None => String::new(),
        },
    };
    format!("{}. {shown}", item(slip, slip.name))
}

/// Returns a picture as an `<img>` that holds all its pixels; `alt` describes it.
pub(crate) fn image(picture: &Picture, alt: &str) -> String {
    format!(
        "<img class=\"pixels\" width=\"{}\" height=\"{}\" alt=\"{}\" src=\"{}\">",
        picture.width(),
        picture.height(),
        escaped(alt),
        address(picture)
    )
}

/// Returns a data URL that holds the whole picture as a PNG.
pub(crate) fn address(picture: &Picture) -> String {
    let png = BASE64_STANDARD.encode(png::encode(picture));
    format!("data:image/png;base64,{png}")
}
