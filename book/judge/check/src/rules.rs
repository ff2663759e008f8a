//! The rules of the judge, in the order in which the page *Check your picture* prints them: for which
//! pictures each holds, and what is then said.
//!
//! Each condition says all of itself, so that exactly one rule holds for a picture.

use std::fmt;

use crate::answer::Answer;
use crate::attempt::Attempt;
use crate::case::Case;
use crate::explanation::Explanation;
use crate::generated;
use crate::sentences::{another_task, nearly_right, right, wrong};
use crate::verdict::Finding;

/// A rule of the judge.
pub struct Rule {
    /// The number, from 1.
    pub number: u8,
    /// When the rule holds, in the words of the page.
    pub condition: &'static str,
    /// Returns true if the rule holds.
    pub(crate) holds: fn(&Case) -> bool,
    /// Returns the programs that explain the picture then.
    pub(crate) explanation: for<'c> fn(&'c Case) -> Option<&'c Explanation>,
    /// True if the repair of a typed text is told.
    pub(crate) is_repair: bool,
    /// Puts what was found into words.
    pub(crate) says: fn(&Attempt, &Finding) -> Answer,
}

/// The numbers of rules that more than the table knows.
pub(crate) const RIGHT: u8 = 1;
pub(crate) const ELSEWHERE: u8 = 2;
pub(crate) const MISTAKE: u8 = 3;
pub(crate) const NEARLY: u8 = 5;
pub(crate) const SEEN: u8 = 8;

/// All rules: the first that holds is the only one.
pub const RULES: [Rule; 8] = [
    Rule {
        number: RIGHT,
        condition: "No change draws your picture: it is *right*.",
        holds: |case| case.is_right(),
        explanation: |case| Some(case.right()),
        is_repair: false,
        says: right,
    },
    Rule {
        number: ELSEWHERE,
        condition: "It is the right picture of another chapter or probe.",
        holds: |case| case.is_elsewhere(),
        explanation: |case| case.elsewhere(),
        is_repair: false,
        says: another_task,
    },
    Rule {
        number: MISTAKE,
        condition: "A known mistake, a [*slip*](slips.md), draws it, or all but a few odd pixels of it.",
        holds: |case| case.is_open() && is_mistake_told(case),
        explanation: |case| case.mistake(),
        is_repair: false,
        says: wrong,
    },
    Rule {
        number: 4,
        condition: "In the editor of a page: one edit of *your* text makes the program right.",
        holds: |case| case.is_open() && !is_mistake_told(case) && case.repair().is_some(),
        explanation: |_| None,
        is_repair: true,
        says: wrong,
    },
    Rule {
        number: NEARLY,
        condition: "It is *right but for* so many pixels: at most a twentieth, or one level anywhere.",
        holds: |case| is_unknown(case) && case.right().is_nearly_all(),
        explanation: |case| Some(case.right()),
        is_repair: false,
        says: nearly_right,
    },
    Rule {
        number: 6,
        condition: "Two slips that are likely together draw exactly it.",
        holds: |case| is_wrong(case) && case.pair().is_some(),
        explanation: |case| case.pair(),
        is_repair: false,
        says: wrong,
    },
    Rule {
        number: 7,
        condition: "One edit such as people make while they type draws exactly it; at most five do.",
        holds: |case| is_wrong(case) && case.pair().is_none() && is_informative(case),
        explanation: |case| case.generated(),
        is_repair: false,
        says: wrong,
    },
    Rule {
        number: SEEN,
        condition: "Nothing that was tried draws it.",
        holds: |case| is_wrong(case) && case.pair().is_none() && !is_informative(case),
        explanation: |case| case.generated(),
        is_repair: false,
        says: wrong,
    },
];

/// Returns true if a known mistake is told: one is found, and it stands in the reader's files, or
/// nothing else repairs them.
fn is_mistake_told(case: &Case) -> bool {
    let mistake = case.mistake();
    mistake.is_some_and(|it| it.is_in_text || case.repair().is_none())
}

/// Returns true if neither a task, a mistake nor a repair explains the picture.
fn is_unknown(case: &Case) -> bool {
    case.is_open() && case.mistake().is_none() && case.repair().is_none()
}

/// Returns true if besides many pixels are wrong.
fn is_wrong(case: &Case) -> bool {
    is_unknown(case) && !case.right().is_nearly_all()
}

/// Returns true if few single edits draw the picture, so that they tell something of the mistake. A
/// picture of only sky tells nothing, unless the line stands in the reader's files.
fn is_informative(case: &Case) -> bool {
    let is_in_text = |it: &Explanation| it.is_in_text && !case.context.sources.is_empty();
    let found = case.generated().filter(|it| it.count <= generated::MOST);
    found.is_some_and(|it| is_in_text(it) || !case.is_only_sky())
}

impl fmt::Debug for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Rule {}", self.number)
    }
}
