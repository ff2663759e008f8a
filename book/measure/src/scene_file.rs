//! TOML by a derived reader: a scene as a person writes it, and where it is wrong.
//!
//! ```toml
//! width = 400             # pixels; the picture is 16:9
//! sun = [1, 0.25, 0.5]    # towards the sun, of any length; without a sun no shadows
//! t_min = 0.001           # no hit counts before; if left out: 0, and 0.001 for shadows
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
use serde::de::Error;
use serde::{Deserialize, Deserializer};
use speed_vs_accuracy::{Lens, Scene, USUAL_T_MIN, unit};

/// The greatest width of a scene's picture, in pixels: drawn by every method, pictures of this
/// width take half a gigabyte together.
pub const WIDEST: u32 = 3840;

/// The scenes of chapter 6, from the book's own to the hardest, parsed from its files when first
/// used. The names of scenes are those of the files.
pub static SCENES: LazyLock<[Scene; 7]> = LazyLock::new(|| {
    macro_rules! scene {
        ($name:literal) => {{
            const TEXT: &str = include_str!(concat!(
                "../../../chapters/6_speed_vs_accuracy/scenes/",
                $name,
                ".toml"
            ));
            parse($name, TEXT).unwrap_or_else(|error| panic!("{}.toml: {error}", $name))
        }};
    }
    [
        scene!("book"),
        scene!("telescope"),
        scene!("ground"),
        scene!("grazing"),
        scene!("shadows"),
        scene!("inside"),
        scene!("neighbors"),
    ]
});

/// Finds the scene of chapter 6 that has exactly this name, such as `telescope`; `None` if none
/// has.
pub fn find_scene(name: &str) -> Option<&'static Scene> {
    SCENES.iter().find(|scene| scene.name == name)
}

/// Parses the TOML in `text` as a scene, and gives it this name. Only spheres are required; without
/// other keys, the picture is 400 pixels wide, the camera is the book's, and no sun shines. All
/// numbers of a scene are finite.
///
/// # Errors
/// Returns the first mistake, with line and column: text that is no TOML, a key that is unknown or
/// missing, or a number that is out of range.
pub fn parse(name: &str, text: &str) -> Result<Scene, toml::de::Error> {
    let SceneTable {
        width,
        sun,
        t_min,
        camera,
        sphere,
    } = toml::from_str(text)?;
    Ok(Scene {
        name: name.to_owned(),
        width,
        sun: sun.map(unit),
        t_min: t_min.map_or(USUAL_T_MIN, |t_min| [t_min; 2]),
        lens: Lens::new(camera.origin, camera.direction, camera.zoom),
        spheres: sphere.iter().map(|it| (it.center, it.radius)).collect(),
    })
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SceneTable {
    #[serde(default = "usual_width", deserialize_with = "width")]
    width: u32,
    #[serde(default, deserialize_with = "sun")]
    sun: Option<Vec3>,
    #[serde(default, deserialize_with = "t_min")]
    t_min: Option<f64>,
    #[serde(default)]
    camera: CameraTable,
    #[serde(deserialize_with = "spheres")]
    sphere: Vec<SphereTable>,
}

#[derive(Deserialize)]
#[serde(default, deny_unknown_fields, expecting = "a table [camera]")]
struct CameraTable {
    #[serde(deserialize_with = "vector")]
    origin: Point3,
    #[serde(deserialize_with = "direction")]
    direction: Vec3,
    /// The magnification across and upwards, where 1 is the book's view.
    #[serde(deserialize_with = "zoom")]
    zoom: [f64; 2],
}

impl Default for CameraTable {
    fn default() -> Self {
        Self {
            origin: Point3::ZERO,
            direction: Vec3::NEG_Z,
            zoom: [1.0; 2],
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SphereTable {
    #[serde(deserialize_with = "vector")]
    center: Point3,
    #[serde(deserialize_with = "radius")]
    radius: f64,
}

#[derive(Deserialize)]
#[serde(
    untagged,
    expecting = "a zoom is one number, or two of them: [across, up]"
)]
enum OneOrTwo {
    One(f64),
    Two([f64; 2]),
}

/// Returns the value if `is_possible`, or else an error with the text `otherwise`.
fn checked<T, E: Error>(value: T, is_possible: bool, otherwise: &str) -> Result<T, E> {
    if is_possible {
        Ok(value)
    } else {
        Err(E::custom(otherwise))
    }
}

fn usual_width() -> u32 {
    400
}

fn width<'de, D: Deserializer<'de>>(from: D) -> Result<u32, D::Error> {
    let width = u32::deserialize(from)?;
    let otherwise = format!("no picture is so wide: write 1 to {WIDEST} pixels");
    checked(width, (1..=WIDEST).contains(&width), &otherwise)
}

fn sun<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Vec3>, D::Error> {
    direction(from).map(Some)
}

fn t_min<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    let t_min = f64::deserialize(from)?;
    let otherwise = "t_min is a finite number, and not below 0";
    checked(Some(t_min), t_min.is_finite() && t_min >= 0.0, otherwise)
}

fn vector<'de, D: Deserializer<'de>>(from: D) -> Result<Vec3, D::Error> {
    let vector = Vec3::from(<[f64; 3]>::deserialize(from)?);
    let otherwise = "all three numbers must be finite";
    checked(vector, vector.is_finite(), otherwise)
}

fn direction<'de, D: Deserializer<'de>>(from: D) -> Result<Vec3, D::Error> {
    let direction = vector(from)?;
    let otherwise = "a direction of length 0 points nowhere";
    checked(direction, direction != Vec3::ZERO, otherwise)
}

fn zoom<'de, D: Deserializer<'de>>(from: D) -> Result<[f64; 2], D::Error> {
    let zoom = match OneOrTwo::deserialize(from)? {
        OneOrTwo::One(zoom) => [zoom; 2],
        OneOrTwo::Two(zoom) => zoom,
    };
    // The directions of all rays are finite then.
    let is_possible = zoom.iter().all(|zoom| (1e-300..=1e300).contains(zoom));
    let otherwise =
        "no lens zooms like that: 1 is the book's view, and 1e-300 to 1e300 are possible";
    checked(zoom, is_possible, otherwise)
}

fn spheres<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<SphereTable>, D::Error> {
    let balls = Vec::<SphereTable>::deserialize(from)?;
    let is_possible = !balls.is_empty();
    checked(balls, is_possible, "a scene has a sphere at least")
}

/// Reads a radius: a finite number above 0.
fn radius<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    let radius = f64::deserialize(from)?;
    let otherwise = "a radius is a finite number above 0: no picture shows a point";
    checked(radius, radius.is_finite() && radius > 0.0, otherwise)
}
