use common::rtweekend::*;

pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

fn lerp(t: f64, from: Color, to: Color) -> Color {
    (1.0 - t) * from + t * to
}

pub fn ray_color(r: &Ray) -> Color {
    let dir = r.direction.normalize();
    let t = (dir.y + 1.0) * 0.5;
    lerp(t, Color::ONE, Color::new(0.5, 0.7, 1.0))
}
