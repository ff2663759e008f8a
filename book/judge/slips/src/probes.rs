//! Probes: changes of a chapter that make visible what the book's picture hides.

use crate::asked::Ball;
use crate::chapter::{Chapter, SphereCount};
use crate::edit::Edit;
use crate::program::ChapterProgram;
use crate::slip::Languages;

/// A small change of a chapter, of its width, spheres or focal length, that a reader makes to test
/// a program: mistakes that the book's picture hides become visible in the changed one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// The name of the probe on the command line: `off-axis`.
    pub name: &'static str,
    /// The width, in pixels, at which the changed picture has to be drawn.
    pub width: u32,
    /// The spheres that replace those of the chapter; `None` to keep the chapter's own.
    pub spheres: Option<&'static [Ball]>,
    /// The distance from the camera's center to the viewport: 1 as in the chapters, or more to make
    /// far spheres large in the picture.
    pub focal_length: f64,
    /// A sentence that tells the reader what the changed picture tests.
    pub shows: &'static str,
}

/// A probe that changes nothing but the width.
const PROBE: Probe = Probe {
    name: "",
    width: 128,
    spheres: None,
    focal_length: 1.0,
    shows: "",
};

/// All probes, which show what a chapter's own picture hides: first those for which a reader changes
/// least. The pictures of probes with spheres of their own are exactly 16:9, so that the rounding of
/// the height plays no part.
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

/// Finds a probe by its [`name`](Probe::name); `None` if no probe has it.
pub fn find(name: &str) -> Option<Probe> {
    PROBES.into_iter().find(|probe| probe.name == name)
}

impl Probe {
    /// Returns true if the program of a chapter can draw all spheres of the probe; always if the
    /// probe keeps the chapter's own.
    pub fn fits(&self, chapter: Chapter) -> bool {
        let count = self.spheres.map_or(0, <[Ball]>::len);
        match chapter.sphere_count() {
            SphereCount::None => count == 0,
            SphereCount::One => count <= 1,
            SphereCount::Many => true,
        }
    }

    /// Returns a program with the spheres and the focal length of the probe; it has to be run for a
    /// picture [`width`](Self::width) pixels wide.
    ///
    /// Returns `None` if the program's chapter draws fewer spheres than the probe has.
    pub fn applied_to(&self, program: &ChapterProgram) -> Option<ChapterProgram> {
        let chapter = program.chapter;
        let edits = self.fits(chapter).then(|| self.edits(chapter))?;
        program.with_any(&edits)
    }

    /// Returns the edits of the judge's text of a chapter that make the change.
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

    /// Returns the instructions for a reader to make the change, in plain text, one per line: the
    /// width, the focal length unless it is 1, and the spheres if they change.
    pub fn instructions(&self, chapter: Chapter, languages: Languages) -> String {
        let mut lines = vec![width_line(self.width, languages)];
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

/// Writes a ball's center and radius in Rust.
fn of_ball(ball: &Ball) -> [String; 2] {
    let [x, y, z] = ball.center.to_array();
    [
        format!("Point3::new({x:?}, {y:?}, {z:?})"),
        format!("{:?}", ball.radius),
    ]
}

/// Returns the code, on one line, that draws a picture `width` pixels wide: `picture(227)` in Rust
/// alone, where the package of a chapter has such a function, else `image_width = 227`.
pub fn width_line(width: u32, languages: Languages) -> String {
    match languages {
        Languages::Rust => format!("picture({width})"),
        Languages::Both => format!("image_width = {width}"),
    }
}
