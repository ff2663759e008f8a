//! Answers to the exercises of chapter 2.

use common::rtweekend::*;
use red_sphere::hit_sphere;

/// Says whether the line of a ray with a direction of length 1 meets a sphere: the walk.
fn met_on_the_walk(center: Point3, radius: f64, ray: &Ray) -> bool {
    let oc = center - ray.origin;
    let h = ray.direction.dot(oc);
    let l_squared = oc.dot(oc) - h * h;
    let half_chord_squared = radius * radius - l_squared;
    half_chord_squared >= 0.0
}

#[test]
fn the_walk_meets_the_sphere_wherever_the_algebra_does() {
    let camera = Camera::new(400);
    let center = Point3::new(0.0, 0.0, -1.0);
    for j in 0..camera.image_height {
        for i in 0..camera.image_width {
            let ray = camera.ray(i, j);
            let unit = Ray::new(ray.origin, ray.direction.normalize());
            let met = met_on_the_walk(center, 0.5, &unit);
            assert_eq!(met, hit_sphere(center, 0.5, &ray), "({i}, {j})");
        }
    }
}

/// Returns the radius of a sphere's disc on a viewport one unit away, if its center is straight
/// ahead.
fn radius_on_viewport(radius: f64, distance: f64) -> f64 {
    radius / (distance * distance - radius * radius).sqrt()
}

#[test]
fn the_disc_is_as_large_as_its_tangents_make_it() {
    // 225 rows share a viewport 2 units high.
    let in_pixels = 112.5 * radius_on_viewport(0.5, 1.0);
    assert_eq!(format!("{in_pixels:.2}"), "64.95");

    let picture = red_sphere::picture(400);
    let (pixels, _) = picture.rgb().as_chunks::<3>();
    let red = |&pixel: &[u8; 3]| pixel == [255, 0, 0];
    assert_eq!(pixels.iter().filter(|&pixel| red(pixel)).count(), 13_254);
    let middle_row = &pixels[112 * 400..][..400];
    assert_eq!(middle_row.iter().position(red), Some(135));
    assert_eq!(middle_row.iter().rposition(red), Some(264));
}

#[test]
fn a_ray_to_the_side_passes_at_the_root_of_one_half() {
    let ray = Ray::new(Point3::ZERO, Vec3::new(1.0, 0.0, -1.0));
    let center = Point3::new(0.0, 0.0, -1.0);
    assert!(!hit_sphere(center, 0.5, &ray));
    // It touches the sphere around the same center that is as large as the line is near.
    assert!(hit_sphere(center, 0.5_f64.sqrt(), &ray));
    assert!(!hit_sphere(center, 0.7, &ray));
}

/// Draws the picture of this chapter with its sphere somewhere else.
fn picture_with(center: Point3, radius: f64) -> Picture {
    render(400, move |ray| {
        if hit_sphere(center, radius, ray) {
            Color::new(1.0, 0.0, 0.0)
        } else {
            sky(ray)
        }
    })
}

#[test]
fn a_sphere_behind_the_eye_draws_the_same_picture() {
    let behind = picture_with(Point3::new(0.0, 0.0, 1.0), 0.5);
    assert_eq!(behind, red_sphere::picture(400));
}

#[test]
fn from_inside_a_sphere_every_pixel_is_red() {
    let around = picture_with(Point3::new(0.0, 0.0, -1.0), 2.0);
    let (pixels, _) = around.rgb().as_chunks::<3>();
    assert!(pixels.iter().all(|&pixel| pixel == [255, 0, 0]));
}
