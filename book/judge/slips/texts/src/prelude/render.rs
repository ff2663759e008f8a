use common::rtweekend::*;

pub fn render(width: u32, ray_color: impl Fn(&Ray) -> Color + Send + Sync + 'static) -> Picture {
    let camera = Camera::new(width);
    Picture::paint(camera.image_width, camera.image_height, move |i, j| {
        ray_color(&camera.ray(i, j))
    })
}
