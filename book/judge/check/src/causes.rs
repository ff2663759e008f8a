//! The causes for which a picture is refused before its pixels are judged: its shape and its numbers.

use slips::{ChapterProgram, Slip};

use crate::reading::{Cause, Reading};
use crate::task::Task;

/// The most pixels that a picture of a wrong shape may have to be explained. To draw the right
/// picture in that shape, for comparison, would take long.
pub(crate) const MOST_MISSHAPEN: u64 = 1 << 20;

/// Finds the slips with which a program draws `width` × `height` pixels, of any color; none if the
/// right program does, too.
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

/// Returns true if a reader may choose that shape: at most eight times as wide as high, or as high
/// as wide, and of no more than [`MOST_MISSHAPEN`] pixels.
pub(crate) fn is_a_shape_to_choose(width: u32, height: u32) -> bool {
    let [width, height] = [width, height].map(u64::from);
    width * height <= MOST_MISSHAPEN && width.max(height) <= 8 * width.min(height)
}

/// Refuses a picture that has not the width of the probe, if that probe is about a width; `None`
/// otherwise.
pub(crate) fn not_as_wide(task: &Task, reading: &Reading) -> Option<Cause> {
    let probe = task.probe.filter(|probe| probe.spheres.is_none())?;
    let (width, height) = (reading.width, reading.height);
    let (name, wanted, chapter) = (probe.name, probe.width, task.chapter.name());
    (wanted != width).then(|| {
        Cause::new(
            "wrong-shape",
            format!(
                "the picture is {width} × {height}, but the probe {name} has image_width = {wanted}"
            ),
            format!("Draw {chapter} with image_width = {wanted}."),
        )
    })
}

/// Refuses a picture of a size that the task does not draw, and names the slips that do; `None` if
/// the task draws it.
pub(crate) fn wrong_shape(task: &Task, width: u32, height: u32) -> Option<Cause> {
    task.fitting(width, height).size?;
    let name = task.chapter.name();
    let expected = task.height(width);
    let slips: Vec<&str> = slips_giving(task, width, height)
        .iter()
        .map(|slip| slip.name)
        .collect();
    let usual = if slips.is_empty() {
        "No mistake in the catalogue gives this shape.".to_owned()
    } else {
        format!("These slips give this shape: {}.", slips.join(", "))
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

/// Refuses a picture with numbers that are no levels, and guesses where they come from; `None` if
/// all numbers are levels.
pub(crate) fn invalid_levels(reading: &Reading) -> Option<Cause> {
    let invalid = reading.invalid_levels()?;
    let [column, row] = invalid.first;
    // What 16 bits can't hold was cut off.
    let said = |level: i16| match level {
        i16::MIN => format!("{level} or less"),
        i16::MAX => format!("{level} or more"),
        _ => level.to_string(),
    };
    let (lowest, highest) = (said(invalid.lowest), said(invalid.highest));
    let range = match (invalid.lowest < 0, invalid.highest > 255) {
        (true, true) => format!("below 0 and above 255, from {lowest} to {highest}"),
        (true, false) => format!("below 0, down to {lowest}"),
        _ => format!("above 255, up to {highest}"),
    };
    let pixels = match invalid.count {
        1 => "1 pixel has".to_owned(),
        all => format!("{all} pixels have"),
    };
    let fix = match (invalid.lowest, invalid.highest) {
        (i16::MIN, _) => {
            "This is what NaN turns into: is 0 / 0 taken, the root of a negative number, or a number that was never set?"
        }
        (0.., 256) => {
            "256 comes from a factor of 256, or from rounding: int(255.999 * r) is at most 255."
        }
        _ => "A component of a color must be from 0 to 1 before it is scaled: int(255.999 * r).",
    };
    Some(Cause::new(
        "levels-outside",
        format!(
            "{pixels} numbers {range}; the first is in column {column}, row {row}: [{}]",
            invalid.pixel.map(said).join(", ")
        ),
        fix,
    ))
}
