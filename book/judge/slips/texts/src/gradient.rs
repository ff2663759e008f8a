use common::rtweekend::*;

pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

pub fn ray_color(ray: &Ray) -> Color {
    let white = Color::new(1.0, 1.0, 1.0);
    let blue = Color::new(0.5, 0.7, 1.0);

    let unit_direction = ray.direction.normalize();
    let a = 0.5 * (unit_direction.y + 1.0);
    (1.0 - a) * white + a * blue
}
