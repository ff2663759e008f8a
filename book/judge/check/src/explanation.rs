//! The explanations of a picture: programs that were drawn and compared, each kind with the same
//! fields.
//!
//! Candidates are tried group by group, those of a group in a few pixels first. The first group in
//! which some program leaves nearly nothing unexplained is the explanation.

use std::cmp::Reverse;

use slips::{Chapter, PROBES, Probe, Slip};

use crate::candidate::{Candidate, Conversion, SampleComparison, Unexplained};
use crate::case::Case;
use crate::programs;
use crate::task::{Task, Version};
use crate::work;

/// Programs that explain the same pixels of a picture.
#[derive(Clone, Debug)]
pub struct Explanation {
    /// What draws the picture: programs, at least one, the likeliest first.
    pub by: Vec<Candidate>,
    /// How many programs draw it, as far as they were tried; no less than there are in `by`.
    pub count: usize,
    /// The pixels that none of the programs explains.
    pub left: Unexplained,
    /// True if the wrong lines of all programs stand in the reader's files, or no file is known.
    pub is_in_text: bool,
}

/// A program with a mistake explains a picture if it leaves at most 1 pixel in `FEW` unexplained.
const FEW: usize = 200;
/// A right program explains a picture if it leaves at most 1 pixel in `MANY` unexplained.
const MANY: usize = 20;
/// If all unexplained pixels are one level off, as in single precision, the limit is not [`FEW`] but
/// 1 pixel in `ROUNDED`.
const ROUNDED: usize = 4;
/// How many more pixels of a sample than the best candidate another one may have wrong, to be
/// compared as a whole; and how many may be wrong by chance.
const NEARLY: usize = 3;
/// A picture resembles a right one if more than 1 pixel of the sample in `PART` is equal.
const PART: usize = 8;
/// The most pairs of mistakes that are named: if more draw the picture, none explains it.
const PAIRS: usize = 4;
/// The part of the work that is left, one in so many, that pairs may take.
const PAIRS_PART: u64 = 3;

/// Mistakes of version 4 whose lines are right in version 3: it counts rows from below.
const RIGHT_IN_VERSION_3: [&str; 3] = ["rows-from-below", "viewport-upside-down", "green-upwards"];

impl Explanation {
    /// Makes an explanation by one program.
    fn of(candidate: Candidate, left: Unexplained) -> Self {
        Self {
            by: vec![candidate],
            count: 1,
            left,
            is_in_text: true,
        }
    }

    /// Returns the slips of the only known mistake that draws the picture; empty if there is none,
    /// or more than one.
    pub fn only_mistake(&self) -> &[&'static Slip] {
        match &self.by[..] {
            [one] => &one.slips,
            _ => &[],
        }
    }

    /// Finds the right program of the task, by a version or after a step, that leaves fewest pixels
    /// unexplained. Pixels that are off by more than a level count first; more than one in
    /// [`MANY`] count as all.
    pub(crate) fn right(case: &Case) -> Self {
        let (reading, work) = (case.reading, &case.work);
        let most = reading.pixels.len() / MANY;
        let measured = right_tasks(case).into_iter().map(|task| {
            let it = Candidate::right(task, case.conversion());
            // Where a tenth of some is far off, more than a twentieth of all is.
            let places = &case.places().all;
            let many = places.len() / (MANY / 2);
            let may_be = it.task.is_compiled()
                || it
                    .drawn(reading, work)
                    .is_some_and(|it| it.leaves(places, 1, many));
            let most = if it.task.is_compiled() {
                usize::MAX
            } else {
                most
            };
            let left = may_be
                .then(|| it.unexplained(reading, work, most))
                .flatten();
            Self::of(it, left.unwrap_or(Unexplained::all(reading)))
        });
        let mut measured = measured.peekable();
        if let Some(exact) = measured.next_if(|it| it.left.is_nothing()) {
            return exact;
        }
        let key = |it: &Self| (it.left.far, it.left.off);
        let best = measured.min_by_key(key);
        best.expect("there is version 4")
    }

    /// Returns true if this is a right program that leaves few pixels, or all of them a level off.
    pub(crate) fn is_nearly_all(&self) -> bool {
        MANY * self.left.off <= self.left.compared || self.left.is_rounding()
    }

    /// Finds the other tasks, of one chapter, whose right picture this is, to the last bit; `None`
    /// if there is none, or if the reader's files are known: who types a chapter has no other
    /// picture at hand.
    pub(crate) fn elsewhere(case: &Case) -> Option<Self> {
        let (reading, work) = (case.reading, &case.work);
        if !case.context.sources.is_empty() {
            return None;
        }
        if case.has_forgotten_width() {
            return Some(case.right().clone());
        }
        let is_it = |it: &Candidate| {
            let drawn = it.drawn(reading, work);
            drawn.is_some_and(|it| it.leaves(&case.places().all, 0, 0))
                && it
                    .unexplained(reading, work, 0)
                    .is_some_and(|it| it.is_nothing())
        };
        let all = other_tasks(case).into_iter();
        let all = all.map(|task| Candidate::right(task, case.conversion()));
        let found: Vec<Candidate> = all.filter(is_it).collect();
        let first = found.first()?.task.chapter;
        let mut by: Vec<Candidate> = Vec::new();
        for it in found.into_iter().filter(|it| it.task.chapter == first) {
            if by.iter().all(|other| other.task.probe != it.task.probe) {
                by.push(it);
            }
        }
        Some(Self {
            count: by.len(),
            by,
            left: Unexplained::default(),
            is_in_text: true,
        })
    }

    /// Returns true if this is the task's chapter, and a probe's change was forgotten or is still in
    /// the program: the picture is the chapter's own in place of a probe's, or has the width of the
    /// probe that it shows.
    pub(crate) fn is_forgotten_change(&self, case: &Case) -> bool {
        let is_it = |it: &Candidate| match (case.task.probe, it.task.probe) {
            (Some(_), other) => other.is_none(),
            (None, other) => other.is_some_and(|probe| probe.width == case.reading.width),
        };
        let is_own = self.by[0].task.chapter == case.task.chapter;
        is_own && (case.has_forgotten_width() || self.by.iter().any(is_it))
    }

    /// Finds the known mistakes that draw the picture: by the version of the nearest right program,
    /// in the picture's shape and in the chapter's own, after each step, with levels that begin
    /// again at 0, and last by the other formula of chapters 3 and 4, if that draws all of it.
    pub(crate) fn mistake(case: &Case) -> Option<Self> {
        let groups = groups_with_a_slip(case).into_iter();
        let own = first(case, groups.map(|right| with_one_slip(case, &right)));
        let found = own.or_else(|| {
            let twin = the_other_formula(case)?;
            let found = first(case, [with_one_slip(case, &twin)].into_iter());
            found.filter(|it| it.left.is_nothing() && !case.is_only_sky())
        });
        found.map(|it| it.in_the_text(case))
    }

    /// Finds two known mistakes that draw the picture together, those first that are reported most;
    /// `None` if no pair does, or more than [`PAIRS`] do.
    pub(crate) fn pair(case: &Case) -> Option<Self> {
        // Many pairs draw one color everywhere, or only sky.
        if case.reading.has_one_color() || case.is_only_sky() {
            return None;
        }
        let part = case.work.part(PAIRS_PART);
        let task = case.right().by[0].task;
        let right = Candidate::right(task, case.conversion());
        let slips: Vec<&'static Slip> = case.slips(task.chapter).collect();
        let pairs = (0..slips.len()).flat_map(|n| (0..n).map(move |m| (m, n)));
        let mut pairs: Vec<[&'static Slip; 2]> = pairs.map(|(m, n)| [slips[m], slips[n]]).collect();
        let reports = |pair: &[&Slip; 2]| pair.map(Slip::report_count).iter().sum::<usize>();
        let is_one = |pair: &[&Slip; 2]| programs::are_in_one_function(&task, *pair);
        // Those first of which people told both, then those that are read sooner.
        let are_told = |pair: &[&Slip; 2]| pair.iter().all(|slip| slip.report_count() > 0);
        let key = |pair: &[&Slip; 2]| (!are_told(pair), is_one(pair), Reverse(reports(pair)));
        pairs.sort_by_cached_key(key);
        let places = case.places();
        let draws = |it: &Candidate| {
            let drawn = it.drawn(case.reading, &part);
            drawn.is_some_and(|it| places.are_drawn_by(&it)) && !case.refutes(it)
        };
        let is_paid = |pair: &[&Slip; 2]| !is_one(pair) || part.take(work::TEXT);
        let pairs = pairs.into_iter().take_while(is_paid);
        let pairs = pairs.map(|pair| right.with(pair.to_vec()));
        let found: Vec<Candidate> = pairs.filter(draws).take(PAIRS + 1).collect();
        case.work.add(&part);
        let left = found.first()?.unexplained(case.reading, &case.work, 0)?;
        let found = Self {
            count: found.len(),
            by: found,
            left,
            is_in_text: true,
        };
        let found = found.in_the_text(case);
        (found.by.len() <= PAIRS && found.left.is_nothing()).then_some(found)
    }

    /// Keeps the programs whose wrong lines stand in the reader's files; keeps all if no file is
    /// known, or no wrong line is found.
    fn in_the_text(mut self, case: &Case) -> Self {
        if case.context.sources.is_empty() {
            return self;
        }
        self.is_in_text = self.by.iter().any(|it| case.has_lines_of(it));
        if self.is_in_text {
            self.by.retain(|it| case.has_lines_of(it));
            self.count = self.by.len();
        }
        self
    }
}

/// Chooses the right task beside which a picture is described that nothing explains: the nearest
/// one, if it draws one in [`PART`] pixels of a sample and has less than half as many wrong ones as
/// version 4's; or else version 4's.
pub(crate) fn described_beside(case: &Case) -> Task {
    let (nearest, asked) = (case.right().by[0].task, right_tasks(case)[0]);
    let places = &case.places().all;
    let off = |task: Task| {
        let drawn = Candidate::right(task, case.conversion()).drawn(case.reading, &case.work);
        let sample = drawn.and_then(|it| it.sample(places));
        sample.map_or(places.len(), |it| it.off)
    };
    if nearest == asked {
        return asked;
    }
    let is_like = PART * (places.len() - off(nearest)) > places.len();
    // Half a pixel, which sets the versions apart, says nothing where much else is off.
    let is_nearer = nearest.step.is_some() || 2 * off(nearest) < off(asked);
    if is_like && is_nearer { nearest } else { asked }
}

/// Returns the task by each version that counts as right, in the size of the picture, version 4
/// first; and after each step before the last, but for those that the reader is past.
pub(crate) fn right_tasks(case: &Case) -> Vec<Task> {
    let mut tasks = versions(case, case.task);
    tasks.extend(step_tasks(case));
    tasks
}

fn versions(case: &Case, task: Task) -> Vec<Task> {
    let (width, height) = (case.reading.width, case.reading.height);
    case.context.versions(&task, width, height)
}

fn step_tasks(case: &Case) -> Vec<Task> {
    let before = case.context.steps.len().saturating_sub(1);
    let steps = (0..before).map(|step| Task {
        step: Some(step),
        ..case.task
    });
    let steps = steps.filter(|step| !case.is_past(step));
    steps.map(|task| versions(case, task)[0]).collect()
}

/// Returns the other tasks: the chapter with other probes or none, and other chapters, by each
/// version, in their own shapes.
fn other_tasks(case: &Case) -> Vec<Task> {
    let own = case.task;
    let is_sky = case.is_only_sky();
    // Only sky is the picture of many things: of a probe only in its own width.
    let may_be =
        |probe: &Probe| probe.spheres.is_some() && (!is_sky || probe.width == case.reading.width);
    let probes = PROBES.into_iter().filter(may_be).map(Some);
    let tasks = [None].into_iter().chain(probes);
    let tasks = tasks.filter(|probe| *probe != own.probe);
    let tasks = tasks.filter_map(|probe| Task::new(own.chapter, probe));
    let chapters = Chapter::OF_THE_BOOK.into_iter();
    let chapters = chapters.filter(|&chapter| chapter != own.chapter && !is_sky);
    let all = tasks.chain(chapters.map(Task::of));
    let all = all.flat_map(|task| versions(case, task));
    all.filter(|task| task.size.is_none()).collect()
}

/// Returns the right programs in which slips are made.
fn groups_with_a_slip(case: &Case) -> Vec<Candidate> {
    let fitting = versions(case, case.task);
    let shaped = fitting.iter().filter(|task| task.size.is_some());
    // A slip may give the picture its shape.
    let own: Vec<Task> = shaped
        .map(|task| Task {
            size: None,
            ..*task
        })
        .collect();
    let tasks = fitting.into_iter().chain(own).chain(step_tasks(case));
    let groups = tasks.map(|task| Candidate::right(task, case.conversion()));
    let groups: Vec<Candidate> = groups.collect();
    let wrapped = (case.conversion() != Conversion::Printed).then(|| Candidate {
        conversion: Conversion::Wrapped,
        ..groups[0].clone()
    });
    groups.into_iter().chain(wrapped).collect()
}

/// Returns the right program of chapter 4 in place of 3, or of 3 in place of 4, which draw the same
/// picture by the whole of b or its half; `None` for other chapters.
fn the_other_formula(case: &Case) -> Option<Candidate> {
    let chapter = match case.task.chapter {
        Chapter::Normals => Chapter::HalfBSphere,
        Chapter::HalfBSphere => Chapter::Normals,
        _ => return None,
    };
    let task = versions(
        case,
        Task {
            chapter,
            ..case.task
        },
    )[0];
    Some(Candidate::right(task, case.conversion()))
}

fn with_one_slip(case: &Case, right: &Candidate) -> Vec<Candidate> {
    let is_wrong = |slip: &&Slip| {
        right.task.version == Version::Four || !RIGHT_IN_VERSION_3.contains(&slip.name)
    };
    let slips = case.slips(right.task.chapter).filter(is_wrong);
    slips.map(|slip| right.with(vec![slip])).collect()
}

/// Returns the programs of the first group in which some explain nearly all of what the right
/// program leaves unexplained, or else those of all groups that explain most of it; `None` if none
/// explains most.
fn first(case: &Case, groups: impl Iterator<Item = Vec<Candidate>>) -> Option<Explanation> {
    let all = case.left_by_right();
    let mut best: Option<Explanation> = None;
    let fits = groups.filter_map(|group| least(case, group));
    for fit in fits.filter(|fit| fit.left.is_little_of(all)) {
        if fit.left.is_nearly_nothing_of(all) {
            return Some(fit);
        }
        let most = best.as_ref().map_or(usize::MAX, |it| it.left.off);
        if fit.left.off < most {
            best = Some(fit);
        }
    }
    best
}

/// Returns the programs of a group that leave fewest pixels unexplained; `None` if each leaves more
/// than one in [`FEW`], or in [`ROUNDED`] if all are one level off. Of programs that draw the same
/// sample of pixels only the first is compared as a whole.
fn least(case: &Case, group: Vec<Candidate>) -> Option<Explanation> {
    let total = case.reading.pixels.len();
    let mut most = total / FEW;
    let mut best: Option<(Explanation, SampleComparison)> = None;
    for (sample, it) in likeliest(case, group, most) {
        if let Some((best, first)) = &mut best {
            if sample.mark == first.mark {
                best.by.push(it);
                continue;
            }
            // What is off in more of some pixels is off in more of all.
            let give = if best.left.is_nothing() { 0 } else { NEARLY };
            if sample.off > first.off + give {
                break;
            }
        }
        let left = it.unexplained(case.reading, &case.work, most);
        let Some(left) = left.filter(|it| it.far > 0 || ROUNDED * it.off <= it.compared) else {
            continue;
        };
        most = most.min(left.off);
        match &mut best {
            Some((best, _)) if best.left == left => best.by.push(it),
            Some((best, _)) if best.left.off <= left.off => {}
            _ => best = Some((Explanation::of(it, left), sample)),
        }
    }
    best.map(|(it, _)| Explanation {
        count: it.by.len(),
        ..it
    })
}

/// Returns the programs of a group that may leave at most `most` pixels unexplained and that
/// nothing refutes, with the comparison of a sample: the fewest wrong pixels first, and of equals
/// the mistake that was reported more often.
fn likeliest(
    case: &Case,
    group: Vec<Candidate>,
    most: usize,
) -> Vec<(SampleComparison, Candidate)> {
    let places = case.places();
    let total = case.reading.pixels.len();
    // One explains three quarters of what is wrong, or nothing is wrong but the answers.
    let wrong = places.wrong.len() / 4 + if total < 100 { 1 } else { 0 };
    let far = NEARLY + 2 * most * places.all.len() / total;
    let compared = group.into_iter().filter_map(|it| {
        let drawn = it.drawn(case.reading, &case.work)?;
        let may_be = drawn.leaves(&places.wrong, 0, wrong);
        let sample = may_be
            .then(|| drawn.sample_within(&places.all, far))
            .flatten()?;
        (!case.refutes(&it)).then_some((sample, it))
    });
    let mut likeliest: Vec<(SampleComparison, Candidate)> = compared.collect();
    let reports =
        |it: &Candidate| -> usize { it.slips.iter().map(|slip| slip.report_count()).sum() };
    likeliest.sort_by_key(|(sample, it)| (sample.off, Reverse(reports(it))));
    likeliest
}
