//! Diffs: what changed from one chapter to the next in the picture.

use base64::prelude::{BASE64_STANDARD, Engine as _};
use common::rtweekend::Picture;
use course::chapter::Chapter;
use difference::{Comparison, difference_picture, png};
use figures::number::as_printed;

/// A chapter and the function that draws its picture.
type Drawn = (Chapter, fn(u32) -> Picture);

/// The chapters whose pictures change, each behind the one before it.
const CHANGES: [[Drawn; 2]; 3] = [
    [
        (Chapter::Gradient, gradient::picture),
        (Chapter::RedSphere, red_sphere::picture),
    ],
    [
        (Chapter::RedSphere, red_sphere::picture),
        (Chapter::Normals, normals::picture),
    ],
    [
        (Chapter::HalfBSphere, half_b_sphere::picture),
        (Chapter::HittableList, hittable_list::picture),
    ],
];

/// Returns the Markdown for `{{changes NAME}}`: the pictures of the chapter `name` and of the one
/// before, the pixels that changed, and a sentence about them.
///
/// # Errors
/// If there is no such chapter, or it changes no pixels, or all.
pub(crate) fn changes(name: &str) -> Result<String, String> {
    let found = CHANGES
        .into_iter()
        .find(|[_, (after, _)]| after.name() == name);
    let chapters = found.ok_or_else(|| format!("no chapter `{name}` changes a picture"))?;
    let [(old, before), (new, after)] =
        chapters.map(|(chapter, draw)| (draw(chapter.book_width()), chapter));
    let (Comparison::Pixels(difference), Some(changed)) =
        (Comparison::of(&old, &new), difference_picture(&old, &new))
    else {
        return Err(format!("`{name}` changes no pixels, or all"));
    };
    let [count, total] = [difference.count, difference.total].map(|it| as_printed(&it.to_string()));
    let sentence = format!(
        "{count} of {total} pixels change, in columns {} to {} and rows {} to {}.",
        difference.columns[0], difference.columns[1], difference.rows[0], difference.rows[1]
    );
    let file = |of: Chapter| format!("pictures/{}.snap.png", of.name());
    let png = BASE64_STANDARD.encode(png::encode(&changed));
    let panels = [
        panel("Before", &file(before), before.shows()),
        panel("After", &file(after), after.shows()),
        panel(
            "Changed pixels",
            &format!("data:image/png;base64,{png}"),
            &sentence,
        ),
    ];
    let panels = panels.concat();
    Ok(format!(
        "<div class=\"changes\">{panels}</div>\n\n{sentence}"
    ))
}

/// Returns a picture with a title below, as HTML.
fn panel(title: &str, file: &str, alt: &str) -> String {
    format!("<figure><img src=\"{file}\" alt=\"{alt}\"><figcaption>{title}</figcaption></figure>")
}
