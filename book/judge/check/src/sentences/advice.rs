//! Advice on what to do next: a further picture to draw, a line to look at, a step to write.

use slips::{Slip, steps};

use super::{law_rows, named};
use crate::answer::{Row, RowKind};
use crate::attempt::{Attempt, LawsStatus};
use crate::blind_spots::{self, NextPicture};
use crate::task::Task;
use crate::verdict::{Finding, RightPicture};

impl Attempt<'_> {
    /// Returns the rows that the laws add to a wrong picture: the broken law, or that all of them
    /// hold; none if the lines to mend are known.
    pub(super) fn of_the_laws(&self, finding: &Finding) -> Vec<Row> {
        let is_unknown = finding.mistakes.as_ref().is_none_or(|it| !it.is_in_text);
        let hold = "hold: look at what calls the function, and at what becomes of its answer";
        match self.laws {
            _ if finding.repair.is_some() => Vec::new(),
            Some(LawsStatus::Broken(report)) if !finding.is_answered || is_unknown => {
                law_rows(report)
            }
            Some(LawsStatus::Obeyed) if is_unknown => vec![Row::new(RowKind::Laws, hold)],
            _ => Vec::new(),
        }
    }

    /// Returns the row that names the chapter that was guessed. Chapters 3 and 4 draw the same
    /// picture, so that both are named.
    pub(crate) fn taken_for(&self) -> Row {
        let other = self.task.with_the_other_formula();
        let also = other.map_or(String::new(), |it| format!(" or {}", it.chapter.name()));
        let said = format!("the picture was taken for {}{also}", named(&self.task));
        Row::new(RowKind::Besides, said)
    }

    /// Proposes a further picture, which shows mistakes that the right one hides: of those that
    /// the reader can have made, and with which the functions would answer as they do. `None` if
    /// no mistake is hidden.
    pub(super) fn to_test_more(&self, right: &RightPicture) -> Option<Row> {
        let chapter = self.task.chapter;
        let may_be = |slip: &Slip| {
            self.context.can_be_made(slip, &self.task)
                && (self.context.answers)
                    .is_none_or(|compare| compare(&slip.program(chapter)).differing == 0)
        };
        let NextPicture { task, width, .. } =
            &blind_spots::next_picture(&right.task, right.width, may_be)?;
        // A program may have its height as a number.
        let line = format!("image_width = {width}");
        let both = format!("{line}, so that image_height is {}", task.height(*width));
        let change = task.change_lines(*width, self.context.languages);
        let change = change.replace('\n', "; ").replacen(&line, &both, 1);
        let (name, what) = match task.probe {
            Some(probe) => (probe.name, format!("the probe {}", probe.name)),
            None => ("", format!("the chapter {width} pixels wide")),
        };
        let judge = (self.commands.judge)(task.probe);
        let said = format!("to test more, draw {what}: {change}; then {judge}");
        Some(Row::new(RowKind::Probe(name), said))
    }

    /// Proposes a probe that tells apart mistakes that draw the same picture; `None` if no probe
    /// does.
    pub(super) fn to_tell_apart(&self, finding: &Finding) -> Option<Row> {
        let probe = finding.mistakes.as_ref()?.telling?;
        let change = probe.instructions(finding.task.chapter, self.context.languages);
        let change = change.replace('\n', "; ");
        let (name, judge) = (probe.name, (self.commands.judge)(Some(probe)));
        let said = format!(
            "draw the probe {name}, which tells some of these mistakes apart: {change}; then {judge}"
        );
        Some(Row::new(RowKind::Probe(name), said))
    }

    /// Advises on a shape that is not the book's: it may be a choice, or the work of these slips.
    pub(super) fn shape_is(&self, task: &Task, slips: &[&Slip]) -> String {
        let said = |slip: &&Slip| {
            let wrong = self.context.slip_lines(slip, task).swap_remove(0).wrong;
            format!("{} ({wrong})", slip.name)
        };
        let slips: Vec<String> = slips.iter().map(said).collect();
        let look = match &slips[..] {
            [] => String::new(),
            slips => format!("; if not, look for {}", slips.join(", or ")),
        };
        format!("if you chose the shape, nothing is wrong{look}")
    }
}

/// Says what to write in the step at an index from 0: `step 1: …`.
pub(super) fn step_says(at: usize, step: &steps::ChapterStep) -> String {
    format!("step {}: {}", at + 1, step.instruction)
}
