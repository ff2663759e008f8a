//! Appearance: what can be seen of the slips, as a test keeps it.
//!
//! To draw all of them and to look takes a quarter of a minute. What was seen is a snapshot of the
//! test of these pictures, and whoever shows them draws only what is shown.

use std::sync::OnceLock;

use common::rtweekend::Picture;

use crate::catalogue::find;
use crate::chapter::Chapter;
use crate::slip::Slip;

/// A wrong picture, and the slips that draw exactly this one.
pub struct Sight {
    /// How it differs from the right one, in a word: `Gone` where no sphere is left.
    pub look: &'static str,
    /// Whose picture it should be.
    pub chapter: Chapter,
    /// The slips.
    pub slips: Vec<&'static Slip>,
    picture: OnceLock<Picture>,
}

/// The width of the pictures of all sights, in pixels: exactly 16:9.
pub const SIGHT_WIDTH: u32 = 96;

/// A line for each sight: its look, its chapter, its slips.
const KEPT: &str = include_str!("../tests/pictures/snapshots/pictures__sights.snap");

/// Lists everything that can be seen: each slip in the first chapter in which it has a look, and
/// again in the first one in which it has another.
pub fn sights() -> Vec<Sight> {
    kept(KEPT).filter_map(Sight::read).collect()
}

/// Returns the lines of a snapshot, below its header between lines of dashes.
pub(crate) fn kept(snapshot: &'static str) -> impl Iterator<Item = &'static str> {
    let body = snapshot.splitn(3, "---\n").nth(2);
    body.unwrap_or_default().lines()
}

impl Sight {
    fn read(line: &'static str) -> Option<Self> {
        let mut words = line.split_whitespace();
        Some(Self {
            look: words.next()?,
            chapter: Chapter::find(words.next()?)?,
            slips: words.filter_map(find).collect(),
            picture: OnceLock::new(),
        })
    }

    /// Draws what each of the slips draws, once.
    pub fn picture(&self) -> &Picture {
        let draw = || {
            self.slips[0]
                .program(self.chapter)
                .run(SIGHT_WIDTH)
                .picture()
        };
        self.picture.get_or_init(draw)
    }
}
