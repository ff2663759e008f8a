//! Function calls from outside: what a program's functions answer to a ray and a sphere.

use common::rtweekend::*;
use interpreter::Value;

use crate::program::ChapterProgram;

/// A sphere to ask about: the functions of a program get it as an argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// The center of the sphere.
    pub center: Point3,
    /// The radius of the sphere. The `Sphere::new` of chapter 5 turns a negative radius into 0.
    pub radius: f64,
}

impl Ball {
    /// Makes a sphere from the coordinates of its center and its radius, which may be negative.
    pub const fn new(x: f64, y: f64, z: f64, radius: f64) -> Self {
        Self {
            center: Point3::new(x, y, z),
            radius,
        }
    }
}

impl ChapterProgram {
    /// Returns the ray that the program casts through a pixel of a picture `width` pixels wide, in
    /// column `i` and row `j`, from 0 at the top left. `None` if the program stops.
    pub fn ray(&self, width: u32, i: u32, j: u32) -> Option<Ray> {
        let camera = self.call("Camera::new", &mut [width.into()])?;
        let ray = self.call("Camera::ray", &mut [camera, i.into(), j.into()])?;
        ray.ray()
    }

    /// Calls the program's `ray_color` with the ray, and with its `world()` if it has one.
    /// Components of the color are 0 to 1 if the program is right, and NaN if it stops or has no
    /// such function.
    pub fn ray_color(&self, ray: &Ray) -> Color {
        let color = || {
            let mut given = vec![Value::from(*ray)];
            if self.code().parameters("world") == Some(0) {
                given.push(self.call("world", &mut [])?);
            }
            self.call("ray_color", &mut given)?.vec3()
        };
        color().unwrap_or(Color::NAN)
    }

    /// Calls the program's `hit_sphere`, which chapters 2 to 4 have. Returns the nearer root `t`, in
    /// lengths of `ray.direction`, also behind the origin; `None` for a miss, or if the program
    /// stops or has no such function. In chapter 2, which only decides, `t` is 0 for a hit.
    pub fn hit_sphere(&self, center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
        let mut given = [center.into(), radius.into(), Value::from(*ray)];
        match self.call("hit_sphere", &mut given)? {
            Value::Bool(is_hit) => is_hit.then_some(0.0),
            Value::Float(t) => Some(t),
            option => option.parts().first()?.float(),
        }
    }

    /// Calls a function, `f` or `Type::f`, with values. What it changes by a `&mut` is changed in
    /// `given`. `None` if the program stops or has no such function.
    pub fn call(&self, function: &str, given: &mut [Value]) -> Option<Value> {
        self.code().call(function, given).ok()
    }
}

/// Calls a function, and returns the integers of the list that it returns; `None` if the program
/// stops or has no such function.
pub(crate) fn integers(
    code: &interpreter::Program,
    function: &str,
    given: &mut [Value],
) -> Option<Vec<i32>> {
    let list = code.call(function, given).ok()?;
    let numbers = list.parts().iter().map(|part| match part {
        Value::Int(number, _) => i32::try_from(*number).ok(),
        _ => None,
    });
    numbers.collect()
}
