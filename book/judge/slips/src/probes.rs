//! Probes: small scenes that show what the book's picture can't.

use interpreter::Ball;

use super::program::ChapterProgram;
use crate::chapter::{Chapter, SphereCount};
use crate::edit::Edit;
use crate::reader_language::ReaderLanguage;

/// A change to a chapter of which every right program makes the same picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// Its name on the command line.
    pub name: &'static str,
    /// The width of its picture, in pixels.
    pub width: u32,
    /// The spheres to put in place of the chapter's, or `None` to keep those.
    pub spheres: Option<&'static [Ball]>,
    /// How far the viewport is from the eye: 1 as in the chapters, or more to
    /// see something far away as large as if it were near.
    pub focal_length: f64,
    /// What it brings to light.
    pub shows: &'static str,
}

const PROBE: Probe = Probe {
    name: "",
    width: 128,
    spheres: None,
    focal_length: 1.0,
    shows: "",
};

/// All probes, the cheapest change first.
///
/// Those that bring spheres of their own are of exactly 16:9, so that nothing
/// but the spheres speaks.
pub const PROBES: [Probe; 8] = [
    Probe {
        name: "odd-width",
        width: 227,
        shows: "227 / (16/9) is 127.7: which way the height is rounded, and whether the viewport follows it.",
        ..PROBE
    },
    Probe {
        name: "one-pixel",
        width: 1,
        shows: "A picture one pixel wide has no row unless the height is kept at 1 or more.",
        ..PROBE
    },
    Probe {
        name: "reversed",
        spheres: Some(&[
            Ball::new(0.0, -100.5, -1.0, 100.0),
            Ball::new(0.0, 0.0, -1.0, 0.5),
        ]),
        shows: "The book's spheres, the ground first: whether the nearest hit wins, or the first or last one.",
        ..PROBE
    },
    Probe {
        name: "overlapping",
        spheres: Some(&[
            Ball::new(0.4, 0.1, -1.4, 0.5),
            Ball::new(0.0, 0.0, -1.0, 0.5),
            Ball::new(-0.3, 0.2, -1.8, 0.6),
        ]),
        shows: "The nearest of three spheres is neither first nor last in the list.",
        ..PROBE
    },
    Probe {
        name: "inside",
        spheres: Some(&[Ball::new(0.0, 0.0, -1.0, 2.0)]),
        shows: "The eye is inside the sphere: the nearer root lies behind, and the normal has to turn.",
        ..PROBE
    },
    Probe {
        name: "behind",
        spheres: Some(&[Ball::new(0.3, 0.2, 1.0, 0.5)]),
        shows: "The sphere is behind the eye: both roots are negative, and from chapter 3 on nothing is drawn.",
        ..PROBE
    },
    Probe {
        name: "off-axis",
        spheres: Some(&[Ball::new(2.0, 1.0, -4.0, 0.5)]),
        shows: "A small sphere off the axis, four units away: nothing is 1, equal or symmetric by chance.",
        ..PROBE
    },
    Probe {
        name: "far",
        spheres: Some(&[Ball::new(0.4, 0.2, -800.0, 0.5)]),
        focal_length: 1000.0,
        shows: "A small sphere 800 units away, through a telescope: single precision loses it.",
        ..PROBE
    },
];

/// The probe of that name.
pub fn find(name: &str) -> Option<Probe> {
    PROBES.into_iter().find(|probe| probe.name == name)
}

impl Probe {
    /// Returns true if the chapter has [room](Chapter::room) for its spheres.
    pub fn fits(&self, chapter: Chapter) -> bool {
        let count = self.spheres.map_or(0, <[Ball]>::len);
        match chapter.sphere_count() {
            SphereCount::None => count == 0,
            SphereCount::One => count <= 1,
            SphereCount::Many => true,
        }
    }

    /// The program with this probe's spheres and focal length; its picture is to be
    /// [`width`](Self::width) pixels wide. `None` if the chapter has no room for them.
    pub fn applied_to(&self, program: &ChapterProgram) -> Option<ChapterProgram> {
        let chapter = program.chapter;
        let edits = self.fits(chapter).then(|| self.edits(chapter))?;
        program.with_any(&edits)
    }

    /// Returns what a reader changes in the chapter's text.
    fn edits(&self, chapter: Chapter) -> Vec<Edit> {
        let mut edits = Vec::new();
        if self.focal_length != 1.0 {
            let focal_length = format!("focal_length = {:?}", self.focal_length);
            edits.push(Edit::new("focal_length = 1.0", focal_length));
        }
        let Some(spheres) = self.spheres else {
            return edits;
        };
        let spheres: Vec<[String; 2]> = spheres.iter().map(of_ball).collect();
        let [center, radius] = &spheres[0];
        match chapter {
            Chapter::RedSphere => {
                let call = format!("hit_sphere({center}, {radius}, ray)");
                edits.push(Edit::new(
                    "hit_sphere(Point3::new(0.0, 0.0, -1.0), 0.5, ray)",
                    call,
                ));
            }
            Chapter::HittableList => {
                let add = |[center, radius]: &[String; 2]| {
                    format!("world.add(Sphere::new({center}, {radius}));")
                };
                edits.push(Edit::new(
                    "world.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5)); \
                     world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0));",
                    spheres.iter().map(add).collect::<String>(),
                ));
            }
            _ => edits.extend([
                Edit::new(
                    "center = Point3::new(0.0, 0.0, -1.0)",
                    format!("center = {center}"),
                ),
                Edit::new(
                    "hit_sphere(center, 0.5, ray)",
                    format!("hit_sphere(center, {radius}, ray)"),
                ),
            ]),
        }
        edits
    }

    /// Returns what a reader changes, a line each: the width, the focal length if it is another,
    /// and the spheres, which replace the chapter's.
    pub fn lines(&self, chapter: Chapter, language: Option<ReaderLanguage>) -> String {
        let mut lines = vec![width_line(self.width, language)];
        if self.focal_length != 1.0 {
            lines.push(format!("focal_length = {}", self.focal_length));
        }
        let spheres = self.spheres.into_iter().flatten().enumerate();
        lines.extend(spheres.map(|(n, Ball { center, radius })| {
            let [x, y, z] = center.to_array();
            match chapter.sphere_count() {
                SphereCount::Many if n == 0 => {
                    format!("in place of all spheres, world.add(sphere(({x}, {y}, {z}), {radius}))")
                }
                SphereCount::Many => format!("world.add(sphere(({x}, {y}, {z}), {radius}))"),
                _ => format!("the sphere gets center = ({x}, {y}, {z}), radius = {radius}"),
            }
        }));
        lines.join("\n")
    }
}

/// A ball's center and radius, as our Rust has them.
fn of_ball(ball: &Ball) -> [String; 2] {
    let [x, y, z] = ball.center.to_array();
    [
        format!("Point3::new({x:?}, {y:?}, {z:?})"),
        format!("{:?}", ball.radius),
    ]
}

/// How a reader asks for a picture of that width: a crate of ours has a function for it.
pub fn width_line(width: u32, language: Option<ReaderLanguage>) -> String {
    match language {
        Some(ReaderLanguage::Rust) => format!("picture({width})"),
        _ => format!("image_width = {width}"),
    }
}
