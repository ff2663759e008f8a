//! What is said of a picture, in the order of the [rules](crate::rules), and in the parts below what
//! is said besides: clauses of several sentences, advice, and what `watch` says without a picture.

mod advice;
mod clauses;
mod program;

use std::iter;

use slips::{Chapter, Languages, steps};

use crate::answer::{Answer, Grade, Row, RowKind};
use crate::attempt::{Attempt, LawsStatus};
use crate::candidate::{Candidate, Conversion};
use crate::causes;
use crate::context::Context;
use crate::explanation::Explanation;
use crate::generated::Generated;
use crate::reading::Cause;
use crate::repair::Repair;
use crate::rules::{NEARLY, RIGHT, SEEN};
use crate::task::{Task, Version};
use crate::verdict::Finding;

use advice::step_says;
pub(crate) use clauses::by;
use clauses::{alternatives, differ, line_and_right, named, row, step_of};
pub use clauses::{law_rows, mistake_name, picture_done_line, printed_rows, step_done_line};
use program::{BREAKS, THE_PICTURE, breaks_a_law, right_but};
pub use program::{broken_so_far, not_compiled, not_written, refused};

/// An observation about a picture whose every ray misses.
pub(crate) const ONLY_SKY: &str = "There is only sky: no sphere is to be seen.";

/// Rule 1: the picture is right, to the last bit, within the tolerance, in a shape of its own, or as
/// far as a step; or it is right and the laws are not obeyed.
pub(crate) fn right(attempt: &Attempt, finding: &Finding) -> Answer {
    if let Some(step) = finding.task.step {
        return step_is_right(attempt, step, finding);
    }
    let by = by(&finding.task);
    let size = match (finding.yours.width(), finding.yours.height()) {
        (1, 1) => "its one pixel".to_owned(),
        (width, height) => format!("all {width} × {height} pixels"),
    };
    let same = format!("{size} of {}, to the last bit.", named(&attempt.task));
    if finding.task.size.is_some() {
        let rest = format!("{by} in this shape, which is not the book's: {same}");
        let next = attempt.shape_is(&finding.task, &finding.shape_given_by);
        return Answer::of(Grade::OnTheWay, &attempt.name, "right", rest).then(next);
    }
    if finding.levels() > 0 {
        let (off, levels) = (differ(finding.off(), finding.total()), finding.levels());
        let rest = format!("{by} within the tolerance: {off}, by at most {levels} of 255 levels.");
        return Answer::of(Grade::Right, &attempt.name, "right", rest);
    }
    match attempt.laws {
        None | Some(LawsStatus::Obeyed) => right_in_all(attempt, finding, format!("{by}: {same}")),
        Some(laws) => right_but(laws, THE_PICTURE, attempt.commands.test),
    }
}

/// Answers that nothing is left to do, with a further picture to draw and the next chapter.
fn right_in_all(attempt: &Attempt, finding: &Finding, mut rest: String) -> Answer {
    let chapter = attempt.task.chapter;
    let mut done = vec![match attempt.task.probe {
        Some(probe) => format!("{}, probe {}: right", chapter.name(), probe.name),
        None => picture_done_line(chapter),
    }];
    if attempt.laws.is_some() {
        rest += " The laws hold. They ask your functions about rays of all kinds.";
        done.push(format!("{}: the laws hold", chapter.name()));
    }
    let mut later = Chapter::OF_THE_BOOK.into_iter().filter(|&it| it > chapter);
    let next = match (&attempt.commands.start, later.next()) {
        (Some(start), Some(next)) => format!("{}: {}", next.name(), start(next)),
        (Some(_), None) => "that was the last chapter to type".to_owned(),
        (None, _) => String::new(),
    };
    let older = (finding.task.version == Version::Three).then(slips::version_3);
    Answer {
        done,
        read: older.into_iter().collect(),
        ..Answer::of(Grade::Right, &attempt.name, "right", rest)
    }
    .with(older.map(|it| Row::new(RowKind::Besides, it.why)))
    .with(attempt.to_test_more(finding))
    .then(next)
}

/// Answers that the picture shows a step on the way, counted from 0, and what the next one is.
fn step_is_right(attempt: &Attempt, step: usize, finding: &Finding) -> Answer {
    let (chapter, number) = (attempt.task.chapter, step + 1);
    let name = step_of(chapter, step);
    match attempt.laws {
        Some(LawsStatus::Broken(_) | LawsStatus::BrokenPrelude(_)) if finding.is_answered => {}
        None | Some(LawsStatus::Obeyed | LawsStatus::Unknown(_) | LawsStatus::Coming) => {}
        Some(laws) => return right_but(laws, &name, attempt.commands.test),
    }
    let again = match attempt.context.steps[step] {
        true => ", again",
        false => "",
    };
    Answer {
        done: vec![step_done_line(chapter, number)],
        ..Answer::of(Grade::OnTheWay, &name, "right", format!("{again}."))
    }
    .then(step_says(number, &steps::of_chapter(chapter)[number]))
}

/// Rule 2: the picture is the right one of another task.
pub(crate) fn another_task(attempt: &Attempt, finding: &Finding) -> Answer {
    let cause = finding.another(&attempt.task, attempt.context.languages);
    refused(&attempt.name, "wrong", &cause)
}

impl Finding {
    /// Names the other task whose right picture this is, where `wanted` was asked for.
    pub(crate) fn another(&self, wanted: &Task, languages: Languages) -> Cause {
        let tasks: Vec<Task> = self
            .explanation
            .iter()
            .flat_map(|it| &it.by)
            .map(|it| it.task)
            .collect();
        match tasks[0].chapter == wanted.chapter {
            true => another_probe(wanted, &tasks, languages),
            false => another_chapter(wanted, &tasks[0]),
        }
    }
}

fn another_chapter(wanted: &Task, other: &Task) -> Cause {
    let (own, name) = (wanted.chapter.name(), other.chapter.name());
    let by = by(other);
    let missing = match other.chapter < wanted.chapter {
        true => format!("What {own} adds is not seen: is it called, and is its answer used? "),
        false => String::new(),
    };
    Cause::new(
        "another-chapter",
        format!("this is a picture of the chapter {name}{by}, not of {own}"),
        format!("{missing}If you meant {name}: {}", other.command()),
    )
}

/// Names the probe whose picture this is, or the chapter itself, where a probe's was asked for.
fn another_probe(wanted: &Task, others: &[Task], languages: Languages) -> Cause {
    let own = wanted.chapter.name();
    let (problem, fix) = match (wanted.probe, others[0].probe) {
        (Some(probe), None) => {
            let change = wanted.change_lines(probe.width, languages);
            let change = change.replace('\n', "; ");
            (
                format!(
                    "this is the picture of the chapter itself, {own}: the change for the probe {} is not in it",
                    probe.name
                ),
                format!("change your program: {change}; then {}", wanted.command()),
            )
        }
        (wanted, _) => {
            let probes = others.iter().filter_map(|task| Some(task.probe?.name));
            let probes = probes.collect::<Vec<_>>().join(" or ");
            let wanted = wanted.map_or("the chapter itself", |wanted| wanted.name);
            (
                format!("this is the picture of the probe {probes}, not of {wanted}"),
                format!(
                    "Is the change still in your program? For the probe, the picture is right: {}",
                    others[0].command()
                ),
            )
        }
    };
    Cause::new("another-scene", problem, fix)
}

/// Rules 3, 4 and 6 to 8: the picture is wrong, with what explains it; or it is right and breaks a
/// law.
pub(crate) fn wrong(attempt: &Attempt, finding: &Finding) -> Answer {
    let (count, total) = (finding.off(), finding.total());
    let from = format!("{} from {}", differ(count, total), named(&finding.task));
    let rest = format!(": {from}{}.", by(&finding.task));
    let nearly = "right within one level, but not to the last bit";
    let answer = match finding.task.step {
        Some(step) if count == 0 => breaks_a_law(&step_of(attempt.task.chapter, step)),
        None if count == 0 => breaks_a_law(THE_PICTURE),
        _ if finding.levels() == 1 => Answer::of(Grade::Wrong, &attempt.name, nearly, rest),
        _ => Answer::of(Grade::Wrong, &attempt.name, "wrong", rest),
    };
    attempt
        .explained(answer, finding)
        .with(attempt.of_the_laws(finding))
        .with(attempt.to_tell_apart(finding))
}

/// Rule 5: the picture is right but for a few pixels.
pub(crate) fn nearly_right(attempt: &Attempt, finding: &Finding) -> Answer {
    let left = finding
        .explanation
        .as_ref()
        .map_or_else(Default::default, |it| it.left);
    let as_step = finding.task.step;
    let as_step = as_step.map_or(String::new(), |step| format!(" as step {}", step + 1));
    let but = format!("{as_step}, but for {}", left.said());
    if let Some(LawsStatus::Broken(report)) = attempt.laws
        && !finding.is_answered
    {
        let rest = format!(", and the picture is right{but}.");
        return Answer::of(Grade::Wrong, "", BREAKS, rest).with(law_rows(report));
    }
    let next = "look at these pixels: the book's program draws them otherwise";
    let next = match finding.task.size {
        Some((width, height)) => {
            let slips = causes::slips_giving(&attempt.task, width, height);
            attempt.shape_is(&finding.task, &slips)
        }
        None => next.to_owned(),
    };
    let rest = format!("{}{but}.", by(&finding.task));
    Answer::of(Grade::OnTheWay, &attempt.name, "right", rest).then(next)
}

/// How many mistakes that draw the same picture are named at most.
const NAMED: usize = 3;
/// How many warnings of a compiler are shown at most.
const WARNINGS: usize = 2;

impl Finding {
    /// Lists what explains the picture, the most important row first: after up to two warnings of
    /// the compiler, the line of a repair, programs that draw the picture, or what is to be seen.
    /// Empty if the picture is right but for a few pixels.
    pub fn rows(&self, context: &Context) -> Vec<Row> {
        let explanation = self.explanation.as_ref();
        let rows = match (self.rule.number, &self.repair, explanation) {
            (RIGHT | NEARLY, ..) => return Vec::new(),
            (_, Some(repair), _) => return repair.rows(),
            (SEEN, ..) => self.seen_rows(context),
            (_, _, Some(it)) => it.rows(context, self.is_only_sky),
            _ => Vec::new(),
        };
        let warnings = context.warnings.iter().take(WARNINGS);
        let warnings = warnings.map(|it| Row::new(RowKind::Warned, it));
        warnings.chain(rows).collect()
    }

    /// Rule 8: lists what is to be seen, the first pixel that differs, and edits of which many draw
    /// the picture.
    fn seen_rows(&self, context: &Context) -> Vec<Row> {
        let seen = self.observations.iter();
        let seen = seen.map(|it| Row::new(RowKind::Seen, it));
        let mut rows: Vec<Row> = seen.chain(self.first_pixel.iter().cloned()).collect();
        match &self.explanation {
            Some(it) => {
                let many = "many more edits of the chapter draw your picture, which does not tell them apart";
                rows.extend(it.perhaps(context));
                rows.push(Row::new(RowKind::Tried, many));
            }
            None if self.observations.len() != 1 => rows.push(nothing_known(self, context)),
            None => {}
        }
        rows
    }
}

/// Says that no known mistake was found.
fn nothing_known(finding: &Finding, context: &Context) -> Row {
    let said = match finding.task.probe {
        Some(_) => {
            "no known mistake was found that draws this picture and leaves the chapter's own right: is that one right?"
        }
        None if context.sources.is_empty() => "no known mistake was found that draws this picture",
        None => "no known mistake was found that can be in your files and draws this picture",
    };
    Row::new(RowKind::Tried, said)
}

impl Explanation {
    /// Rules 3, 6 and 7: lists the only program in full, or the first of several by their wrong
    /// lines, and how they were tried. Of a picture of only sky every line is but a *perhaps*.
    fn rows(&self, context: &Context, is_only_sky: bool) -> Vec<Row> {
        if is_only_sky && (context.sources.is_empty() || !self.is_in_text) {
            let many = "many more mistakes draw only sky: the picture can't tell them apart";
            let rows = iter::once(Row::new(RowKind::Seen, ONLY_SKY)).chain(self.perhaps(context));
            return rows.chain([Row::new(RowKind::More, many)]).collect();
        }
        let mut rows = match &self.by[..] {
            [one] => {
                // Where a part is left over, or two mistakes are made, the lines may be others.
                let is_likely = one.slips.len() == 1 && self.left.is_nothing();
                one.in_full(context, self.is_in_text && is_likely)
            }
            _ => self.perhaps(context),
        };
        rows.push(Row::new(RowKind::Tried, self.tried(context)));
        rows
    }

    /// Lists the wrong lines of the first few programs, each in C++ and in Rust.
    fn perhaps(&self, context: &Context) -> Vec<Row> {
        let all: Vec<Vec<String>> = self
            .by
            .iter()
            .take(NAMED)
            .map(|it| it.in_short(context))
            .collect();
        let rows = alternatives(all.iter().map(|it| it[0].clone()));
        let rows = rows.zip(&all).flat_map(|(line, lines)| {
            let in_rust = lines.get(1).map(|it| Row::new(RowKind::InRust, it));
            iter::once(line).chain(in_rust)
        });
        rows.collect()
    }

    /// Says how well the programs explain the picture, and whether their lines were found in the
    /// reader's files. A picture alone can come from others, too.
    fn tried(&self, context: &Context) -> String {
        let first = &self.by[0];
        let (is_edit, is_pair) = (first.edit.is_some(), first.slips.len() > 1);
        let with = match (self.count, is_edit, is_pair) {
            (1, true, _) => "this one edit".to_owned(),
            (1, _, true) => format!("both mistakes, {},", mistake_name(&first.slips)),
            (1, ..) if first.slips[0].name.is_empty() => "this mistake".to_owned(),
            (1, ..) => format!("the mistake {}", first.slips[0].name),
            (_, true, _) => "any of these edits".to_owned(),
            (_, _, true) => "any of these pairs".to_owned(),
            _ => "any of these mistakes".to_owned(),
        };
        let wrapped = match first.conversion {
            Conversion::Wrapped => ", if levels beyond 255 begin again at 0, as in a byte of C",
            _ => "",
        };
        let others = match self.count {
            1 if !context.sources.is_empty() => String::new(),
            0..=NAMED => ", and so may others".to_owned(),
            all if is_edit => format!(", and so may others; {all} were found"),
            all => format!(", and so may others; {all} are known"),
        };
        let recognized = match (self.is_in_text || is_edit, self.count > 1 || is_pair) {
            (true, _) => "",
            (false, false) => ". The wrong line was not found in your files",
            (false, true) => ". The wrong lines were not found in your files",
        };
        let drawn = self.left.drawn();
        format!("the chapter with {with} draws {drawn}{wrapped}{others}{recognized}")
    }
}

impl Candidate {
    /// Lists the wrong line, the right line and the reason of each mistake, and below them the lines
    /// in Rust that stand for those in C++. Of two mistakes only lines in one language.
    fn in_full(&self, context: &Context, is_likely: bool) -> Vec<Row> {
        if let Some(edit) = &self.edit {
            return edit.in_full();
        }
        let kind = match is_likely {
            true => RowKind::Probably,
            false => RowKind::Perhaps,
        };
        let is_one = self.slips.len() == 1;
        let rows = self.slips.iter().flat_map(|slip| {
            let said = &context.slip_lines(slip, &self.task)[0];
            let lines = match context.wrong_line(slip, &self.task) {
                Some(found) => found.rows(),
                None if said.wrong.is_empty() => {
                    vec![Row::new(kind, format!("{}  left out", said.right))]
                }
                None => line_and_right(kind, &said.wrong, &said.right),
            };
            lines
                .into_iter()
                .chain(row(RowKind::Why, slip.why).filter(|_| is_one))
        });
        let in_rust = self.slips.iter().filter(|_| is_one).flat_map(|slip| {
            let lines = context.slip_lines(slip, &self.task);
            let line = lines.into_iter().nth(1).unwrap_or_default();
            line_and_right(RowKind::InRust, &line.wrong, &line.right)
        });
        let rows = rows.chain(in_rust).filter(|it| !it.text.is_empty());
        rows.collect()
    }

    /// Writes the wrong line, in C++ with the name of the mistake, and in Rust if that is another
    /// line.
    fn in_short(&self, context: &Context) -> Vec<String> {
        if let Some(edit) = &self.edit {
            return vec![edit.in_short()];
        }
        let wrong = |n: usize| {
            let lines = self.slips.iter().map(|slip| {
                let mut lines = context.slip_lines(slip, &self.task);
                let n = n.min(lines.len() - 1);
                lines.swap_remove(n).wrong.into_owned()
            });
            lines.collect::<Vec<_>>().join("; ")
        };
        let in_rust = Some(wrong(1)).filter(|it| *it != wrong(0));
        let first = format!("{}  ({})", wrong(0), mistake_name(&self.slips));
        iter::once(first).chain(in_rust).collect()
    }
}

impl Generated {
    fn in_full(&self) -> Vec<Row> {
        match (&*self.wrong, &self.yours) {
            ("", _) => vec![Row::new(RowKind::Missing, &*self.right)],
            (_, Some(yours)) => yours.rows(),
            (wrong, None) => line_and_right(RowKind::Perhaps, wrong, &self.right),
        }
    }

    fn in_short(&self) -> String {
        match (&*self.wrong, &self.yours) {
            (_, Some(yours)) => yours.line.to_string(),
            ("", None) => format!("{}  left out", self.right),
            (wrong, None) => wrong.to_owned(),
        }
    }
}

impl Repair {
    /// Rule 4: lists the reader's wrong line with what should be there, and how that was tried.
    fn rows(&self) -> Vec<Row> {
        let tried = match self.is_hidden {
            true => "with this change your functions answer as the chapter's do",
            false => "with this change your program draws the picture",
        };
        let mut rows = self.line.rows();
        rows.push(Row::new(RowKind::Tried, tried));
        rows
    }
}
