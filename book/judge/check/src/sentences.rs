//! All that a reader is told, in the order in which it is read: the verdict, what explains it, and
//! what to do next.

use std::iter;

use common::rtweekend::Picture;
use laws::Report;
use slips::{Chapter, Edition, ReaderLanguage, Slip, steps};

use crate::answer::{Answer, Attempt, Grade, LawsStatus, Row, RowKind};
use crate::blind_spots::{self, NextPicture};
use crate::candidate::{Conversion, Unexplained};
use crate::causes;
use crate::context::Context;
use crate::names;
use crate::reading::Cause;
use crate::search::{Change, Correction, DrawingMutants, Mutant, Repair};
use crate::sources::CorrectedLine;
use crate::task::Task;
use crate::verdict::{Finding, Mistakes, RightPicture, Verdict};

/// So many mistakes that draw the same are named.
const NAMED: usize = 3;
/// So many warnings of a compiler are shown.
const WARNINGS: usize = 2;

// 1. The verdict on a picture, from right to none.

impl Attempt<'_> {
    pub(crate) fn right(&self, right: &RightPicture) -> Answer {
        let by = by(&right.editions);
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
            let rest = format!("{by} as far as is tolerated: {off}, by no more than {levels}.");
            return Answer::of(Grade::Right, &self.name, "right", rest);
        }
        match self.laws {
            None | Some(LawsStatus::Obeyed) => self.right_in_all(right, format!("{by}: {same}")),
            Some(laws) => right_but(laws, "The picture", self.commands.test),
        }
    }

    fn right_in_all(&self, right: &RightPicture, mut rest: String) -> Answer {
        let chapter = self.task.chapter;
        let mut done = vec![match self.task.probe {
            Some(probe) => format!("{}, probe {}: right", chapter.name(), probe.name),
            None => picture_is_right(chapter),
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
        Answer {
            done,
            ..Answer::of(Grade::Right, &self.name, "right", rest)
        }
        .with(self.to_test_more(right))
        .then(next)
    }

    /// Right but for odd pixels.
    pub(crate) fn nearly_right(&self, finding: &Finding, unexplained: &Unexplained) -> Answer {
        let step = finding.task.step();
        let as_step = step.map_or(String::new(), |step| format!(" as step {}", step + 1));
        let but = format!("{as_step}, but for {}", unexplained.said(finding.total()));
        if let Some(LawsStatus::Broken(report)) = self.laws
            && !finding.is_answered
        {
            let rest = format!("{but}; and a law is broken.");
            return Answer::of(Grade::Wrong, &self.name, "right", rest).with(law(report));
        }
        let next = if finding.task.has_another_shape() {
            let (width, height) = (finding.yours.width(), finding.yours.height());
            let slips = causes::slips_giving(&self.task, width, height);
            self.shape_is(&finding.task, &slips)
        } else {
            "look at these pixels: the book's program draws them otherwise".to_owned()
        };
        let rest = format!("{}{but}.", by(&finding.editions));
        Answer::of(Grade::OnTheWay, &self.name, "right", rest).then(next)
    }

    pub(crate) fn step(&self, step: usize, finding: &Finding) -> Answer {
        let (chapter, number) = (self.task.chapter, step + 1);
        let name = step_of(chapter, step);
        match self.laws {
            Some(LawsStatus::Broken(_) | LawsStatus::BrokenPrelude(_)) if finding.is_answered => {}
            None | Some(LawsStatus::Obeyed | LawsStatus::Unknown(_) | LawsStatus::Coming) => {}
            Some(laws) => return right_but(laws, &name, self.commands.test),
        }
        let again = if self.context.steps[step] {
            ", again"
        } else {
            ""
        };
        Answer {
            done: vec![step_is_done(chapter, number)],
            ..Answer::of(Grade::OnTheWay, &name, "right", format!("{again}."))
        }
        .then(step_says(number, &steps::of_chapter(chapter)[number]))
    }

    pub(crate) fn wrong(&self, finding: &Finding) -> Answer {
        let count = finding.difference.as_ref().map_or(0, |it| it.count);
        let (pixels, from) = (differ(count, finding.total()), named(&finding.task));
        let rest = format!(": {pixels} from {from}{}.", by(&finding.editions));
        let nearly = "right within one level, but not to the last bit";
        let answer = match finding.task.step() {
            Some(step) if count == 0 => {
                let name = step_of(self.task.chapter, step);
                Answer::of(Grade::Wrong, &name, "right", BUT_A_LAW)
            }
            None if count == 0 => Answer::of(Grade::Wrong, "The picture", "right", BUT_A_LAW),
            _ if finding.levels() == 1 => Answer::of(Grade::Wrong, &self.name, nearly, rest),
            _ => Answer::of(Grade::Wrong, &self.name, "wrong", rest),
        };
        self.explained(answer, finding)
            .with(self.of_the_laws(finding))
            .with(self.to_tell_apart(finding))
    }

    /// Adds what explains a picture, and the pages that tell how it is right.
    pub(crate) fn explained(&self, answer: Answer, finding: &Finding) -> Answer {
        let read = finding.single().iter().filter(|slip| !slip.page.is_empty());
        Answer {
            read: read.copied().collect(),
            ..answer
        }
        .with(finding.rows(self.context))
    }

    /// Returns what is seen, where the chapter was guessed and the picture says too little of it.
    pub(crate) fn unrecognized(&self, verdict: &Verdict) -> Option<Answer> {
        let seen = match (verdict, verdict.finding()) {
            // Levels that are none are said first.
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
        let next = "name the chapter, and the picture is compared with that";
        Some(Answer::of(Grade::Wrong, &self.name, "not recognized", rest).then(next))
    }
}

/// A right picture, of a step or of all, and what keeps its program from being right.
fn right_but(laws: &LawsStatus, subject: &str, test: &str) -> Answer {
    let is = |grade, rest: &str| Answer::of(grade, subject, "right", rest);
    match laws {
        LawsStatus::Broken(report) | LawsStatus::BrokenPrelude(report) => {
            is(Grade::Wrong, BUT_A_LAW).with(law(report)).then(test)
        }
        LawsStatus::NotWritten(place) | LawsStatus::UnwrittenPrelude(place) => {
            let rest = format!(", but not all is written: there is a todo!() at {place}.");
            let next = "write that as well: the laws ask for it, and a later picture needs it";
            is(Grade::OnTheWay, &rest).then(next)
        }
        LawsStatus::Unknown(errors) => {
            is(Grade::OnTheWay, ", but the laws can't be tried.").with(printed(errors))
        }
        LawsStatus::Coming | LawsStatus::Obeyed => {
            is(Grade::OnTheWay, ". The laws are still being built.")
                .then("as soon as the laws are built, they ask your functions")
        }
    }
}

const BUT_A_LAW: &str = ", but a law is broken, which must hold for every ray.";

/// Answers that there is no picture of the program or file, or none of the right shape.
pub fn refused(name: &str, verdict: &str, cause: &Cause) -> Answer {
    let grade = match verdict {
        "wrong" => Grade::Wrong,
        _ => Grade::NoPicture,
    };
    let rest = format!(": {}.", cause.problem);
    Answer::of(grade, name, verdict, rest).then(&cause.fix)
}

/// Answers that the compiler refuses the text, with the first of so many complaints.
pub fn not_compiled(complaints: usize, first: Vec<Row>) -> Answer {
    let more = match complaints {
        1 => String::new(),
        all => format!(" This is the first of {all} errors."),
    };
    Answer::sentence(Grade::Wrong, format!("It does not compile.{more}")).with(first)
}

/// Answers that the program stopped at a `todo!()`. What obeys the laws so far is named.
pub fn not_written(chapter: Chapter, place: &str, obeyed: &[String]) -> Answer {
    let so_far = format!("so far they hold for {}", obeyed.join(", "));
    let step = steps::of_chapter(chapter).first();
    Answer::sentence(
        Grade::OnTheWay,
        format!("Not written yet: todo!() at {place}."),
    )
    .with((!obeyed.is_empty()).then(|| Row::new(RowKind::Laws, so_far)))
    .then(step.map_or(String::new(), |step| step_says(0, step)))
}

/// Answers that what is written so far breaks a law, where the program stopped at a `todo!()`.
pub fn broken_so_far(report: &Report, place: &str) -> Answer {
    Answer::sentence(Grade::Wrong, "A law is broken in what is written so far.")
        .with(law(report))
        .then(format!("put this right, and then go on at {place}"))
}

// 2. What explains the verdict.

impl Finding {
    /// Lists what explains the picture, or else what is to be seen.
    pub fn rows(&self, context: &Context) -> Vec<Row> {
        if let Some(repair) = &self.repair {
            let slip = self.single().first();
            let why = slip.map_or("", |slip| context.words(slip, &self.task).why);
            return repair.rows().chain(row(RowKind::Why, why)).collect();
        }
        if self.almost_right.is_some() {
            return Vec::new();
        }
        let warnings = context.warnings.iter().take(WARNINGS);
        let warnings = warnings.map(|it| Row::new(RowKind::Warned, it));
        warnings.chain(self.explained(context)).collect()
    }

    fn explained(&self, context: &Context) -> Vec<Row> {
        // A hundred mistakes draw only sky: a picture alone tells none of them.
        let is_sky = self.shows_only_sky();
        match &self.mistakes {
            Some(it) if is_sky && (context.sources.is_empty() || !it.is_in_text) => {
                let many = "and many others draw only sky: the picture does not tell which it is";
                let rows = iter::once(Row::new(RowKind::Seen, ONLY_SKY)).chain(it.perhaps(context));
                return rows.chain(row(RowKind::More, many)).collect();
            }
            Some(it) => return it.rows(context, self.total()),
            None if self.drawn.is_told() => return self.drawn.rows(context, &self.task),
            None => {}
        }
        let seen = self.sights.iter().map(|it| Row::new(RowKind::Seen, it));
        let seen = seen.chain(self.first.iter().cloned());
        let drawn = self.drawn.rows(context, &self.task);
        let unknown =
            (drawn.is_empty() && self.sights.len() != 1).then(|| self.nothing_known(context));
        seen.chain(drawn).chain(unknown).collect()
    }

    fn nothing_known(&self, context: &Context) -> Row {
        let said = match self.task.probe {
            Some(_) => {
                "no known mistake draws this picture and the chapter's own right: is that right?"
            }
            None if context.sources.is_empty() => "no known mistake draws this picture",
            None => "no known mistake that your files can have draws this picture",
        };
        Row::new(RowKind::Tried, said)
    }
}

/// What is seen where each ray misses.
pub(crate) const ONLY_SKY: &str = "There is only sky: no sphere is to be seen.";

impl Mistakes {
    fn rows(&self, context: &Context, pixels: usize) -> Vec<Row> {
        let rows = match &self.all[..] {
            [mistake] => self.in_full(mistake, context),
            _ => self.perhaps(context).collect(),
        };
        rows.into_iter()
            .chain([Row::new(RowKind::Tried, self.tried(pixels))])
            .collect()
    }

    fn in_full(&self, mistake: &[&'static Slip], context: &Context) -> Vec<Row> {
        let rows = mistake.iter().flat_map(|slip| {
            let words = context.words(slip, &self.task);
            let kind = match self.is_in_text {
                true => RowKind::Probably,
                false => RowKind::Perhaps,
            };
            let lines = match context.line_of(slip, &self.task) {
                Some(found) => found.rows(),
                None => line_and_right(kind, &words.wrong, &words.right),
            };
            let lines = lines.into_iter().filter(|it| !it.text.is_empty());
            lines.chain(row(RowKind::Why, words.why))
        });
        rows.collect()
    }

    /// The first of several, each in the reader's language.
    fn perhaps(&self, context: &Context) -> impl Iterator<Item = Row> {
        let wrong = |mistake: &Vec<&'static Slip>| {
            let words = mistake.iter().map(|slip| context.words(slip, &self.task));
            let wrong: Vec<String> = words.map(|words| words.wrong.into_owned()).collect();
            format!("{}  ({})", wrong.join("; "), names_of(mistake))
        };
        alternatives(self.all.iter().take(NAMED).map(wrong))
    }

    /// By what the mistakes were tried, and how well they explain a picture of so many pixels.
    fn tried(&self, pixels: usize) -> String {
        let is_pair = self.all[0].len() > 1;
        let with = match (&self.all[..], is_pair) {
            ([one], false) if one[0].name.is_empty() => "this mistake".to_owned(),
            ([one], false) => format!("the mistake {}", one[0].name),
            ([one], true) => format!("both mistakes, {},", names_of(one)),
            (_, false) => "any of these mistakes".to_owned(),
            (_, true) => "any of these pairs".to_owned(),
        };
        let draws = match self.unexplained.is_nothing() {
            true => "draws exactly your picture".to_owned(),
            false => format!(
                "draws your picture, but for {}",
                self.unexplained.said(pixels)
            ),
        };
        let wrapped = match self.conversion {
            Conversion::Wrapped => ", if levels beyond 255 begin again at 0, as in a byte of C",
            _ => "",
        };
        let others = match self.all.len() {
            1 => String::new(),
            2..=NAMED => ", and so may others".to_owned(),
            all => format!(", and so may others; {all} are known"),
        };
        let recognized = match (self.is_in_text, self.all.len() > 1 || is_pair) {
            (true, _) => "",
            (false, false) => ". Its line was not found in your files",
            (false, true) => ". Their lines were not found in your files",
        };
        format!("the chapter with {with} {draws}{wrapped}{others}{recognized}")
    }
}

impl DrawingMutants {
    /// The likeliest edits, each in the reader's language.
    fn rows(&self, context: &Context, task: &Task) -> Vec<Row> {
        let language = context
            .language
            .unwrap_or(ReaderLanguage::Cpp(task.edition));
        let typed = |line: &str| language.spelled(line, task.chapter);
        let said = |it: &Mutant| match (&*it.wrong, &it.yours) {
            (_, Some(yours)) => yours.line.to_string(),
            ("", None) => format!("{}  left out", typed(&it.right)),
            (wrong, None) => typed(wrong),
        };
        let (rows, tried) = match &self.all[..] {
            [] => return Vec::new(),
            [it] if self.count == 1 => {
                let rows = match (&*it.wrong, &it.yours) {
                    ("", _) => vec![Row::new(RowKind::Missing, typed(&it.right))],
                    (_, Some(yours)) => yours.rows(),
                    (wrong, None) => {
                        line_and_right(RowKind::Perhaps, &typed(wrong), &typed(&it.right))
                    }
                };
                (
                    rows,
                    "the chapter with this one edit draws exactly your picture",
                )
            }
            all => {
                let tried = match self.is_told() {
                    true => {
                        "the chapter with any of these edits draws exactly your picture, and so may others"
                    }
                    false => {
                        "many more edits of the chapter draw your picture: it does not tell which it is"
                    }
                };
                (alternatives(all.iter().map(said)).collect(), tried)
            }
        };
        rows.into_iter().chain(row(RowKind::Tried, tried)).collect()
    }
}

impl Repair {
    /// The reader's lines and what should be there, and that it was tried.
    fn rows(&self) -> impl Iterator<Item = Row> {
        let with = match self.changes.len() {
            1 => "with it",
            _ => "with all of this",
        };
        let is_spelled = |it: &Change| matches!(it.right, Correction::InOwnLanguage(_));
        let tried = if self.changes.iter().all(is_spelled) {
            "the chapter with your line in its place draws your picture".to_owned()
        } else if self.is_hidden {
            format!("{with} your functions answer as the chapter's do")
        } else {
            format!("{with} your program draws the picture")
        };
        let changes = self.changes.iter().flat_map(Change::rows);
        changes.chain(row(RowKind::Tried, &tried))
    }
}

impl Change {
    fn rows(&self) -> Vec<Row> {
        let right = match &self.right {
            Correction::Above(line) => {
                let above = format!("above {}:{}  {line}", self.yours.file, self.yours.number);
                return vec![Row::new(RowKind::Missing, above)];
            }
            Correction::Instead(line) | Correction::InOwnLanguage(line) => line,
            Correction::LeaveOut => "left out",
        };
        line_and_right(RowKind::Yours, &self.yours.to_string(), right)
    }
}

impl CorrectedLine {
    fn rows(&self) -> Vec<Row> {
        line_and_right(RowKind::Yours, &self.line.to_string(), &self.right)
    }
}

impl Attempt<'_> {
    /// Returns what the laws add to a wrong picture.
    fn of_the_laws(&self, finding: &Finding) -> Vec<Row> {
        let is_unknown = finding.mistakes.as_ref().is_none_or(|it| !it.is_in_text);
        let hold = "they hold: look at what calls the function, and what becomes of its answer";
        match self.laws {
            _ if finding.repair.is_some() => Vec::new(),
            Some(LawsStatus::Broken(report)) if !finding.is_answered || is_unknown => law(report),
            Some(LawsStatus::Obeyed) if is_unknown => vec![Row::new(RowKind::Laws, hold)],
            _ => Vec::new(),
        }
    }
}

/// Lists the parts of a report on a broken law.
pub fn law(report: &Report) -> Vec<Row> {
    let broken = &report.broken;
    let kinds = iter::once(RowKind::SameAs).chain(iter::repeat(RowKind::More));
    let same_as = kinds
        .zip(&report.same_as)
        .map(|(kind, it)| Row::new(kind, it));
    let rows = [
        (RowKind::Law, &*broken.law),
        (RowKind::Found, &broken.found),
        (RowKind::Allowed, &broken.allowed),
    ];
    let rows = rows.into_iter().map(|(kind, it)| Row::new(kind, it));
    rows.chain(same_as)
        .chain([Row::new(RowKind::Read, &*broken.read)])
        .collect()
}

/// Lists what somebody else has printed, line by line, without what a terminal would obey.
pub fn printed(text: &str) -> Vec<Row> {
    let lines = text.lines();
    lines
        .map(|line| Row::new(RowKind::Printed, names::escape_for_terminal(line)))
        .collect()
}

impl Attempt<'_> {
    /// The chapter that was guessed; chapters 3 and 4 draw the same picture.
    pub(crate) fn taken_for(&self) -> Row {
        let also = self
            .task
            .with_the_other_formula()
            .map(|other| other.chapter);
        let also = also.map_or(String::new(), |other| format!(" or {}", other.name()));
        Row::new(
            RowKind::Besides,
            format!("it was taken for {}{also}", named(&self.task)),
        )
    }
}

// 3. What to do next.

impl Attempt<'_> {
    /// A further picture that shows most of what can hide from a right one: but not what the
    /// reader can't have done, nor what would answer otherwise.
    fn to_test_more(&self, right: &RightPicture) -> Option<Row> {
        let chapter = self.task.chapter;
        let may_be = |slip: &Slip| {
            self.context.can_be_made(slip, &self.task)
                && (self.context.answers)
                    .is_none_or(|compare| compare(&slip.program(chapter)).differing == 0)
        };
        let NextPicture { task, width, .. } = &blind_spots::next(&right.task, right.width, may_be)?;
        // A program may have its height as a number.
        let line = format!("image_width = {width}");
        let both = format!("{line}, so that image_height is {}", task.height(*width));
        let change = task
            .change(*width, self.context.language)
            .replace('\n', "; ");
        let change = change.replacen(&line, &both, 1);
        let (name, what) = match task.probe {
            Some(probe) => (probe.name, format!("the probe {}", probe.name)),
            None => ("", format!("it {width} wide")),
        };
        let judge = (self.commands.judge)(task.probe);
        let said = format!("to test more, draw {what}: {change}; then {judge}");
        Some(Row::new(RowKind::Probe(name), said))
    }

    /// A small change of scene that tells mistakes apart which draw the same.
    fn to_tell_apart(&self, finding: &Finding) -> Option<Row> {
        let probe = finding.mistakes.as_ref()?.telling?;
        let change = probe
            .lines(finding.task.chapter, self.context.language)
            .replace('\n', "; ");
        let (name, judge) = (probe.name, (self.commands.judge)(Some(probe)));
        let said = format!(
            "draw the probe {name}, which tells some of them apart: {change}; then {judge}"
        );
        Some(Row::new(RowKind::Probe(name), said))
    }

    /// Returns what is to be thought of a shape that is not the book's.
    fn shape_is(&self, task: &Task, slips: &[&Slip]) -> String {
        let said =
            |slip: &&Slip| format!("{} ({})", slip.name, self.context.words(slip, task).wrong);
        let look = match slips {
            [] => String::new(),
            slips => {
                let slips = slips.iter().map(said).collect::<Vec<_>>();
                format!("; if not, look for {}", slips.join(", or "))
            }
        };
        format!("if you chose the shape, nothing is wrong{look}")
    }
}

fn step_says(at: usize, step: &steps::ChapterStep) -> String {
    format!("step {}: {}", at + 1, step.says)
}

/// Returns the line of the list when a step of a chapter shows what it should.
pub fn step_is_done(chapter: Chapter, step: usize) -> String {
    format!("{}: step {step} shows what it should", chapter.name())
}

/// Returns the line of the list when the picture of a chapter is right.
pub fn picture_is_right(chapter: Chapter) -> String {
    format!("{}: the picture is right, to the last bit", chapter.name())
}

// 4. Words that stand in several sentences.

/// Names a scene: `step 1 of normals`, `normals with the probe far`.
fn named(task: &Task) -> String {
    let step = task
        .step()
        .map_or(String::new(), |step| format!("step {} of ", step + 1));
    let probe = task
        .probe
        .map_or(String::new(), |it| format!(" with the probe {}", it.name));
    format!("{step}{}{probe}", task.chapter.name())
}

fn step_of(chapter: Chapter, step: usize) -> String {
    format!("Step {} of {}", step + 1, steps::of_chapter(chapter).len())
}

/// Names the edition, if it is not the one that this workspace follows.
fn by(editions: &[Edition]) -> String {
    match editions.contains(&Edition::V4) {
        true => String::new(),
        false => format!(" by version {}", editions[0].name()),
    }
}

fn differ(count: usize, total: usize) -> String {
    let differ = if count == 1 { "differs" } else { "differ" };
    format!("{count} of {total} pixels {differ}")
}

fn span(name: &str, [first, last]: [u32; 2]) -> String {
    match first == last {
        true => format!("{name} {first}"),
        false => format!("{name}s {first} to {last}"),
    }
}

impl Unexplained {
    /// Says how many pixels are off, and where.
    fn said(&self, pixels: usize) -> String {
        let off = self.off;
        if self.is_rounding() {
            return format!(
                "one level in {off} of {pixels} pixels, as with single precision or another way of rounding"
            );
        }
        let (columns, rows) = (span("column", self.columns), span("row", self.rows));
        format!("{off} of {pixels} pixels, in {columns}, {rows}")
    }
}

/// Names slips that were made together; one without a name by its line in our Rust.
pub fn names_of(mistake: &[&'static Slip]) -> String {
    let name = |slip: &&'static Slip| match slip.name {
        "" => {
            let chapter = slip.chapters().next().unwrap_or(Chapter::HittableList);
            slip.words(ReaderLanguage::Rust, chapter).wrong
        }
        name => name.into(),
    };
    let names: Vec<_> = mistake.iter().map(name).collect();
    names.join(" and ")
}

fn row(kind: RowKind, text: &str) -> Option<Row> {
    (!text.is_empty()).then(|| Row::new(kind, text))
}

fn line_and_right(kind: RowKind, line: &str, right: &str) -> Vec<Row> {
    vec![Row::new(kind, line), Row::new(RowKind::ShouldBe, right)]
}

fn alternatives(lines: impl Iterator<Item = String>) -> impl Iterator<Item = Row> {
    let kinds = iter::once(RowKind::Perhaps).chain(iter::repeat(RowKind::Or));
    kinds.zip(lines).map(|(kind, line)| Row::new(kind, line))
}

fn only_color(picture: &Picture) -> Option<&[u8]> {
    let mut colors = picture.rgb().chunks_exact(3);
    let first = colors.next()?;
    colors.all(|color| color == first).then_some(first)
}
