//! Function calls from outside: what a chapter's functions answer to a ray and a sphere.

use common::rtweekend::*;

use crate::machine::value::{Data, Value};
use crate::program::{Program, u32_value};
use crate::refusal::Span;
use crate::types::Ctor;

/// A sphere to ask about: the functions of an interpreted [`Program`] get it as an argument.
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

/// A record of a hit, as the `Sphere::hit` of chapter 5 returns it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereHit {
    /// The ray parameter, in lengths of the ray's direction.
    pub t: f64,
    /// The point on the sphere: the field `point` of the program's record, or `p`.
    pub point: Point3,
    /// The normal; a right program returns a unit vector that points against the ray.
    pub normal: Vec3,
    /// True if the ray met the outer side of the sphere.
    pub front_face: bool,
}

impl Program {
    /// Calls the program's `ray_color` with the ray, and with its `world()` if it has one, and
    /// returns the color: linear, 0 to 1.
    ///
    /// Returns NaN in each component if the program has no `ray_color`, or stops in one of the two.
    pub fn ray_color(&self, ray: &Ray) -> Color {
        let color = || {
            let mut machine = self.machine();
            let world = self
                .role("world", 0)
                .map(|it| self.asked(machine.call(it, &[])));
            let mut given = vec![Self::ray(self, ray)];
            if let Some(world) = world {
                given.push(world?);
            }
            let color = self.asked(machine.call(self.ray_color_role()?, &given))?;
            self.vec3_of(&color)
        };
        color().unwrap_or(Color::NAN)
    }

    /// Calls the program's `hit_sphere`, as chapters 2 to 4 have it, and returns its `t` in lengths
    /// of the ray's direction; 0 for a hit if the function returns a `bool`.
    ///
    /// Returns `None` for a miss, and also if the program has no such function or stops in it.
    pub fn hit_sphere(&self, center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
        let given = [self.vec3(center), radius.into(), Self::ray(self, ray)];
        let answer = self.call(self.role("hit_sphere", 3)?, &given)?;
        match answer.data {
            Data::Bool(is_hit) => is_hit.then_some(0.0),
            Data::Float(t) => Some(t),
            _ => answer.option().map(|t| t.float()),
        }
    }

    /// Calls `Sphere::hit` of chapter 5 on a sphere made by `Sphere::new`, and returns its record
    /// of the nearest hit between `t_min` and `t_max`, as the program itself decides.
    ///
    /// Returns `None` for a miss, if the program stops, or if one of these functions or a field of
    /// the record is missing.
    pub fn record(&self, ball: Ball, ray: &Ray, t_min: f64, t_max: f64) -> Option<SphereHit> {
        let sphere = [self.vec3(ball.center), ball.radius.into()];
        let sphere = self.called("Sphere::new", &sphere)?;
        let given = [sphere, Self::ray(self, ray), t_min.into(), t_max.into()];
        let record = self.called("Sphere::hit", &given)?.option()?;
        let point = self.field(&record, "point");
        Some(SphereHit {
            t: self.field(&record, "t")?.float(),
            point: self.vec3_of(&point.or_else(|| self.field(&record, "p"))?)?,
            normal: self.vec3_of(&self.field(&record, "normal")?)?,
            front_face: self.field(&record, "front_face")?.truth(),
        })
    }

    /// Calls `HittableList::hit` of chapter 5 on a list with these spheres in this order, and
    /// returns the `t` of the nearest hit between `t_min` and `t_max`, as the program itself
    /// decides.
    ///
    /// Returns `None` for a miss (an empty list, too), if the program stops, or if one of these
    /// functions or the field `t` is missing.
    pub fn nearest(&self, balls: &[Ball], ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
        let mut machine = self.machine();
        let new = self.code.number_of("HittableList::new");
        let made = match self.code.number_of("HittableList::default").or(new) {
            Some(new) => self.asked(machine.call(new, &[]))?,
            None => {
                let kind = self.code.names.kind("HittableList")?;
                machine
                    .default(&Ctor::Own(kind).into(), Span::default())
                    .ok()?
            }
        };
        let spheres = balls.iter().map(|ball| {
            let given = [self.vec3(ball.center), ball.radius.into()];
            self.called("Sphere::new", &given)
        });
        let spheres = spheres.collect::<Option<_>>()?;
        let add = self.code.number_of("HittableList::add")?;
        let filled = self.asked(machine.filled(add, made, spheres))?;
        let given = [filled, Self::ray(self, ray), t_min.into(), t_max.into()];
        let record = self.called("HittableList::hit", &given)?.option()?;
        Some(self.field(&record, "t")?.float())
    }
}

/// Calls of functions that only a whole program has, with its camera and its vectors in its text.
impl Program {
    /// Calls `Camera::new(width)` and its `ray(i, j)`: the ray of the pixel in column `i` and row
    /// `j`, from 0 at the top left, of a picture `width` pixels wide.
    ///
    /// Returns `None` if the program stops, has no such functions, or has a ray type of its own.
    pub fn camera_ray(&self, width: u32, i: u32, j: u32) -> Option<Ray> {
        let camera = self.called("Camera::new", &[u32_value(width)])?;
        let [i, j] = [i, j].map(u32_value);
        match self.called("Camera::ray", &[camera, i, j])?.data {
            Data::Ray(ray) => Some(*ray),
            _ => None,
        }
    }

    /// Calls the function with the name `function`, `f` or `Type::f`, with `u32` arguments, and
    /// returns the integers in the array or list that it returns.
    ///
    /// Returns `None` if the program stops or has no such function, or if the result is anything
    /// else, or has an integer that is no `i32`.
    pub fn call_with_integers(&self, function: &str, given: &[u32]) -> Option<Vec<i32>> {
        let given: Vec<Value> = given.iter().copied().map(u32_value).collect();
        self.called(function, &given)?.integers()
    }

    /// Calls the function with the name `function`, `f` or `Type::f`, with a color, and returns the
    /// integers in the array or list that it returns.
    ///
    /// Returns `None` if the program stops or has no such function, or if the result is anything
    /// else, or has an integer that is no `i32`.
    pub fn call_with_color(&self, function: &str, color: Color) -> Option<Vec<i32>> {
        self.called(function, &[color.into()])?.integers()
    }

    /// Calls the function with the name `function`, `f` or `Type::f`, with vectors, and returns the
    /// `f64` that it returns, or x, y and z of the vector.
    ///
    /// Returns `None` if the program stops or has no such function, or if the result is anything
    /// else.
    pub fn call_with_vectors(&self, function: &str, given: &[Vec3]) -> Option<Vec<f64>> {
        let given: Vec<Value> = given.iter().copied().map(Value::from).collect();
        match self.called(function, &given)?.data {
            Data::Float(it) => Some(vec![it]),
            Data::Vec3(it) => Some(it.to_array().to_vec()),
            _ => None,
        }
    }

    fn called(&self, function: &str, given: &[Value]) -> Option<Value> {
        self.call(self.code.number_of(function)?, given)
    }

    /// Returns the number of the function of that name, if it takes that many parameters.
    pub(crate) fn role(&self, name: &str, parameters: usize) -> Option<usize> {
        let takes = |it: &usize| self.code.names.functions[*it].parameters.len();
        self.code
            .number_of(name)
            .filter(|it| takes(it) == parameters)
    }

    /// Returns the number of `ray_color`, if it takes a ray, or a ray and a world.
    pub(crate) fn ray_color_role(&self) -> Option<usize> {
        self.role("ray_color", 1)
            .or_else(|| self.role("ray_color", 2))
    }

    fn field(&self, value: &Value, name: &str) -> Option<Value> {
        let Data::Own(kind, _) = value.data else {
            return None;
        };
        Some(value.part(self.code.names.structs[kind as usize].field(name)?))
    }
}

impl Value {
    fn integers(&self) -> Option<Vec<i32>> {
        let Data::List(all) = &self.data else {
            return None;
        };
        let all = all.all.iter().map(|it| match &it.data {
            Data::Int(it, _) => i32::try_from(it.get()).ok(),
            _ => None,
        });
        all.collect()
    }
}
