//! Model selection: the cheapest method that draws every pixel right, and why the next
//! cheaper one does not do.

mod culprit;

use crate::contest::spread_of_ratios;
use crate::cost::MethodTimes;
use crate::spread::Spread;
use crate::wrong_pixels::MethodView;
use speed_vs_accuracy::{METHODS, Precision, Scene};

pub use culprit::Culprit;

/// The least method that a scene needs in one precision.
pub struct PrecisionNeeds {
    /// The precision.
    pub precision: Precision,
    /// The methods, the cheapest first.
    pub rows: Vec<RatedMethod>,
    /// The place of the least that draws every pixel right, if one does.
    pub least: Option<usize>,
    /// The place of the least that sees the right sphere in every pixel, and its t to
    /// within the tolerance, if one does.
    pub least_of_t: Option<usize>,
    /// The places of those that suffice too, and cost the same as far as can be told.
    pub ties: Vec<usize>,
    /// The place of the next cheaper one that fails, or of one that costs the same;
    /// where none suffices, of the one that comes nearest.
    pub failing: Option<(usize, Culprit)>,
}

/// A method: what it draws, and what it takes.
pub struct RatedMethod {
    /// The picture that it draws, judged.
    pub view: MethodView,
    /// Nanoseconds for a question in the quickest round, which others disturbed least.
    pub ns: f64,
    /// The time divided by that of the reference in the same round: the median. By this
    /// the rows are in order, because it does not change with the pace of the processor.
    pub ratio: f64,
    /// Nanoseconds in each round.
    times: Vec<f64>,
}

impl PrecisionNeeds {
    /// Judges what the methods of one precision draw, beside the times of all methods, the
    /// reference first. `tolerance` is the part of t that may be wrong.
    pub fn new(
        scene: &Scene,
        precision: Precision,
        views: Vec<MethodView>,
        times: &[MethodTimes],
        tolerance: f64,
    ) -> Self {
        let views = views.into_iter();
        let mut rows: Vec<RatedMethod> = views.map(|view| RatedMethod::new(view, times)).collect();
        rows.sort_by(|one, other| one.ratio.total_cmp(&other.ratio));
        let (least, ties) = least_of(&rows, |view| view.wrong == 0);
        let (least_of_t, _) = least_of(&rows, |view| {
            view.misjudged == 0 && view.off.is_none_or(|off| off.t <= tolerance)
        });
        let failing = match least {
            Some(least) => (0..rows.len())
                .rev()
                .find(|&n| rows[n].view.wrong > 0 && !rows[least].is_cheaper_than(&rows[n])),
            None => (0..rows.len()).min_by_key(|&n| rows[n].view.wrong),
        };
        let culprit = |n: usize| Some((n, Culprit::of(scene, &rows[n].view)?));
        Self {
            failing: failing.and_then(culprit),
            precision,
            rows,
            least,
            least_of_t,
            ties,
        }
    }
}

/// Returns the least of the leasts of `f64` and of `f32`: where neither is cheaper, that of `f32`,
/// whose numbers take half the memory.
pub fn least_of_all(found: &[PrecisionNeeds]) -> Option<(&PrecisionNeeds, &RatedMethod)> {
    let leasts = found
        .iter()
        .filter_map(|it| Some((it, &it.rows[it.least?])));
    leasts.reduce(|one, other| {
        if one.1.is_cheaper_than(other.1) {
            one
        } else {
            other
        }
    })
}

impl RatedMethod {
    fn new(view: MethodView, times: &[MethodTimes]) -> Self {
        let of = times
            .iter()
            .find(|times| times.method.name == view.method.name);
        let taken = &of.expect("every method has its turns").nanoseconds;
        Self {
            view,
            ns: Spread::of(taken.clone()).least,
            ratio: spread_of_ratios(taken, &times[0].nanoseconds).median,
            times: taken.clone(),
        }
    }

    /// Returns true if it took less time than the other in three rounds of four at least, which by
    /// chance alone happens once in some thousand times; and so much less, a twentieth, that the
    /// next run says the same.
    fn is_cheaper_than(&self, other: &Self) -> bool {
        let rounds = self.times.iter().zip(&other.times);
        let won = rounds.filter(|(one, other)| one < other).count();
        4 * won >= 3 * self.times.len() && 1.05 * self.ratio < other.ratio
    }
}

/// Returns which of `rows`, the cheapest first, to take: the cheapest that suffices, or of several
/// that cost the same the first in the order of [`METHODS`], which begins with the simplest. And
/// the others of these.
fn least_of(
    rows: &[RatedMethod],
    suffices: impl Fn(&MethodView) -> bool,
) -> (Option<usize>, Vec<usize>) {
    let mut sufficing = (0..rows.len()).filter(|&n| suffices(&rows[n].view));
    let Some(cheapest) = sufficing.next() else {
        return (None, Vec::new());
    };
    let ties = sufficing.filter(|&n| !rows[cheapest].is_cheaper_than(&rows[n]));
    let mut alike: Vec<usize> = [cheapest].into_iter().chain(ties).collect();
    let place = |n: &usize| {
        let name = rows[*n].view.method.name;
        METHODS.iter().position(|method| method.name == name)
    };
    alike.sort_by_key(place);
    (Some(alike.remove(0)), alike)
}
