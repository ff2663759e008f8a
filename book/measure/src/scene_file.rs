//! TOML by a derived reader: a scene as a person writes it, and where it is wrong.
//!
//! ```toml
//! width = 400             # pixels; the picture is 16:9
//! sun = [1, 0.25, 0.5]    # towards it, of any length; without it nothing has a shadow
//!
//! [camera]                # all of it may be left out
//! origin = [0, 0, 0]
//! direction = [0, 0, -1]  # of any length
//! zoom = 1                # or [across, up]
//!
//! [[sphere]]              # as often as there are spheres
//! center = [0, 0, -1]
//! radius = 0.5
//! ```

use std::sync::LazyLock;

use common::rtweekend::*;
use serde::Deserialize;
use speed_vs_accuracy::{Lens, Scene, unit};

/// The widest picture that is drawn by every method, in pixels. All of these pictures
/// together take half a gigabyte then.
pub const WIDEST: u32 = 3840;

/// The most spheres. Each method is asked about each of them in each pixel: ten
/// thousand take minutes in the smallest picture.
const MOST_SPHERES: usize = 10_000;

/// The scenes of chapter 6, from the book's own to the hardest.
pub static SCENES: LazyLock<[Scene; 7]> = LazyLock::new(|| {
    macro_rules! scene {
        ($name:literal) => {{
            let file = concat!(
                "../../../chapters/6_speed_vs_accuracy/scenes/",
                $name,
                ".toml"
            );
            (
                file,
                $name,
                include_str!(concat!(
                    "../../../chapters/6_speed_vs_accuracy/scenes/",
                    $name,
                    ".toml"
                )),
            )
        }};
    }
    [
        scene!("book"),
        scene!("telescope"),
        scene!("planet"),
        scene!("grazing"),
        scene!("inside"),
        scene!("shadows"),
        scene!("neighbors"),
    ]
    .map(|(file, name, text)| read(name, text).unwrap_or_else(|error| panic!("{file}: {error}")))
});

/// The scene of chapter 6 of that name.
pub fn find_scene(name: &str) -> Option<&'static Scene> {
    SCENES.iter().find(|scene| scene.name == name)
}

/// The scene in `text`, the content of a file.
///
/// # Errors
/// The first mistake, with line and column: what is no TOML, a key that is not known or
/// is missing, or a number that is out of range. All numbers of a scene are finite.
pub fn read(name: &str, text: &str) -> Result<Scene, toml::de::Error> {
    let File {
        width: Width(width),
        sun,
        camera,
        sphere: Spheres(spheres),
    } = toml::from_str(text)?;
    let Camera {
        origin: Vector(origin),
        direction: Direction(direction),
        zoom: Zooms(zoom),
    } = camera;
    Ok(Scene {
        name: name.to_owned(),
        width,
        sun: sun.map(|Direction(sun)| unit(sun)),
        lens: Lens::new(origin, direction, zoom),
        spheres,
    })
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    width: Width,
    sun: Option<Direction>,
    #[serde(default)]
    camera: Camera,
    sphere: Spheres,
}

#[derive(Deserialize)]
#[serde(try_from = "u32")]
struct Width(u32);

#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields, expecting = "a table [camera]")]
struct Camera {
    origin: Vector,
    direction: Direction,
    zoom: Zooms,
}

#[derive(Default, Deserialize)]
#[serde(try_from = "[f64; 3]")]
struct Vector(Vec3);

#[derive(Deserialize)]
#[serde(try_from = "[f64; 3]")]
struct Direction(Vec3);

/// How large things look, across and upwards.
#[derive(Deserialize)]
#[serde(try_from = "OneOrTwo")]
struct Zooms([f64; 2]);

#[derive(Deserialize)]
#[serde(
    untagged,
    expecting = "a zoom is one number, or two of them: [across, up]"
)]
enum OneOrTwo {
    One(f64),
    Two([f64; 2]),
}

/// At least one.
#[derive(Deserialize)]
#[serde(try_from = "Vec<Ball>")]
struct Spheres(Vec<(Point3, f64)>);

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Ball {
    center: Vector,
    radius: Radius,
}

#[derive(Deserialize)]
#[serde(try_from = "f64")]
struct Radius(f64);

impl Default for Width {
    fn default() -> Self {
        Self(400)
    }
}

impl Default for Direction {
    fn default() -> Self {
        Self(Vec3::NEG_Z)
    }
}

impl Default for Zooms {
    fn default() -> Self {
        Self([1.0; 2])
    }
}

impl TryFrom<u32> for Width {
    type Error = String;

    fn try_from(width: u32) -> Result<Self, String> {
        let possible = (1..=WIDEST).contains(&width);
        possible
            .then_some(Self(width))
            .ok_or_else(|| format!("no picture is so wide: write 1 to {WIDEST} pixels"))
    }
}

impl TryFrom<[f64; 3]> for Vector {
    type Error = &'static str;

    fn try_from(numbers: [f64; 3]) -> Result<Self, Self::Error> {
        let finite = numbers.iter().all(|number| number.is_finite());
        finite
            .then_some(Self(numbers.into()))
            .ok_or("all three numbers must be finite")
    }
}

impl TryFrom<[f64; 3]> for Direction {
    type Error = &'static str;

    fn try_from(numbers: [f64; 3]) -> Result<Self, Self::Error> {
        match Vector::try_from(numbers)? {
            Vector(Vec3::ZERO) => Err("a direction of length 0 points nowhere"),
            Vector(direction) => Ok(Self(direction)),
        }
    }
}

impl TryFrom<OneOrTwo> for Zooms {
    type Error = &'static str;

    fn try_from(zoom: OneOrTwo) -> Result<Self, Self::Error> {
        let zooms = match zoom {
            OneOrTwo::One(zoom) => [zoom; 2],
            OneOrTwo::Two(zooms) => zooms,
        };
        // The directions of all rays are finite then.
        let possible = zooms.iter().all(|zoom| (1e-300..=1e300).contains(zoom));
        possible.then_some(Self(zooms)).ok_or(
            "no lens zooms like that: 1 is the book's view, and 1e-300 to 1e300 are possible",
        )
    }
}

impl TryFrom<Vec<Ball>> for Spheres {
    type Error = String;

    fn try_from(balls: Vec<Ball>) -> Result<Self, String> {
        if !(1..=MOST_SPHERES).contains(&balls.len()) {
            return Err(format!(
                "there are {} spheres: write 1 to {MOST_SPHERES}",
                balls.len()
            ));
        }
        let sphere = |ball: Ball| (ball.center.0, ball.radius.0);
        Ok(Self(balls.into_iter().map(sphere).collect()))
    }
}

/// Below 0 too: the same sphere, with the normal inwards.
impl TryFrom<f64> for Radius {
    type Error = &'static str;

    fn try_from(radius: f64) -> Result<Self, Self::Error> {
        let possible = radius.is_finite() && radius != 0.0;
        possible
            .then_some(Self(radius))
            .ok_or("a radius is a finite number, and not 0: no picture shows a point")
    }
}
