//! The program around a chapter: the loop, the header and the levels of its file. What takes
//! their place in `common` paints many pixels at once, and no text can show that.

use common::rtweekend::*;

/// The column and the row of the nth pixel in the file: `for j …`, and in each row `for i …`.
fn place(n: u32, image_width: u32, image_height: u32) -> [u32; 2] {
    let j = n / image_width;
    let i = n - j * image_width;
    [i, j]
}

/// The two numbers below `P3`.
fn header(image_width: u32, image_height: u32) -> [u32; 2] {
    [image_width, image_height]
}

/// The three numbers of a pixel, which a wrong program may print beyond 0 and 255.
fn print(color: Color) -> [i32; 3] {
    let r = level(color.x);
    let g = level(color.y);
    let b = level(color.z);
    [r, g, b]
}

fn level(component: f64) -> i32 {
    (255.999 * component) as i32
}
