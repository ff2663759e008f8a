
#[test]
fn a_prelude_obeys_the_laws() {
    holds(Trial::default().prelude(&prelude()));
}

fn prelude() -> Prelude<'static> {
    Prelude {
        mul: &|t, v| our(t * own(v)),
        add: &|u, v| our(own(u) + own(v)),
        neg: &|v| our(-own(v)),
        sub: &|u, v| our(own(u) - own(v)),
        dot: &|u, v| own(u).dot(own(v)),
        length_squared: &|v| own(v).length_squared(),
        length: &|v| own(v).length(),
        normalize: &|v| our(own(v).normalize()),
        ray: &|origin, direction| our_ray(Ray::new(own(origin), own(direction))),
        at: &|ray, t| our(own_ray(ray).at(t)),
    }
}

// The laws are written for our vectors: these become yours, and yours become ours.

fn own(v: ours::Vec3) -> Vec3 {
    Vec3::new(v.x, v.y, v.z)
}

fn own_ray(ray: ours::Ray) -> Ray {
    Ray::new(own(ray.origin), own(ray.direction))
}

fn our(v: Vec3) -> ours::Vec3 {
    ours::Vec3::new(v.x, v.y, v.z)
}

fn our_ray(ray: Ray) -> ours::Ray {
    ours::Ray::new(our(ray.origin), our(ray.direction))
}
