//! Model selection: the cheapest method that draws every pixel right, and why the next
//! cheaper one does not do. Costs are those that the book has recorded, on the rays of the
//! situation that is the most like the scene: so the answer is the same on every machine.

mod culprit;

use std::sync::LazyLock;

use common::rtweekend::*;
use figures::{Map, Spot};
use speed_vs_accuracy::{Case, Method, Precision, Scene};

use crate::wrong_pixels::MethodView;

pub use culprit::Culprit;

/// The map and the times of the book, as they were when this was compiled.
pub static RECORDED: LazyLock<Map> = LazyLock::new(|| {
    let cells = include_str!("../../../notes/measured/map.snap.csv");
    let timings = include_str!("../../../notes/measured/timings.csv");
    Map::read(cells, timings).expect("a test has read these files")
});

/// Where a scene stands on the map of the book, and which of its situations it is like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The name of the situation: `shadows` if the scene has a sun, or else that of most rays.
    pub situation: &'static str,
    /// The spot, of those of the camera's rays, that needs the dearest method: of several the
    /// nearest to the rim or the surface.
    pub hardest: Spot,
}

impl Place {
    /// Finds the place of a scene, by some thousand rays of its camera, each with one sphere.
    ///
    /// # Panics
    /// If the scene has no sphere.
    pub fn of(scene: &Scene) -> Self {
        let spots: Vec<Spot> = questions(scene).map(|case| Spot::of(&case)).collect();
        let like = |name: &str| spots.iter().filter(|it| it.situation() == name).count();
        let names = spots.iter().map(|spot| spot.situation());
        let most = names.max_by_key(|name| like(name)).unwrap_or("book");
        let cost = |spot: &Spot| {
            let least = RECORDED.least(*spot, Precision::Double, 3);
            least.map_or(f64::INFINITY, |method| ratio(&method, "telescope"))
        };
        let order = |one: &&Spot, other: &&Spot| {
            let cost = cost(one).total_cmp(&cost(other));
            cost.then(one.row().cmp(&other.row()))
        };
        let hardest = spots.iter().max_by(order);
        Self {
            situation: scene.sun.map_or(most, |_| "shadows"),
            hardest: *hardest.expect("a scene has a sphere, and a picture a pixel"),
        }
    }
}

/// Chooses rays of the camera and spheres, spread over the picture.
fn questions(scene: &Scene) -> impl Iterator<Item = Case> {
    const CASES: usize = 4096;
    let camera = Camera::new(scene.width);
    let (width, spheres) = (scene.width as usize, scene.spheres.len());
    let all = width * camera.image_height as usize * spheres;
    (0..CASES.min(all)).map(move |k| {
        let n = k * all / CASES.min(all);
        let (i, j) = (n / spheres % width, n / spheres / width);
        let (center, radius) = scene.spheres[n % spheres];
        Case::new(center, radius, scene.ray(&camera.ray(i as u32, j as u32)))
    })
}

/// Returns the recorded time of a method on the rays of a situation, divided by that of `half_b`.
fn ratio(method: &Method, situation: &str) -> f64 {
    let time = RECORDED.timings.find("method", method.name, situation);
    time.map_or(f64::INFINITY, |time| time.ratio)
}

/// The methods of one precision, with the cheapest of them that draws a scene right. All indices
/// count in `rows`, from 0.
pub struct PrecisionNeeds {
    /// The precision, `f32` or `f64`.
    pub precision: Precision,
    /// All methods of the precision, the cheapest first.
    pub rows: Vec<RatedMethod>,
    /// The index of the method to take for colors: the quickest that draws every pixel right, as
    /// [`quickest`](figures::table::Table::quickest) chooses. `None` if none draws every pixel
    /// right.
    pub least: Option<usize>,
    /// The index of the method to take for distances: the quickest that sees the right sphere in
    /// every pixel, with its t within the tolerance. `None` if there is no such method.
    pub least_of_t: Option<usize>,
    /// The index of a method that draws wrong pixels, with one of them to show: the next cheaper
    /// one than `least`; or the one with the fewest wrong pixels if `least` is `None`. `None` if no
    /// such method fails.
    pub failing: Option<(usize, Culprit)>,
}

/// A method, with its picture of a scene and its recorded time, by which methods are chosen.
pub struct RatedMethod {
    /// The method's picture of the scene, compared with the right one.
    pub view: MethodView,
    /// The method's time divided by that of the reference method, on the rays of the situation.
    pub ratio: f64,
}

impl PrecisionNeeds {
    /// Finds what `scene` needs in one precision, on rays like those of `situation`. `views` are
    /// the pictures of the precision's methods. `tolerance` is the greatest relative error of t
    /// that counts as right.
    pub fn new(
        scene: &Scene,
        precision: Precision,
        situation: &str,
        views: Vec<MethodView>,
        tolerance: f64,
    ) -> Self {
        let rate = |view: MethodView| RatedMethod {
            ratio: ratio(&view.method, situation),
            view,
        };
        let mut rows: Vec<RatedMethod> = views.into_iter().map(rate).collect();
        rows.sort_by(|one, other| one.ratio.total_cmp(&other.ratio));
        let quickest = |suffices: &dyn Fn(&MethodView) -> bool| {
            let is_it = |row: &RatedMethod, name: &str| row.view.method.name == name;
            let suffices = |method: &Method| {
                rows.iter()
                    .any(|row| is_it(row, method.name) && suffices(&row.view))
            };
            let found = RECORDED.timings.quickest(precision, situation, suffices)?;
            rows.iter().position(|row| is_it(row, found.name))
        };
        let least = quickest(&|view| view.wrong == 0);
        let least_of_t =
            quickest(&|view| view.misjudged == 0 && view.off.is_none_or(|off| off.t <= tolerance));
        let failing = match least {
            Some(least) => (0..least).rev().find(|&n| rows[n].view.wrong > 0),
            None => (0..rows.len()).min_by_key(|&n| rows[n].view.wrong),
        };
        let culprit = |n: usize| Some((n, Culprit::of(scene, &rows[n].view)?));
        Self {
            failing: failing.and_then(culprit),
            precision,
            least,
            least_of_t,
            rows,
        }
    }
}

/// Returns the cheaper `least` of all precisions, with the needs that it belongs to; where they
/// cost the same but for a twentieth, that of `f32`, whose numbers take half the memory. It has to
/// come last. Returns `None` if no method draws every pixel right.
pub fn least_of_all(found: &[PrecisionNeeds]) -> Option<(&PrecisionNeeds, &RatedMethod)> {
    let leasts = found
        .iter()
        .filter_map(|it| Some((it, &it.rows[it.least?])));
    leasts.reduce(|one, other| {
        if 1.05 * one.1.ratio < other.1.ratio {
            one
        } else {
            other
        }
    })
}
