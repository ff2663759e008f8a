//! The verdict on a reader's picture: right, wrong, or no picture.

use common::rtweekend::Picture;

use crate::comparison::{Comparison, Difference};
use crate::diagnosis::{self, Diagnosis, Scene};
use crate::reading::{self, Cause, Reading};

/// What there is to say about a picture.
#[derive(Debug)]
pub enum Check {
    /// It is right.
    Right(Right),
    /// It is a picture, and not the right one.
    Wrong(Finding),
    /// It is a picture of another shape than the scene's.
    WrongShape {
        /// The shape that it should have, and what gives this one.
        cause: Cause,
        /// What its pixels tell, unless there are more than [`MOST_MISSHAPEN`].
        finding: Option<Box<Finding>>,
    },
    /// It is no picture, or not a valid one.
    NotAPicture {
        /// Why.
        cause: Cause,
        /// What its pixels tell, if there are any.
        finding: Option<Box<Finding>>,
    },
}

/// A right picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Right {
    /// Pixels in a row.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
    /// How many pixels are off at all; 0 means equal to the last bit.
    pub off: usize,
    /// The farthest that a component is off, in levels; no more than was
    /// tolerated.
    pub levels: u8,
}

/// What is wrong with a picture.
#[derive(Debug)]
pub struct Finding {
    /// The right picture in the same size.
    pub right: Picture,
    /// The reader's, as a viewer shows it.
    pub yours: Picture,
    /// Where the two differ; `None` if only the shape is wrong, or only numbers
    /// that are no levels.
    pub difference: Option<Difference>,
    /// The farthest that a component is off, in levels.
    pub levels: u8,
    /// The mistakes that draw it.
    pub diagnosis: Diagnosis,
}

/// Compares the picture in `bytes` with the scene's, and accepts components that
/// are at most `tolerance` levels off.
pub fn check(scene: &Scene, bytes: &[u8], tolerance: u8) -> Check {
    match reading::read(bytes) {
        Ok(reading) => judge(scene, &reading, tolerance),
        Err(cause) => Check::NotAPicture {
            cause,
            finding: None,
        },
    }
}

/// The most pixels of a picture of a wrong shape that are looked at. Its shape tells
/// more than its pixels do, and to draw the right one in a shape that nobody wants may
/// take long.
pub const MOST_MISSHAPEN: u64 = 1 << 20;

fn judge(scene: &Scene, reading: &Reading, tolerance: u8) -> Check {
    let (width, height) = (reading.width, reading.height);
    let shape = wrong_shape(scene, width, height);
    let size = u64::from(width) * u64::from(height);
    if let Some(cause) = &shape
        && size > MOST_MISSHAPEN
    {
        return Check::WrongShape {
            cause: cause.clone(),
            finding: None,
        };
    }
    let right = scene.right(width, height);
    let yours = reading.picture();
    let difference = match Comparison::of(&right, &yours) {
        Comparison::Pixels(difference) => Some(difference),
        _ => None,
    };
    let levels = difference
        .as_ref()
        .map_or(0, |difference| difference.levels);
    let outside = no_levels(reading);
    if shape.is_none() && outside.is_none() && levels <= tolerance {
        return Check::Right(Right {
            width,
            height,
            off: difference.map_or(0, |difference| difference.count),
            levels,
        });
    }
    let finding = Finding {
        diagnosis: diagnosis::diagnose(scene, reading, &right),
        right,
        yours,
        difference,
        levels,
    };
    match (shape, outside) {
        (None, None) => Check::Wrong(finding),
        (Some(cause), _) => Check::WrongShape {
            cause,
            finding: Some(Box::new(finding)),
        },
        (None, Some(cause)) => Check::NotAPicture {
            cause,
            finding: Some(Box::new(finding)),
        },
    }
}

impl Check {
    /// The exit code: 0 for right, 1 for wrong, 2 for not a picture.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Right(_) => 0,
            Self::Wrong(_) | Self::WrongShape { .. } => 1,
            Self::NotAPicture { .. } => 2,
        }
    }

    /// What is wrong, if there are pixels to judge.
    pub fn finding(&self) -> Option<&Finding> {
        match self {
            Self::Right(_) => None,
            Self::Wrong(finding) => Some(finding),
            Self::WrongShape { finding, .. } | Self::NotAPicture { finding, .. } => {
                finding.as_deref()
            }
        }
    }
}

/// Why the picture is not of the scene's shape, if it is not.
fn wrong_shape(scene: &Scene, width: u32, height: u32) -> Option<Cause> {
    let name = scene.chapter.name();
    if let Some(probe) = scene.probe
        && probe.spheres.is_none()
        && probe.width != width
    {
        let (probe, wanted) = (probe.name, probe.width);
        return Some(Cause::new(
            "wrong-shape",
            format!(
                "the picture is {width} × {height}, but the probe {probe} is about one {wanted} pixels wide"
            ),
            format!("Draw {name} with image_width = {wanted}."),
        ));
    }
    let expected = scene.height(width);
    if expected == height {
        return None;
    }
    let slips: Vec<&str> = diagnosis::slips_giving(scene, width, height)
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
fn no_levels(reading: &Reading) -> Option<Cause> {
    let outside = reading.outside()?;
    let (column, row) = outside.first;
    let range = match (outside.lowest < 0, outside.highest > 255) {
        (true, true) => format!(
            "below 0 and above 255, from {} to {}",
            outside.lowest, outside.highest
        ),
        (true, false) => format!("below 0, down to {}", outside.lowest),
        _ => format!("above 255, up to {}", outside.highest),
    };
    Some(Cause::new(
        "levels-outside",
        format!(
            "{} pixels have numbers {range}; the first is column {column}, row {row}: {:?}",
            outside.count, outside.pixel
        ),
        "A component of a color must be from 0 to 1 before it is scaled: int(255.999 * r). The mistakes below give these very numbers, if there are any.",
    ))
}
