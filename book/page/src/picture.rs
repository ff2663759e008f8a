//! Progressive rendering: the picture of a chapter at any width, and what a slip draws in
//! its place, painted in pieces, so that a page can show each frame what there is.

use std::iter;

use common::rtweekend::Picture;
use figures::escape;
use slips::{Chapter, Edition, Letters, PROBES, Program, Slip, Unseen, Words};

use crate::opaque;

/// A picture while it is painted.
pub struct Painting {
    /// Width and height in pixels. A slip may swap them.
    pub size: (u32, u32),
    /// Pieces of it in reading order, four bytes a pixel as a canvas takes them.
    pub pieces: Box<dyn Iterator<Item = Vec<u8>>>,
}

impl Painting {
    /// The picture of a chapter, as it should be or with a slip.
    pub fn new(chapter: Chapter, slip: Option<&Slip>, width: u32) -> Self {
        match slip {
            Some(slip) => Self::slipped(slip.program(chapter), width),
            None => Self::right(picture(chapter, width)),
        }
    }

    fn right(picture: Picture) -> Self {
        let (size, strips) = ((picture.width(), picture.height()), picture.strips());
        let piece = move |strip| {
            let mut rgb = Vec::new();
            picture.push_strip(strip, &mut rgb);
            let (pixels, _) = rgb.as_chunks();
            opaque(pixels.iter().copied())
        };
        Self {
            size,
            pieces: Box::new((0..strips).map(piece)),
        }
    }

    fn slipped(program: Program, width: u32) -> Self {
        let output = program.run(width);
        let mut pixels = output.rgb();
        let piece = move || {
            let piece = opaque(pixels.by_ref().take(PIECE));
            (!piece.is_empty()).then_some(piece)
        };
        Self {
            size: output.size(),
            pieces: Box::new(iter::from_fn(piece)),
        }
    }
}

/// What is painted, as HTML: the picture in that width; or a slip, which makes
/// `different` of its pixels wrong.
pub fn verdict(chapter: Chapter, slip: Option<&Slip>, width: u32, different: u32) -> String {
    let right = picture(chapter, width);
    let (width, height) = (right.width(), right.height());
    let Some(slip) = slip else {
        return format!(
            "{width} × {height} pixels, painted in this page by the chapter's own code."
        );
    };
    let (wide, high) = slip.program(chapter).run(width).size();
    let seen = if (wide, high) != (width, height) {
        format!("It is {wide} × {high}, and should be {width} × {height}.")
    } else if different == 0 {
        format!("Here no pixel differs{}", shown_by(slip, chapter))
    } else {
        format!("{different} of {} pixels differ.", width * height)
    };
    let Words { wrong, right, why } = slip.words(Letters::Book(Edition::V4), chapter);
    format!(
        "<code>{}</code> should be <code>{}</code>. {} {} <a href=\"{}\">The right line</a>, and \
         <a href=\"slips.html#{name}\">more that look like this</a>.",
        escape(&wrong),
        escape(&right),
        escape(why),
        escape(&seen),
        slip.address(),
        name = slip.name,
    )
}

/// The numbers of a pixel, a line each: as they should be, and with the slip.
pub fn inspect(chapter: Chapter, slip: Option<&Slip>, width: u32, pixel: [u32; 2]) -> String {
    let [column, row] = pixel;
    let slipped = slip.map(|slip| slip.program(chapter));
    let programs = iter::once(Program::right(chapter)).chain(slipped);
    let traced = programs.map(|it| it.traced(width, column, row).rows(chapter));
    slips::side_by_side(&traced.collect::<Vec<_>>())
}

/// What shows a slip where this picture does not.
fn shown_by(slip: &Slip, chapter: Chapter) -> String {
    match slip.unseen_in(chapter) {
        Some(Unseen::Equivalent(why)) => format!(". {why}"),
        Some(Unseen::OnlyByLaw(law)) => format!("; a law shows it: {law}"),
        None => match PROBES.iter().find(|probe| probe.tells(slip, chapter)) {
            Some(probe) => format!("; the probe {} shows it.", probe.name),
            None => ".".to_owned(),
        },
    }
}

/// By the chapter's own function. [`Chapter::picture`] knows chapter 6, too, and so would bring
/// the files of its scenes along, and what reads them.
fn picture(chapter: Chapter, width: u32) -> Picture {
    match chapter {
        Chapter::BuildTest => build_test::picture(width),
        Chapter::Gradient => gradient::picture(width),
        Chapter::RedSphere => red_sphere::picture(width),
        Chapter::Normals => normals::picture(width),
        Chapter::HalfBSphere => half_b_sphere::picture(width),
        Chapter::HittableList => hittable_list::picture(width),
        Chapter::SpeedVsAccuracy => unreachable!("no page paints it"),
    }
}

/// Pixels in a piece of a wrong picture: as many as in a strip of the right one, or more.
const PIECE: usize = 2560;
