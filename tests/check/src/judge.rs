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
    /// It is right, but of another scene of the chapter: a change was forgotten, or is
    /// still there.
    Another {
        /// Which one it is, and how to go on.
        cause: Cause,
        /// The scenes that it shows: several if their right pictures are the same.
        scenes: Vec<Scene>,
    },
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
    /// Probes of which it is the right picture, as wide as it has to be, though one
    /// mistake draws it as well.
    pub others: Vec<Scene>,
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
    if let Some(cause) = wrong_shape(scene, reading.width, reading.height) {
        return misshapen(scene, reading, cause);
    }
    let outside = no_levels(reading);
    let finding = Finding::undiagnosed(scene, reading);
    if outside.is_none() && finding.levels <= tolerance {
        return Check::Right(finding.into_right());
    }
    match outside {
        None => wrong(scene, reading, finding),
        Some(cause) => Check::NotAPicture {
            cause,
            finding: Some(Box::new(finding.diagnosed(scene, reading))),
        },
    }
}

fn wrong(scene: &Scene, reading: &Reading, finding: Finding) -> Check {
    // What is off by single levels is this scene, in another way of rounding.
    let mut others = match finding.levels {
        0 | 1 => Vec::new(),
        _ => scene.others(reading),
    };
    if others.first().is_some_and(|other| other.probe.is_none()) {
        return Check::of_another(scene, others);
    }
    let finding = finding.diagnosed(scene, reading);
    if !finding.diagnosis.is_certain() && !others.is_empty() {
        return Check::of_another(scene, others);
    }
    others.retain(|other| {
        other
            .probe
            .is_some_and(|probe| probe.width == reading.width)
    });
    Check::Wrong(Finding { others, ..finding })
}

fn misshapen(scene: &Scene, reading: &Reading, cause: Cause) -> Check {
    let others = scene.others(reading);
    if !others.is_empty() {
        return Check::of_another(scene, others);
    }
    let size = u64::from(reading.width) * u64::from(reading.height);
    let finding = || Box::new(Finding::undiagnosed(scene, reading).diagnosed(scene, reading));
    Check::WrongShape {
        cause,
        finding: (size <= MOST_MISSHAPEN).then(finding),
    }
}

impl Finding {
    /// The reader's picture beside the right one, before anybody has asked why.
    fn undiagnosed(scene: &Scene, reading: &Reading) -> Self {
        let right = scene.right(reading.width, reading.height);
        let yours = reading.picture();
        let difference = match Comparison::of(&right, &yours) {
            Comparison::Pixels(difference) => Some(difference),
            _ => None,
        };
        Self {
            levels: difference
                .as_ref()
                .map_or(0, |difference| difference.levels),
            right,
            yours,
            difference,
            diagnosis: Diagnosis::default(),
            others: Vec::new(),
        }
    }

    fn diagnosed(self, scene: &Scene, reading: &Reading) -> Self {
        Self {
            diagnosis: diagnosis::diagnose(scene, reading, &self.right),
            ..self
        }
    }

    fn into_right(self) -> Right {
        Right {
            width: self.right.width(),
            height: self.right.height(),
            off: self.difference.map_or(0, |difference| difference.count),
            levels: self.levels,
        }
    }
}

impl Check {
    fn of_another(scene: &Scene, scenes: Vec<Scene>) -> Self {
        Self::Another {
            cause: scene.but_shown(&scenes),
            scenes,
        }
    }

    /// The exit code: 0 for right, 1 for wrong, 2 for not a picture.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Right(_) => 0,
            Self::Wrong(_) | Self::WrongShape { .. } | Self::Another { .. } => 1,
            Self::NotAPicture { .. } => 2,
        }
    }

    /// Other scenes of the chapter of which it is the right picture.
    pub fn others(&self) -> &[Scene] {
        match self {
            Self::Another { scenes, .. } => scenes,
            other => other.finding().map_or(&[], |finding| &finding.others),
        }
    }

    /// What is wrong, if there are pixels to judge.
    pub fn finding(&self) -> Option<&Finding> {
        match self {
            Self::Right(_) | Self::Another { .. } => None,
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
