//! Advice on what to do next: a further picture to draw, a line to look at, a step to write.

use common::rtweekend::Picture;
use slips::{Chapter, Slip, steps};

use super::clauses::{law_rows, named};
use crate::answer::{Answer, Grade, Row, RowKind};
use crate::attempt::{Attempt, LawsStatus};
use crate::blind_spots::{self, NextPicture};
use crate::task::Task;
use crate::verdict::{Finding, Refusal, RefusalKind, Verdict};

impl Attempt<'_> {
    /// Returns the rows that the laws add to a wrong picture: the broken law, or that all of them
    /// hold; none if the lines to mend are known.
    pub(super) fn of_the_laws(&self, finding: &Finding) -> Vec<Row> {
        let mistake = finding
            .explanation
            .as_ref()
            .filter(|_| !finding.mistakes().is_empty());
        let is_unknown = mistake.is_none_or(|it| !it.is_in_text);
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
        let also = match self.task.chapter {
            Chapter::Normals => " or half_b_sphere",
            Chapter::HalfBSphere => " or normals",
            _ => "",
        };
        let said = format!("the picture was taken for {}{also}", named(&self.task));
        Row::new(RowKind::Besides, said)
    }

    /// Proposes a further picture, which shows mistakes that the right one hides: of those that
    /// the reader can have made, and with which the functions would answer as they do. `None` if
    /// no mistake is hidden.
    pub(super) fn to_test_more(&self, right: &Finding) -> Option<Row> {
        let chapter = self.task.chapter;
        let may_be = |slip: &Slip| {
            self.context.can_be_made(slip, &self.task)
                && (self.context.answers)
                    .is_none_or(|compare| compare(&slip.program(chapter)).differing == 0)
        };
        let NextPicture { task, width, .. } =
            &blind_spots::next_picture(&right.task, right.yours.width(), may_be)?;
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
        let probe = finding.telling?;
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

    /// Adds the rows that explain a picture to the answer, and the pages on its slips.
    pub(crate) fn explained(&self, answer: Answer, finding: &Finding) -> Answer {
        let slips = finding.only_mistake().iter().copied();
        Answer {
            read: slips.filter(|slip| !slip.page.is_empty()).collect(),
            ..answer
        }
        .with(finding.rows(self.context))
    }

    /// Answers that a picture whose chapter was guessed is not recognized: it has one color, no
    /// chapter's shape, or pixels that are unexplained and unlike the guessed chapter's. `None` for
    /// any other picture.
    pub(crate) fn unrecognized(&self, verdict: &Verdict) -> Option<Answer> {
        let is_shape = |it: &Refusal| it.kind != RefusalKind::NotAPicture;
        // Numbers that are no levels come first.
        if !self.is_guessed || !verdict.refusal.as_ref().is_none_or(is_shape) {
            return None;
        }
        let seen = match (&verdict.refusal, verdict.finding()) {
            (Some(it), None) if it.kind == RefusalKind::WrongShape => {
                "it has the shape of none of these chapters' pictures".to_owned()
            }
            (_, finding) => match only_color(&finding?.yours) {
                Some(color) => format!("it is {color:?} everywhere, and many mistakes draw that"),
                None if finding?.is_unlike() => "it is found neither among the pictures of these \
                     chapters, nor among those with a mistake"
                    .to_owned(),
                None => return None,
            },
        };
        let rest = format!(": {seen}.");
        let next = "name the chapter: the picture is then compared with the chapter's own";
        Some(Answer::of(Grade::Wrong, &self.name, "not recognized", rest).then(next))
    }
}

/// Says what to write in the step at an index from 0: `step 1: …`.
pub(super) fn step_says(at: usize, step: &steps::ChapterStep) -> String {
    format!("step {}: {}", at + 1, step.instruction)
}

/// Returns the color of a picture whose pixels are all the same; `None` if two of them differ.
fn only_color(picture: &Picture) -> Option<&[u8]> {
    let mut colors = picture.rgb().chunks_exact(3);
    let first = colors.next()?;
    colors.all(|color| color == first).then_some(first)
}
