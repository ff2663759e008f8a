//! The scene that a picture is meant to show.

use common::engine::companion;
use common::rtweekend::Picture;

use crate::chapter::Chapter;
use crate::slips::{self, Probe, Program, Slip};

/// A chapter's scene, or a probe's in that chapter.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// The chapter.
    pub chapter: Chapter,
    /// The probe, or `None` for the book's own scene.
    pub probe: Option<Probe>,
    /// Width and height in pixels, if they are not the chapter's own.
    shape: Option<(u32, u32)>,
}

impl Scene {
    /// The scene, or `None` if the chapter has no place for the probe's spheres.
    pub fn new(chapter: Chapter, probe: Option<Probe>) -> Option<Self> {
        if let Some(probe) = probe {
            probe.put_to(Program::right(chapter))?;
        }
        Some(Self {
            chapter,
            probe,
            shape: None,
        })
    }

    /// What a reader changes to draw it that wide, a line each.
    pub fn change(&self, width: u32) -> String {
        match self.probe {
            Some(probe) => probe.lines(self.chapter),
            None => format!("image_width = {width}"),
        }
    }

    /// The command that checks a picture of it.
    pub fn command(&self) -> String {
        let probe = self.probe.map(|probe| format!("--probe {} ", probe.name));
        let (companion, chapter) = (companion(), self.chapter.name());
        format!(
            "{companion} check {chapter} {}PICTURE",
            probe.unwrap_or_default()
        )
    }

    /// The same scene in a picture of another shape.
    pub(super) fn shaped(self, width: u32, height: u32) -> Self {
        Self {
            shape: Some((width, height)),
            ..self
        }
    }

    /// The program that draws the scene, with these slips in it.
    pub fn program(&self, slips: &[&Slip]) -> Program {
        let mut program = Program::right(self.chapter);
        if let Some((width, height)) = self.shape {
            program.aspect_ratio = ratio(width, height);
            program.image_height = |width, ratio| ((width / ratio) as u32).max(1);
        }
        for slip in slips {
            program = (slip.alter)(program);
        }
        match self.probe {
            Some(probe) => probe
                .put_to(program)
                .expect("a scene has room for its probe"),
            None => program,
        }
    }

    /// The slips that can be made here.
    pub fn slips(&self) -> impl Iterator<Item = &'static Slip> + use<> {
        let chapter = self.chapter;
        slips::all().filter(move |slip| slip.chapters.contains(&chapter))
    }

    /// The height of the right picture that is `width` pixels wide.
    pub fn height(&self, width: u32) -> u32 {
        self.program(&[]).camera(width).image_height
    }

    /// The right picture in the size of the reader's.
    pub fn right(&self, width: u32, height: u32) -> Picture {
        let program = self.shaped(width, height).program(&[]);
        let camera = program.camera(width);
        Picture::paint(width, height, move |i, j| {
            (program.color)(&program, &camera, i, j)
        })
    }
}

/// Width over height, such that dividing the width by it gives the height even
/// after rounding down.
fn ratio(width: u32, height: u32) -> f64 {
    let [width, height] = [width, height].map(f64::from);
    let ratio = width / height;
    if width / ratio < height {
        ratio.next_down()
    } else {
        ratio
    }
}
