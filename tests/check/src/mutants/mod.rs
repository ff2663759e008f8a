//! Mutation of source code: what each program draws that is our chapter with one word,
//! number or sign changed.
//!
//! The catalogue knows the mistakes that people have made. These are those that nobody
//! has thought of: each is a slip without a name, said in the line of the chapter.

mod edits;
mod run;
mod syntax;

use std::sync::{Arc, LazyLock};

use common::rtweekend::*;
use slips::{Ball, Chapter, Hit, Interpreted, Program, Slip, Words};

use run::{Machine, Value};

/// The mutants of a chapter.
pub(crate) fn of(chapter: Chapter) -> &'static [Slip] {
    static GRADIENT: LazyLock<Vec<Slip>> = LazyLock::new(|| all(Chapter::Gradient));
    static RED_SPHERE: LazyLock<Vec<Slip>> = LazyLock::new(|| all(Chapter::RedSphere));
    static NORMALS: LazyLock<Vec<Slip>> = LazyLock::new(|| all(Chapter::Normals));
    static HALF_B: LazyLock<Vec<Slip>> = LazyLock::new(|| all(Chapter::HalfBSphere));
    static LIST: LazyLock<Vec<Slip>> = LazyLock::new(|| all(Chapter::HittableList));
    match chapter {
        Chapter::Gradient => &GRADIENT,
        Chapter::RedSphere => &RED_SPHERE,
        Chapter::Normals => &NORMALS,
        Chapter::HalfBSphere => &HALF_B,
        Chapter::HittableList => &LIST,
        Chapter::BuildTest | Chapter::SpeedVsAccuracy => &[],
    }
}

/// The chapter itself, run from its source.
pub fn unchanged(chapter: Chapter) -> Program {
    let program = Program::right(chapter);
    let sources = functions(chapter);
    let machine = Machine::new(chapter, &sources).expect("the chapter can be run");
    Program {
        code: Some(Box::leak(Box::new(machine))),
        ..program
    }
}

/// A function in the source of a chapter.
#[derive(Clone, Copy)]
struct Source {
    /// Its name, a method's with its type.
    name: &'static str,
    text: &'static str,
    file: &'static str,
}

/// The functions of a chapter that a picture depends on.
fn functions(chapter: Chapter) -> Vec<Source> {
    macro_rules! source {
        ($name:literal, $start:literal, $file:literal) => {
            Source {
                name: $name,
                text: from(
                    include_str!(concat!("../../../../chapters/", $file)),
                    $start,
                ),
                file: concat!("chapters/", $file),
            }
        };
    }
    macro_rules! with_ray_color {
        ($file:literal) => {
            vec![
                source!("ray_color", "fn ray_color", $file),
                source!("hit_sphere", "fn hit_sphere", $file),
            ]
        };
    }
    match chapter {
        Chapter::Gradient => vec![source!(
            "ray_color",
            "fn ray_color",
            "1_gradient/src/lib.rs"
        )],
        Chapter::RedSphere => with_ray_color!("2_red_sphere/src/lib.rs"),
        Chapter::Normals => with_ray_color!("3_normals/src/lib.rs"),
        Chapter::HalfBSphere => with_ray_color!("4_half_b_sphere/src/lib.rs"),
        Chapter::HittableList => vec![
            source!("ray_color", "fn ray_color", "5_hittable_list/src/lib.rs"),
            source!("Sphere::hit", "fn hit", "5_hittable_list/src/sphere.rs"),
            source!(
                "set_face_normal",
                "fn set_face",
                "5_hittable_list/src/hittable.rs"
            ),
            source!(
                "HittableList::hit",
                "fn hit",
                "5_hittable_list/src/hittable_list.rs"
            ),
        ],
        Chapter::BuildTest | Chapter::SpeedVsAccuracy => Vec::new(),
    }
}

/// The function that begins so, up to the brace that closes it.
fn from(source: &'static str, start: &str) -> &'static str {
    let start = source.find(start).expect("the chapter has the function");
    let mut depth = 0;
    let end = source[start..].char_indices().find(|(_, letter)| {
        depth += i32::from(*letter == '{') - i32::from(*letter == '}');
        depth == 0 && *letter == '}'
    });
    let (end, _) = end.expect("a function ends");
    &source[start..=start + end]
}

impl Machine {
    fn new(chapter: Chapter, sources: &[Source]) -> Option<Self> {
        let function = |it: &Source| Some((it.name, Arc::new(syntax::function(it.text)?)));
        Some(Self {
            functions: sources.iter().map(function).collect::<Option<_>>()?,
            world: Program::right(chapter).world,
        })
    }

    /// The same with another text of a function, if that is a program.
    fn with(&self, name: &str, text: &str) -> Option<Self> {
        let mut machine = self.clone();
        let mut functions = machine.functions.iter_mut();
        let (_, function) = functions.find(|(own, _)| *own == name)?;
        *function = Arc::new(syntax::function(text)?);
        machine.can_be_run().then_some(machine)
    }

    /// Whether a few rays get colors, and no other values.
    fn can_be_run(&self) -> bool {
        let is_color = |ray: &Ray| matches!(self.color(ray), Some(Value::Vector(_)));
        [(0.0, 0.0), (0.3, 0.2), (1.7, 0.9), (-0.4, -0.6)]
            .into_iter()
            .all(|(x, y)| is_color(&Ray::new(Point3::ZERO, Vec3::new(x, y, -1.0))))
    }

    fn color(&self, ray: &Ray) -> Option<Value> {
        self.call(
            "ray_color",
            &[Value::Ray(*ray), Value::World][..self.arguments()],
        )
    }

    /// Chapter 5 hands the world on.
    fn arguments(&self) -> usize {
        1 + usize::from(self.functions.len() > 2)
    }
}

impl Interpreted for Machine {
    fn ray_color(&self, ray: &Ray) -> Color {
        match self.color(ray) {
            Some(Value::Vector(color)) => color,
            _ => Color::NAN,
        }
    }

    fn hit_sphere(&self, center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
        let given = [
            Value::Vector(center),
            Value::Number(radius),
            Value::Ray(*ray),
        ];
        match self.call("hit_sphere", &given)? {
            Value::Bool(is_hit) => is_hit.then_some(0.0),
            Value::Number(t) => Some(t),
            _ => None,
        }
    }

    fn record(&self, ball: Ball, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        let given = [
            Value::Ball(ball),
            Value::Ray(*ray),
            Value::Number(t_min),
            Value::Number(t_max),
        ];
        match self.call("Sphere::hit", &given)? {
            Value::Record(hit) => Some(hit),
            _ => None,
        }
    }

    fn nearest(&self, balls: &[Ball], ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
        let given = [
            Value::World,
            Value::Ray(*ray),
            Value::Number(t_min),
            Value::Number(t_max),
        ];
        match self.call_in(balls, "HittableList::hit", &given)? {
            Value::Record(hit) => Some(hit.t),
            _ => None,
        }
    }
}

/// Each mutant of the chapter that can be run, as a slip.
fn all(chapter: Chapter) -> Vec<Slip> {
    let sources = functions(chapter);
    let Some(right) = Machine::new(chapter, &sources) else {
        return Vec::new();
    };
    let mutants = sources.iter().flat_map(|source| {
        let right = &right;
        edits::of(source.text).into_iter().filter_map(move |edit| {
            let machine: &'static Machine =
                Box::leak(Box::new(right.with(source.name, &edit.text)?));
            let leaked = |text: String| -> &'static str { Box::leak(text.into_boxed_str()) };
            let words = Words {
                wrong: leaked(edit.wrong),
                right: leaked(edit.right),
                why: "",
            };
            Some(Slip::interpreted(chapter, source.file, words, machine))
        })
    });
    mutants.collect()
}
