//! Answers to the exercises of chapter 3.

use common::rtweekend::*;
use normals::hit_sphere;

const CENTER: Point3 = Point3::new(0.0, 0.0, -1.0);

#[test]
fn t_is_a_half_in_the_middle_of_the_ball_and_three_quarters_at_its_rim() {
    assert_eq!(
        hit_sphere(CENTER, 0.5, &Ray::new(Point3::ZERO, Vec3::NEG_Z)),
        Some(0.5)
    );
    // A tangent of 30 degrees; a hair inside of it the line goes in.
    let rim = Vec3::new(30.0_f64.to_radians().tan() * (1.0 - 1e-12), 0.0, -1.0);
    let t = hit_sphere(CENTER, 0.5, &Ray::new(Point3::ZERO, rim)).expect("it is inside");
    assert!((t - 0.75).abs() < 1e-5, "{t}");
}

/// Returns the share of a sphere's surface that an eye sees at `distance` from the center: the part
/// where the normal points towards the eye.
fn visible_share(radius: f64, distance: f64) -> f64 {
    0.5 * (1.0 - radius / distance)
}

#[test]
fn a_quarter_of_the_ball_is_seen() {
    assert_eq!(visible_share(0.5, 1.0), 0.25);

    // All of it has n.z ≥ ½, so its blue is at least ¾.
    let camera = Camera::new(400);
    let mut least_blue = f64::INFINITY;
    for j in 0..camera.image_height {
        for i in 0..camera.image_width {
            let ray = camera.ray(i, j);
            if red_sphere::hit_sphere(CENTER, 0.5, &ray) {
                least_blue = least_blue.min(normals::ray_color(&ray).z);
            }
        }
    }
    assert!((0.75..0.76).contains(&least_blue), "{least_blue}");
}

/// How far from 1 the length of the normal gets, if the way from the center to
/// the point is divided by the radius. The sphere is `radii` of its own radii
/// away, and a hundred rays aim at it.
fn worst_length(radii: f64) -> f64 {
    let center = Point3::new(0.0, 0.0, -radii);
    let rays = (0..100).map(|k| Vec3::new(0.009 * f64::from(k), 0.1, -radii));
    let length_off = |direction| {
        let ray = Ray::new(Point3::ZERO, direction);
        let t = hit_sphere(center, 1.0, &ray).expect("it is aimed at the sphere");
        ((ray.at(t) - center).length() - 1.0).abs()
    };
    rays.map(length_off).fold(0.0, f64::max)
}

#[test]
fn the_radius_is_as_good_as_a_square_root_until_the_sphere_is_far() {
    assert!(worst_length(2.0) < 1e-15);
    assert!((1e-12..1e-11).contains(&worst_length(2e2)));
    assert!((1e-8..1e-7).contains(&worst_length(2e4)));
    assert!((1e-4..1e-3).contains(&worst_length(2e6)));
    // A level of a picture is 1/256.
    assert!(0.5 * worst_length(2e7) > 1.0 / 256.0);
}
