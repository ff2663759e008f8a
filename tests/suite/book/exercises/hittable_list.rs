//! Answers to the exercises of chapter 5.

use common::rtweekend::*;
use hittable_list::{HitRecord, Hittable, HittableList, Sphere, ray_color, world};

/// Returns the two spheres of the chapter, in its order.
fn ball_and_ground() -> [Sphere; 2] {
    [
        Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5),
        Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0),
    ]
}

/// A list in which the first hit wins, which is wrong.
struct FirstWins(Vec<Sphere>);

impl Hittable for FirstWins {
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        self.0
            .iter()
            .find_map(|sphere| sphere.hit(ray, t_min, t_max))
    }
}

#[test]
fn that_the_first_hit_wins_is_seen_only_in_the_other_order() {
    let [ball, ground] = ball_and_ground();
    let draw = |spheres| {
        let world = FirstWins(spheres);
        render(400, move |ray| ray_color(ray, &world))
    };
    let right = hittable_list::picture(400);
    assert_eq!(draw(vec![ball, ground]), right);

    let wrong = draw(vec![ground, ball]);
    let (wrong, right) = (wrong.rgb().as_chunks::<3>(), right.rgb().as_chunks::<3>());
    let differ = wrong.0.iter().zip(right.0).filter(|(w, r)| w != r).count();
    assert_eq!(differ, 5226);
}

/// Returns the highest row in which the ground is seen in a column, without the ball in front.
fn horizon(i: u32) -> Option<u32> {
    let camera = Camera::new(400);
    let [_, ground] = ball_and_ground();
    let on_ground = |&j: &u32| ground.hit(&camera.ray(i, j), 0.0, f64::INFINITY).is_some();
    (0..camera.image_height).find(on_ground)
}

#[test]
fn the_horizon_is_lower_than_the_middle_and_lowest_at_the_sides() {
    assert_eq!(Camera::new(400).image_height / 2, 112);
    assert_eq!(horizon(0), horizon(399));
    assert_eq!(
        [0, 100, 200].map(horizon),
        [Some(134), Some(126), Some(123)]
    );
}

#[test]
fn the_horizon_is_about_ten_units_away() {
    let way = Point3::new(0.0, -100.5, -1.0);
    let tangent = (way.length_squared() - 100.0 * 100.0).sqrt();
    assert_eq!(format!("{tangent:.1}"), "10.1");
}

/// Lists the surfaces that a ray meets on its way through `thing`: `t`, and true for a front.
fn crossings(thing: &dyn Hittable, ray: &Ray) -> Vec<(f64, bool)> {
    let mut crossings = Vec::new();
    let mut t_min = 0.0;
    while let Some(record) = thing.hit(ray, t_min, f64::INFINITY) {
        crossings.push((record.t, record.front_face));
        t_min = record.t;
    }
    crossings
}

#[test]
fn a_ray_goes_in_and_out_of_a_ball_and_of_balls_in_balls() {
    let ahead = Ray::new(Point3::ZERO, Vec3::NEG_Z);
    let [ball, _] = ball_and_ground();
    assert_eq!(crossings(&ball, &ahead), [(0.5, true), (1.5, false)]);

    let mut onion = HittableList::default();
    onion.add(ball);
    onion.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.25));
    assert_eq!(
        crossings(&onion, &ahead),
        [(0.5, true), (0.75, true), (1.25, false), (1.5, false)]
    );
    assert_eq!(crossings(&world(), &ahead), [(0.5, true), (1.5, false)]);
}

/// Returns true if the ray comes from inside: for a program that asks when it colors, and whose
/// normals point out.
fn comes_from_inside(ray: &Ray, outward_normal: Vec3) -> bool {
    ray.direction.dot(outward_normal) > 0.0
}

#[test]
fn both_ways_to_ask_for_the_side_agree_unless_the_ray_only_grazes() {
    let mut record = HitRecord::default();
    for (direction, inside, back_face) in [
        (Vec3::NEG_Z, false, false),
        (Vec3::Z, true, true),
        (Vec3::X, false, true),
    ] {
        let ray = Ray::new(Point3::ZERO, direction);
        assert_eq!(comes_from_inside(&ray, Vec3::Z), inside);
        record.set_face_normal(&ray, Vec3::Z);
        assert_eq!(!record.front_face, back_face);
    }
}

/// A plane through `point`, with the unit normal `normal`.
struct Plane {
    point: Point3,
    normal: Vec3,
}

impl Hittable for Plane {
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        let t = self.normal.dot(self.point - ray.origin) / self.normal.dot(ray.direction);
        if !(t_min < t && t < t_max) {
            return None;
        }
        let mut record = HitRecord {
            t,
            point: ray.at(t),
            ..HitRecord::default()
        };
        record.set_face_normal(ray, self.normal);
        Some(record)
    }
}

/// Makes the ball of the chapter on a flat floor.
fn on_a_plane() -> HittableList {
    let mut world = HittableList::default();
    world.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5));
    world.add(Plane {
        point: Point3::new(0.0, -0.5, 0.0),
        normal: Vec3::Y,
    });
    world
}

#[test]
fn a_floor_that_is_flat_needs_no_change_of_the_chapter_and_has_a_straight_horizon() {
    let world = on_a_plane();
    let picture = render(400, move |ray| ray_color(ray, &world));
    let (pixels, _) = picture.rgb().as_chunks::<3>();
    let floor = [127, 255, 127];
    let rows: Vec<&[[u8; 3]]> = pixels.chunks(400).collect();
    // Row 112 goes straight ahead, along the plane, and below it all rays meet it.
    assert!(!rows[112].contains(&floor));
    let is_floor_or_ball = |pixel: &[u8; 3]| *pixel == floor || pixel[2] > 127;
    assert!(
        rows[113..]
            .iter()
            .all(|row| row.iter().all(is_floor_or_ball))
    );
    assert_eq!([rows[113][0], rows[113][399], rows[224][200]], [floor; 3]);
}

#[test]
fn a_ray_along_a_plane_misses_it_and_one_from_below_comes_from_inside() {
    let world = on_a_plane();
    let along = Ray::new(Point3::new(3.0, -0.5, 0.0), Vec3::X);
    assert_eq!(world.hit(&along, 0.0, f64::INFINITY), None);
    let up = Ray::new(Point3::new(3.0, -2.0, 0.0), Vec3::Y);
    let record = world.hit(&up, 0.0, f64::INFINITY).expect("it is above");
    assert_eq!((record.t, record.front_face), (1.5, false));
    assert_eq!(record.normal, -Vec3::Y);
}

/// Draws the picture of the chapter, each pixel the mean of 4 × 4 rays.
fn smooth(width: u32) -> Picture {
    let (camera, world) = (Camera::new(width), world());
    let (columns, rows) = (camera.image_width, camera.image_height);
    Picture::paint(columns, rows, move |i, j| {
        let mut sum = Color::ZERO;
        for n in 0..16 {
            // Off the center by 1/8 or 3/8 of a pixel, to either side.
            let across = (f64::from(n % 4) - 1.5) / 4.0;
            let down = (f64::from(n / 4) - 1.5) / 4.0;
            let center = camera.ray(i, j);
            let off = across * camera.pixel_delta_u + down * camera.pixel_delta_v;
            let ray = Ray::new(center.origin, center.direction + off);
            sum += ray_color(&ray, &world);
        }
        sum / 16.0
    })
}

/// Between two neighbors the color never jumps as far as it does where a pixel is one ray.
#[test]
fn sixteen_rays_a_pixel_smooth_the_outline_of_the_ball() {
    let jump = |picture: Picture| {
        let rows = picture.rgb().chunks(3 * 400).map(<[u8]>::to_vec);
        let steps = rows.flat_map(|row| {
            let neighbors = row[..1197].iter().zip(row[3..].to_vec());
            neighbors
                .map(|(one, other)| one.abs_diff(other))
                .collect::<Vec<_>>()
        });
        steps.max().expect("a picture has pixels")
    };
    assert!(jump(smooth(400)) < jump(hittable_list::picture(400)));
}
