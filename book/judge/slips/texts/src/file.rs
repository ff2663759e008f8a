use common::rtweekend::*;

pub fn place(n: u32, image_width: u32, image_height: u32) -> [u32; 2] {
    let j = n / image_width;
    let i = n - j * image_width;
    [i, j]
}

pub fn header(image_width: u32, image_height: u32) -> [u32; 2] {
    [image_width, image_height]
}

pub fn print(color: Color) -> [i32; 3] {
    let r = level(color.x);
    let g = level(color.y);
    let b = level(color.z);
    [r, g, b]
}

pub fn level(component: f64) -> i32 {
    (255.999 * component) as i32
}
