//! What the pages show of mistakes: each wrong picture, and beside it the mistakes that draw it.

use std::collections::BTreeMap;
use std::fs::{self, DirEntry};

use common::rtweekend::Picture;
use difference::png;
use fixtures::drawn::shown_in;
use insta::{assert_binary_snapshot, assert_snapshot};
use slips::{Chapter, ChapterProgram, Edit, Languages, PROBES, Slip, Unseen, steps};

use crate::Seen;
use crate::looks::Look;

/// The parts of the page, each with the look of its pictures, and with the mistakes or the chapter
/// whose pictures these are, or nothing. A picture stands in the first part that fits.
const PARTS: [(&str, Look, &str); 15] = [
    ("only-sky", Look::Gone, ""),
    ("no-sky", Look::Flooded, ""),
    (
        "egg",
        Look::Misplaced,
        "focal-length-two integer-viewport-ratio inverted-viewport-ratio rows-by-width \
         radius-not-squared a-from-length deltas-from-last-pixel",
    ),
    ("ground", Look::Misplaced, "hittable_list"),
    ("moved", Look::Misplaced, ""),
    ("ground", Look::Incomplete, "hittable_list"),
    ("egg", Look::Incomplete, ""),
    ("turned", Look::Turned, ""),
    ("other-size", Look::OtherSize, ""),
    (
        "dark",
        Look::OtherHits,
        "far-root two-a-without-brackets numerator-without-brackets not-divided normal-from-point \
         center-added normal-inward normal-not-mapped normal-only-halved z-forward stale-boolean \
         divided-by-a faces-swapped normal-not-set",
    ),
    ("other-colors", Look::OtherHits, ""),
    ("all-colors", Look::OtherColors, ""),
    ("all-colors", Look::OtherSky, "build_test"),
    ("sky", Look::OtherSky, ""),
    ("right", Look::Faint, ""),
];

/// Compares the parts of the page of mistakes and their pictures with what the book has.
pub(crate) fn assert_shown(seen: &[(Seen, Picture)]) {
    let mut texts: BTreeMap<&str, String> = PARTS.map(|(part, ..)| (part, String::new())).into();
    for row @ (part, ..) in PARTS {
        let of_part = seen.iter().filter(|(wrong, _)| row_of(wrong) == row);
        let tiles = of_part.map(|(wrong, picture)| tile(wrong, picture, seen));
        *texts.entry(part).or_default() += &tiles.collect::<String>();
    }
    let is_seen = |slip: &&Slip| {
        seen.iter()
            .any(|((.., names), _)| names.contains(&slip.name))
    };
    let unseen = slips::all().filter(|slip| !is_seen(slip)).map(shown_by);
    texts.insert("unseen", unseen.collect());
    let mut names: Vec<&str> = slips::all().map(|slip| slip.name).collect();
    names.sort_unstable();
    let link = |name: &&str| format!("<a href=\"#{name}\">{name}</a>");
    let links: Vec<String> = names.iter().map(link).collect();
    texts.insert("names", format!("<p>{}</p>", links.join(" · ")));
    for (part, text) in texts {
        assert!(!text.is_empty(), "nothing is in {part}");
        shown_in("slips").bind(|| assert_snapshot!(part, text));
    }
    for (wrong, picture) in seen {
        let file = format!("{}.png", id(wrong.2[0], wrong, seen));
        shown_in("slips").bind(|| assert_binary_snapshot!(&file, png::encode(picture)));
    }
    let folder = fs::read_dir(notes("slips")).expect("the folder of the pictures");
    let is_picture = |it: &DirEntry| it.path().extension().is_some_and(|it| it == "png");
    let pictures = folder.flatten().filter(is_picture).count();
    assert_eq!(pictures, seen.len(), "pictures of slips that are gone");
}

/// Returns the row of [`PARTS`] in which a wrong picture stands: the first that fits.
fn row_of((look, chapter, names): &Seen) -> (&'static str, Look, &'static str) {
    let fits = |(_, of, words): &(_, Look, &str)| {
        let is_meant = |word| word == chapter.name() || names.contains(&word);
        of == look && (words.is_empty() || words.split(' ').any(is_meant))
    };
    PARTS.into_iter().find(fits).expect("a part for each look")
}

/// The pages of the chapters show some mistakes and half-finished pictures.
#[test]
fn pages_show_what_mistakes_and_steps_draw() {
    use Chapter::{BuildTest, Gradient, HalfBSphere, HittableList, Normals};
    let shown = |name: String, chapter: Chapter, program: &ChapterProgram| {
        let picture = program.run(chapter.book_width()).picture();
        shown_in("pictures")
            .bind(|| assert_binary_snapshot!(&format!("{name}.png"), png::encode(&picture)));
    };
    for (slip, chapter) in [
        ("red-and-green-swapped", BuildTest),
        ("blend-not-mapped", Gradient),
        ("normal-not-mapped", Normals),
        ("far-root", Normals),
        ("minus-h", HalfBSphere),
        ("faces-swapped", HittableList),
        ("closest-ignored", HittableList),
        ("oc-reversed", HittableList),
    ] {
        let program = slips::find(slip).expect("a slip").program(chapter);
        shown(format!("{slip}_{}", chapter.name()), chapter, &program);
    }
    for (chapter, number) in [(Gradient, 2), (Gradient, 3), (Normals, 2)] {
        let step = &steps::of_chapter(chapter)[number - 1];
        let program = step.applied_to(&ChapterProgram::right(chapter));
        shown(
            format!("{}_step_{number}", chapter.name()),
            chapter,
            &program,
        );
    }
}

/// The page *Check* lists the probes: of each its name, what it shows, and what a reader changes in
/// the last chapter to draw it.
#[test]
fn the_page_lists_all_probes() {
    let items = PROBES.iter().map(|probe| {
        let change = probe.instructions(Chapter::HittableList, Languages::Both);
        let change = change.replace('\n', "; ");
        format!("- `{}`: {} Change: {change}\n", probe.name, probe.shows)
    });
    let items: String = items.collect();
    shown_in("slips").bind(|| assert_snapshot!("probes", items));
}

fn notes(folder: &str) -> String {
    format!("{}/../../notes/{folder}", env!("CARGO_MANIFEST_DIR"))
}

/// Returns a wrong picture, and beside it the slips that draw it.
fn tile(wrong: &Seen, picture: &Picture, seen: &[(Seen, Picture)]) -> String {
    let (_, chapter, names) = wrong;
    let (chapter, size) = (chapter.name(), [picture.width(), picture.height()]);
    let items: String = names
        .iter()
        .map(|name| {
            let slip = slips::find(name).expect("a slip");
            item(slip, &id(name, wrong, seen)) + "\n"
        })
        .collect();
    format!(
        "<div class=\"slip\">\n<figure><img class=\"pixels\" width=\"{}\" height=\"{}\" \
         alt=\"What {} draws in {chapter}\" src=\"slips/{}.snap.png\"><figcaption>{chapter}</figcaption></figure>\n\
         <div>\n\n{items}\n</div>\n</div>\n\n",
        size[0],
        size[1],
        names.join(", "),
        id(names[0], wrong, seen),
    )
}

/// Returns the anchor of a slip on the page: its name, where its first picture stands, and else its
/// name with the chapter's.
fn id(name: &str, wrong: &Seen, seen: &[(Seen, Picture)]) -> String {
    let first = seen.iter().find(|((.., names), _)| names.contains(&name));
    match first {
        Some((first, _)) if first == wrong => name.to_owned(),
        _ => format!("{name}-in-{}", wrong.1.name()),
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

/// Returns the slip with a sentence on what shows it, since the book's pictures hide it.
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
    format!("{}. {shown}\n", item(slip, slip.name))
}
