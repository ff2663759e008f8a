//! Function calls from outside: what a chapter's functions answer to a ray and a sphere.

use common::rtweekend::*;

use crate::machine::value::{Data, Value};
use crate::program::{Program, u32_value};
use crate::refusal::At;

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its center.
    pub center: Point3,
    /// Its radius.
    pub radius: f64,
}

impl Ball {
    /// The sphere at (`x`, `y`, `z`).
    pub const fn new(x: f64, y: f64, z: f64, radius: f64) -> Self {
        Self {
            center: Point3::new(x, y, z),
            radius,
        }
    }
}

/// What there is to know about a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The ray parameter, in lengths of the ray's direction.
    pub t: f64,
    /// The point on the sphere.
    pub point: Point3,
    /// The normal, which should be a unit vector against the ray.
    pub normal: Vec3,
    /// Whether the ray came from outside.
    pub front_face: bool,
}

impl Program {
    /// The chapter's `ray_color`; NaN where it stops.
    pub fn ray_color(&self, ray: &Ray) -> Color {
        let color = || {
            let mut machine = self.machine();
            let world = self.roles.world.map(|it| self.asked(machine.call(it, &[])));
            let mut given = vec![Self::ray(self, ray)];
            if let Some(world) = world {
                given.push(world?);
            }
            let color = self.asked(machine.call(self.roles.ray_color?, &given))?;
            self.vec3_of(&color)
        };
        color().unwrap_or(Color::NAN)
    }

    /// The `hit_sphere` of chapters 2 to 4; any `t` where it only says yes.
    pub fn hit_sphere(&self, center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
        let given = [self.vec3(center), radius.into(), Self::ray(self, ray)];
        let answer = self.call(self.roles.hit_sphere?, &given)?;
        match answer.data {
            Data::Bool(is_hit) => is_hit.then_some(0.0),
            Data::Float(t) => Some(t),
            _ => answer.option().map(|t| t.float()),
        }
    }

    /// The `hit` of a sphere in chapter 5.
    pub fn record(&self, ball: Ball, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        let (new, hit) = self.roles.sphere?;
        let sphere = self.call(new, &[self.vec3(ball.center), ball.radius.into()])?;
        let ray = Self::ray(self, ray);
        let given = [sphere, ray, t_min.into(), t_max.into()];
        let record = self.call(hit, &given)?.option()?;
        let [t, point, normal, front_face] = self.roles.record?.map(|n| record.part(n));
        Some(Hit {
            t: t.float(),
            point: self.vec3_of(&point)?,
            normal: self.vec3_of(&normal)?,
            front_face: front_face.truth(),
        })
    }

    /// The `hit` of a list in chapter 5.
    pub fn nearest(&self, balls: &[Ball], ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
        let (list, (new, _)) = (self.roles.list.as_ref()?, self.roles.sphere?);
        let mut machine = self.machine();
        let made = match list.new {
            Some(new) => self.asked(machine.call(new, &[]))?,
            None => machine.default(&list.ty, At::default()).ok()?,
        };
        let mut spheres = Vec::new();
        for ball in balls {
            let given = [self.vec3(ball.center), ball.radius.into()];
            spheres.push(self.asked(machine.call(new, &given))?);
        }
        let filled = self.asked(machine.filled(list.add, made, spheres))?;
        let ray = Self::ray(self, ray);
        let given = [filled, ray, t_min.into(), t_max.into()];
        let record = self.asked(machine.call(list.hit, &given))?.option()?;
        Some(record.part(self.roles.record?[0]).float())
    }
}

/// What only a whole program has, with its camera and its vectors in its text.
impl Program {
    /// The ray that its camera casts for the pixel in a column and row of a picture that wide.
    pub fn camera_ray(&self, width: u32, i: u32, j: u32) -> Option<Ray> {
        let camera = self.called("Camera::new", &[u32_value(width)])?;
        let [i, j] = [i, j].map(u32_value);
        match self.called("Camera::ray", &[camera, i, j])?.data {
            Data::Ray(ray) => Some(*ray),
            _ => None,
        }
    }

    /// The integers that a function of integers comes to.
    pub fn integers(&self, function: &str, given: &[u32]) -> Option<Vec<i32>> {
        let given: Vec<Value> = given.iter().copied().map(u32_value).collect();
        self.called(function, &given)?.integers()
    }

    /// The integers that a function of a color comes to.
    pub fn integers_of(&self, function: &str, color: Color) -> Option<Vec<i32>> {
        self.called(function, &[color.into()])?.integers()
    }

    /// The number, or the numbers of the vector, that a function of vectors comes to.
    pub fn of_vectors(&self, function: &str, given: &[Vec3]) -> Option<Vec<f64>> {
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
