//! Answers to the exercises of chapter 4.

use common::rtweekend::*;

const CENTER: Point3 = Point3::new(0.0, 0.0, -1.0);

/// `hit_sphere` with one sign too many, as the notes first had it.
fn with_minus_h(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    let discriminant = h * h - a * c;
    if discriminant < 0.0 {
        return None;
    }
    Some((-h - discriminant.sqrt()) / a)
}

/// Draws the picture of this chapter with another `hit_sphere`.
fn picture_by(hit_sphere: fn(Point3, f64, &Ray) -> Option<f64>) -> Picture {
    render(400, move |ray| match hit_sphere(CENTER, 0.5, ray) {
        Some(t) if t > 0.0 => 0.5 * ((ray.at(t) - CENTER).normalize() + Vec3::ONE),
        _ => sky(ray),
    })
}

#[test]
fn one_sign_too_many_gives_the_far_root_negated_and_no_ball() {
    let ahead = Ray::new(Point3::ZERO, Vec3::NEG_Z);
    assert_eq!(half_b_sphere::hit_sphere(CENTER, 0.5, &ahead), Some(0.5));
    assert_eq!(with_minus_h(CENTER, 0.5, &ahead), Some(-1.5));
    assert_eq!(picture_by(with_minus_h), gradient::picture(400));
}

#[test]
fn with_one_sign_too_many_a_ball_behind_the_eye_is_seen() {
    let behind = Point3::new(0.0, 0.0, 1.0);
    let ahead = Ray::new(Point3::ZERO, Vec3::NEG_Z);
    assert_eq!(with_minus_h(behind, 0.5, &ahead), Some(0.5));
    let normal = (ahead.at(0.5) - behind).normalize();
    assert_eq!(normal, Vec3::NEG_Z);
}

#[test]
fn a_looser_test_for_t_brings_back_only_a_ring_of_the_ball() {
    let camera = Camera::new(400);
    let is_drawn = |i| with_minus_h(CENTER, 0.5, &camera.ray(i, 112)).is_some_and(|t| t > -1.0);
    let columns: Vec<u32> = (0..400).filter(|&i| is_drawn(i)).collect();
    let ring: Vec<u32> = (135..144).chain(256..265).collect();
    assert_eq!(columns, ring);
}

/// `hit_sphere` for rays whose direction has length 1, where a is 1.
fn for_unit_direction(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
    assert!((ray.direction.length() - 1.0).abs() < 1e-12);
    let oc = center - ray.origin;
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    let discriminant = h * h - c;
    if discriminant < 0.0 {
        return None;
    }
    Some(h - discriminant.sqrt())
}

#[test]
fn with_a_unit_direction_t_is_the_distance() {
    let camera = Camera::new(80);
    for j in 0..camera.image_height {
        for i in 0..camera.image_width {
            let ray = camera.ray(i, j);
            let unit = Ray::new(ray.origin, ray.direction.normalize());
            let t = half_b_sphere::hit_sphere(CENTER, 0.5, &ray);
            let distance = for_unit_direction(CENTER, 0.5, &unit);
            assert_eq!(t.is_some(), distance.is_some());
            if let (Some(t), Some(distance)) = (t, distance) {
                assert!((t * ray.direction.length() - distance).abs() < 1e-12);
            }
        }
    }
}
