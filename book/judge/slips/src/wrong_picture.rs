//! Appearance: the wrong pictures that slips draw, grouped by how they look.
//!
//! To draw and compare all of them takes a quarter of a minute. A test does it once and keeps a
//! line for each picture in a snapshot, which is read here; a picture itself is drawn when asked
//! for.

use std::sync::OnceLock;

use common::rtweekend::Picture;

use crate::catalogue::find;
use crate::chapter::Chapter;
use crate::slip::Slip;

/// A wrong picture of a chapter, and all slips (known mistakes) whose programs draw exactly this
/// picture.
pub struct WrongPicture {
    /// The kind of difference from the right picture, in a word, as `Gone` where no sphere is left.
    pub look: &'static str,
    /// The chapter in which the slips are made.
    pub chapter: Chapter,
    /// The slips that draw the picture, in the order of [`all`](crate::all); never empty.
    pub slips: Vec<&'static Slip>,
    picture: OnceLock<Picture>,
}

/// The width in pixels for which every [`WrongPicture`] is drawn. It is a multiple of 16, so that
/// right pictures with rays are exactly 16:9; the build test's is a square.
pub const WRONG_PICTURE_WIDTH: u32 = 96;

/// A line for each wrong picture: its look, its chapter, its slips.
const KEPT: &str = include_str!("../tests/pictures/snapshots/pictures__looks.snap");

/// Lists the wrong pictures that slips draw, in the order of their first slips. A slip is listed
/// once for each look that it has, in the first chapter where it looks so.
pub fn wrong_pictures() -> Vec<WrongPicture> {
    kept(KEPT).filter_map(WrongPicture::read).collect()
}

/// Returns the lines of a snapshot, below its header between lines of dashes.
pub(crate) fn kept(snapshot: &'static str) -> impl Iterator<Item = &'static str> {
    let body = snapshot.splitn(3, "---\n").nth(2);
    body.unwrap_or_default().lines()
}

impl WrongPicture {
    /// Reads a line of the snapshot; `None` if a word is missing or names no chapter.
    fn read(line: &'static str) -> Option<Self> {
        let mut words = line.split_whitespace();
        Some(Self {
            look: words.next()?,
            chapter: Chapter::find(words.next()?)?,
            slips: words.filter_map(find).collect(),
            picture: OnceLock::new(),
        })
    }

    /// Returns the picture that the first slip draws for the width [`WRONG_PICTURE_WIDTH`]; its own
    /// width may be wrong. It is drawn at the first call and kept.
    pub fn picture(&self) -> &Picture {
        let draw = || {
            self.slips[0]
                .program(self.chapter)
                .run(WRONG_PICTURE_WIDTH)
                .picture()
        };
        self.picture.get_or_init(draw)
    }
}
