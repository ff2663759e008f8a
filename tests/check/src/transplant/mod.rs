//! Transplantation of a reader's expressions: what the chapter draws with one of them in the
//! place of its own.
//!
//! A reader's line is named only if the chapter with it draws the reader's picture: each is
//! a slip without a name, in the reader's own words.

mod run;
mod syntax;

use std::borrow::Cow;
use std::sync::{Arc, Mutex, PoisonError};

use common::rtweekend::*;
use slips::{Ball, Chapter, Hit, Interpreted, Program, Slip, Words};

use crate::sources::{Sources, Variant};
use run::{Machine, Value};

/// The chapter itself, run from its source.
pub fn unchanged(chapter: Chapter) -> Program {
    let program = Program::right(chapter);
    let sources = [functions(chapter), prelude(chapter)].concat();
    let all: Option<Vec<Read>> = sources.into_iter().map(read).collect();
    let machine = Machine::new(chapter, all.expect("the chapter can be read").iter());
    Program {
        code: Some(Box::leak(Box::new(machine))),
        ..program
    }
}

/// A function in a source.
#[derive(Clone)]
struct Source {
    /// Its name, a method's with its type.
    name: &'static str,
    text: Cow<'static, str>,
    file: &'static str,
    part: Part,
}

/// What a function belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    /// The chapter, which is always run from its text.
    Chapter,
    /// The prelude: a function that is run from its text where that is changed.
    Prelude,
    /// The same of the camera, where hardly anybody takes one name for another.
    Camera,
}

macro_rules! source {
    ($part:ident: $name:literal, $start:literal, $file:literal) => {
        Source {
            name: $name,
            text: from(include_str!(concat!("../../../../", $file)), $start).into(),
            file: $file,
            part: Part::$part,
        }
    };
}

/// The functions of a chapter that a picture depends on.
fn functions(chapter: Chapter) -> Vec<Source> {
    macro_rules! with_ray_color {
        ($file:literal) => {
            vec![
                source!(Chapter: "ray_color", "fn ray_color", $file),
                source!(Chapter: "hit_sphere", "fn hit_sphere", $file),
            ]
        };
    }
    match chapter {
        Chapter::Gradient => {
            vec![source!(Chapter: "ray_color", "fn ray_color", "chapters/1_gradient/src/lib.rs")]
        }
        Chapter::RedSphere => with_ray_color!("chapters/2_red_sphere/src/lib.rs"),
        Chapter::Normals => with_ray_color!("chapters/3_normals/src/lib.rs"),
        Chapter::HalfBSphere => with_ray_color!("chapters/4_half_b_sphere/src/lib.rs"),
        Chapter::HittableList => vec![
            source!(Chapter: "ray_color", "fn ray_color", "chapters/5_hittable_list/src/lib.rs"),
            source!(Chapter: "Sphere::hit", "fn hit", "chapters/5_hittable_list/src/sphere.rs"),
            source!(
                Chapter: "set_face_normal",
                "fn set_face",
                "chapters/5_hittable_list/src/hittable.rs"
            ),
            source!(
                Chapter: "HittableList::hit",
                "fn hit",
                "chapters/5_hittable_list/src/hittable_list.rs"
            ),
        ],
        Chapter::BuildTest | Chapter::SpeedVsAccuracy => Vec::new(),
    }
}

/// What the chapter takes from those before it and from the prelude.
fn prelude(chapter: Chapter) -> Vec<Source> {
    // The first chapter writes the sky out.
    let sky = source!(Prelude: "sky", "fn ray_color", "chapters/1_gradient/src/lib.rs");
    let at = source!(Prelude: "at", "fn at", "common/src/ray.rs");
    let camera = [
        source!(Camera: "with_size", "fn with_size", "common/src/camera.rs"),
        source!(Camera: "ray", "fn ray", "common/src/camera.rs"),
    ];
    let sky = Some(sky).filter(|_| chapter > Chapter::Gradient);
    let at = Some(at).filter(|_| chapter > Chapter::RedSphere);
    sky.into_iter().chain(at).chain(camera).collect()
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

/// A function that was read.
type Read = (Source, Arc<syntax::Function>);

fn read(source: Source) -> Option<Read> {
    let function = syntax::function(&source.text)?;
    Some((source, Arc::new(function)))
}

impl Machine {
    fn new<'a>(chapter: Chapter, functions: impl Iterator<Item = &'a Read> + Clone) -> Self {
        let named = |(source, function): &Read| (source.name, Arc::clone(function));
        Self {
            functions: functions.map(named).collect(),
            world: Program::right(chapter).world,
        }
    }

    /// The chapter with a changed text of one of the functions, if that is another program.
    fn with(chapter: Chapter, all: &[Read], changed: &Source, text: &str) -> Option<Self> {
        let is_run = |(it, _): &&Read| it.part == Part::Chapter || it.name == changed.name;
        let mut machine = Self::new(chapter, all.iter().filter(is_run));
        let mut functions = machine.functions.iter_mut();
        let (_, function) = functions.find(|(own, _)| *own == changed.name)?;
        *function = Arc::new(syntax::function(text)?);
        let is_same =
            changed.name == "with_size" && machine.camera(16, 9) == Some(Camera::with_size(16, 9));
        (!is_same && machine.can_be_run()).then_some(machine)
    }

    /// Whether all that is run from its text gives what it should, and no other values.
    fn can_be_run(&self) -> bool {
        let camera = Camera::with_size(4, 2);
        let is_color = |ray: &Ray| matches!(self.color(ray), Some(Value::Vector(_)));
        (!self.has("with_size") || self.camera(4, 2).is_some())
            && (!self.has("ray") || self.ray(&camera, 1, 1).is_some())
            && [(0.0, 0.0), (0.3, 0.2), (1.7, 0.9), (-0.4, -0.6)]
                .into_iter()
                .all(|(x, y)| is_color(&Ray::new(Point3::ZERO, Vec3::new(x, y, -1.0))))
    }

    fn color(&self, ray: &Ray) -> Option<Value> {
        let given = [Value::Ray(*ray), Value::World];
        // Chapter 5 hands the world on.
        let arguments = 1 + usize::from(self.has("HittableList::hit"));
        self.call("ray_color", &given[..arguments])
    }
}

impl Interpreted for Machine {
    fn camera(&self, width: u32, height: u32) -> Option<Camera> {
        let given = [width, height].map(|it| Value::Number(it.into()));
        match self.call("with_size", &given)? {
            // The size is that of the steps.
            Value::Camera(camera) => Some(Camera {
                image_width: width,
                image_height: height,
                ..camera
            }),
            _ => None,
        }
    }

    fn ray(&self, camera: &Camera, i: u32, j: u32) -> Option<Ray> {
        let [i, j] = [i, j].map(|it| Value::Number(it.into()));
        match self.call("ray", &[Value::Camera(*camera), i, j])? {
            Value::Ray(ray) => Some(ray),
            _ => None,
        }
    }

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

/// The chapter and what it takes from the prelude.
fn sources(chapter: Chapter) -> Vec<Read> {
    let sources = [functions(chapter), prelude(chapter)].concat();
    sources.into_iter().filter_map(read).collect()
}

/// The chapter with the way to the center turned round, as older editions have it.
fn older(mut all: Vec<Read>) -> Vec<Read> {
    all.retain_mut(|(source, function)| {
        if source.part != Part::Chapter {
            return true;
        }
        let text = source
            .text
            .replace("self.center - ray.origin", "ray.origin - self.center")
            .replace("center - ray.origin", "ray.origin - center")
            .replace("-2.0 * ray", "2.0 * ray")
            .replace("(h ", "(-h ");
        let read = syntax::function(&text);
        source.text = text.into();
        read.map(|read| *function = Arc::new(read)).is_some()
    });
    all
}

/// The chapter with single expressions as the reader has them, in the edition to which the
/// reader keeps.
pub fn typed(chapter: Chapter, yours: &Sources) -> Vec<&'static Slip> {
    static SEEN: Mutex<Vec<(Chapter, String, Option<&'static Slip>)>> = Mutex::new(Vec::new());
    let mut seen = SEEN.lock().unwrap_or_else(PoisonError::into_inner);
    let editions = [older(sources(chapter)), sources(chapter)].map(|all| {
        let texts: Vec<&str> = all.iter().map(|(source, _)| &*source.text).collect();
        let (missing, variants) = yours.variants(&texts);
        (missing, variants, all)
    });
    let [older, newest] = editions;
    let (_, variants, all) = if older.0 < newest.0 { older } else { newest };
    let variants = variants.into_iter().filter_map(|(n, variant)| {
        let (source, _) = &all[n];
        let mut text = source.text.to_string();
        text.replace_range(variant.at.clone(), &variant.with);
        let mut known = seen.iter();
        let known = known.find(|(of, other, _)| *of == chapter && *other == text);
        if let Some((.., slip)) = known {
            return *slip;
        }
        let slip = made_in(chapter, &all, source, &text, variant);
        seen.push((chapter, text, slip));
        slip
    });
    variants.collect()
}

/// The chapter with that text of one of its functions as a slip, if it is another program.
fn made_in(
    chapter: Chapter,
    all: &[Read],
    source: &Source,
    text: &str,
    variant: Variant,
) -> Option<&'static Slip> {
    let machine = Machine::with(chapter, all, source, text)?;
    let machine: &'static Machine = Box::leak(Box::new(machine));
    let leaked = |text: String| -> &'static str { Box::leak(text.into_boxed_str()) };
    let words = Words {
        wrong: leaked(variant.wrong),
        right: leaked(variant.right),
        why: "",
    };
    let slip = Slip::interpreted(chapter, source.file, words, machine);
    Some(Box::leak(Box::new(slip)))
}
