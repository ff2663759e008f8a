//! The first two stairs of chapter 5, before it has a trait.

use common::rtweekend::*;
use hittable_list::HitRecord;

/// Finds the nearest hit with `t_min` < `t` < `t_max`, if there is one.
fn hit_sphere(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    let discriminant = h * h - a * c;
    if discriminant < 0.0 {
        return None;
    }
    let sqrtd = discriminant.sqrt();
    let roots = [(h - sqrtd) / a, (h + sqrtd) / a];
    let t = roots.into_iter().find(|&t| t_min < t && t < t_max)?;

    let mut record = HitRecord {
        t,
        point: ray.at(t),
        ..HitRecord::default()
    };
    let outward_normal = (record.point - center) * (1.0 / radius);
    record.set_face_normal(ray, outward_normal);
    Some(record)
}

/// Returns the normal of the hit as a color, or the sky.
fn color_of(hit: Option<HitRecord>, ray: &Ray) -> Color {
    match hit {
        Some(record) => 0.5 * (record.normal + Vec3::ONE),
        None => sky(ray),
    }
}

/// Draws the ball of chapter 4.
fn one_ball(width: u32) -> Picture {
    let center = Point3::new(0.0, 0.0, -1.0);
    render(width, move |ray| {
        color_of(hit_sphere(center, 0.5, ray, 0.0, f64::INFINITY), ray)
    })
}

#[test]
fn with_a_range_and_a_record_one_ball_is_as_in_chapter_4() {
    assert_eq!(one_ball(400), half_b_sphere::picture(400));
}

/// A sphere as a value.
struct Ball {
    center: Point3,
    radius: f64,
}

/// Finds the nearest hit in front of the ray.
fn nearest_hit(balls: &[Ball], ray: &Ray) -> Option<HitRecord> {
    let mut nearest = None;
    let mut closest_so_far = f64::INFINITY;
    for ball in balls {
        if let Some(record) = hit_sphere(ball.center, ball.radius, ray, 0.0, closest_so_far) {
            closest_so_far = record.t;
            nearest = Some(record);
        }
    }
    nearest
}

/// Draws a ball on the ground, which is another ball.
fn two_balls(width: u32) -> Picture {
    let ball = |y: f64, radius: f64| Ball {
        center: Point3::new(0.0, y, -1.0),
        radius,
    };
    let balls = vec![ball(0.0, 0.5), ball(-100.5, 100.0)];
    render(width, move |ray| color_of(nearest_hit(&balls, ray), ray))
}

#[test]
fn a_vector_of_balls_draws_the_picture_of_the_chapter() {
    assert_eq!(two_balls(400), hittable_list::picture(400));
}
