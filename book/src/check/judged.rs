//! A picture with its verdict: what text, JSON and the page tell.

use check::blind_spots::BlindSpots;
use check::evidence::Known;
use check::scene::Scene;
use check::verdict::{Check, Right};

use super::input::Source;

/// A picture after it has been judged.
pub(crate) struct Judged<'a> {
    /// What it should show.
    pub(crate) scene: Scene,
    /// Where it came from.
    pub(crate) source: Source<'a>,
    /// What is known besides the picture.
    pub(crate) known: Known<'a>,
    /// What was found.
    pub(crate) check: Check,
    /// What is still hidden, if the picture is right to the last bit.
    pub(crate) blind_spots: Option<BlindSpots>,
}

impl<'a> Judged<'a> {
    /// Says of a right picture what it can't show. That of a probe follows the chapter's
    /// own, so it has to show only what is left.
    pub(crate) fn new(scene: Scene, source: Source<'a>, known: Known<'a>, check: Check) -> Self {
        let blind_spots = match &check {
            Check::Right(Right {
                scene,
                width,
                levels: 0,
                ..
            }) => Some(BlindSpots::after(scene, *width)),
            _ => None,
        };
        Self {
            scene,
            source,
            known,
            check,
            blind_spots,
        }
    }
}
