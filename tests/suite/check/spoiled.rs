//! Fuzzing: good files are spoiled, and whatever comes of it, it is answered soon and
//! sanely.
//!
//! `cargo test` tries a few. The page `trials.md` has longer campaigns: `SPOILED_CASES`
//! says how many files are spoiled, `SPOILED_SEED` which ones.

use std::time::{Duration, Instant};
use std::{env, fs};

use check::evidence::Known;
use check::png;
use check::reading::{MOST_PIXELS, read};
use check::scene::Scene;
use check::verdict::{Check, Finding, check};
use common::rtweekend::Picture;
use slips::Chapter;
use slips::PROBES;
use tempfile::TempDir;

use crate::reading::{crc, p6};
use suite::command::{program_with, run, text};
use suite::drawn::p3;
use suite::random::Random;

/// Through all of `check`: reading, comparison and diagnosis.
#[test]
fn no_picture_does_any_harm() {
    let Campaign { cases, mut random } = Campaign::of(1_000);
    #[cfg(unix)]
    if env::var_os("SPOILED_CASES").is_some() {
        limit_memory();
    }
    let mut counts = [0; 4];
    for _ in 0..cases {
        let scene = scene(&mut random);
        let mut bytes = picture(&scene, &mut random);
        // Some stay as they are: wrong pictures, in shapes that nobody draws.
        if random.below(8) > 0 {
            spoil(&mut bytes, &OF_PICTURES, &mut random);
        }
        if bytes.starts_with(b"\x89PNG") && random.below(4) > 0 {
            mend_sums(&mut bytes);
        }
        let start = Instant::now();
        let answer = check(&scene, &bytes, 0);
        assert!(start.elapsed() < HANGS, "it hangs on {bytes:?}");
        assert_sane(&scene, &bytes, &answer);
        counts[match answer {
            Check::Right(_) => 0,
            Check::Near(_) | Check::Wrong(_) | Check::Another { .. } => 1,
            Check::WrongShape { .. } => 2,
            Check::NotAPicture { .. } => 3,
        }] += 1;
    }
    let [right, wrong, misshapen, none] = counts;
    println!(
        "{cases} files: {right} right, {wrong} wrong, {misshapen} of a wrong shape, {none} no picture"
    );
    // If one of them were missing, the campaign would try less than it says.
    assert!(
        counts.iter().all(|&count| count > cases / 1000),
        "{counts:?}"
    );
}

/// Through the real program: it reads a file while it answers.
#[test]
#[ignore = "runs a program two hundred times"]
fn no_file_of_rays_does_any_harm() {
    let Campaign { cases, mut random } = Campaign::of(200);
    let folder = TempDir::new().expect("a folder");
    let path = folder.path().join("rays.csv");
    let mut counts = [0; 2];
    for _ in 0..cases {
        let mut bytes = rays(&mut random);
        spoil(&mut bytes, &OF_RAYS, &mut random);
        fs::write(&path, &bytes).expect("a file");
        // The first time, the program is built.
        let mut command = program_with("rtrace", &["hit", "--method", "certified_t", "--csv"]);
        let start = Instant::now();
        let output = run(command.arg(&path));
        assert!(start.elapsed() < HANGS, "it hangs on {bytes:?}");
        let (code, problem) = (output.status.code(), text(&output.stderr));
        let shown = String::from_utf8_lossy(&bytes);
        match code {
            Some(0) => assert_eq!(problem, "", "{shown:?}"),
            _ => assert_names_a_line(&problem, &bytes),
        }
        assert_are_answers(&text(&output.stdout), &shown);
        counts[usize::from(code == Some(1))] += 1;
    }
    let [answered, refused] = counts;
    println!("{cases} files: {answered} answered to the end, {refused} refused");
    assert!(
        counts.iter().all(|&count| count > cases / 100),
        "{counts:?}"
    );
}

/// Whatever takes so long hangs, however busy the machine is.
const HANGS: Duration = Duration::from_secs(60);

/// How many files are spoiled, and which.
struct Campaign {
    cases: u64,
    random: Random,
}

impl Campaign {
    fn of(few: u64) -> Self {
        let number = |name| {
            let said = env::var(name).ok();
            said.map(|number| number.parse().expect("cases and seed are numbers"))
        };
        Self {
            cases: number("SPOILED_CASES").unwrap_or(few),
            random: Random(number("SPOILED_SEED").unwrap_or(1)),
        }
    }
}

/// Any memory beyond this is refused by the system, and ends the program.
#[cfg(unix)]
fn limit_memory() {
    use rustix::process::{Resource, Rlimit, setrlimit};
    let limit = Rlimit {
        current: Some(1 << 30),
        maximum: Some(1 << 30),
    };
    setrlimit(Resource::As, limit).expect("a limit may be lowered");
}

fn scene(random: &mut Random) -> Scene {
    let chapter = Chapter::OF_THE_BOOK[random.below(Chapter::OF_THE_BOOK.len())];
    let probe = (random.below(4) == 0).then(|| PROBES[random.below(PROBES.len())]);
    let book = || Scene::new(chapter, None).expect("a chapter has its own scene");
    Scene::new(chapter, probe).unwrap_or_else(book)
}

/// A small picture in some format: the right one, one in any shape, or one that a
/// known mistake draws.
fn picture(scene: &Scene, random: &mut Random) -> Vec<u8> {
    let width = 1 + random.below(20) as u32;
    let slips: Vec<_> = scene.slips().collect();
    let slip = slips[random.below(slips.len())];
    let (program, shape) = match random.below(4) {
        0 => (scene.program(&[]), None),
        1 => (scene.program(&[]), Some(SHAPES[random.below(SHAPES.len())])),
        _ => (scene.program(&[slip]), None),
    };
    let output = program.run(width);
    let (columns, rows) = output.size();
    let format = random.below(3);
    if format == 0 && shape.is_none() || columns == 0 || rows == 0 {
        return output.to_string().into_bytes();
    }
    let picture: Picture = match shape {
        Some((width, height)) => scene.right(width, height),
        None => output.picture(),
    };
    match format {
        0 => p3(&picture),
        1 => p6(&picture),
        _ => png::encode(&picture),
    }
}

/// Width and height of pictures that nobody draws.
const SHAPES: [(u32, u32); 6] = [(1, 1), (1, 200), (200, 1), (2, 97), (97, 2), (16, 16)];

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
            assert_eq!((right.width, right.height), (reading.width, reading.height));
            assert!(reading.picture() == right.scene.right(right.width, right.height));
        }
        (_, Ok(reading)) => {
            let size = u64::from(reading.width) * u64::from(reading.height);
            assert!((1..=MOST_PIXELS).contains(&size));
            assert_eq!(reading.pixels.len() as u64, size);
        }
        (answer, Err(why)) => panic!("{why}, but it is judged: {answer:?}"),
    }
    if let Check::WrongShape { cause, .. } | Check::NotAPicture { cause, .. } = answer {
        assert_readable(&cause.problem);
        assert_readable(&cause.fix);
    }
    if let Some(finding) = answer.finding() {
        assert_tells_something(scene, finding);
    }
}

fn assert_tells_something(scene: &Scene, finding: &Finding) {
    let pixels = finding.right.rgb().len() / 3;
    for set in &finding.sets {
        assert!(!set.mistakes.is_empty() && set.mistakes.iter().all(|mistake| !mistake.is_empty()));
        assert_readable(&set.title(pixels));
    }
    let told = finding.how_to_tell(|probe| scene.probed_command(probe));
    let rows = finding.rows(&Known::default()).into_iter();
    let rows = rows.map(|(_, said)| said).chain(told);
    rows.for_each(|said| assert_readable(&said));
}

fn assert_readable(sentence: &str) {
    assert!((1..1000).contains(&sentence.len()), "{sentence:?}");
    assert!(!sentence.contains(obeyed), "{sentence:?}");
}

/// Whether a terminal does something else with it than show it.
fn obeyed(letter: char) -> bool {
    letter.is_control() && letter != '\n'
}

/// A few rows, among them some that are hard to read or to answer.
fn rays(random: &mut Random) -> Vec<u8> {
    const NUMBERS: [&str; 8] = ["0", "-1", "0.5", "1e308", "5e-324", " 1 ", "\"2\"", "-1e-9"];
    let ends = ["\n", "\r\n", "\r", "\n\n"];
    let end = ends[random.below(ends.len())];
    let mut text = format!("ox,oy,oz,dx,dy,dz,cx,cy,cz,r{end}");
    for _ in 0..random.below(20) {
        let row = [(); 10].map(|()| NUMBERS[random.below(NUMBERS.len())]);
        text += &(row.join(",") + end);
    }
    text.into_bytes()
}

/// It says so in a line that the file has, or in the next one.
fn assert_names_a_line(problem: &str, bytes: &[u8]) {
    let shown = String::from_utf8_lossy(bytes);
    assert!(
        problem.starts_with("rtrace: ") && problem.len() < 500,
        "{problem} {shown:?}"
    );
    assert!(!problem.contains("panicked"), "{problem} {shown:?}");
    let (_, rest) = problem.split_once(", line ").expect("a line is named");
    let (line, what) = rest.split_once(": ").expect("it says what");
    let line: usize = line.parse().expect("a number");
    let ends = bytes.iter().filter(|byte| b"\r\n".contains(byte)).count();
    assert!((1..=ends + 1).contains(&line), "{problem} {shown:?}");
    assert_readable(what);
}

/// Each line is a row that goes up, the method, and a finite number or nothing.
fn assert_are_answers(said: &str, file: &str) {
    for (line, row) in said.lines().skip(1).zip(1..) {
        let t = line.strip_prefix(&format!("{row},certified_t,"));
        let t = t.unwrap_or_else(|| panic!("{line} is no answer: {file:?}"));
        let is_number = t.parse::<f64>().is_ok_and(f64::is_finite);
        assert!(t.is_empty() || is_number, "{line}: {file:?}");
    }
}

/// What numbers and headers are sensitive to.
const OF_PICTURES: [&[u8]; 12] = [
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

/// What rows and their numbers are sensitive to.
const OF_RAYS: [&[u8]; 12] = [
    b"\"",
    b"\"\"",
    b",",
    b"\r",
    b"\n",
    b"\r\n",
    b"nan",
    b"1e999",
    b"-",
    b"\xef\xbb\xbf",
    b"\0",
    b"\x1b[2J",
];

/// Changes a few bytes, takes some out, doubles them, or puts one of the `words`
/// there.
fn spoil(bytes: &mut Vec<u8>, words: &[&[u8]], random: &mut Random) {
    for _ in 0..1 + random.below(4) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(9)).min(bytes.len());
        match random.below(6) {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(at..end)),
            2 => drop(bytes.splice(at..end, words[random.below(words.len())].iter().copied())),
            3 => bytes.extend_from_within(at..end),
            _ if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
            _ => bytes.push(random.below(256) as u8),
        }
    }
}

/// Makes the sums of a PNG right, so that what they guard is reached.
fn mend_sums(bytes: &mut [u8]) {
    let mut at = 8;
    while let Some(length) = bytes.get(at..at + 4) {
        let length = u32::from_be_bytes([length[0], length[1], length[2], length[3]]) as usize;
        let Some(end) = at.checked_add(8).and_then(|at| at.checked_add(length)) else {
            return;
        };
        let Some(sum) = bytes.get(at + 4..end).map(crc) else {
            return;
        };
        let Some(place) = bytes.get_mut(end..end + 4) else {
            return;
        };
        place.copy_from_slice(&sum.to_be_bytes());
        at = end + 4;
    }
}
