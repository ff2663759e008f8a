//! What `cargo rtrace hit` says.

use std::io::{BufRead, BufReader, Write};
use std::process::{Child, Output, Stdio};

use insta::assert_snapshot;
use speed_vs_accuracy::{METHODS, Precision, REGIMES};

use suite::command::{assert_success, program_with, run, text};
use suite::random::Random;

mod one_ray {
    use super::*;

    #[test]
    fn at_a_far_sphere_shows_which_methods_lose_digits_and_why() {
        assert_snapshot!(said_of(["-1,0,0", "1,0,-1e-9", "3e7,0.5,0"], "1", &[]));
    }

    #[test]
    fn with_a_direction_too_long_shows_which_methods_overflow() {
        assert_snapshot!(said_of(["0,0,0", "0,0,-1e200", "0,0,-1"], "0.5", &[]));
    }

    /// Also where negative numbers stand after a space.
    #[test]
    fn may_have_a_range_and_be_seen_by_one_method() {
        let range = ["--t-min=0.5", "--t-max=1.5", "--method=half_b"];
        let miss = said_of(["0,0,0", "0,0,-1", "0,0,-1"], "0.5", &range);
        let behind = ["--t-min", "-1", "--method=exact"];
        let hit = said_of(["-1,-2,-3", "-1, 0, 0", "-5,-2,-3"], "-1", &behind);
        assert_snapshot!(miss + &hit);
    }

    /// Where numbers end, or there is nothing to hit, or to hit with.
    #[test]
    fn beyond_all_numbers_is_told_in_words() {
        let max = "0,0,1.7976931348623157e308";
        let transcript = [
            ("0,0,-1e-300", "0,0,-1e300", "1"),
            ("0,0,1", max, "0"),
            ("0,0,1e-30", "0,0,1e30", "1"),
            ("0,0,-1e308", "0,0,-5e-324", "0"),
            ("0,0,1e-50", "0,0,1", "0.5"),
            ("0,0,-1", "0,1e-200,-1e200", "1e-201"),
        ]
        .map(|(direction, center, radius)| {
            let said = said_of(["0,0,0", direction, center], radius, &[]);
            format!("along {direction}, at {center}, radius {radius}\n{said}")
        });
        assert_snapshot!(transcript.join("\n"));
    }

    #[test]
    fn has_no_answer_that_is_no_number() {
        let numbers = [
            "0", "-1", "1e308", "5e-324", "1e-160", "1e160", "1e39", "1e-46",
        ];
        let mut random = Random(1);
        // Of these, one in ten has shown each mistake that there was.
        for _ in 0..60 {
            let mut number = || numbers[random.below(numbers.len())];
            let vectors = [(); 3].map(|()| [(); 3].map(|()| number()).join(","));
            let vectors = vectors.each_ref().map(String::as_str);
            let radius = number();
            let ranges: [&[&str]; 3] = [&[], &["--t-min=-inf"], &["--t-max=1e308"]];
            let said = said_of(vectors, radius, ranges[random.below(3)]);
            for word in said.split(|letter: char| !letter.is_alphanumeric()) {
                let odd = ["nan", "inf"].contains(&word.to_lowercase().as_str());
                assert!(!odd, "{vectors:?} and {radius}: {said}");
            }
        }
    }

    #[test]
    fn that_is_no_ray_is_refused() {
        let wrong = [
            "--origin=1,2",
            "--origin=1,2,x",
            "--origin=1,2,1e999",
            "--origin=1,2,inf",
            "--origin=0,0,0",
        ];
        assert_snapshot!(wrong.map(|option| refused(&[option], 2)).join("\n"));
    }

    /// Of origin, direction and center, and a radius.
    fn said_of(vectors: [&str; 3], radius: &str, more: &[&str]) -> String {
        let names = ["--origin", "--direction", "--center"];
        let mut command = program_with("rtrace", &["hit"]);
        for (name, vector) in names.into_iter().zip(vectors) {
            command.args([name, vector]);
        }
        let output = run(command.args(["--radius", radius]).args(more));
        assert_success(&output);
        text(&output.stdout)
    }
}

mod a_file {
    use super::*;

    const HEAD: &str = "ox,oy,oz,dx,dy,dz,cx,cy,cz,r";
    const GOOD: &str = "0,0,0,0,0,-1,0,0,-1,0.5";

    #[test]
    fn is_answered_row_by_row_by_every_method() {
        let miss = "0,0,0,1,0,0,0,0,-1,0.5";
        assert_snapshot!(answers(&format!("{HEAD}\n{GOOD}\n{miss}\n"), &[]));
    }

    /// Whatever the columns are called besides, in any order, from Windows, from a
    /// spreadsheet, with empty lines, or with more digits than a number has: a little more
    /// than half of the way to the next number after 1.
    #[test]
    fn may_come_from_any_program() {
        let far = "0,0,0,0,0,-1,0,0,-1.00000000000000011102230246251565404236316680908203126,0";
        let files = [
            "note,r,cz,cy,cx,dz,dy,dx,oz,oy,ox\n\"a, b\",0.5,-1,0,0,-2,0,0,0,0,0\n".to_owned(),
            format!("\u{feff}{HEAD}\r\n\r\n0, 0, 0, 0, 0, -1, 0, 0, -1, 5e-1\r\n"),
            format!("{HEAD}\n{far}"),
        ];
        let said = files.map(|file| answers(&file, &["--method", "exact"]));
        assert_snapshot!(said.concat());
    }

    #[test]
    fn has_the_answers_of_the_library_to_the_last_bit() {
        let mut file = format!("{HEAD}\n");
        let mut expected = Vec::new();
        for case in REGIMES
            .iter()
            .flat_map(|regime| regime.cases(Precision::Double, 7, 20))
        {
            let [cx, cy, cz, r, qx, qy, qz, dx, dy, dz] = case.numbers();
            let row = [qx, qy, qz, dx, dy, dz, cx, cy, cz, r].map(|number| format!("{number:?}"));
            file += &(row.join(",") + "\n");
            for method in METHODS {
                expected.push((method, case.put_to(method, 0.0, f64::INFINITY)));
            }
        }
        let said = answers(&file, &[]);
        let lines: Vec<&str> = said.lines().skip(1).collect();
        assert_eq!(lines.len(), expected.len());
        for (line, (method, t)) in lines.into_iter().zip(expected) {
            let field = line.rsplit(',').next().expect("a line has fields");
            let found = match method.precision() {
                Precision::Double => field.parse().ok(),
                Precision::Single => field.parse::<f32>().ok().map(f64::from),
            };
            assert_eq!(found, t, "{line}");
        }
    }

    #[test]
    fn is_answered_until_a_bad_row_which_is_refused_by_line_and_reason() {
        let five = GOOD.replace("0.5", "five");
        let files = [
            format!("{HEAD}\n{GOOD}\n{five}\n"),
            format!("{HEAD}\r\n\r\n{GOOD}\r\n\r\n{five}"),
            format!("{HEAD}\n{GOOD}\n0,0,0,0,0,-1,0,,-1,1\n"),
            format!("{HEAD}\n{GOOD}\n0,0,0,0,0,-1,0,0,-1\n"),
            format!("{HEAD}\n{GOOD}\nnan,0,0,0,0,-1,0,0,-1,1\n"),
            format!("{HEAD}\n{GOOD}\n0,1e400,0,0,0,-1,0,0,-1,1\n"),
            format!("{HEAD}\r{GOOD}\r"),
            HEAD.replace(",r", ""),
            format!("r,{HEAD}\n"),
            String::new(),
        ];
        let transcript = files.map(|file| {
            let output = answer(file.as_bytes(), &["--method", "half_b"]);
            assert_eq!(output.status.code(), Some(1), "{file}");
            text(&output.stdout) + &text(&output.stderr)
        });
        assert_snapshot!(transcript.join("\n"));
    }

    #[test]
    fn that_is_no_file_or_no_text_is_refused() {
        let no_text = answer(&[HEAD.as_bytes(), b"\n\xff\n"].concat(), &[]);
        let said = text(&no_text.stderr);
        assert!(said.contains("standard input, line 2: "), "{said}");
        for path in [".", "no such file"] {
            assert!(refused(&["--csv", path], 1).contains("cannot read"));
        }
    }

    #[test]
    fn is_answered_while_it_is_written() {
        let mut child = start(&["--method", "half_b"]);
        let mut stdin = child.stdin.take().expect("it is piped");
        let mut answers = BufReader::new(child.stdout.take().expect("it is piped")).lines();
        let mut next = || answers.next().expect("it goes on").expect("text");
        writeln!(stdin, "{HEAD}").expect("it reads");
        for row in 1..=3 {
            writeln!(stdin, "{GOOD}").expect("it reads");
            if row == 1 {
                assert_eq!(next(), "row,method,t");
            }
            assert_eq!(next(), format!("{row},half_b,0.5"));
        }
        drop(stdin);
        assert!(child.wait().expect("the program ends").success());
    }

    #[cfg(unix)]
    #[test]
    fn that_has_a_line_without_end_is_refused() {
        for (shell, words) in [
            ("cat /dev/zero", "line 1: it has more than 65536 bytes"),
            (
                "echo HEAD; cat /dev/zero",
                "line 2: it has more than 65536 bytes",
            ),
            ("cat /dev/urandom", "line 1: "),
        ] {
            assert_limited(shell, words);
        }
    }

    #[cfg(unix)]
    #[test]
    #[ignore = "reads all that may be read: some seconds"]
    fn that_has_no_last_line_is_refused() {
        let padded = GOOD.replace("0.5", &format!("{}.5", "0".repeat(60_000)));
        let words = "the file has more than 1000000 lines or 268435456 bytes";
        for line in ["", GOOD, &padded] {
            assert_limited(&format!("echo HEAD; yes '{line}'"), words);
        }
    }

    /// In as much memory as a small file takes.
    #[cfg(unix)]
    fn assert_limited(shell: &str, words: &str) {
        let writer = shell.replace("HEAD", HEAD);
        let script = format!("{{ {writer}; }} | {{ ulimit -v 60000; exec \"$0\" \"$@\"; }}");
        let mut command = std::process::Command::new("sh");
        command
            .args(["-c", &script])
            .arg(suite::command::path_of("rtrace"));
        command.args(["hit", "--method", "half_b", "--csv", "-"]);
        let output = run(&mut command);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{shell}: {said}");
        assert!(said.contains(words), "{shell}: {said}");
    }

    fn answers(file: &str, arguments: &[&str]) -> String {
        let output = answer(file.as_bytes(), arguments);
        assert_success(&output);
        text(&output.stdout)
    }

    /// Hands `file` to the program's standard input.
    fn answer(file: &[u8], arguments: &[&str]) -> Output {
        let mut child = start(arguments);
        let mut stdin = child.stdin.take().expect("it is piped");
        let file = file.to_owned();
        // At the same time, because the answers may fill a pipe too.
        let writer = std::thread::spawn(move || {
            let _ = stdin.write_all(&file);
        });
        let output = child.wait_with_output().expect("the program ends");
        writer.join().expect("the file was handed over");
        output
    }

    fn start(arguments: &[&str]) -> Child {
        program_with("rtrace", &["hit", "--csv", "-"])
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts")
    }
}

/// What is said of a command line that ends with this exit code.
fn refused(arguments: &[&str], code: i32) -> String {
    let output = run(program_with("rtrace", &["hit"]).args(arguments));
    assert_eq!(output.status.code(), Some(code));
    assert_eq!(text(&output.stdout), "");
    text(&output.stderr)
}
