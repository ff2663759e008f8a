//! Fuzzing: good files are spoiled, and whatever comes of it, it is answered soon and sanely.
//!
//! `cargo test` tries a few. For a longer campaign `SPOILED_CASES` says how many files are
//! spoiled, `SPOILED_SEED` which ones.

use std::env;
use std::time::{Duration, Instant};

use check::known::Known;
use check::png;
use check::reading::{MOST_PIXELS, read};
use check::scene::Scene;
use check::verdict::{Check, Finding, check};
use slips::{Chapter, PROBES};

#[test]
fn no_picture_does_any_harm() {
    let number = |name, few| env::var(name).map_or(few, |said| said.parse().expect("a number"));
    let (cases, seed) = (number("SPOILED_CASES", 400), number("SPOILED_SEED", 1));
    let mut random = Random(seed);
    let mut counts = [0; 3];
    for _ in 0..cases {
        let scene = scene(&mut random);
        let mut bytes = picture(&scene, &mut random);
        // Some stay as they are: wrong pictures, in shapes that nobody draws.
        if random.below(8) > 0 {
            spoil(&mut bytes, &mut random);
        }
        let start = Instant::now();
        let answer = check(&scene, &bytes, 0);
        assert!(start.elapsed() < HANGS, "it hangs on {bytes:?}");
        assert_sane(&scene, &bytes, &answer);
        counts[match answer {
            Check::Right(_) => 0,
            Check::NotAPicture { .. } => 1,
            _ => 2,
        }] += 1;
    }
    // If one of them were missing, the campaign would try less than it says.
    assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
}

/// Whatever takes so long hangs, however busy the machine is.
const HANGS: Duration = Duration::from_secs(60);

fn scene(random: &mut Random) -> Scene {
    let chapter = Chapter::OF_THE_BOOK[random.below(Chapter::OF_THE_BOOK.len())];
    let probe = (random.below(4) == 0).then(|| PROBES[random.below(PROBES.len())]);
    let book = || Scene::new(chapter, None).expect("a chapter has its own scene");
    Scene::new(chapter, probe).unwrap_or_else(book)
}

/// A small picture as text or PNG: the right one, one in any shape, or one that a known
/// mistake draws.
fn picture(scene: &Scene, random: &mut Random) -> Vec<u8> {
    const SHAPES: [(u32, u32); 6] = [(1, 1), (1, 200), (200, 1), (2, 97), (97, 2), (16, 16)];
    if random.below(4) == 0 {
        let (width, height) = SHAPES[random.below(SHAPES.len())];
        return png::encode(&scene.right(width, height));
    }
    let slips: Vec<_> = scene.slips().collect();
    let slip = slips[random.below(slips.len())];
    let made = if random.below(3) > 0 {
        &[slip][..]
    } else {
        &[]
    };
    let output = scene.program(made).run(1 + random.below(20) as u32);
    let (width, height) = output.size();
    if random.below(2) == 0 || width == 0 || height == 0 {
        return output.to_string().into_bytes();
    }
    png::encode(&output.picture())
}

fn assert_sane(scene: &Scene, bytes: &[u8], answer: &Check) {
    match (answer, read(bytes)) {
        (
            Check::NotAPicture {
                cause,
                finding: None,
            },
            Err(why),
        ) => assert_eq!(*cause, why),
        (Check::Right(right), Ok(reading)) => {
            assert!(reading.picture() == right.scene.right(right.width, right.height));
        }
        (_, Ok(reading)) => {
            let size = u64::from(reading.width) * u64::from(reading.height);
            assert!((1..=MOST_PIXELS).contains(&size));
        }
        (answer, Err(why)) => panic!("{why}, but it is judged: {answer:?}"),
    }
    if let Some(cause) = answer.cause() {
        assert_readable(&cause.problem);
        assert_readable(&cause.fix);
    }
    if let Some(finding) = answer.finding() {
        assert_says_something(scene, finding);
    }
}

fn assert_says_something(scene: &Scene, finding: &Finding) {
    let pixels = finding.right.rgb().len() / 3;
    if let Some(mistakes) = &finding.mistakes {
        assert!(mistakes.all.iter().all(|mistake| !mistake.is_empty()));
        assert_readable(&mistakes.title(pixels));
    }
    let next = finding.next(None, |probe| scene.probed_command(probe));
    let rows = finding.rows(&Known::default()).into_iter();
    let said = rows.map(|(_, said)| said).chain(next);
    said.for_each(|said| assert_readable(&said));
}

fn assert_readable(sentence: &str) {
    assert!((1..1000).contains(&sentence.len()), "{sentence:?}");
    let is_obeyed = |letter: char| letter.is_control() && letter != '\n';
    assert!(!sentence.contains(is_obeyed), "{sentence:?}");
}

/// What numbers and headers are sensitive to.
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

/// Changes a few bytes, takes some out, doubles them, or puts one of the words there.
fn spoil(bytes: &mut Vec<u8>, random: &mut Random) {
    for _ in 0..1 + random.below(4) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(9)).min(bytes.len());
        match random.below(6) {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(at..end)),
            2 => drop(bytes.splice(at..end, WORDS[random.below(WORDS.len())].iter().copied())),
            3 => bytes.extend_from_within(at..end),
            _ if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
            _ => bytes.push(random.below(256) as u8),
        }
    }
}

/// Marsaglia's xorshift: quick, the same everywhere, and good enough to spoil.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 33) as usize % limit
    }
}
