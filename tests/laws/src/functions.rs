//! Adapters: a crate's chapter 5 as the functions that the laws ask.

/// Defines the functions `set_face_normal`, `record`, `nearest` and `ray_color`, in the form in
/// which laws ask them, for a crate `$chapter` with the types and functions of chapter 5:
/// `Hittable`, `HitRecord`, `HittableList`, `Sphere`, `world` and `ray_color`.
///
/// `$vector` and `$ray` turn vectors and rays of `common` into the crate's own, and `$back` turns a
/// vector of the crate into one of `common`. `$Ray` is the crate's type of rays.
#[macro_export]
macro_rules! functions_of_a_list {
    ($chapter:ident, $Ray:ty, $vector:path, $ray:path, $back:path) => {
        fn set_face_normal(ray: &$crate::Ray, outward_normal: $crate::Vec3) -> $crate::face::Face {
            let mut record = $chapter::HitRecord::default();
            record.set_face_normal(&$ray(*ray), $vector(outward_normal));
            $crate::face::Face {
                normal: $back(record.normal),
                front_face: record.front_face,
            }
        }

        fn record(asked: &$crate::IntervalCase) -> Option<$crate::record::RecordedHit> {
            #[allow(unused_imports)] // A list of spheres has no trait.
            use $chapter::*;
            let $crate::Case {
                center,
                radius,
                ray,
            } = asked.case;
            let sphere = $chapter::Sphere::new($vector(center), radius);
            let record = sphere.hit(&$ray(ray), asked.t_min, asked.t_max)?;
            Some($crate::record::RecordedHit {
                t: record.t,
                point: $back(record.point),
                normal: $back(record.normal),
                front_face: record.front_face,
            })
        }

        fn nearest(scene: &$crate::list::World) -> Option<f64> {
            #[allow(unused_imports)] // A list of spheres has no trait.
            use $chapter::*;
            let mut list = $chapter::HittableList::default();
            for &(center, radius) in &scene.spheres {
                list.add($chapter::Sphere::new($vector(center), radius));
            }
            Some(list.hit(&$ray(scene.ray), scene.t_min, scene.t_max)?.t)
        }

        fn ray_color(ray: &$crate::Ray) -> $crate::Color {
            $back($chapter::ray_color(&$ray(*ray), &$chapter::world()))
        }
    };
}
