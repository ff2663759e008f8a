//! The interpreted program: how its files are read, its picture is drawn, and which lines never
//! ran.

use std::ops::RangeInclusive;
use std::rc::Rc;
use std::sync::atomic::Ordering::Relaxed;
use std::sync::{Arc, OnceLock};

use common::rtweekend::*;

use crate::limits::{MAX_TURNS, MAX_TURNS_OF_A_PICTURE, MAX_WIDTH};
use crate::machine::value::{Data, Value};
use crate::machine::{Code, Machine};
use crate::names::collect::collect;
use crate::refusal::{Fault, FaultKind, Refusal, lines};
use crate::types::Int;
use crate::{lower, read as parsing};

/// A pixel and the color that it should have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExpectedPixel {
    /// The number of the pixel: `j * width + i` in column `i` and row `j`, from 0 at the top left.
    pub index: u32,
    /// The levels of red, green and blue, 0 to 255.
    pub levels: [u8; 3],
}

/// Lines of a file that never ran, so that their types are not checked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UncheckedLines {
    /// The index of the file in the list that was given to [`read`], from 0.
    pub file: usize,
    /// The first line and the last, counted from 1, both included.
    pub lines: RangeInclusive<usize>,
}

/// A Rust program, as a reader of the chapters types it, that was read without a fault and can be
/// run.
#[derive(Clone, Debug)]
pub struct Program {
    pub(crate) code: Arc<Code>,
    pub(crate) refused: Arc<OnceLock<Fault>>,
}

/// A file of a program as its author typed it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceFile {
    /// The path from the folder of the program, with `/`, such as `src/lib.rs`.
    pub name: String,
    /// The whole text.
    pub text: String,
}

impl SourceFile {
    /// Makes a file from its path, such as `src/lib.rs`, and its whole text. Nothing is read from
    /// the disk.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            text: text.into(),
        }
    }
}

/// Reads the files of a crate. Its root is the file whose name ends with `lib.rs`, or else the
/// first. Nothing runs yet.
///
/// Spans of a text that was read earlier on this thread become invalid.
///
/// # Errors
/// Faults that show without running, from the first step that finds any: syntax, one for each file;
/// then declarations; then bodies, one for each function. Those that the compiler would refuse come
/// first, then texts that end too early, then what this interpreter does not read.
///
/// # Panics
/// If there is no file.
pub fn read(files: &[SourceFile]) -> Result<Program, Vec<Fault>> {
    // Places of an earlier text are not needed any more.
    proc_macro2::extra::invalidate_current_thread_spans();
    let texts: Vec<String> = files.iter().map(|it| it.text.clone()).collect();
    let refused = |mut all: Vec<Refusal>| {
        all.sort_by_key(|it| it.kind);
        let faults = all.into_iter().map(|it| it.fault(&texts));
        faults.collect::<Vec<_>>()
    };
    let (mut trees, mut faults) = (Vec::new(), Vec::new());
    for (n, file) in files.iter().enumerate() {
        match parsing::parse(n, &file.text) {
            Ok(tree) => trees.push((file.name.clone(), tree)),
            Err(fault) => faults.push(fault),
        }
    }
    if !faults.is_empty() {
        return Err(refused(faults));
    }
    let (names, bodies) = collect(&trees).map_err(refused)?;
    let mut functions = Vec::new();
    for (signature, body) in names.functions.iter().zip(&bodies) {
        let text = &texts[names.modules[signature.module].file as usize];
        match lower::lower(&names, text, signature, *body) {
            Ok(function) => functions.push(Arc::new(function)),
            Err(fault) => faults.push(fault),
        }
    }
    if !faults.is_empty() {
        return Err(refused(faults));
    }
    Ok(Program {
        code: Arc::new(Code {
            names: Arc::new(names),
            functions,
            texts: Arc::new(texts),
            is_single: false,
            mutant: 0,
            instead: Vec::new(),
            read: Arc::default(),
        }),
        refused: Arc::default(),
    })
}

impl Program {
    /// Draws the whole picture, `width` pixels wide: by the program's `picture`, or by `ray_color`
    /// and the book's camera if it has none.
    ///
    /// # Errors
    /// If the program stops: a panic, an overflow, too many turns of a loop; if the compiler would
    /// refuse a line that runs, as with mismatched types; or if the picture's width or height is
    /// not from 1 to 4096 pixels.
    pub fn draw(&self, width: u32) -> Result<Picture, Fault> {
        let canvas = self.canvas(width)?;
        let (width, height) = canvas.size();
        let is_drawn = |it| (1..=MAX_WIDTH).contains(it);
        if ![width, height].iter().all(is_drawn) {
            let message = "there is no picture that is 1 to 4096 pixels wide and high";
            return Err(stopped(message));
        }
        let mut rgb = Vec::with_capacity(3 * width as usize * height as usize);
        for (j, i) in (0..height).flat_map(|j| (0..width).map(move |i| (j, i))) {
            rgb.extend(canvas.levels(i, j)?);
        }
        Picture::from_rgb(width, height, rgb).ok_or_else(|| stopped(NO_PICTURE))
    }

    /// Computes these pixels one after the other, in a picture `width` pixels wide, and counts
    /// those that have the expected levels, up to the first that has others or lies outside of the
    /// picture. The count is the length of `pixels` if all match.
    ///
    /// # Errors
    /// If the program stops, or the compiler would refuse a line that runs.
    pub fn count_matching(&self, width: u32, pixels: &[ExpectedPixel]) -> Result<usize, Fault> {
        // A reader's own loop over all pixels can't be asked for some.
        let canvas = match self.code.names.own_ray {
            Some(_) => self.by_ray_color(width)?,
            None => self.canvas(width)?,
        };
        let (width, height) = canvas.size();
        for (n, &ExpectedPixel { index, levels }) in pixels.iter().enumerate() {
            if index >= width * height || canvas.levels(index % width, index / width)? != levels {
                return Ok(n);
            }
        }
        Ok(pixels.len())
    }

    /// Returns the first fault that the compiler would refuse and that showed only in a call, such
    /// as [`ray_color`](Self::ray_color), which itself returns no fault. `None` if there was none
    /// so far.
    pub fn first_refusal(&self) -> Option<&Fault> {
        self.refused.get()
    }

    /// Lists the lines that no picture and no call has run so far, in the order of files and lines;
    /// ranges that touch are joined. Empty if each line has run.
    ///
    /// Types are checked when a line runs, so these may have mistakes that the compiler would
    /// refuse.
    pub fn unchecked(&self) -> Vec<UncheckedLines> {
        let marks = self.code.functions.iter().flat_map(|it| &it.marks);
        let unrun = marks.filter(|it| !it.has_run.load(Relaxed));
        let lines = unrun.filter_map(|it| lines(&self.code.texts, it.at));
        let mut lines: Vec<_> = lines.collect();
        lines.sort_by_key(|it| (it.file, *it.lines.start()));
        let mut joined: Vec<UncheckedLines> = Vec::new();
        for UncheckedLines { file, lines } in lines {
            match joined.last_mut() {
                Some(last) if last.file == file && *lines.start() <= last.lines.end() + 1 => {
                    last.lines = *last.lines.start()..=*last.lines.end().max(lines.end());
                }
                _ => joined.push(UncheckedLines { file, lines }),
            }
        }
        joined
    }
}

/// The message about a program whose `picture` returns none.
pub(crate) const NO_PICTURE: &str = "there is no picture to draw";

/// Makes the fault of a program that stops at no place of its text.
pub(crate) fn stopped(message: &str) -> Fault {
    Fault::without_place(FaultKind::Stopped, message.to_owned())
}

impl Program {
    /// Makes a machine with the budget of one pixel, or of a picture if the text loops over its
    /// own.
    pub(crate) fn machine(&self) -> Machine<'_> {
        let turns = match self.code.names.own_ray {
            Some(_) => MAX_TURNS_OF_A_PICTURE,
            None => MAX_TURNS,
        };
        Machine::new(&self.code, turns)
    }

    /// Calls the function with that number; `None` if it stops.
    pub(crate) fn call(&self, function: usize, given: &[Value]) -> Option<Value> {
        self.asked(self.machine().call(function, given))
    }

    /// Turns a refusal into a fault with line and columns.
    pub(crate) fn ran<T>(&self, result: Result<T, Refusal>) -> Result<T, Fault> {
        result.map_err(|it| it.fault(&self.code.texts))
    }

    /// Returns the value; or `None` for a refusal, which is kept if the compiler would refuse it.
    pub(crate) fn asked<T>(&self, result: Result<T, Refusal>) -> Option<T> {
        match self.ran(result) {
            Ok(value) => Some(value),
            Err(fault) => {
                if fault.kind == FaultKind::Refused {
                    let _ = self.refused.set(fault);
                }
                None
            }
        }
    }

    /// Makes a vector of the program's own type, if it has one, or else of ours.
    pub(crate) fn vec3(&self, vector: Vec3) -> Value {
        let parts = vector.to_array().map(Value::from);
        match self.code.names.own_vec3 {
            Some(kind) => self.own(kind, ["x", "y", "z"].into_iter().zip(parts)),
            None => vector.into(),
        }
    }

    /// Makes a ray of the program's own type, if it has one, or else of ours.
    pub(crate) fn ray(&self, ray: &Ray) -> Value {
        let parts = [ray.origin, ray.direction].map(|it| self.vec3(it));
        match self.code.names.own_ray {
            Some(kind) => self.own(kind, ["origin", "direction"].into_iter().zip(parts)),
            None => Data::Ray(Rc::new(*ray)).into(),
        }
    }

    /// Makes one of the program's structs from values with field names. A value whose name no field
    /// has goes to the field at its position; a field without a value is left empty.
    pub(crate) fn own<'n>(
        &self,
        kind: u32,
        parts: impl Iterator<Item = (&'n str, Value)>,
    ) -> Value {
        let known = &self.code.names.structs[kind as usize];
        let mut fields = vec![Value::default(); known.fields.len()];
        for (n, (name, value)) in parts.enumerate() {
            let place = known.field(name).unwrap_or(n);
            if let Some(field) = fields.get_mut(place) {
                *field = value;
            }
        }
        Data::Own(kind, fields.into()).into()
    }

    /// Returns a vector, or a struct of the program's with three numbers, as a vector; `None` for a
    /// struct with fewer.
    pub(crate) fn vec3_of(&self, value: &Value) -> Option<Vec3> {
        let Data::Own(kind, fields) = &value.data else {
            return Some(value.vec3());
        };
        let known = &self.code.names.structs[*kind as usize];
        let parts = ["x", "y", "z"].into_iter().enumerate().map(|(n, name)| {
            let place = known.field(name).unwrap_or(n);
            match fields.get(place)?.data {
                Data::Float(it) => Some(it),
                Data::Single(it) => Some(it.into()),
                _ => None,
            }
        });
        let parts = parts.collect::<Option<Vec<f64>>>()?;
        Some(Vec3::from_slice(&parts))
    }
}

/// Makes a value of type `u32`.
pub(crate) fn u32_value(number: u32) -> Value {
    Value::whole(number.into(), Int::U32)
}
