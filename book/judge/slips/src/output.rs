//! Lazy rendering: what a chapter's program prints, computed pixel by pixel when asked for.

use std::fmt;

use common::rtweekend::*;
use interpreter::{Canvas, TracedValue};
use texts::file;

use crate::asked::integers;
use crate::code::stored;
use crate::files::FILE;
use crate::program::ChapterProgram;

/// The output of a [`ChapterProgram`] that draws one picture: the size and the pixels of a P3 file.
/// Pixels are computed when they are asked for, each time anew.
///
/// Pixels are numbered from 0 in the order in which they are printed. A right program prints them
/// row by row from the top, each row from the left: number `j * width + i`.
#[derive(Clone, Debug)]
pub struct Output {
    program: ChapterProgram,
    /// `None` if the program stops before its first pixel.
    canvas: Option<Canvas>,
    size: (u32, u32),
    /// True if loop and levels are the right ones, which are computed here faster than by the text.
    has_right_loop: bool,
}

/// The functions around a chapter, in `file.rs`, by which a color becomes a pixel of the file.
const AROUND: [&str; 3] = ["place", "print", "level"];

impl ChapterProgram {
    /// Returns the output of the program for a picture `width` pixels wide. No pixel is computed
    /// yet, unless the program prints its whole picture as one text. If the program stops before
    /// its first pixel, the size is 0 by 0.
    pub fn run(&self, width: u32) -> Output {
        let canvas = self.code().canvas(width).ok();
        let (columns, rows) = canvas.as_ref().map_or((0, 0), Canvas::size);
        let header = integers(self.code(), "header", &mut [columns.into(), rows.into()]);
        let size = match header.as_deref() {
            Some([columns, rows]) => (*columns as u32, *rows as u32),
            _ => (0, 0),
        };
        let is_right = |(name, text)| !AROUND.contains(&name) || FILE.contains(text);
        Output {
            program: self.clone(),
            canvas,
            size,
            has_right_loop: self.functions().all(is_right),
        }
    }
}

impl Output {
    /// Returns the width and the height, in pixels, that the program prints in the header of the
    /// file; 0 and 0 if it stops before.
    pub fn size(&self) -> (u32, u32) {
        self.size
    }

    /// Returns the three levels, red, green and blue, that the program prints for the `n`th pixel,
    /// from 0; zeros if the program stops there. `n` has to be below width times height.
    ///
    /// The levels of a right program are 0 to 255. A wrong one may print any number; NaN becomes 0,
    /// as a conversion to `i32` makes it. In C++ numbers beyond ±2³¹ and NaN become −2³¹ on some
    /// processors.
    pub fn pixel(&self, n: u32) -> [i32; 3] {
        self.printed(n).unwrap_or_default()
    }

    /// Returns the levels of the `n`th pixel like [`pixel`](Self::pixel), but `None` if the program
    /// stops there.
    pub fn printed(&self, n: u32) -> Option<[i32; 3]> {
        let color = self.color(n)?;
        if self.has_right_loop {
            return Some(color.to_array().map(file::level));
        }
        let program = &self.program;
        let levels = integers(program.code(), "print", &mut [color.into()])?;
        levels.try_into().ok()
    }

    /// Returns the color of the `n`th pixel, unless the program stops there.
    pub(crate) fn color(&self, n: u32) -> Option<Color> {
        let (i, j) = self.place(n)?;
        self.canvas.as_ref()?.color(i, j).ok()
    }

    /// Returns the ray of the `n`th pixel; `None` if the program has no rays or stops.
    pub(crate) fn ray(&self, n: u32) -> Option<Ray> {
        let (i, j) = self.place(n)?;
        let (width, _) = self.canvas.as_ref()?.size();
        self.program.ray(width, i, j)
    }

    /// Returns the column and the row of the `n`th pixel, from the top left.
    fn place(&self, n: u32) -> Option<(u32, u32)> {
        let (columns, rows) = self.canvas.as_ref()?.size();
        if self.has_right_loop {
            let [i, j] = (columns > 0).then(|| file::place(n, columns, rows))?;
            return Some((i, j));
        }
        let mut given = [n.into(), columns.into(), rows.into()];
        let place = integers(self.program.code(), "place", &mut given)?;
        Some((place[0] as u32, place[1] as u32))
    }

    /// Returns the levels of all pixels, in the order in which the program prints them.
    pub fn pixels(&self) -> impl Iterator<Item = [i32; 3]> + '_ {
        (0..self.size.0 * self.size.1).map(|n| self.pixel(n))
    }

    /// Returns the values that the program's variables get while it computes the `n`th pixel, in
    /// the order of the computation. Empty if the program stops before its first pixel.
    pub fn traced_values(&self, n: u32) -> Vec<TracedValue> {
        match (&self.canvas, self.place(n)) {
            (Some(canvas), Some((i, j))) => canvas.trace(i, j),
            _ => Vec::new(),
        }
    }

    /// Returns true if the ray of the `n`th pixel, from 0, hits a sphere: `ray_color` returns
    /// before its last expression, the sky.
    pub fn hits(&self, n: u32) -> bool {
        let is_hit = |value: &TracedValue| value.name.is_none() && *value.function == *"ray_color";
        self.traced_values(n).iter().any(is_hit)
    }

    /// Returns all pixels as bytes of red, green and blue, row by row from the top left. Levels are
    /// clamped to 0 to 255.
    pub fn rgb(&self) -> impl Iterator<Item = [u8; 3]> + '_ {
        self.pixels().map(move |pixel| pixel.map(stored))
    }

    /// Returns the picture of all pixels as [`rgb`](Self::rgb) gives them.
    ///
    /// # Panics
    /// If width times height, as the program prints them, is 2³² or more.
    pub fn picture(&self) -> Picture {
        let (width, height) = self.size;
        let rgb = self.rgb().flatten().collect();
        Picture::from_rgb(width, height, rgb).expect("there are as many pixels as the size says")
    }
}

/// Writes the P3 file that the book's C++ prints, with levels like 256 and −127 as they are.
impl fmt::Display for Output {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (width, height) = self.size;
        write!(f, "P3\n{width} {height}\n255\n")?;
        for [red, green, blue] in self.pixels() {
            writeln!(f, "{red} {green} {blue}")?;
        }
        Ok(())
    }
}
