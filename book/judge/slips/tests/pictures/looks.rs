//! Appearance: how a wrong picture differs from the right one at first sight.

use common::rtweekend::Picture;
use slips::ChapterProgram;

/// The width in pixels of the pictures that are looked at. It is a multiple of 16, so that right
/// pictures with rays are exactly 16:9; the build test's is a square.
const WIDTH: u32 = 96;

/// The difference of a wrong picture from the right one that is seen first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Look {
    /// The pictures are equal.
    Right,
    /// No level differs by more than 2, which no eye sees.
    Faint,
    /// The wrong picture has another width or height.
    OtherSize,
    /// There should be a sphere, and nothing is hit.
    Gone,
    /// There should be sky, and everything is hit.
    Flooded,
    /// The right picture upside down, in a mirror, or transposed.
    Turned,
    /// Something is hit where there should be sky.
    Misplaced,
    /// There is sky where something should be hit.
    Incomplete,
    /// Hits are where they should be, and only they have other colors.
    OtherHits,
    /// Hits are where they should be, and only the sky has other colors.
    OtherSky,
    /// Hits are where they should be, and both they and the sky have other colors.
    OtherColors,
}

impl Look {
    /// Compares a wrong picture with the right one.
    pub(crate) fn of(right: &Drawn, wrong: &Drawn) -> Self {
        let size = |drawn: &Drawn| (drawn.picture.width(), drawn.picture.height());
        if size(right) != size(wrong) {
            return Self::OtherSize;
        }
        let hits = || right.is_hit.iter().zip(&wrong.is_hit);
        let gained = hits().any(|(right, wrong)| !right && *wrong);
        let lost = hits().any(|(right, wrong)| *right && !wrong);
        let [sky_off, hits_off] = levels_off(right, wrong);
        match sky_off.max(hits_off) {
            0 => Self::Right,
            1 | 2 => Self::Faint,
            _ if lost && wrong.is_hit.iter().all(|is_hit| !is_hit) => Self::Gone,
            _ if gained && wrong.is_hit.iter().all(|is_hit| *is_hit) => Self::Flooded,
            _ if turned(&right.picture).contains(&wrong.picture) => Self::Turned,
            _ if gained => Self::Misplaced,
            _ if lost => Self::Incomplete,
            _ if sky_off == 0 => Self::OtherHits,
            _ if hits_off == 0 => Self::OtherSky,
            _ => Self::OtherColors,
        }
    }
}

/// A picture, and for each of its pixels whether the ray hits something.
pub(crate) struct Drawn {
    pub(crate) picture: Picture,
    is_hit: Vec<bool>,
}

impl Drawn {
    /// Draws a program's picture. Only for pixels that differ from the right picture the program is
    /// asked again whether the ray hits something.
    pub(crate) fn by(program: &ChapterProgram, right: Option<&Self>) -> Self {
        let output = program.run(WIDTH);
        let picture = output.picture();
        let pixel = |picture: &Picture, n: usize| picture.rgb().as_chunks::<3>().0[n];
        let right = right.filter(|it| it.is_hit.len() == picture.rgb().len() / 3);
        let as_right = |n| right.filter(|it| pixel(&it.picture, n) == pixel(&picture, n));
        let is_hit = |n| match as_right(n) {
            Some(right) => right.is_hit[n],
            None => output.hits(n as u32),
        };
        Self {
            is_hit: (0..picture.rgb().len() / 3).map(is_hit).collect(),
            picture,
        }
    }
}

/// Returns the largest difference of a level in the sky, and the largest where the ray should hit.
fn levels_off(right: &Drawn, wrong: &Drawn) -> [u8; 2] {
    let levels = right.picture.rgb().iter().zip(wrong.picture.rgb());
    let mut off = [0; 2];
    for (n, (right_level, wrong_level)) in levels.enumerate() {
        let most = &mut off[usize::from(right.is_hit[n / 3])];
        *most = right_level.abs_diff(*wrong_level).max(*most);
    }
    off
}

/// Returns the picture upside down, in a mirror, and transposed if it is a square.
fn turned(picture: &Picture) -> Vec<Picture> {
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    let (pixels, _) = picture.rgb().as_chunks::<3>();
    let pixels_at = |place: fn(usize, usize, usize, usize) -> usize| {
        let places = (0..height).flat_map(|j| (0..width).map(move |i| place(i, j, width, height)));
        let rgb = places.flat_map(|n| pixels[n]).collect();
        Picture::from_rgb(picture.width(), picture.height(), rgb)
            .expect("there are as many pixels as before")
    };
    let mut all = vec![
        pixels_at(|i, j, width, height| (height - 1 - j) * width + i),
        pixels_at(|i, j, width, _| j * width + width - 1 - i),
    ];
    if width == height {
        all.push(pixels_at(|i, j, width, _| i * width + j));
    }
    all
}
