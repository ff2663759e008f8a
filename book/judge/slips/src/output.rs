//! Lazy rendering: what a chapter's program prints, computed pixel by pixel when asked for.

use std::fmt;

use common::rtweekend::*;
use interpreter::{Canvas, TracedValue};

use crate::files::FILE;
use crate::program::ChapterProgram;

/// The output of a [`ChapterProgram`] for one width: the size and the pixels of a P3 file. A pixel
/// is computed each time that it is asked for.
///
/// Pixels are numbered from 0 in the order in which they are printed: row by row from the left, the
/// top row first, unless the program has the loops wrong.
#[derive(Clone, Debug)]
pub struct Output {
    program: ChapterProgram,
    /// `None` if the program stops before its first pixel.
    canvas: Option<Canvas>,
    size: (u32, u32),
    /// True if loop and levels are the right ones, which are computed here faster than by the text.
    has_right_loop: bool,
}

/// The functions around a chapter, in `text/file.rs`, by which a color becomes a pixel of the file.
const AROUND: [&str; 3] = ["place", "print", "level"];

impl ChapterProgram {
    /// Starts the program for a picture `width` pixels wide. Nothing is traced before a pixel is
    /// asked for. The output of a program that stops at once has no pixels.
    pub fn run(&self, width: u32) -> Output {
        let canvas = self.code().canvas(width).ok();
        let (columns, rows) = canvas.as_ref().map_or((0, 0), Canvas::size);
        let header = self.code().call_with_integers("header", &[columns, rows]);
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
    /// Returns the width and the height that the header has, in pixels; 0 and 0 if the program stops
    /// before it.
    pub fn size(&self) -> (u32, u32) {
        self.size
    }

    /// Returns the levels red, green and blue that are printed for the `n`th pixel; zeros where the
    /// program stops.
    ///
    /// A right program prints 0 to 255, a wrong one may print levels that no picture can hold. C++
    /// converts to `int` in the same way, except that numbers beyond ±2³¹ and NaN become −2³¹ on
    /// some processors.
    pub fn pixel(&self, n: u32) -> [i32; 3] {
        self.printed(n).unwrap_or_default()
    }

    /// Returns the levels of the `n`th pixel as [`pixel`](Self::pixel) does, but `None` where the
    /// program stops.
    pub fn printed(&self, n: u32) -> Option<[i32; 3]> {
        let color = self.color(n)?;
        if self.has_right_loop {
            return Some(
                color
                    .to_array()
                    .map(|component| (255.999 * component) as i32),
            );
        }
        let levels = self
            .program
            .code_of_levels()
            .call_with_color("print", color)?;
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
            return Some((n.checked_rem(columns)?, n / columns));
        }
        let place = self
            .program
            .code()
            .call_with_integers("place", &[n, columns, rows])?;
        Some((place[0] as u32, place[1] as u32))
    }

    /// Returns the levels of all pixels in the order in which they are printed.
    pub fn pixels(&self) -> impl Iterator<Item = [i32; 3]> + '_ {
        (0..self.size.0 * self.size.1).map(|n| self.pixel(n))
    }

    /// Returns the values that the program gives to names while it computes the `n`th pixel, in
    /// their order; none if it has no such pixel.
    pub fn traced_values(&self, n: u32) -> Vec<TracedValue> {
        match (&self.canvas, self.place(n)) {
            (Some(canvas), Some((i, j))) => canvas.trace(i, j),
            _ => Vec::new(),
        }
    }

    /// Returns true if the ray of the `n`th pixel hits something, that is, if `ray_color` returns
    /// before its end, where the sky is.
    pub fn hits(&self, n: u32) -> bool {
        match (&self.canvas, self.place(n)) {
            (Some(canvas), Some((i, j))) => canvas.returns_early("ray_color", i, j),
            _ => false,
        }
    }

    /// Returns all pixels as bytes, with levels below 0 as 0 and above 255 as 255, as a conversion
    /// in Rust makes them.
    pub fn rgb(&self) -> impl Iterator<Item = [u8; 3]> + '_ {
        let stored = |level: i32| level.clamp(0, 255) as u8;
        self.pixels().map(move |pixel| pixel.map(stored))
    }

    /// Draws the picture of all pixels, with levels as in [`rgb`](Self::rgb).
    ///
    /// # Panics
    /// If width times height is 2³² or more.
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
