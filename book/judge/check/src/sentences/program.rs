//! What is said of a program: that it breaks a law, does not compile, is not written, or has no
//! picture.

use laws::Report;
use slips::{Chapter, steps};

use super::advice::step_says;
use super::clauses::{law_rows, printed_rows};
use crate::answer::{Answer, Grade, Row, RowKind};
use crate::attempt::LawsStatus;
use crate::reading::Cause;

/// Answers that the subject, a picture or a step, is right, and what keeps its program from being
/// right. The command `test` shows more of a broken law.
pub(super) fn right_but(laws: &LawsStatus, subject: &str, test: &str) -> Answer {
    let is = |grade, rest: &str| Answer::of(grade, subject, "right", rest);
    match laws {
        LawsStatus::Broken(report) | LawsStatus::BrokenPrelude(report) => {
            breaks_a_law(subject).with(law_rows(report)).then(test)
        }
        LawsStatus::NotWritten(place) | LawsStatus::UnwrittenPrelude(place) => {
            let rest =
                format!(", but a function is not written yet: there is a todo!() at {place}.");
            let next = "write it as well: the laws ask the function, and a later picture needs it";
            is(Grade::OnTheWay, &rest).then(next)
        }
        LawsStatus::Unknown(errors) => {
            is(Grade::OnTheWay, ", but the laws can't be tried.").with(printed_rows(errors))
        }
        LawsStatus::Coming | LawsStatus::Obeyed => {
            is(Grade::OnTheWay, ". The laws are still being built.")
                .then("as soon as the laws are built, they ask your functions")
        }
    }
}

/// Answers that a program breaks a law, though what it draws, the subject, is right.
pub(super) fn breaks_a_law(subject: &str) -> Answer {
    let rest = format!(", which must hold for every ray. {subject} alone is right.");
    Answer::of(Grade::Wrong, "", BREAKS, rest)
}

/// The verdict on a program that breaks a law.
pub(super) const BREAKS: &str = "your program breaks a law";
/// The name of a picture that is not a step's.
pub(super) const THE_PICTURE: &str = "The picture";

/// Answers that what is called `name`, such as a file, is no picture or not the right one: `name is
/// verdict`, with the problem, and its fix as what to do next. The answer is graded wrong if the
/// verdict is the word `wrong`, else as no picture.
pub fn refused(name: &str, verdict: &str, cause: &Cause) -> Answer {
    let grade = match verdict {
        "wrong" => Grade::Wrong,
        _ => Grade::NoPicture,
    };
    let rest = format!(": {}.", cause.problem);
    Answer::of(grade, name, verdict, rest).then(&cause.fix)
}

/// Answers that the compiler refuses the program. `errors` is the number of errors that it found,
/// at least 1, and `first` are the rows about the first of them.
pub fn not_compiled(errors: usize, first: Vec<Row>) -> Answer {
    let more = match errors {
        1 => String::new(),
        all => format!(" This is the first of {all} errors."),
    };
    Answer::sentence(Grade::Wrong, format!("The program does not compile.{more}")).with(first)
}

/// Answers that the program stopped at the `todo!()` in `place`, such as `src/lib.rs:12`. Names the
/// functions that obey the laws so far, `obeyed`, if there are any, and the first step of the
/// chapter as what to do next.
pub fn not_written(chapter: Chapter, place: &str, obeyed: &[String]) -> Answer {
    let so_far = format!("hold so far for {}", obeyed.join(", "));
    let step = steps::of_chapter(chapter).first();
    let verdict = format!("Not written yet: todo!() at {place}.");
    Answer::sentence(Grade::OnTheWay, verdict)
        .with((!obeyed.is_empty()).then(|| Row::new(RowKind::Laws, so_far)))
        .then(step.map_or(String::new(), |step| step_says(0, step)))
}

/// Answers that a program that stopped at the `todo!()` in `place`, such as `src/lib.rs:12`, breaks
/// the law of the report before that.
pub fn broken_so_far(report: &Report, place: &str) -> Answer {
    let verdict = "A function that is written so far breaks a law.";
    Answer::sentence(Grade::Wrong, verdict)
        .with(law_rows(report))
        .then(format!("put this right, and then go on at {place}"))
}
