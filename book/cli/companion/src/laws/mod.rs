//! `laws`: property-based testing of a function in any language, by lines of text.

mod advice;
mod dialogue;

use std::cell::RefCell;
use std::collections::HashMap;
use std::error::Error;
use std::ffi::OsString;
use std::time::Duration;

use ::laws::record::RecordedHit;
use ::laws::{Case, Complaint, IntervalCase, Question, Report, Trial};
use check::answer::{Answer, Grade, Row, RowKind};
use check::any_language::{self, FunctionKind, FunctionVerdict};
use check::lawful;
use check::names;
use check::sentences::law_rows;
use common::rtweekend::*;
use slips::{Chapter, Languages};

use crate::check::seconds;
use crate::command_line::Words;
use crate::reader_crates::shell_word;
use crate::wrap::lay_out;
use dialogue::{Dialogue, DialogueFailure};

/// How the words say that a program is to be asked.
struct Arguments {
    chapter: Chapter,
    /// The reader's program and its arguments; not empty.
    program: Vec<OsString>,
    /// How long the program may take for an answer; for all of them, twenty times as long.
    timeout: Duration,
}

/// Asks a reader's program where rays hit spheres, and returns which law its answers break, after
/// the exit code: 0 if all laws hold, 1 if one is broken, and 2 if the program can't be asked.
pub(crate) fn laws(words: &Words) -> Result<(u8, String), Box<dyn Error>> {
    let chapter = words.required_chapter()?;
    if words.program.is_empty() {
        return Err(words.command.misuse("name your program after --"));
    }
    let timeout = words.option("--timeout", seconds)?;
    let arguments = Arguments {
        chapter,
        program: words.program.clone(),
        timeout: timeout.unwrap_or(Duration::from_secs(5)),
    };
    let (code, answer) = match Dialogue::start(&arguments.program, arguments.timeout) {
        Ok(dialogue) => Interview::new(&arguments, dialogue).judge(),
        Err(cause) => {
            let next =
                "is the program built, and is its path right? A program in this folder is ./NAME";
            let headline = ("your program does not start", format!(": {cause}"));
            (2, answer(Grade::NoPicture, headline).then(next))
        }
    };
    // What is to be typed by hand is never left out.
    Ok((code, lay_out(&answer, usize::MAX)))
}

/// Makes an answer of a headline: a verdict on the program, and the rest of the sentence.
fn answer(grade: Grade, (verdict, rest): (&str, String)) -> Answer {
    Answer::of(grade, "", verdict, rest)
}

/// The time to wait after the first answers for lines that nobody has asked for.
const GREETING: Duration = Duration::from_millis(300);

/// A program with all the questions that it has been asked, and its answers.
struct Interview<'a> {
    arguments: &'a Arguments,
    dialogue: RefCell<Dialogue>,
    /// The answers by their questions. No question is asked twice: the laws make a failing case
    /// smaller, and must find the answers that they found before.
    answers: RefCell<HashMap<String, LineAnswer>>,
    /// The reason why the program is asked no more, and the question at which that was found;
    /// `None` while it can be asked.
    failure: RefCell<Option<(DialogueFailure, String)>>,
    function: FunctionKind,
}

/// A line that a program answered, and the hit that it stands for; `None` for a miss.
struct LineAnswer {
    said: String,
    hit: Option<RecordedHit>,
}

impl<'a> Interview<'a> {
    fn new(arguments: &'a Arguments, dialogue: Dialogue) -> Self {
        Self {
            arguments,
            dialogue: RefCell::new(dialogue),
            answers: RefCell::default(),
            failure: RefCell::default(),
            function: match arguments.chapter {
                Chapter::RedSphere => FunctionKind::Decision,
                Chapter::HittableList => FunctionKind::Record,
                _ => FunctionKind::Root,
            },
        }
    }

    /// Asks the program all questions, and returns the exit code and the answer.
    fn judge(&self) -> (u8, Answer) {
        let trial = Trial {
            answers: None,
            ..Trial::default()
        };
        let line = self.greet();
        let verdict = any_language::try_laws(&trial, self.function, &|asked| self.answer(asked));
        let ended = || Some((self.dialogue.borrow_mut().close_input().err()?, line));
        let failed = self.failure.take().or_else(ended);
        match (failed, &verdict.outcome) {
            (Some((failure, line)), _) => (2, self.failed(&failure, &line)),
            (None, Err(Complaint::Broken(report))) => (1, self.broken(report, &verdict.questions)),
            (None, _) => (0, self.obeyed(&verdict)),
        }
    }

    /// Asks two easy questions first: a ray from the eye past the ball, which shows the program's
    /// word for a miss, and one to the ball. Both are short enough to be typed by hand. Returns the
    /// last question.
    fn greet(&self) -> String {
        let ball = Point3::new(0.0, 0.0, -1.0);
        let [_, last] = [Vec3::Y, ball].map(|direction| {
            let asked = IntervalCase {
                case: Case::new(ball, 0.5, Ray::new(Point3::ZERO, direction)),
                t_min: 0.0,
                t_max: f64::INFINITY,
            };
            self.answer(&asked);
            let line = self.question_line(&asked);
            if let Err(more) = self.dialogue.borrow().says_no_more(GREETING) {
                let mut failure = self.failure.borrow_mut();
                failure.get_or_insert((more, line.clone()));
            }
            line
        });
        last
    }

    /// Returns the hit that the program answers; `None` for a miss, and always after a failure.
    fn answer(&self, asked: &IntervalCase) -> Option<RecordedHit> {
        let line = self.question_line(asked);
        if let Some(known) = self.answers.borrow().get(&line) {
            return known.hit;
        }
        if self.failure.borrow().is_some() {
            return None;
        }
        let said = self.dialogue.borrow_mut().ask(&line).and_then(|said| {
            let read = self
                .function
                .parse_answer(asked, &said, self.says_minus_one());
            match read {
                Ok(hit) => Ok(LineAnswer { said, hit }),
                Err(why) => Err(DialogueFailure::NoAnswer(said, why)),
            }
        });
        match said {
            Ok(answer) => {
                let hit = answer.hit;
                self.answers.borrow_mut().insert(line, answer);
                hit
            }
            Err(failure) => {
                *self.failure.borrow_mut() = Some((failure, line));
                None
            }
        }
    }

    fn question_line(&self, asked: &IntervalCase) -> String {
        self.function.question_line(asked)
    }

    /// Returns true if the answer -1 may stand for a miss, as in the book: until the program
    /// answers `miss`.
    fn says_minus_one(&self) -> bool {
        let answers = self.answers.borrow();
        self.function == FunctionKind::Root && !answers.values().any(|it| it.said == "miss")
    }

    fn obeyed(&self, verdict: &FunctionVerdict) -> Answer {
        let all = self.answers.borrow().len();
        let besides = verdict.manners.iter().map(|manner| {
            let says = manner.description();
            let says = format!("{says}; no picture of these chapters shows that");
            Row::new(RowKind::Besides, says)
        });
        let rest = format!(": your program gave {all} answers, each as it should be.");
        answer(Grade::Right, ("the laws hold", rest)).with(besides)
    }

    /// Returns true if the program's answer to `question` may be a miss or a root: -1.
    fn may_be_both(&self, question: &Question) -> bool {
        let Question::Root(case) = question else {
            return false;
        };
        let answers = self.answers.borrow();
        let answer = answers.get(&self.question_line(&IntervalCase::unbounded(*case)));
        self.says_minus_one() && answer.is_some_and(|it| it.said.parse() == Ok(-1.0))
    }

    /// Shows the law that is broken, with a reason that all answers are wrong, if one is seen, or
    /// else with the mistakes that give the same answers.
    fn broken(&self, report: &Report, last: &[IntervalCase]) -> Answer {
        let mut report = report.clone();
        let besides = self.printed_short();
        if besides.is_none() {
            let given = &mut report.answers.given;
            given.retain(|it| !self.may_be_both(&it.question));
            lawful::explain(&mut report, self.arguments.chapter, Languages::Both);
        }
        let mut rows = law_rows(&report);
        let place = rows.len() - 1;
        rows.splice(
            place..place,
            besides.map(|it| Row::new(RowKind::Besides, it)),
        );
        let answers = self.answers.borrow();
        let by_hand = last.iter().flat_map(|asked| {
            let line = self.question_line(asked);
            let said = answers.get(&line).map_or("", |answer| &answer.said);
            let said = names::escape_for_terminal(said);
            [self.by_hand(&line), printed("answer", &said)]
        });
        let rest = ", which should hold for every ray and every sphere.".to_owned();
        let broken = answer(Grade::Wrong, ("your program breaks a law", rest));
        broken.with(rows).with(by_hand)
    }

    /// Returns a complaint that all answers have too few digits, if they have: of so many, one
    /// should be long, and those of a wrong function are as long as those of a right one.
    fn printed_short(&self) -> Option<String> {
        const MANY: usize = 50;
        const DIGITS_OF_A_DOUBLE: usize = 15;
        let answers = self.answers.borrow();
        let numbers = answers
            .values()
            .filter(|it| it.hit.is_some_and(|hit| hit.t.is_finite()));
        let t = |it: &'_ LineAnswer| it.said.split(' ').next().unwrap_or_default().to_owned();
        let numbers: HashMap<String, f64> = numbers
            .map(t)
            .filter_map(|t| Some((t.clone(), t.parse().ok()?)))
            .collect();
        if numbers.len() < MANY {
            return None;
        }
        let digits = numbers.keys().map(|said| digits(said)).max()?;
        if digits < DIGITS_OF_A_DOUBLE {
            return Some(format!(
                "print all digits, of which the longest answer has {digits}: in C++ by std::setprecision(17), \
                 in awk by \"%.17g\", and elsewhere without a format"
            ));
        }
        let mut numbers = numbers.values();
        let is_single = numbers.all(|&t| f64::from(t as f32) == t);
        is_single.then(|| "every answer is a number of single precision: use double".to_owned())
    }

    fn failed(&self, failure: &DialogueFailure, line: &str) -> Answer {
        let answers = self.answers.borrow().len();
        let (problem, to_do) = advice::explain(failure, self.arguments, answers);
        let by_hand = match failure {
            DialogueFailure::Ended(_)
            | DialogueFailure::TooMuch(_)
            | DialogueFailure::NoAnswer(..) => Some(self.by_hand(line)),
            // By hand, its input ends at once: that shows another thing.
            DialogueFailure::Tardy
            | DialogueFailure::Late
            | DialogueFailure::Silent
            | DialogueFailure::Slow(_) => None,
        };
        let rest = format!(" {problem}.");
        let failed = answer(Grade::NoPicture, ("your program", rest));
        failed.with(by_hand).then(to_do)
    }

    /// Writes the command by which the reader asks this question in a shell.
    fn by_hand(&self, line: &str) -> Row {
        let words: Vec<String> = self.arguments.program.iter().map(shell_word).collect();
        printed("by hand", &format!("echo '{line}' | {}", words.join(" ")))
    }
}

/// Makes a row that is shown in one line, however long it is.
fn printed(label: &str, text: &str) -> Row {
    Row::new(RowKind::Printed, format!("{label:<11}{text}"))
}

/// Counts the digits of a decimal number from the first that is not 0, without those of the
/// exponent.
fn digits(number: &str) -> usize {
    let mantissa = number.split(['e', 'E']).next().unwrap_or_default();
    let digits = mantissa.chars().filter(char::is_ascii_digit);
    digits.skip_while(|&digit| digit == '0').count()
}
