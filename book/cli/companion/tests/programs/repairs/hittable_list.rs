use common::rtweekend::*;

pub fn picture(width: u32) -> Picture {
    let world = world();
    render(width, move |r| ray_color(r, &world))
}

pub fn world() -> HittableList {
    let mut list = HittableList::new();
    list.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5));
    list.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0));
    list
}

pub fn ray_color(r: &Ray, world: &dyn Hittable) -> Color {
    match world.hit(r, 0.0, f64::INFINITY) {
        Some(rec) => (rec.normal + Color::ONE) * 0.5,
        None => sky(r),
    }
}

#[derive(Clone, Copy, Default)]
pub struct HitRecord {
    pub point: Point3,
    pub normal: Vec3,
    pub t: f64,
    pub front_face: bool,
}

impl HitRecord {
    pub fn set_face_normal(&mut self, r: &Ray, outward: Vec3) {
        self.front_face = r.direction.dot(outward) < 0.0;
        if self.front_face {
            self.normal = outward;
        } else {
            self.normal = -outward;
        }
    }
}

pub trait Hittable {
    fn hit(&self, r: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord>;
}

pub struct Sphere {
    center: Point3,
    radius: f64,
}

impl Sphere {
    pub fn new(center: Point3, radius: f64) -> Self {
        Self { center, radius: radius.max(0.0) }
    }
}

fn in_range(t: f64, low: f64, high: f64) -> bool {
    low < t && t < high
}

impl Hittable for Sphere {
    fn hit(&self, r: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        let oc = self.center - r.origin;
        let a = r.direction.length_squared();
        let half_b = r.direction.dot(oc);
        let c = oc.length_squared() - self.radius * self.radius;
        let disc = half_b * half_b - a * c;
        if disc < 0.0 {
            return None;
        }
        let root = disc.sqrt();
        let mut t = (half_b - root) / a;
        if !in_range(t, t_min, t_max) {
            t = (half_b + root) / a;
            if !in_range(t, t_min, t_max) {
                return None;
            }
        }
        let point = r.at(t);
        let mut rec = HitRecord { point, normal: Vec3::ZERO, t, front_face: false };
        rec.set_face_normal(r, (point - self.center) * (1.0 / self.radius));
        Some(rec)
    }
}

#[derive(Default)]
pub struct HittableList {
    objects: Vec<Box<dyn Hittable + Send + Sync>>,
}

impl HittableList {
    pub fn new() -> Self {
        Self { objects: Vec::new() }
    }

    pub fn add(&mut self, object: impl Hittable + Send + Sync + 'static) {
        self.objects.push(Box::new(object));
    }
}

impl Hittable for HittableList {
    fn hit(&self, r: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        let mut best: Option<HitRecord> = None;
        let mut closest = t_max;
        for object in self.objects.iter() {
            if let Some(rec) = object.hit(r, t_min, closest) {
                closest = rec.t;
                best = Some(rec);
            }
        }
        best
    }
}
