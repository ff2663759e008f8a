//! The right program of a chapter, for pictures of another shape than the chapter's.

use crate::chapter::Chapter;
use crate::edit::Edit;
use crate::program::ChapterProgram;

impl ChapterProgram {
    /// Returns the right program of a chapter, for pictures of any shape.
    ///
    /// `size` is the width and the height of a picture in pixels: the program draws pictures with
    /// this ratio, and the build test (the picture before there are rays) with this height. `None`
    /// keeps the chapter's own shape.
    ///
    /// # Panics
    /// If the chapter is not one of [`Chapter::OF_THE_BOOK`].
    pub fn right_of_shape(chapter: Chapter, size: Option<(u32, u32)>) -> Self {
        let right = Self::right(chapter);
        let edits = match (size, chapter) {
            (None, _) => return right,
            (Some((_, rows)), Chapter::BuildTest) => vec![
                Edit::new(
                    "Picture::paint(width, width",
                    format!("Picture::paint(width, {rows}_u32"),
                ),
                Edit::new(
                    "f64::from(j) / last",
                    format!("f64::from(j) / f64::from(({rows}_u32 - 1).max(1))"),
                ),
            ],
            (Some(size), _) => vec![Edit::new("16.0 / 9.0", format!("{:?}", ratio(size)))],
        };
        let program = right.with_any(&edits);
        program.expect("a chapter of another shape is a program")
    }
}

/// Returns width over height, made smaller by an ulp if the width divided by it, rounded down,
/// would not be the height.
fn ratio((width, height): (u32, u32)) -> f64 {
    let [width, height] = [width, height].map(f64::from);
    let ratio = width / height;
    if width / ratio < height {
        ratio.next_down()
    } else {
        ratio
    }
}
