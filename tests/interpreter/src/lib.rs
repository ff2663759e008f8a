//! Runs what a reader types in the page: the Rust that our chapters are written in, and
//! what people write instead.
//!
//! `read` makes trees of the files, `items` finds what their names mean, `check` finds a
//! type for each expression, and `run` walks what is left. Operations on numbers happen in
//! the order in which they are written, so a picture is that of the compiled program to the
//! last bit. What is not known here is refused by its name. Moves and borrows are not
//! checked: the compiler does that.

mod check;
mod items;
mod node;
mod prelude;
mod read;
mod run;
mod types;

use std::fmt;
use std::ops::Range;
use std::rc::Rc;
use std::sync::Arc;

use common::rtweekend::*;
use slips::{Ball, Hit, Interpreted};

use items::Items;
pub use run::Sample;
use run::{Code, Machine, Value};

/// Why a text does not run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Where it is, if it is somewhere.
    pub place: Option<Place>,
    /// What is wrong, in the words of the compiler where it has some.
    pub message: String,
    /// The words below the place, or none.
    pub label: String,
    /// What to do, or nothing.
    pub help: String,
}

/// A place in a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// Which of the files.
    pub file: usize,
    /// The line, counted from 1.
    pub line: usize,
    /// The columns, counted in characters from 0. The end may be beyond that of the line.
    pub columns: Range<usize>,
}

/// A text that can be run.
#[derive(Debug)]
pub struct Program {
    code: Arc<Code>,
    names: Names,
    /// What the compiler would warn of, in its words.
    pub warnings: Vec<String>,
}

/// The functions of a chapter, by their numbers.
#[derive(Debug, Default)]
struct Names {
    picture: Option<usize>,
    ray_color: Option<usize>,
    hit_sphere: Option<usize>,
    world: Option<usize>,
    sphere: Option<(usize, usize)>,
    list: Option<List>,
    /// Where `t`, `point`, `normal` and `front_face` are in a record.
    record: Option<[usize; 4]>,
}

#[derive(Debug)]
struct List {
    kind: u32,
    new: Option<usize>,
    add: usize,
    hit: usize,
}

/// Reads the files of a crate: their names, such as `src/lib.rs`, and their texts. The
/// first is the root.
///
/// # Errors
/// Whatever the compiler would refuse, apart from moves and borrows, and what is not known
/// here.
pub fn read(files: &[(&str, &str)]) -> Result<Program, Vec<Fault>> {
    // Places of an earlier text are not needed any more.
    proc_macro2::extra::invalidate_current_thread_spans();
    let trees: Vec<_> = files
        .iter()
        .enumerate()
        .map(|(n, (name, text))| Ok((module(name), read::parse(n, text)?)))
        .collect();
    let faults: Vec<Fault> = trees
        .iter()
        .filter_map(|it| it.as_ref().err().cloned())
        .collect();
    if !faults.is_empty() {
        return Err(faults);
    }
    let trees: Vec<_> = trees.into_iter().filter_map(Result::ok).collect();
    let items = Items::of(&trees)?;
    let (code, warnings) = check::check(&items)?;
    Ok(Program {
        names: Names::of(&items),
        code: Arc::new(code),
        warnings,
    })
}

/// The module that a file is.
fn module(file: &str) -> String {
    let name = file.rsplit('/').next().unwrap_or(file);
    name.trim_end_matches(".rs").to_owned()
}

impl Program {
    /// The picture that the text draws: by `picture`, or by `ray_color` alone.
    ///
    /// # Errors
    /// Where the program stops by itself: a panic, an overflow, a loop without end.
    pub fn draw(&self, width: u32) -> Result<Picture, Fault> {
        let mut machine = Machine::new(&self.code);
        if let Some(picture) = self.names.picture {
            let drawn = machine.call(picture, &[Value::Int(width.into())])?;
            return prelude::picture(&drawn).ok_or_else(|| missing("a picture"));
        }
        let color = self.names.ray_color.ok_or_else(|| missing("`ray_color`"))?;
        let world = self
            .names
            .world
            .map(|it| machine.call(it, &[]))
            .transpose()?;
        let camera = Camera::new(width);
        let size = (camera.image_width, camera.image_height);
        let mut rgb = Vec::with_capacity(3 * size.0 as usize * size.1 as usize);
        for (j, i) in (0..size.1).flat_map(|j| (0..size.0).map(move |i| (j, i))) {
            machine.begin();
            let ray = Value::Ray(Rc::new(camera.ray(i, j)));
            let given: Vec<Value> = [ray].into_iter().chain(world.clone()).collect();
            let mut pixel = [0; 3];
            write_color(&mut pixel, machine.call(color, &given)?.vec3());
            rgb.extend(pixel);
        }
        Picture::from_rgb(size.0, size.1, rgb).ok_or_else(|| missing("a picture"))
    }

    /// How many of these pixels are right, up to the first that is not.
    ///
    /// # Errors
    /// Where the program stops by itself.
    pub fn matches(&self, width: u32, pixels: &Rc<Sample>) -> Result<usize, Fault> {
        let mut machine = Machine::new(&self.code);
        machine.sample = Some(Rc::clone(pixels));
        if let Some(picture) = self.names.picture {
            machine.call(picture, &[Value::Int(width.into())])?;
            return Ok(machine.matched);
        }
        Err(missing("a picture"))
    }

    /// The range that `ray_color` asks the world for.
    pub fn range(&self, ray: &Ray) -> Option<[f64; 2]> {
        let asked = Rc::default();
        let given = [Value::Ray(Rc::new(*ray)), Value::Nothing(Rc::clone(&asked))];
        self.call(self.names.ray_color?, &given)?;
        asked.get()
    }

    fn call(&self, function: usize, given: &[Value]) -> Option<Value> {
        Machine::new(&self.code).call(function, given).ok()
    }
}

fn missing(what: &str) -> Fault {
    Fault::at(None, &format!("there is no {what} to draw"), "", "")
}

impl Names {
    fn of(items: &Items) -> Self {
        let function = |name, parameters| {
            let is_it = |it: &items::Signature| {
                it.name == name
                    && it.of.is_none()
                    && it.parameters.len() == parameters
                    && !it.is_constant
            };
            items.functions.iter().position(is_it)
        };
        let kind = |name: &str| items.kinds.iter().position(|it| it.name == name);
        let method = |kind, name| items.method_or_default(kind, name);
        Self {
            picture: function("picture", 1),
            ray_color: function("ray_color", 1).or_else(|| function("ray_color", 2)),
            hit_sphere: function("hit_sphere", 3),
            world: function("world", 0),
            sphere: kind("Sphere").and_then(|it| Some((method(it, "new")?, method(it, "hit")?))),
            list: kind("HittableList").and_then(|it| {
                Some(List {
                    kind: it as u32,
                    new: method(it, "default").or_else(|| method(it, "new")),
                    add: method(it, "add")?,
                    hit: method(it, "hit")?,
                })
            }),
            record: kind("HitRecord").and_then(|it| {
                let fields = &items.kinds[it].variants.first()?.fields;
                let place = |name| fields.iter().position(|it| it.name == name);
                Some([
                    place("t")?,
                    place("point")?,
                    place("normal")?,
                    place("front_face")?,
                ])
            }),
        }
    }
}

impl Interpreted for Program {
    fn camera(&self, _width: u32, _height: u32) -> Option<Camera> {
        None
    }

    fn ray(&self, _camera: &Camera, _i: u32, _j: u32) -> Option<Ray> {
        None
    }

    fn ray_color(&self, ray: &Ray) -> Color {
        let color = || {
            let mut machine = Machine::new(&self.code);
            let world = match self.names.world {
                Some(world) => Some(machine.call(world, &[]).ok()?),
                None => None,
            };
            let ray = Value::Ray(Rc::new(*ray));
            let given: Vec<Value> = [ray].into_iter().chain(world).collect();
            machine.call(self.names.ray_color?, &given).ok()
        };
        color().map_or(Color::NAN, |it| it.vec3())
    }

    fn hit_sphere(&self, center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
        let given = [
            Value::Vec3(center),
            Value::Float(radius),
            Value::Ray(Rc::new(*ray)),
        ];
        match self.call(self.names.hit_sphere?, &given)? {
            Value::Bool(is_hit) => is_hit.then_some(0.0),
            it => it.option().map(|t| t.float()),
        }
    }

    fn record(&self, ball: Ball, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        let (new, hit) = self.names.sphere?;
        let sphere = self.call(new, &[Value::Vec3(ball.center), Value::Float(ball.radius)])?;
        let given = [
            sphere,
            Value::Ray(Rc::new(*ray)),
            Value::Float(t_min),
            Value::Float(t_max),
        ];
        let record = self.call(hit, &given)?.option()?;
        let [t, point, normal, front_face] = self.names.record?.map(|n| record.field(n));
        Some(Hit {
            t: t.float(),
            point: point.vec3(),
            normal: normal.vec3(),
            front_face: front_face.truth(),
        })
    }

    fn nearest(&self, balls: &[Ball], ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
        let (list, (new, _)) = (self.names.list.as_ref()?, self.names.sphere?);
        let mut machine = Machine::new(&self.code);
        let made = match list.new {
            Some(new) => machine.call(new, &[]).ok()?,
            None => machine.default_of(list.kind),
        };
        let spheres: Result<Vec<Value>, Fault> = balls
            .iter()
            .map(|it| machine.call(new, &[Value::Vec3(it.center), Value::Float(it.radius)]))
            .collect();
        let filled = machine.filled(list.add, made, spheres.ok()?).ok()?;
        let given = [
            filled,
            Value::Ray(Rc::new(*ray)),
            Value::Float(t_min),
            Value::Float(t_max),
        ];
        let record = machine.call(list.hit, &given).ok()?.option()?;
        Some(record.field(self.names.record?[0]).float())
    }
}

impl Fault {
    pub(crate) fn at(place: Option<Place>, message: &str, label: &str, help: &str) -> Self {
        Self {
            place,
            message: message.to_owned(),
            label: label.to_owned(),
            help: help.to_owned(),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = &self.place {
            write!(f, "line {}: ", place.line)?;
        }
        f.write_str(&self.message)?;
        for more in [&self.label, &self.help] {
            if !more.is_empty() {
                write!(f, "; {more}")?;
            }
        }
        Ok(())
    }
}
