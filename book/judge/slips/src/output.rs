//! The output of a program, right or wrong, before it is a picture.

use std::fmt;

use common::rtweekend::{Camera, Picture};

use super::program::Program;

/// The output of a [`Program`]: the numbers of a P3 file, traced when asked for.
///
/// A single pixel costs no more than its own ray, so that a large picture can be
/// looked at here and there.
#[derive(Clone, Copy)]
pub struct Output {
    program: Program,
    camera: Camera,
}

impl Program {
    /// What the program prints when it is asked for a picture `width` pixels
    /// wide. Nothing is traced before a pixel is asked for.
    pub fn run(&self, width: u32) -> Output {
        Output {
            program: *self,
            camera: self.camera(width),
        }
    }
}

impl Output {
    /// Width and height as the header tells them.
    pub fn size(&self) -> (u32, u32) {
        (self.program.header)(self.camera.image_width, self.camera.image_height)
    }

    /// The `n`th printed pixel as red, green and blue.
    ///
    /// The right program prints 0 to 255, a wrong one may print what no picture
    /// can hold. C++ converts to `int` in the same way, except that numbers
    /// beyond ±2³¹ and NaN become −2³¹ on some processors.
    pub fn pixel(&self, n: u32) -> [i32; 3] {
        let Camera {
            image_width: width,
            image_height: height,
            ..
        } = self.camera;
        let (i, j) = (self.program.order)(n, width, height);
        let color = (self.program.color)(&self.program, &self.camera, i, j).to_array();
        self.program
            .channels
            .map(|channel| (self.program.level)(color[channel]))
    }

    /// All pixels in the order in which they are printed.
    pub fn pixels(&self) -> impl Iterator<Item = [i32; 3]> + '_ {
        (0..self.camera.image_width * self.camera.image_height).map(|n| self.pixel(n))
    }

    /// Whether the ray of each pixel hits something, in the same order.
    pub fn hits(&self) -> impl Iterator<Item = bool> + '_ {
        let Self { program, camera } = self;
        let (width, height) = (camera.image_width, camera.image_height);
        (0..width * height).map(move |n| {
            let (i, j) = (program.order)(n, width, height);
            let ray = program.ray(camera, i, j);
            program.search(&ray).is_some()
        })
    }

    /// All pixels as the same program stores them in Rust, where a conversion to a byte
    /// stops at 0 and 255.
    pub fn rgb(self) -> impl Iterator<Item = [u8; 3]> {
        let (width, height) = self.size();
        let stored = |level: i32| level.clamp(0, 255) as u8;
        (0..width * height).map(move |n| self.pixel(n).map(stored))
    }

    /// The picture that the same program draws in Rust.
    pub fn picture(&self) -> Picture {
        let (width, height) = self.size();
        let rgb = self.rgb().flatten().collect();
        Picture::from_rgb(width, height, rgb)
            .expect("a header may swap width and height, but not change their product")
    }
}

/// The P3 file of the book's C++, which prints what it gets, 256 and −127 too.
impl fmt::Display for Output {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (width, height) = self.size();
        write!(f, "P3\n{width} {height}\n255\n")?;
        for [red, green, blue] in self.pixels() {
            writeln!(f, "{red} {green} {blue}")?;
        }
        Ok(())
    }
}
