//! The book's vec3 as a reader types it, each function with a line: read as a text, never
//! compiled.

fn add(u: Vec3, v: Vec3) -> Vec3 {
    Vec3::new(u.x + v.x, u.y + v.y, u.z + v.z)
}

fn sub(u: Vec3, v: Vec3) -> Vec3 {
    Vec3::new(u.x - v.x, u.y - v.y, u.z - v.z)
}

fn neg(v: Vec3) -> Vec3 {
    Vec3::new(-v.x, -v.y, -v.z)
}

fn mul(t: f64, v: Vec3) -> Vec3 {
    Vec3::new(t * v.x, t * v.y, t * v.z)
}

fn dot(u: Vec3, v: Vec3) -> f64 {
    u.x * v.x + u.y * v.y + u.z * v.z
}

fn length_squared(v: Vec3) -> f64 {
    v.x * v.x + v.y * v.y + v.z * v.z
}

fn length(v: Vec3) -> f64 {
    v.length_squared().sqrt()
}

fn normalize(v: Vec3) -> Vec3 {
    (1.0 / v.length()) * v
}
