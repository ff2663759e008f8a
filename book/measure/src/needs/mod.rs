//! Model selection: the cheapest method that draws every pixel right, and why the next
//! cheaper one does not do.

mod culprit;

use crate::contest::spread_of_ratios;
use crate::cost::MethodTimes;
use crate::spread::Spread;
use crate::wrong_pixels::MethodView;
use speed_vs_accuracy::{METHODS, Precision, Scene};

pub use culprit::Culprit;

/// The methods of one precision, with the cheapest of them that draws a scene right. All indices
/// count in `rows`, from 0.
pub struct PrecisionNeeds {
    /// The precision, `f32` or `f64`.
    pub precision: Precision,
    /// All methods of the precision, the cheapest first, by [`RatedMethod::ratio`].
    pub rows: Vec<RatedMethod>,
    /// The index of the method to take for colors: the cheapest that draws every pixel right, and
    /// of several that cost the same the simplest. `None` if no method draws every pixel right.
    pub least: Option<usize>,
    /// The index of the method to take for distances: the cheapest that sees the right sphere in
    /// every pixel, with its t within the tolerance. `None` if there is no such method.
    pub least_of_t: Option<usize>,
    /// The indices of the other methods that draw every pixel right and cost the same as `least`,
    /// as far as can be told. Empty if there are none.
    pub ties: Vec<usize>,
    /// The index of a method that draws wrong pixels, with one of them to show: the next cheaper
    /// one than `least`, or one that costs the same; or the one with the fewest wrong pixels if
    /// `least` is `None`. `None` if no such method fails.
    pub failing: Option<(usize, Culprit)>,
}

/// A method, with its picture of a scene and its time, by which methods are chosen.
pub struct RatedMethod {
    /// The method's picture of the scene, compared with the right one.
    pub view: MethodView,
    /// The nanoseconds of a question in the quickest round, which other programs disturbed least.
    pub ns: f64,
    /// The median over all rounds of the method's time divided by that of the reference method in
    /// the same round. Methods are ordered by this, since it does not change with the pace of the
    /// processor.
    pub ratio: f64,
    /// The nanoseconds of a question in each round.
    times: Vec<f64>,
}

impl PrecisionNeeds {
    /// Finds what `scene` needs in one precision. `views` are the pictures of the precision's
    /// methods, and `times` those of all methods, the reference first. `tolerance` is the greatest
    /// relative error of t that counts as right.
    ///
    /// # Panics
    /// If a method of `views` has no `times`.
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

/// Returns the cheapest `least` of all precisions, with the needs that it belongs to; where neither
/// is clearly cheaper, the later in `found`. There `f32` should come last, since its numbers take
/// half the memory. Returns `None` if no method draws every pixel right.
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

    /// Returns true if the method took less time than the other in three rounds of four at least,
    /// which by chance alone happens once in some thousand times; and so much less, a twentieth,
    /// that the next run says the same.
    fn is_cheaper_than(&self, other: &Self) -> bool {
        let rounds = self.times.iter().zip(&other.times);
        let won = rounds.filter(|(one, other)| one < other).count();
        4 * won >= 3 * self.times.len() && 1.05 * self.ratio < other.ratio
    }
}

/// Returns the index of the method to take of `rows`, the cheapest first: the cheapest that
/// suffices, or of several that cost the same the first in the order of [`METHODS`], which begins
/// with the simplest. Also returns the indices of those others.
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
