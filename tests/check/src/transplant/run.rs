//! A tree-walking interpreter for our chapters, in the arithmetic of the prelude.

use std::sync::Arc;

use common::rtweekend::*;
use slips::{Ball, Hit, World};

use super::syntax::{Callee, Function, Member, Node, Sign};

/// What a part of a program comes to. An `Option` is the value itself, or a miss.
#[derive(Clone, Copy, Debug)]
pub(super) enum Value {
    Unit,
    Miss,
    Bool(bool),
    Number(f64),
    Vector(Vec3),
    Ray(Ray),
    Ball(Ball),
    Record(Hit),
    Camera(Camera),
    World,
    Two([f64; 2]),
}

/// Why nothing follows.
enum Stop {
    /// The function has returned.
    Return(Value),
    /// No such program compiles.
    Nonsense,
}

type Result<T = Value> = std::result::Result<T, Stop>;

/// The functions of a chapter by their names, a method's with its type.
#[derive(Clone, Debug)]
pub(super) struct Machine {
    pub(super) functions: Vec<(&'static str, Arc<Function>)>,
    pub(super) world: World,
}

impl Machine {
    /// Whether the function is run from its text.
    pub(super) fn has(&self, name: &str) -> bool {
        self.functions.iter().any(|(own, _)| *own == name)
    }

    /// Calls the function; `None` if it is no program.
    pub(super) fn call(&self, name: &str, arguments: &[Value]) -> Option<Value> {
        self.run(name, arguments, &self.world)
            .ok()
            .map(|(value, _)| value)
    }

    /// The same with a world of other spheres.
    pub(super) fn call_in(&self, world: &[Ball], name: &str, arguments: &[Value]) -> Option<Value> {
        self.run(name, arguments, world)
            .ok()
            .map(|(value, _)| value)
    }

    fn run(&self, name: &str, arguments: &[Value], world: &[Ball]) -> Result<(Value, Value)> {
        let frame = Frame {
            machine: self,
            world,
            slots: Vec::new(),
            depth: 0,
        };
        frame.calls(name, arguments)
    }
}

/// So deep is no call in a chapter: a function that calls itself has no end.
const DEEPEST: u32 = 12;

struct Frame<'a> {
    machine: &'a Machine,
    world: &'a [Ball],
    slots: Vec<Value>,
    depth: u32,
}

impl Frame<'_> {
    /// What the function returns, and what becomes of its first argument.
    fn calls(&self, name: &str, arguments: &[Value]) -> Result<(Value, Value)> {
        let mut functions = self.machine.functions.iter();
        let function = functions.find(|(own, _)| *own == name);
        let (_, function) = function
            .filter(|_| self.depth < DEEPEST)
            .ok_or(Stop::Nonsense)?;
        let mut frame = Frame {
            slots: vec![Value::Unit; function.slots],
            depth: self.depth + 1,
            ..*self
        };
        let given = frame.slots.get_mut(..arguments.len());
        given.ok_or(Stop::Nonsense)?.copy_from_slice(arguments);
        let value = match frame.value(&function.body) {
            Ok(value) | Err(Stop::Return(value)) => value,
            Err(Stop::Nonsense) => return Err(Stop::Nonsense),
        };
        Ok((value, frame.slots.first().copied().unwrap_or(Value::Unit)))
    }

    fn value(&mut self, node: &Node) -> Result {
        match node {
            Node::Number(number) => Ok(Value::Number(*number)),
            Node::Name(name) => constant(name),
            Node::Variable(slot) => Ok(self.slots[*slot]),
            Node::Set(slot, value) => {
                self.slots[*slot] = self.value(value)?;
                Ok(Value::Unit)
            }
            Node::SetField(slot, field, value) => {
                let value = self.value(value)?;
                set(&mut self.slots[*slot], *field, value)
            }
            Node::Field(of, field) => member(self.value(of)?, *field),
            Node::Negated(of) => match self.value(of)? {
                Value::Number(number) => Ok(Value::Number(-number)),
                Value::Vector(vector) => Ok(Value::Vector(-vector)),
                _ => Err(Stop::Nonsense),
            },
            Node::Not(of) => match self.value(of)? {
                Value::Bool(is_so) => Ok(Value::Bool(!is_so)),
                _ => Err(Stop::Nonsense),
            },
            Node::Binary(operator, left, right) => {
                let left = self.value(left)?;
                match (operator, left) {
                    (Sign::And, Value::Bool(false)) | (Sign::Or, Value::Bool(true)) => Ok(left),
                    _ => {
                        let right = self.value(right)?;
                        binary(*operator, left, right)
                    }
                }
            }
            Node::Call(name, arguments) => {
                let given = self.several(arguments)?;
                self.called(*name, &given[..arguments.len()])
            }
            Node::Method(name, of, arguments) => self.method(*name, of, arguments),
            Node::Find(of, slot, condition) => self.find(of, *slot, condition),
            Node::Several(nodes) => match self.several(nodes)? {
                [Value::Number(one), Value::Number(other), ..] => Ok(Value::Two([one, other])),
                _ => Err(Stop::Nonsense),
            },
            Node::Record(fields) => self.built(Value::Record(NO_HIT), fields),
            Node::Camera(fields) => self.built(Value::Camera(NO_CAMERA), fields),
            Node::Matches(slot, value) => {
                self.slots[*slot] = self.value(value)?;
                Ok(Value::Bool(!matches!(self.slots[*slot], Value::Miss)))
            }
            Node::If(all, then, other) => self.choice(all, then, other.as_deref()),
            Node::For(slot, body) => {
                for ball in self.world {
                    self.slots[*slot] = Value::Ball(*ball);
                    self.value(body)?;
                }
                Ok(Value::Unit)
            }
            Node::Return(value) => Err(Stop::Return(self.value(value)?)),
            Node::Try(value) => match self.value(value)? {
                Value::Miss => Err(Stop::Return(Value::Miss)),
                value => Ok(value),
            },
            Node::Block(nodes) => {
                let mut last = Value::Unit;
                for node in nodes {
                    last = self.value(node)?;
                }
                Ok(last)
            }
        }
    }

    /// The values of up to four nodes: no function here has more parameters.
    fn several(&mut self, nodes: &[Node]) -> Result<[Value; 4]> {
        let mut values = [Value::Unit; 4];
        for (n, node) in nodes.iter().enumerate() {
            *values.get_mut(n).ok_or(Stop::Nonsense)? = self.value(node)?;
        }
        Ok(values)
    }

    fn built(&mut self, mut value: Value, fields: &[(Member, Node)]) -> Result {
        for (field, node) in fields {
            let field_value = self.value(node)?;
            set(&mut value, *field, field_value)?;
        }
        Ok(value)
    }

    fn choice(&mut self, all: &[Node], then: &Node, other: Option<&Node>) -> Result {
        for condition in all {
            match self.value(condition)? {
                Value::Bool(true) => {}
                Value::Bool(false) => {
                    return other.map_or(Ok(Value::Unit), |other| self.value(other));
                }
                _ => return Err(Stop::Nonsense),
            }
        }
        self.value(then)
    }

    fn find(&mut self, of: &Node, slot: usize, condition: &Node) -> Result {
        let Value::Two(numbers) = self.value(of)? else {
            return Err(Stop::Nonsense);
        };
        for number in numbers {
            self.slots[slot] = Value::Number(number);
            if let Value::Bool(true) = self.value(condition)? {
                return Ok(self.slots[slot]);
            }
        }
        Ok(Value::Miss)
    }

    fn called(&mut self, name: Callee, arguments: &[Value]) -> Result {
        match (name, arguments) {
            (Callee::Some, [value]) => Ok(*value),
            (Callee::Sky, [Value::Ray(_)]) if self.machine.has("sky") => self.own("sky", arguments),
            (Callee::Sky, [Value::Ray(ray)]) => Ok(Value::Vector(sky(ray))),
            (Callee::From, [Value::Number(_)]) => Ok(arguments[0]),
            (Callee::Ray, [Value::Vector(origin), Value::Vector(direction)]) => {
                Ok(Value::Ray(Ray::new(*origin, *direction)))
            }
            (
                Callee::Point | Callee::Color | Callee::Vector,
                [Value::Number(x), Value::Number(y), Value::Number(z)],
            ) => Ok(Value::Vector(Vec3::new(*x, *y, *z))),
            (Callee::HitSphere, _) => self.own("hit_sphere", arguments),
            _ => Err(Stop::Nonsense),
        }
    }

    fn method(&mut self, name: Member, of: &Node, arguments: &[Node]) -> Result {
        use Value::{Number, Vector};
        let object = self.value(of)?;
        let given = self.several(arguments)?;
        match (name, object, &given[..arguments.len()]) {
            (Member::Sqrt, Number(number), []) => Ok(Number(number.sqrt())),
            (Member::Abs, Number(number), []) => Ok(Number(number.abs())),
            (Member::Abs, Vector(vector), []) => Ok(Vector(vector.abs())),
            (Member::Normalize, Vector(vector), []) => Ok(Vector(vector.normalize())),
            (Member::Length, Vector(vector), []) => Ok(Number(vector.length())),
            (Member::LengthSquared, Vector(vector), []) => Ok(Number(vector.length_squared())),
            (Member::Dot, Vector(one), [Vector(other)]) => Ok(Number(one.dot(*other))),
            (Member::At, Value::Ray(_), &[t]) if self.machine.has("at") => {
                self.own("at", &[object, t])
            }
            (Member::At, Value::Ray(ray), [Number(t)]) => Ok(Vector(ray.at(*t))),
            (Member::IntoIter, object, []) => Ok(object),
            (Member::Hit, Value::Ball(_), &[ray, low, high]) => {
                self.own("Sphere::hit", &[object, ray, low, high])
            }
            (Member::Hit, Value::World, &[ray, low, high]) => {
                self.own("HittableList::hit", &[object, ray, low, high])
            }
            (Member::SetFaceNormal, Value::Record(_), &[ray, normal]) => {
                let given = [object, ray, normal];
                let (_, changed) = self.calls("set_face_normal", &given)?;
                if let Node::Variable(slot) = of {
                    self.slots[*slot] = changed;
                }
                Ok(Value::Unit)
            }
            _ => Err(Stop::Nonsense),
        }
    }

    fn own(&mut self, name: &str, given: &[Value]) -> Result {
        Ok(self.calls(name, given)?.0)
    }
}

/// A camera that is not set up yet.
const NO_CAMERA: Camera = Camera {
    image_width: 0,
    image_height: 0,
    center: Point3::ZERO,
    pixel00: Point3::ZERO,
    pixel_delta_u: Vec3::ZERO,
    pixel_delta_v: Vec3::ZERO,
};

/// What `HitRecord::default` gives.
const NO_HIT: Hit = Hit {
    t: 0.0,
    point: Point3::ZERO,
    normal: Vec3::ZERO,
    front_face: false,
};

fn constant(name: &str) -> Result {
    match name {
        "None" => Ok(Value::Miss),
        "false" => Ok(Value::Bool(false)),
        "true" => Ok(Value::Bool(true)),
        "f64::INFINITY" | "INFINITY" => Ok(Value::Number(f64::INFINITY)),
        "Point3::ZERO" => Ok(Value::Vector(Point3::ZERO)),
        "Vec3::ONE" | "Color::ONE" | "ONE" => Ok(Value::Vector(Vec3::ONE)),
        _ => Err(Stop::Nonsense),
    }
}

fn set(of: &mut Value, field: Member, value: Value) -> Result {
    match (of, field, value) {
        (Value::Record(record), Member::T, Value::Number(t)) => record.t = t,
        (Value::Record(record), Member::Point, Value::Vector(point)) => record.point = point,
        (Value::Record(record), Member::Normal, Value::Vector(normal)) => record.normal = normal,
        (Value::Record(record), Member::FrontFace, Value::Bool(front_face)) => {
            record.front_face = front_face;
        }
        (Value::Camera(camera), field, value) => match (field, value) {
            (Member::ImageWidth | Member::ImageHeight, Value::Number(_)) => {}
            (Member::Center, Value::Vector(center)) => camera.center = center,
            (Member::Pixel00, Value::Vector(pixel00)) => camera.pixel00 = pixel00,
            (Member::PixelDeltaU, Value::Vector(delta)) => camera.pixel_delta_u = delta,
            (Member::PixelDeltaV, Value::Vector(delta)) => camera.pixel_delta_v = delta,
            _ => return Err(Stop::Nonsense),
        },
        _ => return Err(Stop::Nonsense),
    }
    Ok(Value::Unit)
}

fn member(of: Value, field: Member) -> Result {
    Ok(match (of, field) {
        (Value::Ray(ray), Member::Origin) => Value::Vector(ray.origin),
        (Value::Ray(ray), Member::Direction) => Value::Vector(ray.direction),
        (Value::Vector(vector), Member::X) => Value::Number(vector.x),
        (Value::Vector(vector), Member::Y) => Value::Number(vector.y),
        (Value::Vector(vector), Member::Z) => Value::Number(vector.z),
        (Value::Camera(camera), Member::Center) => Value::Vector(camera.center),
        (Value::Camera(camera), Member::Pixel00) => Value::Vector(camera.pixel00),
        (Value::Camera(camera), Member::PixelDeltaU) => Value::Vector(camera.pixel_delta_u),
        (Value::Camera(camera), Member::PixelDeltaV) => Value::Vector(camera.pixel_delta_v),
        (Value::Ball(ball), Member::Center) => Value::Vector(ball.center),
        (Value::Ball(ball), Member::Radius) => Value::Number(ball.radius),
        (Value::Record(record), Member::T) => Value::Number(record.t),
        (Value::Record(record), Member::Point) => Value::Vector(record.point),
        (Value::Record(record), Member::Normal) => Value::Vector(record.normal),
        (Value::Record(record), Member::FrontFace) => Value::Bool(record.front_face),
        _ => return Err(Stop::Nonsense),
    })
}

fn binary(operator: Sign, left: Value, right: Value) -> Result {
    use Value::{Bool, Number, Vector};
    Ok(match (operator, left, right) {
        (Sign::Plus, Number(one), Number(other)) => Number(one + other),
        (Sign::Minus, Number(one), Number(other)) => Number(one - other),
        (Sign::Times, Number(one), Number(other)) => Number(one * other),
        (Sign::Over, Number(one), Number(other)) => Number(one / other),
        (Sign::Plus, Vector(one), Vector(other)) => Vector(one + other),
        (Sign::Minus, Vector(one), Vector(other)) => Vector(one - other),
        (Sign::Times, Vector(one), Vector(other)) => Vector(one * other),
        (Sign::Times, Number(one), Vector(other)) => Vector(one * other),
        (Sign::Times, Vector(one), Number(other)) => Vector(one * other),
        (Sign::Over, Vector(one), Number(other)) => Vector(one / other),
        (Sign::Less, Number(one), Number(other)) => Bool(one < other),
        (Sign::Greater, Number(one), Number(other)) => Bool(one > other),
        (Sign::AtMost, Number(one), Number(other)) => Bool(one <= other),
        (Sign::AtLeast, Number(one), Number(other)) => Bool(one >= other),
        (Sign::And | Sign::Or, Bool(_), Bool(other)) => Bool(other),
        _ => return Err(Stop::Nonsense),
    })
}
