//! Progressive rendering: the picture of a chapter at any width, and what a slip draws in
//! its place, painted in pieces, so that a page can show each frame what there is.

use std::iter;

use common::rtweekend::Picture;
use figures::escape;
use slips::{Chapter, Edition, Letters, PROBES, Program, Slip, Unseen, Words};

/// A chapter whose page paints its picture.
#[derive(Clone, Copy, Debug)]
pub struct LivePicture {
    /// The chapter.
    pub chapter: Chapter,
    /// Its own function from a width in pixels.
    pub picture: fn(u32) -> Picture,
    /// What a reader is to find out.
    pub question: &'static str,
}

/// The pictures of the book. Chapter 6 is none of its, knows no slip, and would bring the
/// files of its scenes along, and what reads them: so not [`Chapter::picture`] is asked.
pub static PICTURES: &[LivePicture] = &[
    LivePicture {
        chapter: Chapter::BuildTest,
        picture: build_test::picture,
        question: "Which mistake turns the picture upside down, and which one is invisible?",
    },
    LivePicture {
        chapter: Chapter::Gradient,
        picture: gradient::picture,
        question: "Leave out one function call, and each row has a single color. Which?",
    },
    LivePicture {
        chapter: Chapter::RedSphere,
        picture: red_sphere::picture,
        question: "Which wrong sign makes the disc vanish, and which one does no harm here?",
    },
    LivePicture {
        chapter: Chapter::Normals,
        picture: normals::picture,
        question: "What does the ball look like if you take the farther root?",
    },
    LivePicture {
        chapter: Chapter::HalfBSphere,
        picture: half_b_sphere::picture,
        question: "What do you see if you use h but keep the 2 and the 4 of chapter 3?",
    },
    LivePicture {
        chapter: Chapter::HittableList,
        picture: hittable_list::picture,
        question: "What does the picture show if the first hit wins? And if the last one wins?",
    },
];

/// The widest picture that a page paints, in pixels.
pub const WIDEST: u32 = 1920;

/// A picture while it is painted: pieces of it in reading order, four bytes a pixel as a
/// canvas takes them.
pub struct Painting {
    size: (u32, u32),
    pieces: Box<dyn Iterator<Item = Vec<u8>>>,
}

impl Painting {
    /// A picture of a chapter, as it should be.
    pub fn right(picture: Picture) -> Self {
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

    /// The picture that the program of someone with this slip draws.
    pub fn slipped(slip: &Slip, chapter: Chapter, width: u32) -> Self {
        let output = slip.program(chapter).run(width);
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

    /// Width and height in pixels. A slip may swap them.
    pub fn size(&self) -> (u32, u32) {
        self.size
    }
}

impl Iterator for Painting {
    type Item = Vec<u8>;

    fn next(&mut self) -> Option<Vec<u8>> {
        self.pieces.next()
    }
}

/// What is painted, as HTML: the picture in that width; or a slip, which makes
/// `different` of its pixels wrong.
pub fn verdict(live: &LivePicture, slip: Option<&Slip>, width: u32, different: u32) -> String {
    let picture = (live.picture)(width);
    let size = (picture.width(), picture.height());
    let Some(slip) = slip else {
        let (width, height) = size;
        return format!(
            "{width} × {height} pixels, painted in this page by the chapter's own code."
        );
    };
    let wrong_size = slip.program(live.chapter).run(width).size();
    let Words { wrong, right, why } = slip.words(Letters::Book(Edition::V4), live.chapter);
    format!(
        "<code>{}</code> should be <code>{}</code>. {} {} <a href=\"{}\">The right line</a>, and \
         <a href=\"caught.html#{name}\">the test that catches the wrong one</a>.",
        escape(&wrong),
        escape(&right),
        escape(why),
        escape(&match (size == wrong_size, different) {
            (false, _) => sizes(wrong_size, size),
            (true, 0) => unseen(slip, live.chapter),
            (true, _) => format!("{different} of {} pixels differ.", size.0 * size.1),
        }),
        slip.address(),
        name = slip.name,
    )
}

/// The numbers of a pixel, a line each: as they should be, and with the slip.
pub fn inspect(
    live: &LivePicture,
    slip: Option<&Slip>,
    width: u32,
    [column, row]: [u32; 2],
) -> String {
    let slipped = slip.map(|slip| slip.program(live.chapter));
    let programs = iter::once(Program::right(live.chapter)).chain(slipped);
    let traced = programs.map(|it| it.traced(width, column, row).rows(live.chapter));
    slips::side_by_side(&traced.collect::<Vec<_>>())
}

fn sizes((wide, high): (u32, u32), (width, height): (u32, u32)) -> String {
    format!("It is {wide} × {high}, and should be {width} × {height}.")
}

/// What shows a slip where this picture does not.
fn unseen(slip: &Slip, chapter: Chapter) -> String {
    let probe = || PROBES.iter().find(|probe| probe.tells(slip, chapter));
    match slip.unseen_in(chapter) {
        Some(Unseen::Equivalent(why)) => format!("In this picture no pixel differs. {why}"),
        Some(Unseen::OnlyByLaw(law)) => {
            format!("In this picture no pixel differs; a law shows it: {law}")
        }
        None => match probe() {
            Some(probe) => format!(
                "In this picture no pixel differs; the probe {} shows it.",
                probe.name
            ),
            None => "At this width no pixel differs.".to_owned(),
        },
    }
}

/// Pixels in a piece of a wrong picture: as many as in a strip of the right one, or more.
const PIECE: usize = 2560;

fn opaque(pixels: impl Iterator<Item = [u8; 3]>) -> Vec<u8> {
    pixels
        .flat_map(|[red, green, blue]| [red, green, blue, u8::MAX])
        .collect()
}
