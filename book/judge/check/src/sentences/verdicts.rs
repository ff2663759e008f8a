//! The verdict on a picture or a program, from right to none at all.

use common::rtweekend::Picture;
use laws::Report;
use slips::{Chapter, steps};

use super::advice::step_says;
use super::{
    by, differ, law_rows, named, picture_done_line, printed_rows, step_done_line, step_of,
};
use crate::answer::{Answer, Grade, Row, RowKind};
use crate::attempt::{Attempt, LawsStatus};
use crate::candidate::Unexplained;
use crate::causes;
use crate::reading::Cause;
use crate::verdict::{Finding, RightPicture, Verdict};

impl Attempt<'_> {
    /// Answers that the picture is right: to the last bit, within the tolerance, or in a shape of
    /// its own; or that it is right and the laws are not obeyed.
    pub(crate) fn right(&self, right: &RightPicture) -> Answer {
        let by = by(&right.task);
        let size = match (right.width, right.height) {
            (1, 1) => "its one pixel".to_owned(),
            (width, height) => format!("all {width} × {height} pixels"),
        };
        let same = format!("{size} of {}, to the last bit.", named(&self.task));
        if right.task.has_another_shape() {
            let rest = format!("{by} in this shape, which is not the book's: {same}");
            let next = self.shape_is(&right.task, &right.shape_given_by);
            return Answer::of(Grade::OnTheWay, &self.name, "right", rest).then(next);
        }
        if right.levels > 0 {
            let (off, levels) = (differ(right.off, right.total()), right.levels);
            let rest =
                format!("{by} within the tolerance: {off}, by at most {levels} of 255 levels.");
            return Answer::of(Grade::Right, &self.name, "right", rest);
        }
        match self.laws {
            None | Some(LawsStatus::Obeyed) => self.right_in_all(right, format!("{by}: {same}")),
            Some(laws) => right_but(laws, THE_PICTURE, self.commands.test),
        }
    }

    /// Answers that nothing is left to do, with a further picture to draw and the next chapter.
    fn right_in_all(&self, right: &RightPicture, mut rest: String) -> Answer {
        let chapter = self.task.chapter;
        let mut done = vec![match self.task.probe {
            Some(probe) => format!("{}, probe {}: right", chapter.name(), probe.name),
            None => picture_done_line(chapter),
        }];
        if self.laws.is_some() {
            rest += " The laws hold. They ask your functions about rays of all kinds.";
            done.push(format!("{}: the laws hold", chapter.name()));
        }
        let mut later = Chapter::OF_THE_BOOK.into_iter().filter(|&it| it > chapter);
        let next = match (&self.commands.start, later.next()) {
            (Some(start), Some(next)) => format!("{}: {}", next.name(), start(next)),
            (Some(_), None) => "that was the last chapter to type".to_owned(),
            (None, _) => String::new(),
        };
        let older = Some(slips::version_3()).filter(|_| right.task.is_by_version_3());
        Answer {
            done,
            read: older.into_iter().collect(),
            ..Answer::of(Grade::Right, &self.name, "right", rest)
        }
        .with(older.map(|it| Row::new(RowKind::Besides, it.why)))
        .with(self.to_test_more(right))
        .then(next)
    }

    /// Answers that the picture is right but for a few pixels.
    pub(crate) fn nearly_right(&self, finding: &Finding, unexplained: &Unexplained) -> Answer {
        let step = finding.task.step();
        let as_step = step.map_or(String::new(), |step| format!(" as step {}", step + 1));
        let but = format!("{as_step}, but for {}", unexplained.said(finding.total()));
        if let Some(LawsStatus::Broken(report)) = self.laws
            && !finding.is_answered
        {
            let rest = format!(", and the picture is right{but}.");
            return Answer::of(Grade::Wrong, "", BREAKS, rest).with(law_rows(report));
        }
        let next = if finding.task.has_another_shape() {
            let (width, height) = (finding.yours.width(), finding.yours.height());
            let slips = causes::slips_giving(&self.task, width, height);
            self.shape_is(&finding.task, &slips)
        } else {
            "look at these pixels: the book's program draws them otherwise".to_owned()
        };
        let rest = format!("{}{but}.", by(&finding.task));
        Answer::of(Grade::OnTheWay, &self.name, "right", rest).then(next)
    }

    /// Answers that the picture shows a step on the way, counted from 0, and what the next one is.
    pub(crate) fn step(&self, step: usize, finding: &Finding) -> Answer {
        let (chapter, number) = (self.task.chapter, step + 1);
        let name = step_of(chapter, step);
        match self.laws {
            Some(LawsStatus::Broken(_) | LawsStatus::BrokenPrelude(_)) if finding.is_answered => {}
            None | Some(LawsStatus::Obeyed | LawsStatus::Unknown(_) | LawsStatus::Coming) => {}
            Some(laws) => return right_but(laws, &name, self.commands.test),
        }
        let again = match self.context.steps[step] {
            true => ", again",
            false => "",
        };
        Answer {
            done: vec![step_done_line(chapter, number)],
            ..Answer::of(Grade::OnTheWay, &name, "right", format!("{again}."))
        }
        .then(step_says(number, &steps::of_chapter(chapter)[number]))
    }

    /// Answers that the picture is wrong, with what explains it; or that it is right and breaks a
    /// law.
    pub(crate) fn wrong(&self, finding: &Finding) -> Answer {
        let count = finding.difference.as_ref().map_or(0, |it| it.count);
        let (pixels, from) = (differ(count, finding.total()), named(&finding.task));
        let rest = format!(": {pixels} from {from}{}.", by(&finding.task));
        let nearly = "right within one level, but not to the last bit";
        let answer = match finding.task.step() {
            Some(step) if count == 0 => breaks_a_law(&step_of(self.task.chapter, step)),
            None if count == 0 => breaks_a_law(THE_PICTURE),
            _ if finding.levels() == 1 => Answer::of(Grade::Wrong, &self.name, nearly, rest),
            _ => Answer::of(Grade::Wrong, &self.name, "wrong", rest),
        };
        self.explained(answer, finding)
            .with(self.of_the_laws(finding))
            .with(self.to_tell_apart(finding))
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
        let seen = match (verdict, verdict.finding()) {
            // Numbers that are no levels come first.
            _ if !self.is_guessed => return None,
            (Verdict::NotAPicture { .. }, _) => return None,
            (Verdict::WrongShape { finding: None, .. }, _) => {
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

/// Answers that the subject, a picture or a step, is right, and what keeps its program from being
/// right. The command `test` shows more of a broken law.
fn right_but(laws: &LawsStatus, subject: &str, test: &str) -> Answer {
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
fn breaks_a_law(subject: &str) -> Answer {
    let rest = format!(", which must hold for every ray. {subject} alone is right.");
    Answer::of(Grade::Wrong, "", BREAKS, rest)
}

/// The verdict on a program that breaks a law.
const BREAKS: &str = "your program breaks a law";
/// The name of a picture that is not a step's.
const THE_PICTURE: &str = "The picture";

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

/// Returns the color of a picture whose pixels are all the same; `None` if two of them differ.
fn only_color(picture: &Picture) -> Option<&[u8]> {
    let mut colors = picture.rgb().chunks_exact(3);
    let first = colors.next()?;
    colors.all(|color| color == first).then_some(first)
}
