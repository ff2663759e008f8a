//! Answers to the exercises of chapter 2.

use common::rtweekend::*;
use red_sphere::hit_sphere;

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
