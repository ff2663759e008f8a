/// The picture at `width` pixels wide.
pub fn picture(width: u32) -> Picture {
    let world = world();
    render(width, move |ray| ray_color(ray, &world))
}

/// What there is to see.
pub fn world() -> HittableList {
    let mut world = HittableList::default();
    world.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5));
    world
}

// show ray_color
/// The normal of the nearest hit in front of the ray as a color, or the sky.
pub fn ray_color(ray: &Ray, world: &dyn Hittable) -> Color {
    todo!()
}

/// Anything that a ray can hit.
pub trait Hittable {
    /// The nearest hit with `t_min` < `t` < `t_max`, if there is one.
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord>;
}

/// What there is to know about a hit.
#[derive(Clone, Copy, Debug, Default)]
pub struct HitRecord {
    /// The ray parameter.
    pub t: f64,
    /// The point on the surface.
    pub point: Point3,
    /// The unit normal at that point, always against the ray.
    pub normal: Vec3,
    /// Whether the ray came from outside.
    pub front_face: bool,
}

impl HitRecord {
    /// Sets `front_face`, and `normal` to whichever of `outward_normal`, which has
    /// unit length, and its opposite points against `ray`.
    pub fn set_face_normal(&mut self, ray: &Ray, outward_normal: Vec3) {
        todo!()
    }
}

/// All points at distance `radius` from `center`.
pub struct Sphere {
    center: Point3,
    radius: f64,
}

impl Sphere {
    /// A sphere; a negative `radius` counts as 0.
    pub fn new(center: Point3, radius: f64) -> Self {
        let radius = radius.max(0.0);
        Self { center, radius }
    }
}

// show hit_sphere
impl Hittable for Sphere {
    /// The nearer root if it lies in the range, else the farther one.
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        todo!()
    }
}

/// A list of hittable things.
#[derive(Default)]
pub struct HittableList {
    objects: Vec<Box<dyn Hittable + Send + Sync>>,
}

impl HittableList {
    /// Puts `object` into the list.
    pub fn add(&mut self, object: impl Hittable + Send + Sync + 'static) {
        self.objects.push(Box::new(object));
    }
}

impl Hittable for HittableList {
    /// The nearest hit of all.
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        todo!()
    }
}
