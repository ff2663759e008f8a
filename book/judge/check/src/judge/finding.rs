//! The making of a [`Finding`]: what explains a picture.

use difference::Comparison;
use slips::Slip;

use super::explain::{Explanation, Fit, explain};
use crate::candidate::Candidate;
use crate::context::{Context, Evidence};
use crate::reading::Reading;
use crate::search::DrawingMutants;
use crate::task::Task;
use crate::verdict::{Finding, Mistakes};
use crate::{seen, telling};

impl Finding {
    /// Explains the picture: by a repair of the reader's lines, by programs, or by what is seen.
    ///
    /// # Errors
    /// The other tasks whose right picture this is, if it shows one.
    pub(super) fn of(
        task: &Task,
        reading: &Reading,
        context: &Context,
    ) -> Result<Box<Self>, Vec<Task>> {
        let evidence = Evidence::new(task, reading, context);
        let finding = match explain(&evidence) {
            Explanation::Another(tasks) => return Err(tasks),
            // The width that a probe is about was forgotten.
            Explanation::AlmostRight(fit)
                if fit.unexplained.is_nothing() && evidence.task.probe != task.probe =>
            {
                return Err(vec![evidence.task]);
            }
            Explanation::AlmostRight(fit) => Self {
                almost_right: Some(fit.unexplained),
                ..Self::beside(&evidence, &fit.candidates[0])
            },
            Explanation::Mistakes(fit) => Self {
                mistakes: Some(Mistakes::of(&fit)),
                ..Self::beside(&evidence, &fit.candidates[0])
            },
            Explanation::Nothing(right) => Self {
                repair: evidence.repair().cloned(),
                ..Self::unknown(&evidence, &right)
            },
        };
        Ok(Box::new(finding))
    }

    /// Makes a finding beside the right picture of a candidate's task, as yet without explanation.
    fn beside(evidence: &Evidence, by: &Candidate) -> Self {
        let (reading, mut task) = (evidence.reading, by.task);
        // Chapter 4 draws what chapter 3 does: the answer names the one that the reader types.
        task.chapter = evidence.task.chapter;
        let right = task.right_picture(reading.width, reading.height);
        let yours = reading.picture();
        let difference = match Comparison::of(&right, &yours) {
            Comparison::Pixels(difference) => Some(difference),
            _ => None,
        };
        let program = by.task.without_probe().program(&by.slips);
        Self {
            task,
            right,
            yours,
            difference,
            almost_right: None,
            mistakes: None,
            drawn: DrawingMutants::default(),
            observations: Vec::new(),
            first_pixel: Vec::new(),
            repair: None,
            is_answered: evidence.context.is_answered_by(&program),
        }
    }

    /// Makes a finding of what is seen, and of the single edits that draw the picture, where no
    /// known program does.
    fn unknown(evidence: &Evidence, right: &Candidate) -> Self {
        let mut finding = Self::beside(evidence, right);
        (finding.observations, finding.first_pixel) =
            seen::observe(&finding.task, evidence.reading, &finding.right);
        if evidence.repair().is_none() {
            finding.drawn = evidence.drawing_mutants(&right.task).clone();
        }
        finding
    }
}

impl Mistakes {
    /// Makes the mistakes of a fit, with the probe that tells them apart.
    fn of(fit: &Fit) -> Self {
        let first = &fit.candidates[0];
        let all: Vec<Vec<&'static Slip>> =
            fit.candidates.iter().map(|it| it.slips.clone()).collect();
        Self {
            task: first.task,
            telling: telling::telling_probe(&first.task, &all),
            all,
            conversion: first.conversion,
            is_in_text: fit.is_in_text,
            unexplained: fit.unexplained,
        }
    }
}
