//! A bank of pictures with the truth beside each: how often does `check` say it?
//!
//! A generator makes readers: each follows some edition of the book, chose a size, a
//! shape, colors, several rays a pixel or a curve, and made no slip, one or two. `cargo
//! test` judges a sample of small pictures; the README tells how to judge the whole bank.
//! `BANK_CASES` says how many cases it has, `BANK_SEED` which ones, and `BANK_ONLY=17`
//! judges case 17 alone and keeps its picture.

mod grade;
mod readers;
mod truth;

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{env, fs, thread};

use check::judge::check;

use grade::{Grade, grade, said};
use readers::Kind;
use truth::{Case, Truth};

/// How many cases `cargo test` judges: in seconds, and a hundredth is one of them.
const SAMPLE: usize = 100;
/// The most pixels that those have. Large pictures take longer, and are no harder.
const SMALL: u32 = 20_000;

/// Of a hundred answers so many are correct, at least, and so many misleading or false, at
/// most: over the whole bank it was 93, 1 and none. Readers deserve 95.
const CORRECT: usize = 90;
const MISLEADING: usize = 2;
const FALSE: usize = 0;

#[test]
fn most_pictures_are_told_for_what_they_are() {
    let asked = |name| {
        let said = env::var(name).ok();
        said.map(|number| number.parse::<u64>().expect("it is a number"))
    };
    let seed = asked("BANK_SEED").unwrap_or(1);
    if let Some(number) = asked("BANK_ONLY") {
        return show(seed, number);
    }
    let is_small = |&number: &u64| Truth::numbered(seed, number).pixels() <= SMALL;
    let numbers: Vec<u64> = match asked("BANK_CASES") {
        Some(cases) => (0..cases).collect(),
        None => (0..).filter(is_small).take(SAMPLE).collect(),
    };
    let answers = judged(seed, &numbers);
    let table = table(&answers);
    println!("{table}");
    let count = |grade| {
        answers
            .iter()
            .filter(|answer| answer.grade == grade)
            .count()
    };
    let all = answers.len();
    assert!(100 * count(Grade::Correct) >= CORRECT * all, "{table}");
    assert!(
        100 * count(Grade::Misleading) <= MISLEADING * all,
        "{table}"
    );
    assert!(100 * count(Grade::False) <= FALSE * all, "{table}");
}

/// What became of a case.
struct Answer {
    number: u64,
    kind: Kind,
    grade: Grade,
    truth: String,
    said: String,
}

impl Answer {
    fn of(number: u64, case: &Case) -> Self {
        let answer = check(&case.truth.asked, &case.bytes, 0);
        Self {
            number,
            kind: case.truth.kind,
            grade: grade(case, &answer),
            truth: case.truth.to_string(),
            said: said(&answer),
        }
    }

    /// What is said beside what it is, if that is not the same.
    fn told(&self) -> Option<String> {
        let Self {
            number,
            grade,
            truth,
            said,
            ..
        } = self;
        (*grade != Grade::Correct).then(|| format!("{grade:?} {number}: {truth}\n    {said}"))
    }
}

/// The answers to the cases of these numbers, which as many threads work at as there are
/// processors. What is not told right is printed as it comes.
fn judged(seed: u64, numbers: &[u64]) -> Vec<Answer> {
    let (next, answers) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let work = || {
        while let Some(&number) = numbers.get(next.fetch_add(1, Ordering::Relaxed)) {
            let answer = Answer::of(number, &Case::of(Truth::numbered(seed, number)));
            if let Some(told) = answer.told() {
                println!("{told}");
            }
            answers.lock().expect("no thread panics").push(answer);
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    let mut answers = answers.into_inner().expect("no thread panics");
    answers.sort_by_key(|answer: &Answer| answer.number);
    answers
}

/// How many of each kind are of each grade.
fn table(answers: &[Answer]) -> String {
    let line = |name: String, is_in: &dyn Fn(&Answer) -> bool| {
        let of = |grade| {
            let answers = answers.iter().filter(|answer| is_in(answer));
            answers.filter(|answer| answer.grade == grade).count()
        };
        let [correct, unhelpful, misleading, wrong] = Grade::ALL.map(of);
        format!("{name:<16}{correct:>9}{unhelpful:>11}{misleading:>12}{wrong:>7}\n")
    };
    let kinds =
        Kind::SHARES.map(|(kind, _)| line(format!("{kind:?}"), &|answer| answer.kind == kind));
    let head = format!(
        "{:<16}{:>9}{:>11}{:>12}{:>7}\n",
        "", "correct", "unhelpful", "misleading", "false"
    );
    head + &kinds.concat() + &line("all".to_owned(), &|_| true)
}

/// Judges one case, and keeps its picture.
fn show(seed: u64, number: u64) {
    let case = Case::of(Truth::numbered(seed, number));
    let answer = Answer::of(number, &case);
    let path = format!("{}/bank_{number}", env!("CARGO_TARGET_TMPDIR"));
    fs::write(&path, &case.bytes).expect("a file");
    let Answer {
        grade, truth, said, ..
    } = answer;
    println!("{grade:?} {number}: {truth}\n    {said}\n    {path}");
}
