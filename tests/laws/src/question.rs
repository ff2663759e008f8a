//! Questions: what each kind of function is asked, what a chapter's program answers, and
//! what is a simpler question of the same kind.

use std::fmt::Debug;
use std::sync::LazyLock;

use common::rtweekend::*;
use slips::{Ball, Chapter, Program};
use speed_vs_accuracy::Case;

use crate::answers::Answer;
use crate::camera::{Pixel, Width};
use crate::intervals::WithInterval;
use crate::list::{World, worlds};
use crate::nearer_root::Decided;
use crate::numbers;
use crate::record::{Hit, Recorded};
use crate::sampling::endless;
use crate::strategies;

/// What a function under test is asked.
pub trait Question: Clone + Debug + Send + Sync + 'static {
    /// What it answers.
    type Answer: Answer;

    /// What questions of this kind are called in a file of answers.
    const KIND: &'static str;

    /// What the function is called in a test that asks this.
    const FUNCTION: &'static str;

    /// The chapters that have such a function: mistakes in these are looked for.
    const CHAPTERS: &'static [Chapter];

    /// What the program of such a chapter answers.
    fn answer_of(&self, program: &Program) -> Self::Answer;

    /// Whether two answers are the same, but for roundings.
    fn same(&self, one: &Self::Answer, other: &Self::Answer) -> bool;

    /// Questions to which different mistakes give different answers.
    fn telling() -> Vec<Self>;

    /// The body of a test that asks `function` about this value again.
    fn as_test(&self, function: &str) -> String;

    /// Questions like this one, each with one thing simpler, the simplest first.
    fn simpler(&self) -> Vec<Self> {
        Vec::new()
    }

    /// Whether both ask the same function, so that one mistake may explain both answers.
    fn is_akin(&self, _other: &Self) -> bool {
        true
    }

    /// Whether mistakes fit the question by chance, as for a sphere of radius 0.
    fn is_degenerate(&self) -> bool {
        false
    }

    /// Whether the program's chapter has such a function.
    fn is_of(program: &Program) -> bool {
        Self::CHAPTERS.contains(&program.chapter)
    }

    /// The program that answers rightly.
    fn right_program() -> Program {
        let [.., latest] = Self::CHAPTERS else {
            unreachable!("each kind of function is in a chapter");
        };
        Program::right(*latest)
    }

    /// The right answer, but for roundings.
    fn right(&self) -> Self::Answer {
        self.answer_of(&Self::right_program())
    }
}

/// Replaces a question by simpler ones as long as they still show what this one does.
pub(crate) fn simplified<Q: Question>(mut question: Q, shows: impl Fn(&Q) -> bool) -> Q {
    // A question has a few dozen numbers of at most 17 digits: most take 20 rounds.
    const ROUNDS: usize = 200;
    for _ in 0..ROUNDS {
        match question.simpler().into_iter().find(&shows) {
            Some(simpler) => question = simpler,
            None => break,
        }
    }
    question
}

/// Every chapter that casts rays has vectors, rays and a camera.
pub(crate) const RAYS: &[Chapter] = Chapter::OF_THE_BOOK.split_at(1).1;
pub(crate) const LIST: &[Chapter] = &[Chapter::HittableList];

/// Rays and spheres near and far, from inside and behind, with directions of any
/// length. Rounding decides none of them, except that some are exact tangents.
static TELLING: LazyLock<Vec<Case>> = LazyLock::new(|| {
    endless(strategies::book_rays(), "")
        .take(60)
        .chain(endless(strategies::integers(), "").take(80))
        .chain(endless(strategies::far(0.5..=2.0), "").take(60))
        .chain(endless(strategies::grazing(0.3..=1.5), "").take(40))
        .chain(endless(strategies::inside(), "").take(40))
        .chain(endless(strategies::tangents(), "").take(20))
        .filter(|case| !case.is_degenerate())
        .collect()
});

impl Question for Decided {
    type Answer = bool;

    const KIND: &'static str = "decision";

    const FUNCTION: &'static str = "hit_sphere";

    const CHAPTERS: &'static [Chapter] = &[Chapter::RedSphere];

    fn answer_of(&self, program: &Program) -> bool {
        self.0.answer_of(program).is_some()
    }

    fn same(&self, one: &bool, other: &bool) -> bool {
        one == other
    }

    fn telling() -> Vec<Self> {
        TELLING.iter().copied().map(Self).collect()
    }

    fn as_test(&self, hit_sphere: &str) -> String {
        let case = self.0;
        format!(
            "{case}\nlaws::runner::one_decision(&{hit_sphere}, &laws::Case {{ center, radius, ray }});"
        )
    }

    fn simpler(&self) -> Vec<Self> {
        self.0.simpler().into_iter().map(Self).collect()
    }

    fn is_degenerate(&self) -> bool {
        self.0.is_degenerate()
    }
}

impl Question for Case {
    type Answer = Option<f64>;

    const KIND: &'static str = "nearer_root";

    const FUNCTION: &'static str = "hit_sphere";

    const CHAPTERS: &'static [Chapter] = &[Chapter::Normals, Chapter::HalfBSphere];

    fn answer_of(&self, program: &Program) -> Option<f64> {
        program.hit_sphere(self.center, self.radius, &self.ray)
    }

    /// Two ways to compute one number differ by roundings: of the number itself, and
    /// of what cancels on the way to a small one, which is √(M/a) large. Both are a
    /// thousand times as much as rounding takes in the cases that are telling.
    fn same(&self, one: &Option<f64>, other: &Option<f64>) -> bool {
        match (one, other) {
            (None, None) => true,
            (Some(one), Some(other)) if one.is_nan() || other.is_nan() => {
                one.is_nan() && other.is_nan()
            }
            (Some(one), Some(other)) => {
                let size = one.abs() + other.abs();
                one == other || (one - other).abs() <= 1e-10 * size + 1e-12 * self.t_scale()
            }
            _ => false,
        }
    }

    fn telling() -> Vec<Self> {
        TELLING.clone()
    }

    fn as_test(&self, hit_sphere: &str) -> String {
        format!(
            "{self}\nlaws::runner::one_case(&{hit_sphere}, &laws::Case {{ center, radius, ray }});"
        )
    }

    fn simpler(&self) -> Vec<Self> {
        let numbers = self.numbers();
        let with = |at: usize, simpler: f64| {
            let mut changed = numbers;
            changed[at] = simpler;
            Self::from_numbers(changed)
        };
        let at_each = numbers.iter().enumerate();
        at_each
            .flat_map(|(at, &number)| {
                let simpler = numbers::simpler(number).into_iter();
                simpler.map(move |simpler| with(at, simpler))
            })
            .collect()
    }

    fn is_degenerate(&self) -> bool {
        let [direction, oc] = [self.ray.direction, self.center - self.ray.origin];
        self.radius <= 0.0 || direction == Vec3::ZERO || oc == Vec3::ZERO
    }
}

impl Question for WithInterval {
    type Answer = Option<f64>;

    const KIND: &'static str = "nearest_in_range";

    const FUNCTION: &'static str = "hit";

    const CHAPTERS: &'static [Chapter] = LIST;

    fn answer_of(&self, program: &Program) -> Option<f64> {
        self.solve(&|center, radius, ray, t_min, t_max| {
            program.hit(Ball { center, radius }, ray, t_min, t_max)
        })
    }

    fn same(&self, one: &Option<f64>, other: &Option<f64>) -> bool {
        self.case.same(one, other)
    }

    /// Every third case with the whole line, with what is in front, with a range that holds
    /// only the farther root, and with one that ends before it.
    fn telling() -> Vec<Self> {
        let with_ranges = |case: Case| {
            let range = |t_min, t_max| Self { case, t_min, t_max };
            let behind = |t_min| range(t_min, f64::INFINITY).right();
            let near = behind(f64::NEG_INFINITY);
            let far = near.and_then(behind).or(near);
            let (near, far) = near.zip(far).unwrap_or((1.0, 2.0));
            [
                range(f64::NEG_INFINITY, f64::INFINITY),
                range(0.0, f64::INFINITY),
                range(0.5 * (near + far), f64::INFINITY),
                range(0.0, 0.25 * near + 0.75 * far),
                range(near, 2.0 * far - near),
                range(f64::NEG_INFINITY, near - 0.5 * (far - near)),
            ]
        };
        TELLING
            .iter()
            .step_by(3)
            .copied()
            .flat_map(with_ranges)
            .collect()
    }

    fn as_test(&self, hit: &str) -> String {
        format!(
            "{self}\nlaws::runner::one_interval(&{hit}, laws::Case {{ center, radius, ray }}, t_min, t_max);"
        )
    }

    fn simpler(&self) -> Vec<Self> {
        let low = numbers::simpler(self.t_min).into_iter();
        let high = numbers::simpler(self.t_max).into_iter();
        let cases = self.case.simpler().into_iter();
        low.map(|t_min| Self { t_min, ..*self })
            .chain(high.map(|t_max| Self { t_max, ..*self }))
            .chain(cases.map(|case| Self { case, ..*self }))
            .collect()
    }

    fn is_degenerate(&self) -> bool {
        self.case.is_degenerate()
    }
}

impl Question for Recorded {
    type Answer = Vec<Hit>;

    const KIND: &'static str = "record";

    const FUNCTION: &'static str = "record";

    const CHAPTERS: &'static [Chapter] = LIST;

    fn answer_of(&self, program: &Program) -> Vec<Hit> {
        self.hits(&|center, radius, ray, t_min, t_max| {
            program.record(Ball { center, radius }, ray, t_min, t_max)
        })
    }

    fn same(&self, one: &Vec<Hit>, other: &Vec<Hit>) -> bool {
        let near = |(one, other): (&Hit, &Hit)| {
            let is_near = |one: Vec3, other: Vec3, size: f64| {
                (one - other).length() <= 1e-6 * (one.length() + other.length() + size)
            };
            one.front_face == other.front_face
                && is_near(one.normal, other.normal, 0.0)
                && is_near(one.point, other.point, self.0.m().sqrt())
        };
        one.len() == other.len() && one.iter().zip(other).all(near)
    }

    /// A tangent has no side, so it is left out.
    fn telling() -> Vec<Self> {
        let cases = TELLING.iter().copied().map(Self);
        cases.filter(|asked| asked.right().len() == 2).collect()
    }

    fn as_test(&self, record: &str) -> String {
        format!(
            "{}\nlaws::runner::one_record(&{record}, &laws::Case {{ center, radius, ray }});",
            self.0
        )
    }

    fn simpler(&self) -> Vec<Self> {
        self.0.simpler().into_iter().map(Self).collect()
    }

    fn is_degenerate(&self) -> bool {
        self.0.is_degenerate()
    }
}

impl Question for World {
    type Answer = Option<f64>;

    const KIND: &'static str = "list";

    const FUNCTION: &'static str = "nearest";

    const CHAPTERS: &'static [Chapter] = LIST;

    fn answer_of(&self, program: &Program) -> Option<f64> {
        let ball = |&(center, radius): &(Point3, f64)| Ball { center, radius };
        let balls: Vec<Ball> = self.spheres.iter().map(ball).collect();
        program.search_among(&balls, &self.ray, self.t_min, self.t_max)
    }

    fn same(&self, one: &Option<f64>, other: &Option<f64>) -> bool {
        match (one, other) {
            (Some(one), Some(other)) => (one - other).abs() <= 1e-6 * (one.abs() + other.abs()),
            _ => one == other,
        }
    }

    fn telling() -> Vec<Self> {
        endless(&worlds(), "").take(100).collect()
    }

    fn as_test(&self, nearest: &str) -> String {
        let sphere = |&(center, radius): &_| format!("({}, {radius:?})", code_of(center));
        let spheres: Vec<String> = self.spheres.iter().map(sphere).collect();
        let [origin, direction] = [self.ray.origin, self.ray.direction].map(code_of);
        let [t_min, t_max] = [self.t_min, self.t_max].map(numbers::code);
        format!(
            "let spheres = vec![\n    {},\n];\nlet ray = Ray::new({origin}, {direction});\n\
             let world = laws::list::World {{ spheres, ray, t_min: {t_min}, t_max: {t_max} }};\n\
             assert_eq!({nearest}(&world), {:?});",
            spheres.join(",\n    "),
            self.right()
        )
    }

    /// With fewer spheres, down to one: a world without any says nothing. Or with
    /// a simpler one.
    fn simpler(&self) -> Vec<Self> {
        let places = 0..self.spheres.len();
        let fewer = places.clone().filter(|_| self.spheres.len() > 1).map(|at| {
            let mut fewer = self.clone();
            fewer.spheres.remove(at);
            fewer
        });
        let rounder = places.flat_map(|at| {
            let (center, radius) = self.spheres[at];
            let ray = self.ray;
            let case = Case {
                center,
                radius,
                ray,
            };
            case.simpler().into_iter().map(move |case| {
                let mut rounder = self.clone();
                rounder.spheres[at] = (case.center, case.radius);
                rounder.ray = case.ray;
                rounder
            })
        });
        fewer.chain(rounder).collect()
    }

    fn is_degenerate(&self) -> bool {
        let is_point = |&(_, radius): &(_, f64)| radius <= 0.0;
        self.ray.direction == Vec3::ZERO || self.spheres.iter().any(is_point)
    }
}

impl Question for Width {
    type Answer = u32;

    const KIND: &'static str = "height";

    const FUNCTION: &'static str = "height";

    const CHAPTERS: &'static [Chapter] = RAYS;

    fn answer_of(&self, program: &Program) -> u32 {
        program.camera(self.0).image_height
    }

    fn same(&self, one: &u32, other: &u32) -> bool {
        one == other
    }

    fn telling() -> Vec<Self> {
        (1..=400).map(Self).collect()
    }

    fn as_test(&self, height: &str) -> String {
        format!("assert_eq!({height}({}), {});", self.0, self.right())
    }
}

impl Question for Pixel {
    type Answer = Ray;

    const KIND: &'static str = "pixel_ray";

    const FUNCTION: &'static str = "pixel_ray";

    const CHAPTERS: &'static [Chapter] = RAYS;

    /// The size is one that a picture of that width has.
    fn answer_of(&self, program: &Program) -> Ray {
        let ([width, _], [i, j]) = (self.size, self.place);
        (program.ray)(program, &program.camera(width), i, j)
    }

    fn same(&self, one: &Ray, other: &Ray) -> bool {
        one.origin == other.origin && near(one.direction, other.direction)
    }

    /// The pixels that tell most, in pictures of the widths of the book and its probes.
    fn telling() -> Vec<Self> {
        let in_picture = |size: [u32; 2]| {
            let [width, height] = size;
            [
                [3 * width / 5, height / 3],
                [0, 0],
                [width - 1, 0],
                [0, height - 1],
            ]
            .map(|place| Self { size, place })
        };
        [[100, 56], [227, 127], [400, 225], [16, 9]]
            .into_iter()
            .flat_map(in_picture)
            .collect()
    }

    fn as_test(&self, pixel_ray: &str) -> String {
        let Self { size, place } = self;
        let right = code_of(self.right().direction);
        format!(
            "let ray = {pixel_ray}({size:?}, {place:?});\n\
             assert!((ray.at(1.0) - {right}).length() < 1e-9);"
        )
    }
}

fn near(one: Vec3, other: Vec3) -> bool {
    (one - other).length() <= 1e-9 * (one.length() + other.length())
}

pub(crate) fn code_of(v: Vec3) -> String {
    format!("Vec3::new({:?}, {:?}, {:?})", v.x, v.y, v.z)
}
