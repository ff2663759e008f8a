//! The explanation of a picture by programs: candidates are tried in a fixed order, and the first
//! that draws the picture counts.
//!
//! A candidate counts only if it draws exactly the picture, but for few pixels. A right program
//! comes before one with a mistake, and one mistake before two.

use std::cmp::Reverse;

use crate::candidate::{Candidate, SampleComparison, Unexplained};
use crate::candidates::{
    programs_of_other_tasks, programs_with_one_slip, programs_with_two_slips, right_programs,
};
use crate::context::Evidence;
use crate::pixels::spread;
use crate::task::Task;

/// The explanation of a picture.
pub(crate) enum Explanation {
    /// The picture is the right one of these other tasks, which all draw the same.
    Another(Vec<Task>),
    /// The right program draws the picture but for a few pixels, or none.
    AlmostRight(Fit),
    /// Programs with mistakes draw the picture.
    Mistakes(Fit),
    /// No candidate draws the picture; it is described beside that of this right program.
    Nothing(Candidate),
}

/// Programs that explain the same pixels of a picture.
#[derive(Clone)]
pub(crate) struct Fit {
    /// The programs, at least one, the likeliest first.
    pub(crate) candidates: Vec<Candidate>,
    /// The pixels that none of the programs explains.
    pub(crate) unexplained: Unexplained,
    /// True if the wrong lines of all programs stand in the reader's files, or no file is known.
    pub(crate) is_in_text: bool,
}

/// A program with a mistake explains a picture if it leaves at most 1 pixel in `FEW` unexplained.
const FEW: usize = 200;
/// A right program explains a picture if it leaves at most 1 pixel in `MANY` unexplained.
const MANY: usize = 20;
/// If all unexplained pixels are one level off, as in single precision, the limit is not [`FEW`] but
/// 1 pixel in `ROUNDED`.
const ROUNDED: usize = 4;
/// The size of the sample of pixels in which candidates are compared first.
const SAMPLE: u32 = 2000;
/// How many more pixels of the sample than the best candidate another one may have wrong, to be
/// compared as a whole.
const NEARLY: usize = 3;
/// A picture resembles a right one if more than 1 pixel of the sample in `PART` is equal.
const PART: usize = 8;
/// The most pairs of mistakes that are named: if more draw the picture, none explains it.
const PAIRS: usize = 4;

/// Explains the picture by the first of these that draws it: the right program; another task whose
/// change was forgotten; a mistake whose line stands in the reader's files; a repair of the text that
/// is typed in a page, which ends the search; any other mistake; another task; the right program but
/// for a few pixels; two mistakes.
pub(crate) fn explain(evidence: &Evidence) -> Explanation {
    let reading = evidence.reading;
    let (right, unexplained) = nearest(evidence);
    let almost_right = |unexplained| Explanation::AlmostRight(Fit::of(right.clone(), unexplained));
    let is_answered = || {
        let program = right.task.without_probe().program(&[]);
        evidence.context.is_answered_by(&program)
    };
    if unexplained.is_nothing() && is_answered() {
        return almost_right(unexplained);
    }
    let elsewhere = tasks_elsewhere(evidence).filter(|_| !unexplained.is_nothing());
    if let Some(tasks) = elsewhere.clone().filter(|it| is_forgotten(evidence, it)) {
        return Explanation::Another(tasks);
    }
    let single = first(evidence, &unexplained, programs_with_one_slip(evidence))
        .map(|it| in_the_text(evidence, it));
    if let Some(single) = single.clone().filter(|it| it.is_in_text) {
        return Explanation::Mistakes(single);
    }
    if evidence.repair().is_some() {
        return Explanation::Nothing(right);
    }
    if let Some(single) = single.filter(|_| !unexplained.is_nothing()) {
        return Explanation::Mistakes(single);
    }
    if let Some(tasks) = elsewhere {
        return Explanation::Another(tasks);
    }
    if unexplained.is_nothing()
        || MANY * unexplained.off <= reading.pixels.len()
        || unexplained.is_rounding()
    {
        return almost_right(unexplained);
    }
    let beside = described_beside(evidence, right.clone());
    if !evidence.drawing_mutants(&beside.task).is_informative()
        && let Some(pair) = two_mistakes(evidence, &right, &unexplained)
    {
        return Explanation::Mistakes(pair);
    }
    Explanation::Nothing(beside)
}

/// Chooses the right program beside which a picture is described that no candidate draws: the
/// nearest one, if it draws one in [`PART`] pixels of a sample and has less than half as many wrong
/// ones as version 4's; or else version 4's.
fn described_beside(evidence: &Evidence, nearest: Candidate) -> Candidate {
    let reading = evidence.reading;
    let sampled = spread(SAMPLE, reading.pixels.len() as u32).count();
    let off = |it: &Candidate| {
        it.compare_sample(reading, SAMPLE)
            .map_or(sampled, |it| it.off)
    };
    let asked = right_programs(evidence).swap_remove(0);
    let is_like = PART * (sampled - off(&nearest)) > sampled;
    // Half a pixel, which sets the versions apart, says nothing where much else is off.
    let is_nearer = nearest.task.step().is_some() || 2 * off(&nearest) < off(&asked);
    if is_like && is_nearer { nearest } else { asked }
}

impl Fit {
    /// Makes a fit of one candidate.
    fn of(candidate: Candidate, unexplained: Unexplained) -> Self {
        Self {
            candidates: vec![candidate],
            unexplained,
            is_in_text: true,
        }
    }
}

/// Finds the right program that leaves fewest pixels unexplained, and these. Pixels that are off by
/// more than a level count first; more than one in [`MANY`] count as all.
fn nearest(evidence: &Evidence) -> (Candidate, Unexplained) {
    let reading = evidence.reading;
    let rights = right_programs(evidence).into_iter();
    let sampled = rights.filter_map(|it| Some((it.compare_sample(reading, SAMPLE)?.far, it)));
    let sampled: Vec<_> = sampled.collect();
    let least = sampled
        .iter()
        .map(|(far, _)| *far)
        .min()
        .unwrap_or_default();
    let give = NEARLY.max(least / 4);
    let likely = sampled.into_iter().filter(|(far, _)| *far <= least + give);
    let most = reading.pixels.len() / MANY;
    // Where a tenth of some is far off, more than a twentieth of all is.
    let many = spread(SAMPLE, reading.pixels.len() as u32).count() / (MANY / 2);
    let unexplained = |far: usize, it: &Candidate| {
        let unexplained = (far <= many)
            .then(|| it.unexplained(reading, most))
            .flatten();
        unexplained.unwrap_or(Unexplained::all(reading))
    };
    let measured = likely.map(|(far, it)| (unexplained(far, &it), far, it));
    // Where nothing comes near, one in its own shape does.
    let key = |(unexplained, far, it): &(Unexplained, usize, Candidate)| {
        (
            unexplained.far,
            unexplained.off,
            it.task.has_another_shape(),
            *far,
        )
    };
    let best = measured.min_by_key(key);
    let (unexplained, _, it) = best.expect("the task was fitted to the picture");
    (it, unexplained)
}

/// Returns true if a probe's change was forgotten, or is still in the program: the picture is the
/// chapter's own in place of a probe's, or has the width of the probe that it shows.
fn is_forgotten(evidence: &Evidence, tasks: &[Task]) -> bool {
    let is_it = |task: &Task| match (evidence.task.probe, task.probe) {
        (Some(_), other) => other.is_none(),
        (None, other) => other.is_some_and(|probe| probe.width == evidence.reading.width),
    };
    tasks[0].chapter == evidence.task.chapter && tasks.iter().any(is_it)
}

/// Finds the other tasks, of one chapter, whose right picture this is, to the last bit; `None` if
/// there is none, or if the picture has one color and the reader's files are known.
fn tasks_elsewhere(evidence: &Evidence) -> Option<Vec<Task>> {
    let reading = evidence.reading;
    // One color everywhere is the picture of many things.
    if reading.has_one_color() && !evidence.context.sources.is_empty() {
        return None;
    }
    let is_it = |it: &Candidate| {
        it.may_leave(reading, 0)
            && it
                .unexplained(reading, 0)
                .is_some_and(|unexplained| unexplained.is_nothing())
    };
    let found = programs_of_other_tasks(evidence).into_iter().filter(is_it);
    let mut tasks: Vec<Task> = Vec::new();
    for Candidate { task, .. } in found {
        let is_known = |other: &Task| (other.chapter, other.probe) == (task.chapter, task.probe);
        let is_like = tasks
            .first()
            .is_none_or(|first| first.chapter == task.chapter);
        if is_like && !tasks.iter().any(is_known) {
            tasks.push(task);
        }
    }
    Some(tasks).filter(|tasks| !tasks.is_empty())
}

/// Keeps the programs whose wrong lines stand in the reader's files; keeps all if no file is known,
/// or no wrong line is found.
fn in_the_text(evidence: &Evidence, mut found: Fit) -> Fit {
    if evidence.context.sources.is_empty() {
        return found;
    }
    found.is_in_text = found.candidates.iter().any(|it| evidence.has_lines_of(it));
    if found.is_in_text {
        found.candidates.retain(|it| evidence.has_lines_of(it));
    }
    found
}

/// Finds two mistakes that draw the picture together; `None` if no pair does, or more than
/// [`PAIRS`] do.
fn two_mistakes(evidence: &Evidence, nearest: &Candidate, all: &Unexplained) -> Option<Fit> {
    // Many pairs draw one color everywhere.
    if evidence.reading.has_one_color() {
        return None;
    }
    let pairs = programs_with_two_slips(evidence, &nearest.task);
    let found = first(evidence, all, pairs)?;
    Some(in_the_text(evidence, found)).filter(|it| it.candidates.len() <= PAIRS)
}

/// Returns the programs of the first group in which some explain nearly all of what the right
/// program leaves unexplained, or else those of all groups that explain most of it; `None` if none
/// explains most.
fn first(
    evidence: &Evidence,
    all: &Unexplained,
    groups: impl Iterator<Item = Vec<Candidate>>,
) -> Option<Fit> {
    let mut best: Option<Fit> = None;
    let fits = groups.filter_map(|group| least(evidence, group));
    for fit in fits.filter(|fit| fit.unexplained.is_little_of(all)) {
        if fit.unexplained.is_nearly_nothing_of(all) {
            return Some(fit);
        }
        let most = best.as_ref().map_or(usize::MAX, |it| it.unexplained.off);
        if fit.unexplained.off < most {
            best = Some(fit);
        }
    }
    best
}

/// Returns the programs of a group that leave fewest pixels unexplained; `None` if each leaves more
/// than one in [`FEW`], or in [`ROUNDED`] if all are one level off. Of programs that draw the same
/// sample of pixels only the first is compared as a whole.
fn least(evidence: &Evidence, group: Vec<Candidate>) -> Option<Fit> {
    let reading = evidence.reading;
    let total = reading.pixels.len();
    let mut most = total / FEW;
    let mut best: Option<(Fit, SampleComparison)> = None;
    for (sample, it) in likeliest(evidence, group, most) {
        if let Some((best, first)) = &mut best {
            if sample.mark == first.mark {
                best.candidates.push(it);
                continue;
            }
            // What is off in more of some pixels is off in more of all.
            let give = if best.unexplained.is_nothing() {
                0
            } else {
                NEARLY
            };
            if sample.off > first.off + give {
                break;
            }
        }
        let unexplained = it.unexplained(reading, most);
        let Some(unexplained) = unexplained
            .filter(|unexplained| unexplained.far > 0 || ROUNDED * unexplained.off <= total)
        else {
            continue;
        };
        most = most.min(unexplained.off);
        match &mut best {
            Some((best, _)) if best.unexplained == unexplained => best.candidates.push(it),
            Some((best, _)) if best.unexplained.off <= unexplained.off => {}
            _ => best = Some((Fit::of(it, unexplained), sample)),
        }
    }
    best.map(|(fit, _)| fit)
}

/// Returns the programs of a group that may leave at most `most` pixels unexplained and that no
/// evidence refutes, with the comparison of a sample: the fewest wrong pixels first, and of equals
/// the mistake that was reported more often.
fn likeliest(
    evidence: &Evidence,
    group: Vec<Candidate>,
    most: usize,
) -> Vec<(SampleComparison, Candidate)> {
    let reading = evidence.reading;
    let may_be = |it: &Candidate| it.may_leave(reading, most) && !evidence.refutes(it);
    let group = group.into_iter().filter(may_be);
    let group = group.filter_map(|it| Some((it.compare_sample(reading, SAMPLE)?, it)));
    let mut likeliest: Vec<(SampleComparison, Candidate)> = group.collect();
    let reports =
        |it: &Candidate| -> usize { it.slips.iter().map(|slip| slip.report_count()).sum() };
    likeliest.sort_by_key(|(sample, it)| (sample.off, Reverse(reports(it))));
    likeliest
}
