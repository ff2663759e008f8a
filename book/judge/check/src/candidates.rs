//! Generators of the programs that may have drawn a picture: right ones, and those with known
//! mistakes.

use slips::{Chapter, PROBES, Probe, Slip, SphereCount};

use crate::candidate::{Candidate, Conversion};
use crate::context::Evidence;
use crate::task::Task;

/// Returns the right programs of the task, at least one: by each version that counts as right,
/// version 4 first, and after each step before the last.
pub(crate) fn right_programs(evidence: &Evidence) -> Vec<Candidate> {
    let steps = steps(evidence).into_iter();
    let tasks = versions(evidence, evidence.task).into_iter().chain(steps);
    tasks.map(|task| right(evidence, task)).collect()
}

/// Returns the right programs of other tasks: the chapter with other probes or none, and other
/// chapters. Returns none for a reader who types the chapter, and has no other picture at hand.
pub(crate) fn programs_of_other_tasks(evidence: &Evidence) -> Vec<Candidate> {
    let own = evidence.task;
    if !evidence.context.sources.is_empty() {
        return Vec::new();
    }
    let (width, height) = (evidence.reading.width, evidence.reading.height);
    let is_sky = own.chapter.sphere_count() != SphereCount::None
        && evidence.reading.picture() == own.sky_picture(width, height);
    // Only sky is the picture of many things: of a probe only in its own width.
    let may_be = |probe: &Probe| probe.spheres.is_some() && (!is_sky || probe.width == width);
    let probes = PROBES.into_iter().filter(may_be);
    let tasks = [None].into_iter().chain(probes.map(Some));
    let tasks = tasks.filter(|probe| *probe != own.probe);
    let tasks = tasks.filter_map(|probe| Task::new(own.chapter, probe));
    let chapters = Chapter::OF_THE_BOOK.into_iter();
    let chapters = chapters.filter(|&chapter| chapter != own.chapter && !is_sky);
    let all = tasks.chain(chapters.map(|chapter| own.of_chapter(chapter)));
    let all = all.flat_map(|task| versions(evidence, task));
    let all = all.filter(|task| !task.has_another_shape());
    all.map(|task| right(evidence, task)).collect()
}

/// Iterates over programs with one slip, in groups: one for each version, shape, step, formula of
/// chapters 3 and 4, and conversion; the likeliest group first.
pub(crate) fn programs_with_one_slip(evidence: &Evidence) -> impl Iterator<Item = Vec<Candidate>> {
    let rights = with_slips_in(evidence);
    let wrapped = rights
        .first()
        .filter(|_| !evidence.has_invalid_levels)
        .cloned();
    let wrapped = wrapped.map(|right| Candidate {
        conversion: Conversion::Wrapped,
        ..right
    });
    let other = rights.clone().into_iter().filter_map(|right| {
        let task = right.task.with_the_other_formula()?;
        Some(Candidate { task, ..right })
    });
    let groups = rights.into_iter().chain(other).chain(wrapped);
    groups.map(|right| {
        let slips = evidence.slips(&right.task);
        slips.map(|slip| with(&right, vec![slip])).collect()
    })
}

/// Iterates over programs with two slips, in groups: by version 4, and by version 3 if that is the
/// `nearest`, in each shape and after each step.
pub(crate) fn programs_with_two_slips(
    evidence: &Evidence,
    nearest: &Task,
) -> impl Iterator<Item = Vec<Candidate>> {
    let is_older = nearest.is_by_version_3();
    let rights = with_slips_in(evidence).into_iter();
    let rights = rights.filter(move |it| is_older || !it.task.is_by_version_3());
    rights.map(|right| {
        let slips: Vec<&'static Slip> = evidence.slips(&right.task).collect();
        let all = (0..slips.len()).flat_map(|n| (n + 1..slips.len()).map(move |m| (n, m)));
        all.map(|(n, m)| with(&right, vec![slips[n], slips[m]]))
            .collect()
    })
}

/// Makes the right program of a task.
fn right(evidence: &Evidence, task: Task) -> Candidate {
    Candidate {
        task,
        slips: Vec::new(),
        conversion: match evidence.has_invalid_levels {
            true => Conversion::Printed,
            false => Conversion::Clamped,
        },
    }
}

/// Returns the right program with these slips made in it.
fn with(right: &Candidate, slips: Vec<&'static Slip>) -> Candidate {
    Candidate {
        slips,
        ..right.clone()
    }
}

/// Returns the task by each version that counts as right, in the size of the picture.
fn versions(evidence: &Evidence, task: Task) -> Vec<Task> {
    let (width, height) = (evidence.reading.width, evidence.reading.height);
    evidence.context.versions(&task, width, height)
}

/// Returns the task after each step before the last, but for those that the reader is past, by
/// version 4.
fn steps(evidence: &Evidence) -> Vec<Task> {
    let own = evidence.task;
    let before = evidence.context.steps.len().saturating_sub(1);
    let steps = (0..before).map(|step| own.at_step(step));
    let steps = steps.filter(|step| !evidence.is_past(step));
    let tasks = steps.map(|task| versions(evidence, task)[0]);
    tasks.collect()
}

/// Returns the right programs in which slips are made: in the picture's shape, and in the chapter's
/// own, since a slip may give the picture its shape.
fn with_slips_in(evidence: &Evidence) -> Vec<Candidate> {
    let fitting = versions(evidence, evidence.task);
    let shaped = fitting.iter().filter(|task| task.has_another_shape());
    let own: Vec<Task> = shaped.map(|task| task.in_own_shape()).collect();
    let tasks = fitting.into_iter().chain(own).chain(steps(evidence));
    tasks.map(|task| right(evidence, task)).collect()
}
