//! The verdict on a reader's picture: right, wrong, or no picture.

use common::rtweekend::Picture;

use crate::comparison::{Comparison, Difference};
use crate::diagnosis::{self, Diagnosis, Scene, Set};
use crate::reading::{self, Cause, Reading};
use slips::Slip;

/// What there is to say about a picture.
#[derive(Debug)]
pub enum Check {
    /// It is right.
    Right(Right),
    /// It is right but for something that is no mistake, which the diagnosis names.
    Near(Finding),
    /// It is a picture, and not the right one.
    Wrong(Finding),
    /// It is right, but of another scene: a change was forgotten, or is still there, or
    /// it is another chapter's.
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
#[derive(Clone, Debug)]
pub struct Right {
    /// The scene, by the edition of the book that draws this picture.
    pub scene: Scene,
    /// Pixels in a row.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
    /// How many pixels are off at all; 0 means equal to the last bit.
    pub off: usize,
    /// The farthest that a component is off, in levels; no more than was
    /// tolerated.
    pub levels: u8,
    /// Slips that give it its shape, if that is not the chapter's: it may have been a
    /// choice, or one of these.
    pub shape_given_by: Vec<&'static Slip>,
}

/// What is to be seen in a picture that is not right to the last bit.
#[derive(Debug)]
pub struct Finding {
    /// The right picture in the same size, by the edition that comes nearest.
    pub right: Picture,
    /// The reader's, as a viewer shows it.
    pub yours: Picture,
    /// Where the two differ; `None` if only the shape is wrong, or only numbers
    /// that are no levels.
    pub difference: Option<Difference>,
    /// The farthest that a component is off, in levels.
    pub levels: u8,
    /// The mistakes that draw it, or what it is instead of a mistake.
    pub diagnosis: Diagnosis,
    /// Probes of which it is the right picture, as wide as it has to be, though one
    /// mistake draws it as well.
    pub others: Vec<Scene>,
}

/// Compares the picture in `bytes` with the scene's, by each edition of the book that
/// will do, and accepts components that are at most `tolerance` levels off.
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
    if let Some(cause) = not_as_wide(scene, reading) {
        return misshapen(scene, reading, cause);
    }
    let (width, height) = (reading.width, reading.height);
    let another_shape = wrong_shape(scene, width, height);
    if another_shape.is_none()
        && let Some(cause) = no_levels(reading)
    {
        return Check::NotAPicture {
            cause,
            finding: Some(Box::new(Finding::of(scene, reading))),
        };
    }
    match (Right::of(scene, reading, tolerance), another_shape) {
        (Some(right), None) => Check::Right(right),
        (Some(right), Some(_)) if is_a_shape_to_choose(width, height) => Check::Right(Right {
            shape_given_by: diagnosis::slips_giving(scene, width, height),
            ..right
        }),
        (_, Some(cause)) => misshapen(scene, reading, cause),
        (None, None) => wrong(scene, reading),
    }
}

fn wrong(scene: &Scene, reading: &Reading) -> Check {
    // What is off by single levels is this scene, in another way of rounding.
    let mut others = match Comparison::of(&nearest(scene, reading), &reading.picture()) {
        Comparison::Pixels(difference) if difference.levels <= 1 => Vec::new(),
        _ => scene.others(reading),
    };
    if others.first().is_some_and(|other| other.probe.is_none()) {
        return Check::of_another(scene, others);
    }
    let finding = Finding::of(scene, reading);
    // Two mistakes that nearly look like another scene are less likely than that scene.
    let is_likely = |set: &Set| set.is_exact() || set.is_enough() && set.mistakes[0].len() == 1;
    let is_explained = finding.diagnosis.sets.iter().any(is_likely);
    if !is_explained && !others.is_empty() {
        return Check::of_another(scene, others);
    }
    others.retain(|other| {
        other
            .probe
            .is_some_and(|probe| probe.width == reading.width)
    });
    Finding { others, ..finding }.judged(scene, reading, Check::Wrong)
}

fn misshapen(scene: &Scene, reading: &Reading, cause: Cause) -> Check {
    let others = scene.others(reading);
    if !others.is_empty() {
        return Check::of_another(scene, others);
    }
    let size = u64::from(reading.width) * u64::from(reading.height);
    match (size <= MOST_MISSHAPEN).then(|| Finding::of(scene, reading)) {
        Some(finding) => finding.judged(scene, reading, |finding| Check::WrongShape {
            cause,
            finding: Some(Box::new(finding)),
        }),
        None => Check::WrongShape {
            cause,
            finding: None,
        },
    }
}

impl Right {
    /// The first edition that draws the picture to the last bit, or else the first that
    /// draws it within the tolerance.
    fn of(scene: &Scene, reading: &Reading, tolerance: u8) -> Option<Self> {
        let within = |tolerance| {
            let (width, height) = (reading.width, reading.height);
            scene
                .by_editions(width, height)
                .filter(|scene| scene.may_be_shown_by(reading, tolerance))
                .find_map(|scene| {
                    let (off, levels) =
                        match Comparison::of(&scene.right(width, height), &reading.picture()) {
                            Comparison::Pixels(difference) => (difference.count, difference.levels),
                            _ => (0, 0),
                        };
                    (levels <= tolerance).then_some(Self {
                        scene,
                        width,
                        height,
                        off,
                        levels,
                        shape_given_by: Vec::new(),
                    })
                })
        };
        within(0).or_else(|| within(tolerance))
    }
}

impl Finding {
    /// The reader's picture beside the right one that comes nearest, and why it is not
    /// that one.
    fn of(scene: &Scene, reading: &Reading) -> Self {
        let diagnosis = diagnosis::diagnose(scene, reading);
        let right = diagnosis.scene.right(reading.width, reading.height);
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
            diagnosis,
            others: Vec::new(),
        }
    }

    /// What no mistake explains may be a neighbor of the right picture, or the picture of
    /// another chapter; the rest is `wrong`.
    fn judged(self, scene: &Scene, reading: &Reading, wrong: impl FnOnce(Self) -> Check) -> Check {
        if self.diagnosis.near.is_some() {
            return Check::Near(self);
        }
        let is_explained =
            self.diagnosis.sets.iter().any(Set::is_enough) || self.difference.is_none();
        match (!is_explained)
            .then(|| scene.of_another_chapter(reading))
            .flatten()
        {
            Some(other) => Check::of_another(scene, vec![other]),
            None => wrong(self),
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

    /// The exit code: 0 for right, 1 for wrong, 2 for not a picture. Right is what an
    /// edition of the book draws, to the last bit or within the tolerance, in a shape that
    /// no slip gives.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Right(right) if right.shape_given_by.is_empty() => 0,
            Self::Right(_)
            | Self::Near(_)
            | Self::Wrong(_)
            | Self::WrongShape { .. }
            | Self::Another { .. } => 1,
            Self::NotAPicture { .. } => 2,
        }
    }

    /// Other scenes of which it is the right picture.
    pub fn others(&self) -> &[Scene] {
        match self {
            Self::Another { scenes, .. } => scenes,
            other => other.finding().map_or(&[], |finding| &finding.others),
        }
    }

    /// What is to be seen, if there are pixels to judge and they are not right.
    pub fn finding(&self) -> Option<&Finding> {
        match self {
            Self::Right(_) | Self::Another { .. } => None,
            Self::Near(finding) | Self::Wrong(finding) => Some(finding),
            Self::WrongShape { finding, .. } | Self::NotAPicture { finding, .. } => {
                finding.as_deref()
            }
        }
    }
}

/// Whether somebody may want a picture of that shape: no stripe, and nothing endless.
fn is_a_shape_to_choose(width: u32, height: u32) -> bool {
    let [width, height] = [width, height].map(u64::from);
    width * height <= MOST_MISSHAPEN && width.max(height) <= 8 * width.min(height)
}

/// The right picture in the reader's size, by the edition that comes nearest.
fn nearest(scene: &Scene, reading: &Reading) -> Picture {
    diagnosis::nearest(scene, reading).right(reading.width, reading.height)
}

/// Why the picture is not that of the probe, which is about one width.
fn not_as_wide(scene: &Scene, reading: &Reading) -> Option<Cause> {
    let probe = scene.probe.filter(|probe| probe.spheres.is_none())?;
    let (width, height) = (reading.width, reading.height);
    let (name, wanted, chapter) = (probe.name, probe.width, scene.chapter.name());
    (wanted != width).then(|| Cause::new(
        "wrong-shape",
        format!(
            "the picture is {width} × {height}, but the probe {name} is about one {wanted} pixels wide"
        ),
        format!("Draw {chapter} with image_width = {wanted}."),
    ))
}

/// Why the picture is not of the scene's shape, if it is not.
fn wrong_shape(scene: &Scene, width: u32, height: u32) -> Option<Cause> {
    if scene
        .by_editions(width, height)
        .any(|scene| !scene.has_another_shape())
    {
        return None;
    }
    let name = scene.chapter.name();
    let expected = scene.height(width);
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
