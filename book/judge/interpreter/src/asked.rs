//! Function calls from outside: what a chapter's functions answer to a ray and a sphere.

use common::rtweekend::*;

use crate::machine::value::{Data, Value};
use crate::program::{Program, u32_value};
use crate::refusal::Span;
use crate::types::Ctor;

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its center.
    pub center: Point3,
    /// Its radius.
    pub radius: f64,
}

impl Ball {
    /// Makes the sphere at (`x`, `y`, `z`).
    pub const fn new(x: f64, y: f64, z: f64, radius: f64) -> Self {
        Self {
            center: Point3::new(x, y, z),
            radius,
        }
    }
}

/// A record of a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereHit {
    /// The ray parameter, in lengths of the ray's direction.
    pub t: f64,
    /// The point on the sphere.
    pub point: Point3,
    /// The normal, which should be a unit vector against the ray.
    pub normal: Vec3,
    /// True if the ray came from outside.
    pub front_face: bool,
}

impl Program {
    /// Calls the chapter's `ray_color`; NaN where it stops.
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

    /// Calls the `hit_sphere` of chapters 2 to 4; any `t` where it only says yes.
    pub fn hit_sphere(&self, center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
        let given = [self.vec3(center), radius.into(), Self::ray(self, ray)];
        let answer = self.call(self.role("hit_sphere", 3)?, &given)?;
        match answer.data {
            Data::Bool(is_hit) => is_hit.then_some(0.0),
            Data::Float(t) => Some(t),
            _ => answer.option().map(|t| t.float()),
        }
    }

    /// Calls the `hit` of a sphere in chapter 5.
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

    /// Calls the `hit` of a list in chapter 5; returns the ray parameter.
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

/// Functions that only a whole program has, with its camera and its vectors in its text.
impl Program {
    /// Returns the ray that its camera casts for the pixel in a column and row of a picture that
    /// wide.
    pub fn camera_ray(&self, width: u32, i: u32, j: u32) -> Option<Ray> {
        let camera = self.called("Camera::new", &[u32_value(width)])?;
        let [i, j] = [i, j].map(u32_value);
        match self.called("Camera::ray", &[camera, i, j])?.data {
            Data::Ray(ray) => Some(*ray),
            _ => None,
        }
    }

    /// Returns the integers that a function of integers comes to.
    pub fn call_with_integers(&self, function: &str, given: &[u32]) -> Option<Vec<i32>> {
        let given: Vec<Value> = given.iter().copied().map(u32_value).collect();
        self.called(function, &given)?.integers()
    }

    /// Returns the integers that a function of a color comes to.
    pub fn call_with_color(&self, function: &str, color: Color) -> Option<Vec<i32>> {
        self.called(function, &[color.into()])?.integers()
    }

    /// Returns the number, or the numbers of the vector, that a function of vectors comes to.
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

    /// Returns the number of a chapter's function, if it takes so many arguments.
    pub(crate) fn role(&self, name: &str, parameters: usize) -> Option<usize> {
        let takes = |it: &usize| self.code.names.functions[*it].parameters.len();
        self.code
            .number_of(name)
            .filter(|it| takes(it) == parameters)
    }

    /// Returns the number of `ray_color`, which may take a world.
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
