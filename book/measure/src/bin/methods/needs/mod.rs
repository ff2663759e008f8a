//! `needs`: the cheapest method that a scene of the reader's own needs.
//!
//! The scene is drawn by every method, and the cheapest one that draws every pixel right
//! is named, in each precision, by the times that the book has recorded.

mod text;

use std::error::Error;
use std::path::Path;
use std::sync::atomic::AtomicU64;
use std::sync::atomic::Ordering::Relaxed;
use std::time::Instant;

use launcher::command_line::Words;
use launcher::misuse::misuse;
use launcher::{limited, names};
use measure::needs::{Place, PrecisionNeeds};
use measure::scene_file::{self, WIDEST};
use measure::wrong_pixels;
use speed_vs_accuracy::{METHODS, Precision, Scene};

/// The greatest relative error of t that counts as right, where distances matter.
const WITHIN: f64 = 0.001;

/// Draws the scene of a file by every method of chapter 6, and returns a text that names the cheapest
/// one that draws every pixel right, in each precision.
pub(crate) fn needs(words: &Words) -> Result<String, Box<dyn Error>> {
    let width = |typed: &str| {
        let width = typed.parse().ok().filter(|it| (1..=WIDEST).contains(it));
        width.ok_or_else(|| format!("choose a whole number of pixels from 1 to {WIDEST}"))
    };
    let width = words.option("--width", width)?;
    let missing = || words.command.misuse("SCENE is missing");
    let file = words.values.first().ok_or_else(missing)?;
    let mut scene = read(Path::new(file))?;
    scene.width = width.unwrap_or(scene.width);
    let place = Place::of(&scene);
    let (found, with_acne) = look_into(&scene, &place);
    Ok(text::answer(&scene, &place, &found, with_acne))
}

/// Tries all methods in each precision that can hold the numbers of the scene, `f64` first. Also
/// returns the number of pixels of the right picture with shadow acne.
fn look_into(scene: &Scene, place: &Place) -> (Vec<PrecisionNeeds>, usize) {
    let mut precisions = Precision::ALL.to_vec();
    precisions.retain(|precision| scene.fits(*precision));
    let mut methods = METHODS.to_vec();
    methods.retain(|method| precisions.contains(&method.precision()));
    let drawn = wrong_pixels::draw(scene, &methods, scene.width, &progress());
    let (double, single) = drawn
        .by_method
        .into_iter()
        .partition(|view| view.method.precision() == Precision::Double);
    let found = precisions.into_iter().zip([double, single]);
    let found = found.map(|(precision, views)| {
        PrecisionNeeds::new(scene, precision, place.situation, views, WITHIN)
    });
    (found.collect(), drawn.with_acne)
}

/// Makes a function that prints every two seconds how much of the picture is drawn.
fn progress() -> impl Fn(usize, usize) + Sync {
    const SECONDS: u64 = 2;
    let (start, next) = (Instant::now(), AtomicU64::new(SECONDS));
    move |done, rows| {
        let (now, due) = (start.elapsed().as_secs(), next.load(Relaxed));
        let says = |due| {
            next.compare_exchange(due, now + SECONDS, Relaxed, Relaxed)
                .is_ok()
        };
        if now >= due && says(due) {
            let part = 100 * done / rows;
            eprintln!("{part} % of the picture is drawn; a smaller --width takes less time");
        }
    }
}

/// Reads the scene in the file at `path`, and names it after the file.
fn read(path: &Path) -> Result<Scene, Box<dyn Error>> {
    let shown = names::escaped_name(path);
    let text = limited::read_text(path).map_err(|cause| {
        misuse(&format!(
            "cannot read {shown}: {cause}\nA scene is a TOML file; --help shows an example."
        ))
    })?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    scene_file::parse(&name, &text).map_err(|mistake| misuse(&format!("{shown}: {mistake}")))
}
