//! Chapter 1, typed by somebody else.
use common::rtweekend::*;

/// The sky, at `w` pixels wide.
pub fn picture(w: u32) -> Picture { render(w, ray_color) }

/// White below, blue above.
pub fn ray_color(r: &Ray) -> Color
{
    let t = (r.direction.normalize().y + 1.0) * 0.5;
    Color::ONE * (1.0 - t)
        + Color::new(0.5, 0.7, 1.0) * t
}
