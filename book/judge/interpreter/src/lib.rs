//! Runs what a reader types in the page: the Rust that our chapters are written in, and
//! what people write instead.
//!
//! `read` makes trees of the files, `names` finds what their names mean, `lower` makes nodes
//! of the trees, and `run` walks these. Operations on numbers happen in the order in which
//! they are written, so a picture is that of the compiled program to the last bit. What is not
//! known here is refused by its name. What is not checked at all, [`UNCHECKED`] says.

mod asked;
mod canvas;
mod lower;
mod names;
pub mod nesting;
mod node;
mod operators;
mod patch;
mod prelude;
mod read;
mod run;
mod types;
mod value;

use std::fmt;
use std::ops::Range;
use std::rc::Rc;
use std::sync::{Arc, OnceLock};

use common::rtweekend::*;

pub use asked::{Ball, Hit, Interpreted};
pub use canvas::{Canvas, Note};
use names::{Names, Signature};
use patch::Written;
use read::Refusal;
pub use run::Sample;
use run::{Code, Machine};
use types::{Head, Type};
use value::Value;

/// What an answer must add that calls a text right: only the compiler sees the rest.
pub const UNCHECKED: &str =
    "Moves, borrows and lines that never ran are not checked here: cargo does that.";

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
    /// Whether the compiler refuses the text; else it compiles, and stops when it runs.
    pub is_refused: bool,
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
#[derive(Clone, Debug)]
pub struct Program {
    code: Arc<Code>,
    roles: Roles,
    refused: OnceLock<Fault>,
}

/// The functions of a chapter, by their numbers, and its types.
#[derive(Clone, Debug, Default)]
struct Roles {
    picture: Option<usize>,
    ray_color: Option<usize>,
    hit_sphere: Option<usize>,
    world: Option<usize>,
    sphere: Option<(usize, usize)>,
    list: Option<List>,
    /// Where `t`, `point`, `normal` and `front_face` are in a record.
    record: Option<[usize; 4]>,
    /// The reader's own kinds of these, if they are not ours.
    own_ray: Option<u32>,
    own_vec3: Option<u32>,
}

#[derive(Clone, Debug)]
struct List {
    ty: Type,
    new: Option<usize>,
    add: usize,
    hit: usize,
}

/// So many turns of loops and calls are no pixel's of a chapter.
const TURNS: u32 = 200_000;
/// A reader's own loop over all pixels takes more.
const TURNS_OF_A_PICTURE: u32 = 20_000_000;
/// The widest and the highest picture that is drawn whole.
const WIDEST: u32 = 4096;

/// Reads the files of a crate: their names, such as `src/lib.rs`, and their texts. The
/// root is `lib.rs`, or the first.
///
/// # Errors
/// What the compiler would refuse and reading shows, and what is not known here.
pub fn read(files: &[(&str, &str)]) -> Result<Program, Vec<Fault>> {
    // Places of an earlier text are not needed any more.
    proc_macro2::extra::invalidate_current_thread_spans();
    let texts: Vec<String> = files.iter().map(|it| it.1.to_owned()).collect();
    let refused = |mut all: Vec<Refusal>| {
        all.sort_by_key(|it| it.is_unknown);
        all.into_iter()
            .map(|it| it.fault(&texts))
            .collect::<Vec<_>>()
    };
    let (mut trees, mut faults) = (Vec::new(), Vec::new());
    for (n, (name, text)) in files.iter().enumerate() {
        match read::parse(n, text) {
            Ok(tree) => trees.push(((*name).to_owned(), tree)),
            Err(fault) => faults.push(fault),
        }
    }
    if !faults.is_empty() {
        return Err(refused(faults));
    }
    let (names, bodies) = names::collect(&trees).map_err(refused)?;
    let (mut functions, mut written) = (Vec::new(), Vec::new());
    for (signature, body) in names.functions.iter().zip(&bodies) {
        written.push(Written::of(&names, signature, *body, &texts));
        match lower::lower(&names, signature, *body) {
            Ok(function) => functions.push(Arc::new(function)),
            Err(fault) => faults.push(fault),
        }
    }
    if !faults.is_empty() {
        return Err(refused(faults));
    }
    Ok(Program {
        roles: Roles::of(&names),
        code: Arc::new(Code {
            names: Arc::new(names),
            functions,
            written,
            texts: Arc::new(texts),
            is_single: false,
            mutant: 0,
            instead: Vec::new(),
        }),
        refused: OnceLock::new(),
    })
}

impl Program {
    /// The picture that the text draws: by `picture`, or by `ray_color` alone.
    ///
    /// # Errors
    /// Where the program stops by itself: a panic, an overflow, too many turns of a loop; and
    /// where the compiler would refuse it, which is seen when it runs.
    pub fn draw(&self, width: u32) -> Result<Picture, Fault> {
        let mut canvas = self.canvas(width)?;
        let (width, height) = canvas.size();
        if ![width, height].iter().all(|it| (1..=WIDEST).contains(it)) {
            return Err(missing("a picture that is 1 to 4096 pixels wide and high"));
        }
        let mut rgb = Vec::with_capacity(3 * width as usize * height as usize);
        for (j, i) in (0..height).flat_map(|j| (0..width).map(move |i| (j, i))) {
            rgb.extend(canvas.levels(i, j)?);
        }
        Picture::from_rgb(width, height, rgb).ok_or_else(|| missing("a picture"))
    }

    /// How many of these pixels are right, up to the first that is not.
    ///
    /// # Errors
    /// As for the picture.
    pub fn matches(&self, width: u32, pixels: &Rc<Sample>) -> Result<usize, Fault> {
        // A reader's own loop over all pixels can't be asked for some.
        let mut canvas = match self.roles.own_ray {
            Some(_) => self.by_ray_color(self.machine(), width)?,
            None => self.canvas(width)?,
        };
        let (width, height) = canvas.size();
        for (n, (at, right)) in pixels.iter().enumerate() {
            if *at >= width * height || canvas.levels(at % width, at / width)? != *right {
                return Ok(n);
            }
        }
        Ok(pixels.len())
    }

    /// What the compiler refuses and was seen only when functions were asked by themselves.
    pub fn refused(&self) -> Option<&Fault> {
        self.refused.get()
    }

    fn machine(&self) -> Machine<'_> {
        let turns = match self.roles.own_ray {
            Some(_) => TURNS_OF_A_PICTURE,
            None => TURNS,
        };
        Machine::new(&self.code, turns)
    }

    fn call(&self, function: usize, given: &[Value]) -> Option<Value> {
        self.asked(self.machine().call(function, given))
    }

    fn ran<T>(&self, result: Result<T, Refusal>) -> Result<T, Fault> {
        result.map_err(|it| it.fault(&self.code.texts))
    }

    /// The answer of a function, or none if it stops.
    fn asked<T>(&self, result: Result<T, Refusal>) -> Option<T> {
        match self.ran(result) {
            Ok(value) => Some(value),
            Err(fault) => {
                if fault.is_refused {
                    let _ = self.refused.set(fault);
                }
                None
            }
        }
    }

    fn vec3(&self, vector: Vec3) -> Value {
        let parts = vector.to_array().map(Value::Float);
        match self.roles.own_vec3 {
            Some(kind) => self.own(kind, ["x", "y", "z"].into_iter().zip(parts)),
            None => Value::Vec3(vector),
        }
    }

    fn ray(&self, ray: &Ray) -> Value {
        let parts = [ray.origin, ray.direction].map(|it| self.vec3(it));
        match self.roles.own_ray {
            Some(kind) => self.own(kind, ["origin", "direction"].into_iter().zip(parts)),
            None => Value::Ray(Rc::new(*ray)),
        }
    }

    /// One of the reader's kinds, by the names of its fields; what has other names keeps the
    /// order.
    fn own<'n>(&self, kind: u32, parts: impl Iterator<Item = (&'n str, Value)>) -> Value {
        let known = self.code.names.kinds[kind as usize].known();
        let mut fields = vec![Value::Unit; known.len()];
        for (n, (name, value)) in parts.enumerate() {
            let place = known.iter().position(|it| it.0 == name).unwrap_or(n);
            if let Some(field) = fields.get_mut(place) {
                *field = value;
            }
        }
        Value::Own(kind, fields.into())
    }

    fn vec3_of(&self, value: &Value) -> Option<Vec3> {
        let Value::Own(kind, fields) = value else {
            return Some(value.vec3());
        };
        let known = self.code.names.kinds[*kind as usize].known();
        let parts = ["x", "y", "z"].into_iter().enumerate().map(|(n, name)| {
            let place = known.iter().position(|it| it.0 == name).unwrap_or(n);
            match fields.get(place)? {
                Value::Float(it) => Some(*it),
                _ => None,
            }
        });
        let parts = parts.collect::<Option<Vec<f64>>>()?;
        Some(Vec3::from_slice(&parts))
    }
}

fn u32_value(number: u32) -> Value {
    Value::Int(number.into(), types::Int::U32)
}

fn missing(what: &str) -> Fault {
    Fault {
        place: None,
        message: format!("there is no {what} to draw"),
        label: String::new(),
        help: String::new(),
        is_refused: false,
    }
}

impl Roles {
    fn of(names: &Names) -> Self {
        let function = |name: &str, parameters| {
            let is_it = |it: &Signature| {
                it.name == name
                    && it.of.is_none()
                    && it.parameters.len() == parameters
                    && !it.is_constant
            };
            names.functions.iter().position(is_it)
        };
        let kind = |name: &str| {
            let kind = names.kinds.iter().position(|it| it.name == name);
            kind.map(|it| Type::from(Head::Own(it)))
        };
        let method = |ty: &Type, name| names.method(ty, name, None);
        let ray_color = function("ray_color", 1).or_else(|| function("ray_color", 2));
        // Vectors are what a ray is made of.
        let ray = ray_color.and_then(|it| names.functions[it].parameters.first());
        let own_ray = ray.and_then(own_kind);
        let vec3 = own_ray.map(|it| &names.kinds[it as usize].fields);
        let own_vec3 = vec3.and_then(|it| own_kind(&it.first()?.ty));
        Self {
            picture: function("picture", 1),
            ray_color,
            hit_sphere: function("hit_sphere", 3),
            world: function("world", 0),
            sphere: kind("Sphere").and_then(|it| Some((method(&it, "new")?, method(&it, "hit")?))),
            list: kind("HittableList").and_then(|it| {
                Some(List {
                    new: method(&it, "default").or_else(|| method(&it, "new")),
                    add: method(&it, "add")?,
                    hit: method(&it, "hit")?,
                    ty: it,
                })
            }),
            record: kind("HitRecord").and_then(|it| {
                let fields = names.fields_of(&it);
                let place = |name| fields.iter().position(|it| it.0 == name);
                Some([
                    place("t")?,
                    place("point").or_else(|| place("p"))?,
                    place("normal")?,
                    place("front_face")?,
                ])
            }),
            own_ray,
            own_vec3,
        }
    }
}

fn own_kind(ty: &Type) -> Option<u32> {
    match ty.stripped().0 {
        Head::Own(kind) => Some(kind as u32),
        _ => None,
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
