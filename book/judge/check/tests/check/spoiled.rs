//! Fuzzing: bytes of good files are changed, and the answer to each result is sane.
//!
//! For a longer campaign `PROPTEST_CASES` says how many files are spoiled.

use check::attempt::Attempt;
use check::context::Context;
use check::judge_file;
use check::reading::{MOST_PIXELS, read};
use check::task::Task;
use check::text::{MOST_LINES, Style, answer_lines};
use check::verdict::Verdict;
use difference::png;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::{collection, option};
use slips::{Chapter, PROBES};

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_picture_does_any_harm(
        (task, mut bytes) in tasks().prop_flat_map(|task| (Just(task), pictures(task))),
        damages in collection::vec((any::<Index>(), 0..9_usize, damages()), 0..5),
    ) {
        for (at, length, damage) in damages {
            damage.put_to(&mut bytes, at, length);
        }
        let answer = judge_file(&task, &bytes, 0, &Context::default());
        assert_sane(task, &bytes, answer);
    }
}

fn tasks() -> impl Strategy<Value = Task> {
    let chapters = select(&Chapter::OF_THE_BOOK[..]);
    let probes = option::weighted(0.25, select(&PROBES[..]));
    (chapters, probes).prop_filter_map("room for the probe", |(chapter, probe)| {
        Task::new(chapter, probe)
    })
}

/// A small picture as text or PNG: the right one, one in any shape, or one that a known
/// mistake draws.
fn pictures(task: Task) -> impl Strategy<Value = Vec<u8>> {
    const SHAPES: [(u32, u32); 6] = [(1, 1), (1, 200), (200, 1), (2, 97), (97, 2), (16, 16)];
    let shapes = select(&SHAPES[..]);
    let shaped =
        shapes.prop_map(move |(width, height)| png::encode(&task.right_picture(width, height)));
    let slips = option::weighted(0.7, select(task.slips().collect::<Vec<_>>()));
    let drawn = (slips, 1..21_u32, any::<bool>()).prop_map(move |(slip, width, is_text)| {
        let output = task.program(slip.as_slice()).run(width);
        let (width, height) = output.size();
        if is_text || width == 0 || height == 0 {
            return output.to_string().into_bytes();
        }
        png::encode(&output.picture())
    });
    prop_oneof![1 => shaped, 3 => drawn]
}

/// A damage to a few neighboring bytes of a file.
#[derive(Clone, Copy, Debug)]
enum Damage {
    /// The file ends before the bytes.
    CutOff,
    /// The bytes are taken out.
    Lost,
    /// A word to which numbers or headers are sensitive stands in the place of the bytes.
    Replaced(&'static [u8]),
    /// The bytes follow the file once more.
    Repeated,
    /// The bit of this index is flipped in the first byte.
    Flipped(u8),
}

fn damages() -> impl Strategy<Value = Damage> {
    const WORDS: [&[u8]; 12] = [
        b"P6",
        b"255",
        b"-1",
        b"0",
        b"4294967295",
        b"99999999999999999999",
        b"#",
        b"\r\n",
        b"nan",
        b"\xff\xfe",
        b"\0",
        b"IEND",
    ];
    prop_oneof![
        Just(Damage::CutOff),
        Just(Damage::Lost),
        select(&WORDS[..]).prop_map(Damage::Replaced),
        Just(Damage::Repeated),
        (0..8_u8).prop_map(Damage::Flipped),
    ]
}

impl Damage {
    fn put_to(self, bytes: &mut Vec<u8>, at: Index, length: usize) {
        let at = at.index(bytes.len() + 1);
        let end = (at + length).min(bytes.len());
        match self {
            Self::CutOff => bytes.truncate(at),
            Self::Lost => drop(bytes.drain(at..end)),
            Self::Replaced(word) => drop(bytes.splice(at..end, word.iter().copied())),
            Self::Repeated => bytes.extend_from_within(at..end),
            Self::Flipped(bit) => bytes[at..]
                .iter_mut()
                .take(1)
                .for_each(|it| *it ^= 1 << bit),
        }
    }
}

fn assert_sane(task: Task, bytes: &[u8], answer: Verdict) {
    match read(bytes) {
        Err(why) => {
            assert_eq!(answer.cause(), Some(&why));
            assert!(answer.finding().is_none());
        }
        Ok(reading) => {
            let size = u64::from(reading.width) * u64::from(reading.height);
            assert!((1..=MOST_PIXELS).contains(&size));
            if let Some(right) = answer.finding().filter(|_| answer.is_right()) {
                let (width, height) = (reading.width, reading.height);
                assert!(reading.picture() == right.task.right_picture(width, height));
            }
        }
    }
    if let Some(cause) = answer.cause() {
        assert_readable(&cause.problem);
        assert_readable(&cause.fix);
    }
    assert_says_something(task, answer);
}

fn assert_says_something(task: Task, verdict: Verdict) {
    let answer = Attempt::new(task, &Context::default()).answer(verdict);
    assert_readable(&answer.headline.to_string());
    let next = Some(&answer.next).filter(|next| !next.is_empty());
    let rows = answer.rows.iter().map(|row| &row.text);
    rows.chain(next).for_each(|said| assert_readable(said));
    let style = Style { is_colored: false };
    let lines = answer_lines(&answer, style, 80, usize::MAX);
    assert!(lines.len() <= MOST_LINES, "{}", lines.join("\n"));
}

fn assert_readable(sentence: &str) {
    assert!((1..1000).contains(&sentence.len()), "{sentence:?}");
    let is_obeyed = |letter: char| letter.is_control() && letter != '\n';
    assert!(!sentence.contains(is_obeyed), "{sentence:?}");
}
