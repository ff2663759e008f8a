//! Manners: differences from version 4 of the book that other editions and derivations have, and
//! that no picture of these chapters shows.

use super::{AskProgram, FunctionKind};
use laws::nearer_root::{BAND, root_bound};
use laws::oracle::ExactCase;
use laws::question::telling_cases;
use laws::record::RecordedHit;
use laws::strategies::{ordinary, ordinary_with_interval};
use laws::{Case, IntervalCase};

/// A difference between a function's answers and those of version 4 of the book that no picture of
/// these chapters shows: another treatment of ends, tangents or spheres behind the eye.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Manner {
    /// A root at an end of the range `t_min` to `t_max` counts as a hit.
    EndsCount,
    /// A ray that only touches the sphere, with two equal roots, misses it.
    TangentsMiss,
    /// A root behind the eye is a miss.
    NothingBehind,
}

impl Manner {
    /// Returns the clause, in plain text, that describes the manner and names its origin: `a
    /// tangent is a miss, as in version 1 of the book`.
    pub fn description(self) -> &'static str {
        match self {
            Self::EndsCount => "a root at an end of the range counts, as in version 3 of the book",
            Self::TangentsMiss => "a tangent is a miss, as in version 1 of the book",
            Self::NothingBehind => "nothing behind the eye is hit, as in a geometric solution",
        }
    }

    /// Finds the manners that a function keeps in each telling question in which they would show,
    /// at least one.
    pub(super) fn of(function: FunctionKind, ask: &AskProgram) -> Vec<Self> {
        let asked = match function {
            FunctionKind::Record => telling_cases(&ordinary_with_interval()),
            _ => {
                let cases = telling_cases(&ordinary()).into_iter();
                cases.map(IntervalCase::unbounded).collect()
            }
        };
        let is_kept = |manner: &Self| {
            let mut concerned = asked
                .iter()
                .filter(|it| manner.shows(function, it))
                .peekable();
            concerned.peek().is_some()
                && concerned.all(|it| match (manner, ask(it)) {
                    // Whether it is the right root is the matter of the laws.
                    (Self::NothingBehind, found) => {
                        found.is_none_or(|hit| hit.t >= 0.0 && function != FunctionKind::Decision)
                    }
                    (_, found) => manner.meant(function, it, found.as_ref()).is_some(),
                })
        };
        let all = [Self::EndsCount, Self::TangentsMiss, Self::NothingBehind];
        all.into_iter().filter(is_kept).collect()
    }

    /// Returns true if a function with this manner must give another answer to the question than
    /// one without, whatever its other manners are.
    fn shows(self, function: FunctionKind, asked: &IntervalCase) -> bool {
        let IntervalCase { case, t_min, t_max } = *asked;
        let exact = ExactCase::of(&case);
        let roots = [exact.nearer_root(), exact.farther_root()];
        let [first, last] = roots;
        match self {
            Self::EndsCount => {
                let mut roots = roots.into_iter().flatten();
                let counts = roots.find(|root| *root >= t_min && *root <= t_max);
                let is_at_an_end = counts.filter(|root| *root == t_min || *root == t_max);
                function == FunctionKind::Record && is_at_an_end.is_some_and(|root| root > 0.0)
            }
            Self::TangentsMiss => {
                let is_tangent = exact.discriminant().is_eq();
                is_tangent && first.is_some_and(|it| it > 0.0 && it > t_min && it < t_max)
            }
            Self::NothingBehind => {
                let right = exact.nearest_root_in(t_min, t_max);
                let is_behind = match function {
                    FunctionKind::Decision => last.is_some_and(|root| root < 0.0),
                    FunctionKind::Root | FunctionKind::Record => {
                        right.is_some_and(|root| root < 0.0)
                    }
                };
                is_behind && exact.discriminant_margin() > BAND
            }
        }
    }

    /// Returns the right answer, if the answer that was found differs from it by this manner alone.
    pub(super) fn meant(
        self,
        function: FunctionKind,
        asked: &IntervalCase,
        found: Option<&RecordedHit>,
    ) -> Option<Option<RecordedHit>> {
        let IntervalCase { case, t_min, t_max } = asked;
        let exact = ExactCase::of(case);
        let roots = [exact.nearer_root(), exact.farther_root()];
        let mut roots = roots.into_iter().flatten().map(|root| root.rounded());
        let farther = roots.clone().next_back();
        let right = roots.find(|root| t_min < root && root < t_max);
        let is_meant = match self {
            Self::EndsCount => found.is_some_and(|hit| hit.t == *t_min || hit.t == *t_max),
            Self::TangentsMiss => found.is_none() && exact.discriminant().is_eq(),
            Self::NothingBehind => {
                let ahead = farther.filter(|&root| root >= 0.0);
                let bound = root_bound(case, exact.discriminant_margin());
                let is_ahead =
                    |hit: &RecordedHit| ahead.is_some_and(|root| (hit.t - root).abs() <= bound);
                let may_miss = function != FunctionKind::Decision || ahead.is_none();
                right.is_some_and(|root| root <= 0.0) && found.map_or(may_miss, is_ahead)
            }
        };
        is_meant.then(|| right.map(|root| right_record(case, root)))
    }
}

/// Makes the right record of a hit at the ray parameter `t`, as chapter 5 does.
pub(super) fn right_record(case: &Case, t: f64) -> RecordedHit {
    let point = case.ray.origin + t * case.ray.direction;
    let outward = (point - case.center) * (1.0 / case.radius);
    let front_face = case.ray.direction.dot(outward) < 0.0;
    let normal = if front_face { outward } else { -outward };
    RecordedHit {
        t,
        point,
        normal,
        front_face,
    }
}
