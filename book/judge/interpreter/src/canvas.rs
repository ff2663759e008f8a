//! Lazy evaluation: a picture whose pixels are computed, and traced, when they are asked for.

use std::cell::RefCell;
use std::fmt;
use std::mem;

use common::rtweekend::{Color, Picture};

use crate::fault::{Fault, FaultKind, Span};
use crate::machine::{Machine, TracedValue};
use crate::program::Program;
use crate::value::{Value, kind};

/// The largest width and height, in pixels, of a picture that is drawn whole.
const MAX_WIDTH: u32 = 4096;

/// A picture that a [`Program`] draws, whose pixels are computed one by one when they are asked
/// for.
#[derive(Clone)]
pub struct Canvas {
    program: Program,
    size: (u32, u32),
    color_at: Value,
    /// The stack of the last pixel, which the next one takes.
    stack: RefCell<Vec<Value>>,
}

impl fmt::Debug for Canvas {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Canvas")
            .field("size", &self.size)
            .finish_non_exhaustive()
    }
}

impl Program {
    /// Calls the program's `picture` for a picture `width` pixels wide. No pixel is computed yet.
    ///
    /// # Errors
    /// If the program stops, or `picture` is missing or returns no picture.
    pub fn canvas(&self, width: u32) -> Result<Canvas, Fault> {
        let picture = self.call("picture", &mut [width.into()])?;
        match picture.parts() {
            [Value::Int(width, _), Value::Int(height, _), color_at]
                if picture.kind() == kind::PICTURE =>
            {
                Ok(Canvas {
                    program: self.clone(),
                    size: (*width as u32, *height as u32),
                    color_at: color_at.clone(),
                    stack: RefCell::default(),
                })
            }
            _ => Err(stopped("`picture` returns no picture")),
        }
    }

    /// Draws the whole picture, `width` pixels wide.
    ///
    /// # Errors
    /// If the program stops: a panic, an overflow, too many turns of a loop; if the compiler would
    /// refuse a line that runs; or if the picture's width or height is not from 1 to 4096 pixels.
    pub fn draw(&self, width: u32) -> Result<Picture, Fault> {
        let canvas = self.canvas(width)?;
        let (width, height) = canvas.size;
        let is_drawn = |side: &u32| (1..=MAX_WIDTH).contains(side);
        if ![width, height].iter().all(is_drawn) {
            let message = "there is no picture that is 1 to 4096 pixels wide and high";
            return Err(stopped(message));
        }
        let mut rgb = Vec::with_capacity(3 * width as usize * height as usize);
        for (j, i) in (0..height).flat_map(|j| (0..width).map(move |i| (j, i))) {
            rgb.extend(canvas.levels(i, j)?);
        }
        Picture::from_rgb(width, height, rgb).ok_or_else(|| stopped("there are too many pixels"))
    }
}

/// Makes the fault of a program that stops at no place of its text.
fn stopped(message: &str) -> Fault {
    Fault::new(FaultKind::Stopped, Span::default(), message)
}

impl Canvas {
    /// Returns the picture whose pixels one [mutant](Program::with_mutant) computes. `picture` is not
    /// called again: what a mutant changes there is not seen.
    pub fn with_mutant(&self, number: u32) -> Self {
        Self {
            program: self.program.with_mutant(number),
            ..self.clone()
        }
    }

    /// Returns the width and the height of the picture, in this order, in pixels.
    pub fn size(&self) -> (u32, u32) {
        self.size
    }

    /// Computes the color, linear from 0 to 1, of the pixel in column `i` and row `j`, from 0 at
    /// the top left. Pixels outside of the picture have colors, too.
    ///
    /// # Errors
    /// If the program stops on the way, or the compiler would refuse a line that runs.
    pub fn color(&self, i: u32, j: u32) -> Result<Color, Fault> {
        self.colored(i, j, false).0
    }

    /// Computes the levels of red, green and blue, 0 to 255, of the pixel in column `i` and row
    /// `j`, from 0 at the top left.
    ///
    /// # Errors
    /// If the program stops on the way, or the compiler would refuse a line that runs.
    pub fn levels(&self, i: u32, j: u32) -> Result<[u8; 3], Fault> {
        let level = |component| (255.999 * component) as u8;
        Ok(self.color(i, j)?.to_array().map(level))
    }

    /// Traces the pixel in column `i` and row `j`, counted from 0 at the top left: lists the value
    /// of each `let` and of each early return on the way to its color, in the order in which they
    /// arise. Ends early where the program stops.
    pub fn trace(&self, i: u32, j: u32) -> Vec<TracedValue> {
        self.colored(i, j, true).1
    }

    /// Computes a pixel's color, and returns the values on the way if they are wanted.
    fn colored(&self, i: u32, j: u32, is_traced: bool) -> (Result<Color, Fault>, Vec<TracedValue>) {
        let mut machine = Machine::new(&self.program.code, self.stack.take());
        machine.trace = is_traced.then(Vec::new);
        let color = machine.ask(&self.color_at, &mut [i.into(), j.into()]);
        let color = color.and_then(|color| {
            let message = "a pixel needs a `Color`";
            color
                .vec3()
                .ok_or_else(|| Fault::refused(Span::default(), message))
        });
        self.stack.replace(mem::take(&mut machine.stack));
        (color, machine.trace.take().unwrap_or_default())
    }
}
