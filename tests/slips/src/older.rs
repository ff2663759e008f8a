//! The older editions as mutations of the latest one: a few other steps, like a slip, but
//! right from the first line to the last.

use crate::chapter::Chapter;
use crate::edition::Edition;
use crate::program::Program;
use crate::single;

impl Edition {
    /// The chapter's program in this edition.
    ///
    /// # Panics
    /// If the chapter is not one of [`Chapter::OF_THE_BOOK`].
    pub fn program(self, chapter: Chapter) -> Program {
        let mut program = Program::right(chapter);
        let p = &mut program;
        p.edition = self;
        match self {
            Self::V4 => {}
            Self::V3 => count_from_below(p),
            Self::V3_0 => make_two_to_one(p),
            Self::V1 | Self::V1InDouble => {
                make_two_to_one(p);
                p.level = |component| (255.99 * component) as i32;
                // Front and back are of version 3.
                p.face = |_, _, outward| outward;
            }
        }
        if self == Self::V1 && chapter != Chapter::BuildTest {
            p.color = single::color;
        }
        program
    }
}

/// 16:9. The viewport's left edge points up from its lower left corner, and a pixel is
/// a fraction of the whole edges.
fn count_from_below(p: &mut Program) {
    if p.chapter != Chapter::BuildTest {
        p.image_height = |width, aspect_ratio| (width / aspect_ratio) as u32;
    }
    p.viewport_ratio = |_, _, aspect_ratio| aspect_ratio;
    p.edges = [1.0, 1.0];
    p.last = 1.0;
    p.divisors = |width, height| [width, height];
    p.inset = [0.0, 0.0];
    p.blue = 0.25;
}

/// Twice as wide as high, in all chapters, and the last column stops short of 1.
fn make_two_to_one(p: &mut Program) {
    count_from_below(p);
    p.aspect_ratio = 2.0;
    p.image_height = |width, aspect_ratio| (width / aspect_ratio) as u32;
    p.viewport_ratio = |_, _, _| 2.0;
    p.last = 0.0;
    p.blue = 0.2;
}
