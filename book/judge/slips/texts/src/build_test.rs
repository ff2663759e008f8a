use common::rtweekend::*;

pub fn picture(width: u32) -> Picture {
    let last = f64::from((width - 1).max(1));
    Picture::paint(width, width, move |i, j| {
        Color::new(f64::from(i) / last, f64::from(j) / last, 0.0)
    })
}
