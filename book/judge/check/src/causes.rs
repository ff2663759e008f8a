//! Why a picture is not the one that was asked for: its shape, its numbers, its scene.

use slips::{ChapterProgram, Edition, ReaderLanguage, Slip};

use crate::reading::{Cause, Reading};
use crate::task::Task;

/// The most pixels of a picture of a wrong shape that are looked at. Its shape says
/// more than its pixels do, and to draw the right one in a shape that nobody wants may
/// take long.
pub(crate) const MOST_MISSHAPEN: u64 = 1 << 20;

/// The slips with which a program draws `width` × `height` pixels where the
/// right one does not, whatever the pixels are.
pub(crate) fn slips_giving(task: &Task, width: u32, height: u32) -> Vec<&'static Slip> {
    let gives = |program: &ChapterProgram| {
        [width, height]
            .into_iter()
            .any(|asked| program.run(asked).size() == (width, height))
    };
    if gives(&task.program(&[])) {
        return Vec::new();
    }
    task.slips()
        .filter(|slip| gives(&task.program(&[slip])))
        .collect()
}

/// Returns true if somebody may want a picture of that shape: no stripe, and nothing endless.
pub(crate) fn is_a_shape_to_choose(width: u32, height: u32) -> bool {
    let [width, height] = [width, height].map(u64::from);
    width * height <= MOST_MISSHAPEN && width.max(height) <= 8 * width.min(height)
}

/// Why the picture is not that of the probe, which is about one width.
pub(crate) fn not_as_wide(task: &Task, reading: &Reading) -> Option<Cause> {
    let probe = task.probe.filter(|probe| probe.spheres.is_none())?;
    let (width, height) = (reading.width, reading.height);
    let (name, wanted, chapter) = (probe.name, probe.width, task.chapter.name());
    (wanted != width).then(|| Cause::new(
        "wrong-shape",
        format!(
            "the picture is {width} × {height}, but that of the probe {name} has image_width = {wanted}"
        ),
        format!("Draw {chapter} with image_width = {wanted}."),
    ))
}

/// Why the picture is not of the scene's shape, if it is not.
pub(crate) fn wrong_shape(task: &Task, width: u32, height: u32) -> Option<Cause> {
    if task
        .by_editions(width, height)
        .any(|task| !task.has_another_shape())
    {
        return None;
    }
    let name = task.chapter.name();
    let expected = task.height(width);
    let slips: Vec<&str> = slips_giving(task, width, height)
        .iter()
        .map(|slip| slip.name)
        .collect();
    let usual = if slips.is_empty() {
        "No mistake in the catalogue gives this shape.".to_owned()
    } else {
        format!("This shape is what these slips give: {}.", slips.join(", "))
    };
    Some(Cause::new(
        "wrong-shape",
        format!(
            "the picture is {width} × {height}, but {name} at {width} wide is {width} × {expected}"
        ),
        format!(
            "{usual} image_height = int(image_width / (16.0 / 9.0)), and at least 1; only build_test is a square."
        ),
    ))
}

/// Why the picture has numbers that are no levels, if it has.
pub(crate) fn no_levels(reading: &Reading) -> Option<Cause> {
    let outside = reading.outside()?;
    let (column, row) = outside.first;
    // What 16 bits can't hold was cut off.
    let said = |level: i16| match level {
        i16::MIN => format!("{level} or less"),
        i16::MAX => format!("{level} or more"),
        _ => level.to_string(),
    };
    let (lowest, highest) = (said(outside.lowest), said(outside.highest));
    let range = match (outside.lowest < 0, outside.highest > 255) {
        (true, true) => format!("below 0 and above 255, from {lowest} to {highest}"),
        (true, false) => format!("below 0, down to {lowest}"),
        _ => format!("above 255, up to {highest}"),
    };
    let pixels = match outside.count {
        1 => "1 pixel has".to_owned(),
        all => format!("{all} pixels have"),
    };
    let fix = match (outside.lowest, outside.highest) {
        (i16::MIN, _) => {
            "This is what NaN turns into: is 0 / 0 taken, the root of a negative number, or a number that was never set?"
        }
        (0.., 256) => {
            "256 comes of a factor of 256, or of rounding: int(255.999 * r) is at most 255."
        }
        _ => "A component of a color must be from 0 to 1 before it is scaled: int(255.999 * r).",
    };
    Some(Cause::new(
        "levels-outside",
        format!(
            "{pixels} numbers {range}; the first is column {column}, row {row}: [{}]",
            outside.pixel.map(said).join(", ")
        ),
        fix,
    ))
}

/// Why a picture of `others`, scenes of this chapter, is not the right one.
pub(crate) fn another(wanted: &Task, others: &[Task], language: Option<ReaderLanguage>) -> Cause {
    let own = wanted.chapter.name();
    let probes: Vec<&str> = others
        .iter()
        .filter_map(|task| Some(task.probe?.name))
        .collect();
    if others[0].chapter != wanted.chapter {
        let other = others[0];
        let by = match other.edition {
            Edition::V4 => String::new(),
            edition => format!(" by version {}", edition.name()),
        };
        let (other, command) = (other.chapter, other.command());
        let missing = match other < wanted.chapter {
            true => format!("What {own} adds is not seen: is it called, and is its answer used? "),
            false => String::new(),
        };
        return Cause::new(
            "another-chapter",
            format!(
                "this is a picture of the chapter {}{by}, not of {own}",
                other.name()
            ),
            format!("{missing}If you meant {}: {command}", other.name()),
        );
    }
    let (problem, fix) = match (wanted.probe, others[0].probe) {
        (Some(probe), None) => (
            format!(
                "this is the picture of the chapter itself, {own}: the change for the probe {} is not in it",
                probe.name
            ),
            format!(
                "change your program: {}; then {}",
                wanted.change(probe.width, language).replace('\n', "; "),
                wanted.command()
            ),
        ),
        (wanted, _) => (
            format!(
                "this is the picture of the probe {}, not of {}",
                probes.join(" or "),
                wanted.map_or("the chapter itself", |wanted| wanted.name)
            ),
            format!(
                "Is the change still in your program? As what it is, it is right: {}",
                others[0].command()
            ),
        ),
    };
    Cause::new("another-scene", problem, fix)
}
