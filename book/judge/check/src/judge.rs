//! The judge: comes to a [`Verdict`] on a picture by the first of the [`RULES`] that holds.
//!
//! A picture may be refused besides, for its numbers or its shape.

use difference::Comparison;

use crate::candidate::Candidate;
use crate::case::Case;
use crate::context::Context;
use crate::reading::{self, Reading};
use crate::rules::{ELSEWHERE, MISTAKE, RIGHT, RULES, Rule, SEEN};
use crate::task::Task;
use crate::verdict::{Finding, Refusal, RefusalKind, Verdict};
use crate::{causes, explanation, seen, telling};

/// Judges the picture in the bytes of a file, PPM or PNG, as [`judge`] does. Bytes that can't be
/// read are refused.
pub fn judge_file(task: &Task, bytes: &[u8], tolerance: u8, context: &Context) -> Verdict {
    match reading::read(bytes) {
        Ok(reading) => judge(task, &reading, tolerance, context),
        Err(cause) => Verdict::not_a_picture(cause),
    }
}

/// Judges a picture that was read: whether it fulfills the task, and if not, what explains that.
///
/// The picture is right if version 4 or 3 of the book draws it with every color component at most
/// `tolerance` levels off (0 asks for equality), unless the reader's functions answer otherwise
/// than the chapter's and a mistake or a repair explains that. A reader's files are judged by
/// version 4 alone.
pub fn judge(task: &Task, reading: &Reading, tolerance: u8, context: &Context) -> Verdict {
    let (width, height) = (reading.width, reading.height);
    let refusal = refusal(task, reading);
    let is_shaped = refusal
        .as_ref()
        .is_none_or(|it| it.kind != RefusalKind::WrongShape);
    let has_own_shape = Task::of(task.chapter).height(width) == height;
    let size = u64::from(width) * u64::from(height);
    if !is_shaped && size > causes::MOST_MISSHAPEN && !has_own_shape {
        let finding = None;
        return Verdict { refusal, finding };
    }
    let case = Case::new(task, reading, tolerance, context);
    let mut rules = RULES.iter();
    let rule = rules.find(|rule| (rule.holds)(&case));
    // The last one holds where no other does.
    let rule = rule.unwrap_or(&RULES[RULES.len() - 1]);
    let mut finding = Box::new(Finding::by(rule, &case));
    if rule.number == ELSEWHERE {
        let cause = finding.another(task, context.languages);
        let kind = RefusalKind::Another;
        let refusal = refusal.filter(|it| it.kind == RefusalKind::NotAPicture);
        return Verdict {
            refusal: refusal.or(Some(Refusal { kind, cause })),
            finding: None,
        };
    }
    // A shape may be chosen, or it is the mistake's.
    let is_chosen = causes::is_a_shape_to_choose(width, height) && has_width(task, reading);
    let is_explained = match rule.number {
        RIGHT => is_chosen,
        MISTAKE => true,
        _ => finding.is_nearly_right(),
    };
    if !is_shaped && rule.number == RIGHT && is_chosen {
        finding.shape_given_by = causes::slips_giving(task, width, height);
    }
    let refusal = refusal.filter(|it| it.kind == RefusalKind::NotAPicture || !is_explained);
    let finding = Some(finding);
    Verdict { refusal, finding }
}

/// Returns the numbers of all rules that hold for a picture; it is one.
pub fn rules_that_hold(task: &Task, reading: &Reading, context: &Context) -> Vec<u8> {
    let case = Case::new(task, reading, 0, context);
    let rules = RULES.iter().filter(|rule| (rule.holds)(&case));
    rules.map(|rule| rule.number).collect()
}

/// Judges a picture whose task was guessed. If the picture is the right one of another task, it is
/// judged as that. Returns the task as which it was judged, and the verdict.
pub fn judge_guessed(
    task: &Task,
    reading: &Reading,
    tolerance: u8,
    context: &Context,
) -> (Task, Verdict) {
    let case = Case::new(task, reading, tolerance, context);
    let is_refused = refusal(task, reading).is_some_and(|it| it.kind == RefusalKind::NotAPicture);
    let other = case
        .elsewhere()
        .filter(|_| !is_refused && case.is_elsewhere());
    let other = other.and_then(|it| Task::new(it.by[0].task.chapter, it.by[0].task.probe));
    let task = other.unwrap_or(*task);
    (task, judge(&task, reading, tolerance, context))
}

/// Refuses a picture for its numbers, or for its width and height; `None` if both are the task's.
fn refusal(task: &Task, reading: &Reading) -> Option<Refusal> {
    let refusal = |kind| move |cause| Refusal { kind, cause };
    let numbers = causes::invalid_levels(reading).map(refusal(RefusalKind::NotAPicture));
    numbers.or_else(|| {
        let width = causes::not_as_wide(task, reading);
        let shape = width.or_else(|| causes::wrong_shape(task, reading.width, reading.height));
        shape.map(refusal(RefusalKind::WrongShape))
    })
}

/// Returns true if the picture has the width that its probe is about, if that is about a width.
fn has_width(task: &Task, reading: &Reading) -> bool {
    causes::not_as_wide(task, reading).is_none()
}

impl Finding {
    /// Makes the finding of a rule that holds for a case.
    fn by(rule: &'static Rule, case: &Case) -> Self {
        let reading = case.reading;
        let explanation = (rule.explanation)(case).cloned();
        let by = explanation.as_ref().map(|it| it.by[0].clone());
        let beside = || Candidate::right(explanation::described_beside(case), case.conversion());
        let by = by.filter(|_| rule.number != SEEN).unwrap_or_else(beside);
        // Chapter 4 draws what chapter 3 does: the answer names the one that was asked for.
        let chapter = case.task.chapter;
        let task = Task { chapter, ..by.task };
        let yours = reading.picture();
        let right = match rule.number == RIGHT && case.tolerance == 0 {
            true => reading.picture(),
            false => task.right_picture(reading.width, reading.height),
        };
        let difference = match Comparison::of(&right, &yours) {
            Comparison::Pixels(difference) => Some(difference),
            _ => None,
        };
        let (observations, first_pixel) = match rule.number {
            SEEN => seen::observe(&task, reading, &right),
            _ => Default::default(),
        };
        let all: Vec<_> = explanation.iter().flat_map(|it| &it.by).collect();
        let mistakes = all.iter().map(|it| &*it.slips).filter(|it| !it.is_empty());
        Self {
            rule,
            task,
            telling: telling::telling_probe(&task, &mistakes.collect::<Vec<_>>(), &case.work),
            is_answered: case.is_answered_by(&by),
            is_only_sky: case.is_only_sky(),
            repair: rule.is_repair.then(|| case.repair().cloned()).flatten(),
            shape_given_by: Vec::new(),
            explanation,
            right,
            yours,
            difference,
            observations,
            first_pixel,
        }
    }

    /// Returns true if the picture is right but for a few pixels.
    fn is_nearly_right(&self) -> bool {
        self.rule.number == crate::rules::NEARLY
    }
}
