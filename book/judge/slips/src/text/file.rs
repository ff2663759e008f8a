//! The program around a chapter: the loop over the pixels, the header and the levels of its file.
//! The code of `common` for these paints many pixels at once, which the interpreter can't run.

use common::rtweekend::*;

/// Returns the column and the row of the nth pixel in the file, as `for j …` around `for i …` does.
fn place(n: u32, image_width: u32, image_height: u32) -> [u32; 2] {
    let j = n / image_width;
    let i = n - j * image_width;
    [i, j]
}

/// Returns the two numbers below `P3`.
fn header(image_width: u32, image_height: u32) -> [u32; 2] {
    [image_width, image_height]
}

/// Returns the three numbers that are printed for a pixel: 0 to 255, unless the program is wrong.
fn print(color: Color) -> [i32; 3] {
    let r = level(color.x);
    let g = level(color.y);
    let b = level(color.z);
    [r, g, b]
}

fn level(component: f64) -> i32 {
    (255.999 * component) as i32
}
