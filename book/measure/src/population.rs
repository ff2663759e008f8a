//! A population: all the questions that a statistic is about, so that the largest
//! error in it is a largest error, and not that of a lucky sample.
//!
//! There are two kinds. The book's own rays can all be asked: each pixel of its
//! picture, 3840 wide, about each of its two spheres. Of the other situations there
//! is no end, so a number of random cases stands for them.

use common::rtweekend::*;
use speed_vs_accuracy::{Case, Precision};

/// Questions with numbers from 0, in an order in which the first few are as good a
/// sample as any.
pub struct Population {
    /// What all its numbers are numbers of.
    pub precision: Precision,
    /// How many there are.
    pub count: usize,
    /// The question with that number, from 0.
    pub case: Box<dyn Fn(usize) -> Case + Send + Sync>,
}

impl Population {
    /// These cases.
    pub fn of_cases(precision: Precision, cases: Vec<Case>) -> Self {
        Self {
            precision,
            count: cases.len(),
            case: Box::new(move |number| cases[number]),
        }
    }

    /// So many pixels of the book's last picture, or all there are, about its `ball` or its
    /// `ground`.
    pub fn of_pixels(sphere: &'static str, precision: Precision, count: usize) -> Self {
        Self {
            precision,
            count: count.min(PIXELS),
            case: Box::new(move |number| {
                let [column, row] = scattered(number);
                pixel(sphere, column, row).rounded(precision)
            }),
        }
    }
}

/// The ray of a pixel, and the `ball` of the book or its `ground`.
fn pixel(sphere: &str, column: u32, row: u32) -> Case {
    let (center, radius) = match sphere {
        "ball" => (Point3::new(0.0, 0.0, -1.0), 0.5),
        _ => (Point3::new(0.0, -100.5, -1.0), 100.0),
    };
    Case::new(center, radius, Camera::new(WIDTH).ray(column, row))
}

/// How wide the picture is of which all pixels are asked, and how many there are.
const WIDTH: u32 = 3840;
const PIXELS: usize = 3840 * 2160;

/// A column and a row: others for each number, spread over the picture from the start.
fn scattered(number: usize) -> [u32; 2] {
    // It shares no factor with the number of pixels, so it leads to each of them once.
    const STEP: usize = 5_126_203;
    let pixel = (number * STEP % PIXELS) as u32;
    [pixel % WIDTH, pixel / WIDTH]
}
