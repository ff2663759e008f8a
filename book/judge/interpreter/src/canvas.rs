//! Lazy evaluation: a picture whose pixels are traced when they are asked for.

use std::fmt;
use std::rc::Rc;

use common::rtweekend::*;

use crate::library;
use crate::machine::value::{Brush, Data, Value};
use crate::machine::{Binding, Machine};
use crate::program::{NO_PICTURE, Program, stopped, u32_value};
use crate::refusal::Fault;
use crate::types::Int;

/// A picture that a [`Program`] draws, whose pixels are computed one by one when they are asked
/// for.
#[derive(Clone)]
pub struct Canvas {
    program: Program,
    size: (u32, u32),
    brush: Rc<Brush>,
}

impl fmt::Debug for Canvas {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Canvas")
            .field("size", &self.size)
            .finish_non_exhaustive()
    }
}

/// A step in the computation of a pixel's color: a value that a `let` names, or that a `return`
/// statement returns.
#[derive(Clone, Debug)]
pub struct TracedValue {
    /// The function in which the value arises: `ray_color`, or `Sphere::hit` for a method.
    pub function: String,
    /// The name that a `let` gives the value; `None` for the value of a `return`.
    pub name: Option<String>,
    /// The value as text in one line: numbers as [`format_number`] formats them, a vector as
    /// `(x, y, z)`, a truth as `true` or `false`, an option as its value or `none`.
    pub value: String,
}

impl Program {
    /// Calls the program's `picture` for a picture `width` pixels wide. No pixel is computed yet,
    /// unless `picture` prints the whole picture as text.
    ///
    /// A program without `picture` is drawn by its `ray_color` and the book's camera, which makes
    /// the picture 16:9.
    ///
    /// # Errors
    /// If the program stops, as by a panic; if the compiler would refuse a line that runs; or if
    /// there is neither function, or `picture` returns no picture.
    pub fn canvas(&self, width: u32) -> Result<Canvas, Fault> {
        let Some(picture) = self.role("picture", 1) else {
            return self.by_ray_color(width);
        };
        let given = [u32_value(width)];
        let drawn = self.ran(self.machine().call(picture, &given))?;
        let (size, brush) = match drawn.data {
            Data::Picture(it) => (it.0, Rc::clone(&it.1)),
            Data::Str(text) => {
                let printed = library::printed(&text).ok_or_else(|| stopped(NO_PICTURE))?;
                let size = (printed.width(), printed.height());
                (size, Rc::new(Brush::Printed(printed)))
            }
            _ => return Err(stopped(NO_PICTURE)),
        };
        Ok(Canvas {
            program: self.clone(),
            size,
            brush,
        })
    }

    /// Returns the picture that `ray_color` draws with the book's camera, `width` pixels wide.
    pub(crate) fn by_ray_color(&self, width: u32) -> Result<Canvas, Fault> {
        let color = self
            .ray_color_role()
            .ok_or_else(|| stopped("there is no function `ray_color`"))?;
        let world = self.role("world", 0);
        let world = world.map(|it| self.ran(self.machine().call(it, &[])));
        let camera = Camera::new(width);
        Ok(Canvas {
            program: self.clone(),
            size: (camera.image_width, camera.image_height),
            brush: Rc::new(Brush::Role(camera, color, world.transpose()?)),
        })
    }
}

impl Canvas {
    /// Returns the width and the height of the picture, in this order, in pixels.
    pub fn size(&self) -> (u32, u32) {
        self.size
    }

    /// Computes the color, linear from 0 to 1, of the pixel in column `i` and row `j`, from 0 at
    /// the top left. A picture that the program printed as text gives colors whose levels are the
    /// printed ones. Pixels outside of the picture have colors, too, unless it was printed.
    ///
    /// # Errors
    /// If the program stops on the way, or the compiler would refuse a line that runs.
    ///
    /// # Panics
    /// If the picture was printed as text, and `j * width + i` is the number of none of its pixels,
    /// which are counted row by row from 0.
    pub fn color(&self, i: u32, j: u32) -> Result<Color, Fault> {
        self.colored_by(&mut self.program.machine(), i, j)
    }

    /// Computes a pixel's color on a given machine, which may keep a trace.
    fn colored_by(&self, machine: &mut Machine<'_>, i: u32, j: u32) -> Result<Color, Fault> {
        let program = &self.program;
        let colored = match &*self.brush {
            Brush::Pixel(color, at) => {
                let pixel = [i, j].map(|it| Value::whole(it.into(), Int::U32));
                machine.colored(color, &mut { pixel }, *at)
            }
            Brush::Ray(camera, color, at) => {
                let ray = Value::from(Data::Ray(Rc::new(camera.ray(i, j)))).lent();
                machine.colored(color, &mut [ray], *at)
            }
            Brush::Role(camera, color, world) => {
                let ray = [program.ray(&camera.ray(i, j))].into_iter();
                let given: Vec<Value> = ray.chain(world.clone()).collect();
                let colored = program.ran(machine.call(*color, &given))?;
                return Ok(program.vec3_of(&colored).unwrap_or(Color::NAN));
            }
            Brush::Printed(picture) => {
                let at = 3 * (j * self.size.0 + i) as usize;
                let levels = <[u8; 3]>::try_from(&picture.rgb()[at..at + 3]);
                let levels = levels.expect("three levels").map(f64::from);
                return Ok(Color::from_array(levels.map(|it| (it + 0.5) / 255.999)));
            }
        };
        program.ran(colored)
    }

    /// Computes the levels of red, green and blue, 0 to 255, of the pixel in column `i` and row
    /// `j`, from 0 at the top left.
    ///
    /// # Errors
    /// If the program stops on the way, or the compiler would refuse a line that runs.
    ///
    /// # Panics
    /// If the picture was printed as text, and `j * width + i` is the number of none of its pixels.
    pub fn levels(&self, i: u32, j: u32) -> Result<[u8; 3], Fault> {
        let mut levels = [0; 3];
        write_color(&mut levels, self.color(i, j)?);
        Ok(levels)
    }

    /// Traces the pixel in column `i` and row `j`, counted from 0 at the top left: lists the value
    /// of each `let` and of each `return` on the way to its color, in the order in which they run.
    ///
    /// Leaves out values that are no number, vector or truth, nor an option of one. Ends early
    /// where the program stops; a picture that is printed as text has no such values.
    pub fn trace(&self, i: u32, j: u32) -> Vec<TracedValue> {
        let functions = &self.program.code.functions;
        let traced = self.bindings(i, j).filter_map(|binding| {
            let function = &functions[binding.function];
            let name = match binding.slot {
                Some(slot) => Some(function.names.get(slot)?.clone()),
                None => None,
            };
            Some(TracedValue {
                function: function.written.as_ref()?.name.clone(),
                name,
                value: said(&binding.value)?,
            })
        });
        traced.collect()
    }

    /// Returns true if a `return` statement of the function with the name `name` runs on the way to
    /// the color of the pixel in column `i` and row `j`, from 0 at the top left. In `ray_color`,
    /// that is a hit. Returns false if there is no such function.
    pub fn returns_early(&self, name: &str, i: u32, j: u32) -> bool {
        let function = self.program.code.number_of(name);
        let mut bindings = self.bindings(i, j);
        bindings.any(|it| it.slot.is_none() && Some(it.function) == function)
    }

    /// Computes a pixel's color, and returns the values that were bound on the way.
    fn bindings(&self, i: u32, j: u32) -> impl Iterator<Item = Binding> {
        let mut machine = self.program.machine();
        machine.trace = Some(Vec::new());
        let _ = self.colored_by(&mut machine, i, j);
        machine.trace.take().into_iter().flatten()
    }
}

/// Formats a number with up to six decimals and no zeros at the end, such as `0.5`, or in
/// scientific notation with four significant digits if its size is below 0.001 and not 0. NaN is
/// `NaN`.
pub fn format_number(it: f64) -> String {
    match it.abs() {
        small if small != 0.0 && small < 1e-3 => format!("{it:.3e}"),
        _ => format!("{}", (it * 1e6).round() / 1e6),
    }
}

/// Formats a number, a truth, a vector, or an option of these; `None` for any other value.
fn said(value: &Value) -> Option<String> {
    Some(match &value.data {
        Data::Float(it) => format_number(*it),
        Data::Int(it, _) => it.get().to_string(),
        Data::Bool(it) => it.to_string(),
        Data::Vec3(it) => {
            let [x, y, z] = it.to_array().map(format_number);
            format!("({x}, {y}, {z})")
        }
        Data::Some(it) => return said(it),
        Data::None => "none".to_owned(),
        _ => return None,
    })
}
