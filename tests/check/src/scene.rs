//! The scene that a picture is meant to show.

use crate::names::companion;
use common::rtweekend::{Color, Picture};

use crate::bits::distance;
use crate::explanations::spread;
use crate::reading::Reading;
use slips::{Ball, Chapter, Edition, Ends, Probe, Program, Slip, steps};

/// A chapter's scene, or a probe's in that chapter, by one edition of the book.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// The chapter.
    pub chapter: Chapter,
    /// The probe, or `None` for the book's own scene.
    pub probe: Option<Probe>,
    /// The edition whose program draws it.
    pub edition: Edition,
    /// Whether no other edition will do.
    insists: bool,
    /// Whether nobody has said which chapter it is.
    is_guessed: bool,
    /// A step on the way to the chapter, counted from 0, if it is not the last.
    step: Option<usize>,
    /// Width and height in pixels, if they are not the chapter's own.
    shape: Option<(u32, u32)>,
    /// What the reader chose.
    pub chosen: Chosen,
}

/// What a reader chose otherwise than the book, and not by mistake.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Chosen {
    /// The colors of the sky, below and above.
    pub sky: Option<[Color; 2]>,
    /// The color of the sphere where it has only one.
    pub paint: Option<Color>,
    /// What the color of a hit is made of, if it has more than one.
    pub shade: Option<[Ends; 3]>,
    /// Blue in every pixel of the build test.
    pub blue: Option<f64>,
    /// The first and the second sphere.
    pub balls: [Option<Ball>; 2],
    /// The width of the viewport one unit away, if it does not follow from its height.
    pub viewport_width: Option<f64>,
    /// The height of the viewport one unit away, and with it the field of view.
    pub viewport_height: Option<f64>,
}

impl Chosen {
    /// Whether spheres or the viewport are the reader's own.
    pub(crate) fn is_placed(&self) -> bool {
        self.viewport_height.is_some() || self.balls != [None; 2]
    }

    /// Whether somebody may have typed the numbers of a picture of that ratio.
    pub(crate) fn is_typed(&self, ratio: f64) -> bool {
        let are_colors = !self.has_no_color() || self.times().is_some();
        are_colors
            && self.has_a_typed_sky()
            && self.has_a_typed_viewport(ratio)
            && self.has_a_typed_ground()
    }

    /// Whether the ground's radius has few digits: where it is, noise blurs.
    fn has_a_typed_ground(&self) -> bool {
        self.balls[1].is_none_or(|ground| is_round(100.0 * ground.radius))
    }

    /// Whether all components are hundredths, or all are levels; where the sky is a blend, for one
    /// color is known to a level only.
    fn has_a_typed_sky(&self) -> bool {
        let all = self.sky.iter().filter(|[below, above]| below != above);
        let all: Vec<f64> = all.flatten().flat_map(|it| it.to_array()).collect();
        let are_parts = |parts: f64| all.iter().all(|it| is_round(parts * it));
        are_parts(100.0) || are_parts(255.0)
    }

    /// Whether one of the viewport's lengths, the focal length or the angle has few digits.
    fn has_a_typed_viewport(&self, ratio: f64) -> bool {
        self.viewport_height.is_none_or(|height| {
            let width = self.viewport_width.unwrap_or(height * ratio);
            let mut lengths = [height, width, 2.0 / height, 2.0 / width].into_iter();
            let angle = angle(height);
            lengths.any(|it| is_round(100.0 * it)) || angle < WIDE && is_round(angle)
        })
    }

    /// Whether nobody chooses that, and slips draw it: what a hit's color is made of, the book's
    /// sky upside down, a color that is none.
    pub(crate) fn looks_like_a_slip(&self) -> bool {
        let [white, blue] = Program::right(Chapter::Gradient).sky;
        self.shade.is_some() || self.sky == Some([blue, white]) || self.has_no_color()
    }

    /// Whether a color of the sky is none.
    pub(crate) fn has_no_color(&self) -> bool {
        let is_none = |it: Color| it.min_element() < 0.0 || it.max_element() > 1.0;
        self.sky.is_some_and(|sky| sky.into_iter().any(is_none))
    }
}

/// Nobody looks under a wider angle, in degrees.
const WIDE: f64 = 150.0;

/// The degrees under which a viewport of that height one unit away is seen.
pub(crate) fn angle(height: f64) -> f64 {
    2.0 * (0.5 * height).atan().to_degrees()
}

/// Whether a number is an integer but for what fits leave.
pub(crate) fn is_round(number: f64) -> bool {
    (number - number.round()).abs() < 1e-3
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
            edition: Edition::V4,
            insists: false,
            is_guessed: false,
            step: None,
            shape: None,
            chosen: Chosen::default(),
        })
    }

    /// The same scene by that edition and no other.
    pub fn only_by(self, edition: Edition) -> Self {
        Self {
            edition,
            insists: true,
            ..self
        }
    }

    /// The same scene if nobody has said which it is.
    pub fn guessed(self) -> Self {
        Self {
            is_guessed: true,
            ..self
        }
    }

    /// Whether nobody has.
    pub(crate) fn is_guessed(&self) -> bool {
        self.is_guessed
    }

    /// The same with that probe, or `None` if the chapter has no place for its spheres.
    pub fn with_probe(self, probe: Probe) -> Option<Self> {
        probe.put_to(Program::right(self.chapter))?;
        Some(Self {
            probe: Some(probe),
            shape: None,
            ..self
        })
    }

    /// The chapter's own scene by the same edition.
    pub fn without_probe(self) -> Self {
        self.of_chapter(self.chapter)
    }

    /// The same step of the same scene, before a probe's change.
    pub(crate) fn unchanged(self) -> Self {
        Self {
            probe: None,
            ..self
        }
    }

    /// The same picture drawn with the whole of b in place of its half, or the other way
    /// round, if it is that of one sphere with its normals.
    pub(crate) fn with_the_other_formula(self) -> Option<Self> {
        let chapter = match (self.chapter, self.step) {
            (Chapter::Normals, None) => Chapter::HalfBSphere,
            (Chapter::HalfBSphere, None) => Chapter::Normals,
            _ => return None,
        };
        Some(Self { chapter, ..self })
    }

    /// The scene of another chapter by the same edition.
    pub(crate) fn of_chapter(self, chapter: Chapter) -> Self {
        Self {
            chapter,
            probe: None,
            step: None,
            shape: None,
            ..self
        }
    }

    /// The same scene as the book has it.
    pub(crate) fn without_choices(self) -> Self {
        self.with(Chosen::default())
    }

    /// The same scene as far as it is written after a step.
    pub(crate) fn at_step(self, step: usize) -> Self {
        Self {
            step: Some(step),
            ..self
        }
    }

    /// The step that it shows, counted from 0, if it is not the chapter's last.
    pub fn step(&self) -> Option<usize> {
        self.step
    }

    /// The same scene with what a reader chose.
    pub(crate) fn with(self, chosen: Chosen) -> Self {
        Self { chosen, ..self }
    }

    /// Whether the picture may be the right one of this scene to within so many levels:
    /// some pixels tell, before all are compared.
    pub(crate) fn may_be_shown_by(&self, reading: &Reading, tolerance: u8) -> bool {
        let output = self.program(&[]).run(reading.width);
        output.size() == (reading.width, reading.height)
            && spread(GLANCE, reading.pixels.len() as u32).all(|n| {
                let expected = output.pixel(n).map(|level| level as i16);
                distance(expected, reading.pixels[n as usize]) <= tolerance.into()
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
        let (companion, chapter) = (companion(), self.chapter.name());
        match self.probe {
            Some(probe) => self.probed_command(probe),
            None => format!("{companion} check {chapter} PICTURE"),
        }
    }

    /// The command that checks a picture of it with that probe.
    pub fn probed_command(&self, probe: Probe) -> String {
        let (companion, chapter) = (companion(), self.chapter.name());
        format!("{companion} check {chapter} --probe {} PICTURE", probe.name)
    }

    /// The same scene by each edition that will do, in a picture of that size: the
    /// latest edition first. Who draws in the shape that came with version 3.1.0 reads no
    /// earlier one; but many keep the rays and the factor of the first.
    pub(crate) fn by_editions(self, width: u32, height: u32) -> impl Iterator<Item = Self> {
        Edition::ALL
            .into_iter()
            .filter(move |edition| !self.insists || edition.name() == self.edition.name())
            .map(move |edition| Self { edition, ..self }.fitting(width, height))
            .filter(move |it| it.edition.is_first() || !it.is_in_a_later_shape(width, height))
    }

    /// Whether the picture has the shape of version 4, which its edition has not; never where the
    /// reader insists on that edition.
    pub(crate) fn is_in_a_later_shape(&self, width: u32, height: u32) -> bool {
        let latest = Self {
            edition: Edition::V4,
            ..self.in_own_shape()
        };
        !self.insists && self.has_another_shape() && latest.height(width) == height
    }

    /// The same scene in a picture of that size, whose shape may be the scene's own.
    pub fn fitting(self, width: u32, height: u32) -> Self {
        let own = self.in_own_shape();
        match own.height(width) == height {
            true => own,
            false => self.shaped(width, height),
        }
    }

    /// The same scene in the chapter's own shape.
    pub(crate) fn in_own_shape(self) -> Self {
        Self {
            shape: None,
            ..self
        }
    }

    /// The same scene in a picture of another shape.
    pub(crate) fn shaped(self, width: u32, height: u32) -> Self {
        Self {
            shape: Some((width, height)),
            ..self
        }
    }

    /// The same in another shape with the viewport of 4 × 2 all the same, if its edition prints
    /// that as numbers.
    pub(crate) fn with_printed_viewport(self) -> Option<Self> {
        let has_rays = self.chapter != Chapter::BuildTest;
        let is_printed = self.edition < Edition::V3_1_0 && has_rays && self.has_another_shape();
        let chosen = Chosen {
            viewport_width: Some(4.0),
            viewport_height: Some(2.0),
            ..self.chosen
        };
        is_printed.then(|| self.with(chosen))
    }

    /// Whether the shape is not that of the chapter.
    pub fn has_another_shape(&self) -> bool {
        self.shape.is_some()
    }

    /// The program that draws the scene, with these slips in it.
    pub fn program(&self, slips: &[&Slip]) -> Program {
        let mut program = self.edition.program(self.chapter);
        if let Some((width, height)) = self.shape {
            program.image_height = |width, ratio| ((width / ratio) as u32).max(1);
            program.aspect_ratio = ratio(width, height);
            program.viewport_ratio = |width, height, _| width / height;
            // Before version 4 the viewport has the ratio that was wished for, and the height or
            // the width follows from it.
            let by_width = |ratio: &&f64| (f64::from(width) / **ratio) as u32 == height;
            let by_height = |ratio: &&f64| (f64::from(height) * **ratio) as u32 == width;
            let heights: fn(f64, f64) -> u32 = |width, ratio| (width / ratio).ceil() as u32;
            // A ratio in single precision may be a little larger, and a row is missing.
            let in_single: fn(f64, f64) -> u32 =
                |width, ratio| (width / f64::from(ratio as f32)) as u32;
            let by_single = |ratio: &&f64| in_single(width.into(), **ratio) == height;
            let ratios = USUAL_RATIOS.iter();
            let wished = ratios
                .clone()
                .find(by_width)
                .map(|it| (*it, program.image_height));
            let wished = wished.or(ratios.clone().find(by_single).map(|it| (*it, in_single)));
            let wished = wished.or(ratios.clone().find(by_height).map(|it| (*it, heights)));
            if let Some((ratio, image_height)) = wished.filter(|_| self.edition.counts_from_below())
            {
                program.image_height = image_height;
                program.aspect_ratio = ratio;
                program.viewport_ratio = |_, _, aspect_ratio| aspect_ratio;
            }
        }
        if let Some(step) = self.step {
            program = steps::of(self.chapter)[step].put_to(program);
        }
        program.sky = self.chosen.sky.unwrap_or(program.sky);
        program.paint = self.chosen.paint.unwrap_or(program.paint);
        program.own_shade = self.chosen.shade;
        program.blue = self.chosen.blue.unwrap_or(program.blue);
        program.viewport_width = self.chosen.viewport_width;
        program.viewport_height = self
            .chosen
            .viewport_height
            .unwrap_or(program.viewport_height);
        for slip in slips {
            program = slip.put_to(program);
        }
        for (ball, own) in program.world.iter_mut().zip(self.chosen.balls) {
            *ball = own.unwrap_or(*ball);
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
        let (chapter, has_sizes) = (self.chapter, self.edition >= Edition::V3_1_0);
        slips::all().filter(move |slip| {
            slip.chapters.contains(&chapter) && (has_sizes || !slip.is_of_the_size())
        })
    }

    /// The height of the right picture that is `width` pixels wide.
    pub fn height(&self, width: u32) -> u32 {
        self.program(&[]).camera(width).image_height
    }

    /// The right picture in the size of the reader's.
    pub fn right(&self, width: u32, height: u32) -> Picture {
        let program = self.fitting(width, height).program(&[]);
        if self.edition.is_first() {
            // It has levels of its own; pictures are painted with those of version 4.
            return program.run(width).picture();
        }
        let camera = program.camera(width);
        Picture::paint(width, height, move |i, j| {
            (program.color)(&program, &camera, i, j)
        })
    }
}

/// How many pixels tell a scene from most others.
const GLANCE: u32 = 64;

/// Ratios of width to height that people choose.
pub(crate) const USUAL_RATIOS: [f64; 7] = [
    1.0,
    4.0 / 3.0,
    3.0 / 2.0,
    16.0 / 10.0,
    16.0 / 9.0,
    2.0,
    21.0 / 9.0,
];

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
