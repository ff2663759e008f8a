//! What `cargo rtrace hit` says.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::process::{Command, Output, Stdio};

use speed_vs_accuracy::{METHODS, Precision, REGIMES};
use tempfile::TempDir;

use suite::command::{assert_refused, assert_success, path_of, program_with, run, text};
use suite::random::Random;

mod one_ray {
    use super::*;

    #[test]
    fn at_a_far_sphere_shows_which_methods_lose_digits_and_why() {
        insta::assert_snapshot!(said(&[
            "--origin=-1,0,0",
            "--direction=1,0,-1e-9",
            "--center=3e7,0.5,0",
            "--radius=1",
        ]));
    }

    #[test]
    fn with_a_direction_too_long_shows_which_methods_overflow() {
        insta::assert_snapshot!(said(&[
            "--origin=0,0,0",
            "--direction=0,0,-1e200",
            "--center=0,0,-1",
            "--radius=0.5",
        ]));
    }

    #[test]
    fn may_have_a_range_and_be_seen_by_one_method() {
        let said = said(&[
            "--origin=0,0,0",
            "--direction=0,0,-1",
            "--center=0,0,-1",
            "--radius=0.5",
            "--t-min=0.5",
            "--t-max=1.5",
            "--method=half_b",
        ]);
        assert_eq!(
            said,
            "In f64, the ray misses.\n  half_b                miss                          right\n"
        );
    }

    #[test]
    fn may_start_at_negative_numbers_after_a_space() {
        let ray = ["hit", "--origin", "-1,-2,-3", "--direction", "-1, 0, 0"];
        let sphere = ["--center", "-5,-2,-3", "--radius", "-1", "--t-min", "-1"];
        let output = run(program_with("rtrace", &ray).args(sphere));
        assert_success(&output);
        assert!(text(&output.stdout).starts_with("In f64, the ray hits at t = 3.0.\n"));
    }

    /// Where numbers end, or there is nothing to hit, or to hit with.
    #[test]
    fn beyond_all_numbers_is_told_in_words() {
        const MAX: &str = "1.7976931348623157e308";
        for (direction, center, radius, sentences) in [
            (
                "0,0,-1e-300",
                "0,0,-1e300",
                "1",
                &[
                    "In f64, the ray hits at t = 1.7976931348623157e308 or beyond, where f64 ends.",
                    "as far as f64 goes",
                ][..],
            ),
            ("0,0,1", &format!("0,0,{MAX}"), "0", &["as far as f64 goes"]),
            (
                "0,0,1e-30",
                "0,0,1e30",
                "1",
                &[
                    "In f64, the ray hits at t = 1e60.",
                    "the ray hits at t = 3.4028234663852886e38 or beyond, where f32 ends.",
                ],
            ),
            (
                "0,0,-1e308",
                "0,0,-5e-324",
                "0",
                &["In f64, the ray hits at a t so small that it rounds to 0."],
            ),
            (
                "0,0,1e-50",
                "0,0,1",
                "0.5",
                &[
                    "In f64, the ray hits at t = 5e49.",
                    "In f32, after the numbers are rounded to it, the direction is zero, and such a ray hits nothing.",
                ],
            ),
            (
                "0,0,-1",
                "0,1e-200,-1e200",
                "1e-201",
                &["In f64, the ray misses."],
            ),
        ] {
            let said = said_of(["0,0,0", direction, center], radius, &[]);
            for sentence in sentences {
                assert!(said.contains(sentence), "{sentence}: {said}");
            }
        }
    }

    #[test]
    fn has_no_answer_that_is_no_number() {
        let numbers = [
            "0", "-1", "1e308", "5e-324", "1e-160", "1e160", "1e39", "1e-46",
        ];
        let mut random = Random(1);
        for _ in 0..400 {
            let mut number = || numbers[random.below(numbers.len())];
            let vectors = [(); 3].map(|()| [(); 3].map(|()| number()).join(","));
            let vectors = vectors.each_ref().map(String::as_str);
            let radius = number();
            let ranges: [&[&str]; 3] = [&[], &["--t-min=-inf"], &["--t-max=1e308"]];
            let range = ranges[random.below(3)];
            let said = said_of(vectors, radius, range);
            let words = said.split(|letter: char| !letter.is_alphanumeric());
            for word in words {
                let odd = ["nan", "inf"].contains(&word.to_lowercase().as_str());
                assert!(!odd, "{vectors:?} and {radius}: {said}");
            }
        }
    }

    /// Of origin, direction and center, and a radius.
    fn said_of(vectors: [&str; 3], radius: &str, range: &[&str]) -> String {
        let [origin, direction, center] = vectors;
        let case = [
            "--origin",
            origin,
            "--direction",
            direction,
            "--center",
            center,
        ];
        said(&[&case[..], &["--radius", radius], range].concat())
    }

    #[test]
    fn that_is_no_ray_is_refused() {
        for (option, words) in [
            ("--origin=1,2", &["three numbers"][..]),
            ("--origin=1,2,x", &["x", "is no number"]),
            ("--origin=1,2,1e999", &["1e999", "is too large"]),
            ("--origin=1,2,inf", &["inf", "is no number"]),
        ] {
            assert_refused(&mut program_with("rtrace", &["hit", option]), words);
        }
        let mut alone = program_with("rtrace", &["hit", "--origin=0,0,0"]);
        assert_refused(&mut alone, &["--direction", "--center", "--radius"]);
    }

    fn said(arguments: &[&str]) -> String {
        let output = run(program_with("rtrace", &["hit"]).args(arguments));
        assert_success(&output);
        text(&output.stdout)
    }
}

mod a_file {
    use super::*;

    const HEAD: &str = "ox,oy,oz,dx,dy,dz,cx,cy,cz,r";

    #[test]
    fn is_answered_row_by_row_by_every_method() {
        let output = answer(
            "ox,oy,oz,dx,dy,dz,cx,cy,cz,r\n0,0,0,0,0,-1,0,0,-1,0.5\n0,0,0,1,0,0,0,0,-1,0.5\n",
            &[],
        );
        assert_success(&output);
        let mut expected = "row,method,t\n".to_owned();
        for (row, t) in [("1", "0.5"), ("2", "")] {
            for method in METHODS {
                // The middle of its bounds.
                let t = match (method.name, row) {
                    ("interval_q", "1") => "0.5000000000000001",
                    _ => t,
                };
                expected += &format!("{row},{},{t}\n", method.name);
            }
        }
        assert_eq!(text(&output.stdout), expected);
    }

    #[test]
    fn may_have_its_columns_in_any_order_and_more_of_them() {
        let output = answer(
            "note,r,cz,cy,cx,dz,dy,dx,oz,oy,ox\n\"a, b\",0.5,-1,0,0,-2,0,0,0,0,0\n",
            &["--method", "half_b"],
        );
        assert_success(&output);
        assert_eq!(text(&output.stdout), "row,method,t\n1,half_b,0.25\n");
    }

    #[test]
    fn may_come_from_windows_or_from_a_spreadsheet() {
        let output = answer(
            "\u{feff}ox,oy,oz,dx,dy,dz,cx,cy,cz,r\r\n0, 0, 0, 0, 0, -1, 0, 0, -1, 5e-1\r\n",
            &["--method", "exact"],
        );
        assert_success(&output);
        assert_eq!(text(&output.stdout), "row,method,t\n1,exact,0.5\n");
    }

    #[test]
    fn is_read_to_the_nearest_number_and_answered_in_the_shortest_digits() {
        let output = answer(
            "ox,oy,oz,dx,dy,dz,cx,cy,cz,r\n\
             0,0,0,0,0,-1,0,0,-1.00000000000000011102230246251565404236316680908203126,0\n",
            &["--method", "exact"],
        );
        assert_success(&output);
        // A little more than half of the way to the next number after 1.
        assert_eq!(
            text(&output.stdout),
            "row,method,t\n1,exact,1.0000000000000002\n"
        );
    }

    #[test]
    fn has_the_answers_of_the_library_to_the_last_bit() {
        let mut file = "ox,oy,oz,dx,dy,dz,cx,cy,cz,r\n".to_owned();
        let mut expected = Vec::new();
        for regime in REGIMES {
            for case in regime.cases(Precision::Double, 7, 20) {
                let (ray, center) = (case.ray, case.center);
                let numbers = [ray.origin, ray.direction, center].map(|v| v.to_array());
                for number in numbers.as_flattened() {
                    file += &format!("{number:?},");
                }
                file += &format!("{:?}\n", case.radius);
                for method in METHODS {
                    let t = case.put_to(method, 0.0, f64::INFINITY);
                    expected.push((method, t));
                }
            }
        }
        let output = answer(&file, &[]);
        assert_success(&output);
        let said = text(&output.stdout);
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
    fn with_a_bad_row_is_answered_until_there_and_refused_by_line_and_reason() {
        let good = "ox,oy,oz,dx,dy,dz,cx,cy,cz,r\n0,0,0,0,0,-1,0,0,-1,0.5\n";
        for (row, reason) in [
            (
                "0,0,0,0,0,-1,0,0,-1,five",
                "r is \"five\", which is no number",
            ),
            ("0,0,0,0,0,-1,0,,-1,1", "cy is empty"),
            (
                "0,0,0,0,0,-1,0,0,-1",
                "the fields are 9, but the column names are 10",
            ),
            (
                "nan,0,0,0,0,-1,0,0,-1,1",
                "ox is \"nan\", which is no number",
            ),
            (
                "0,1e400,0,0,0,-1,0,0,-1,1",
                "oy is \"1e400\", which is too large",
            ),
        ] {
            let output = answer(&format!("{good}{row}\n"), &["--method", "half_b"]);
            assert_eq!(output.status.code(), Some(1));
            assert_eq!(text(&output.stdout), "row,method,t\n1,half_b,0.5\n");
            let said = text(&output.stderr);
            assert!(said.contains("standard input, line 3: "), "{said}");
            assert!(said.contains(reason), "{said}");
        }
    }

    /// Whatever ends a line, and however many are empty.
    #[test]
    fn has_lines_that_are_counted_as_an_editor_does() {
        for (file, line) in [
            ("HEAD\r\nGOOD\r\nBAD\r\n", 3),
            ("\u{feff}HEAD\r\nGOOD\r\nBAD", 3),
            ("HEAD\nGOOD\n\n\nBAD\n", 5),
            ("\r\nHEAD\r\n\r\nGOOD\r\n\r\nBAD", 6),
            ("note,HEAD\n\"two\nlines\",GOOD\n\"and\ntwo\",BAD\n", 4),
            ("HEAD\r\nGOOD\r\nGOOD,1\r\n", 3),
            ("HEAD\rGOOD\r\rBAD\r", 4),
            ("\u{feff}HEAD\rGOOD\r\n\r\nBAD\n", 4),
            ("note,HEAD\r\n\"two\r\nlines\",GOOD\r\n\"\r\n\",BAD", 4),
        ] {
            let file = file
                .replace("HEAD", "ox,oy,oz,dx,dy,dz,cx,cy,cz,r")
                .replace("GOOD", "0,0,0,0,0,-1,0,0,-1,0.5")
                .replace("BAD", "0,0,0,0,0,-1,0,0,-1,five");
            let output = answer(&file, &["--method", "half_b"]);
            assert_eq!(output.status.code(), Some(1));
            assert_eq!(text(&output.stdout), "row,method,t\n1,half_b,0.5\n");
            let said = text(&output.stderr);
            assert!(said.contains(&format!("line {line}: ")), "{file:?}: {said}");
        }
    }

    #[test]
    fn with_a_quotation_mark_left_open_is_not_shown_to_its_end() {
        let rows = "0,0,0,0,0,-1,0,0,-1,0.5\n".repeat(1000);
        let file = format!("ox,oy,oz,dx,dy,dz,cx,cy,cz,r\n0,0,0,0,0,-1,0,0,-1,\"0.5\n{rows}");
        let said = text(&answer(&file, &[]).stderr);
        assert!(said.contains("line 2: r is \"0.5"), "{said}");
        assert!(said.len() < 200, "{said}");
    }

    #[test]
    fn is_answered_while_it_is_written() {
        let mut child = start(&["--method", "half_b"]);
        let mut stdin = child.stdin.take().expect("it is piped");
        let mut answers = BufReader::new(child.stdout.take().expect("it is piped"));
        let mut expected = "row,method,t\n".to_owned();
        writeln!(stdin, "\u{feff}{HEAD}").expect("it reads");
        for row in 1..=3 {
            writeln!(stdin, "0,0,0,0,0,-1,0,0,-1,0.5").expect("it reads");
            expected += &format!("{row},half_b,0.5\n");
            let mut said = String::new();
            while said.len() < expected.len() {
                let length = answers.read_line(&mut said).expect("text");
                assert!(length > 0, "it has ended after {said}");
            }
            assert_eq!(said, expected);
            expected.clear();
        }
        drop(stdin);
        assert!(child.wait().expect("the program ends").success());
    }

    /// In as much memory as a small file takes.
    #[cfg(unix)]
    #[test]
    fn that_never_ends_is_refused_by_its_limits() {
        let row = "0,0,0,0,0,-1,0,0,-1,0.5";
        let padded = row.replace("0.5", &format!("{}.5", "0".repeat(60_000)));
        for (shell, words) in [
            ("cat /dev/zero", "line 1: no row ends within 65536 bytes"),
            ("cat /dev/urandom", "line 1: this is no text"),
            (
                "echo HEAD; cat /dev/zero",
                "line 2: no row ends within 65536",
            ),
            (
                "echo HEAD; echo; echo '\"'; yes ROW",
                "line 3: no row ends within",
            ),
            ("echo HEAD; yes ''", "no row ends within 65536 bytes"),
            (
                "echo HEAD; yes ROW",
                "line 1000002: the file has more than 1000000 rows",
            ),
            (
                "echo HEAD; yes PADDED",
                "the file has more than 268435456 bytes",
            ),
        ] {
            let writer = shell
                .replace("HEAD", HEAD)
                .replace("ROW", row)
                .replace("PADDED", &padded);
            let script = format!("{{ {writer}; }} | {{ ulimit -v 60000; exec \"$0\" \"$@\"; }}");
            let mut command = Command::new("sh");
            command.args(["-c", &script]).arg(path_of("rtrace"));
            command.args(["hit", "--method", "half_b", "--csv", "-"]);
            let output = run(&mut command);
            let said = text(&output.stderr);
            assert_eq!(output.status.code(), Some(1), "{shell}: {said}");
            assert!(said.contains(words), "{shell}: {said}");
        }
    }

    #[test]
    fn that_is_a_folder_is_refused() {
        let folder = TempDir::new().expect("a folder");
        let output = run(program_with("rtrace", &["hit", "--csv"]).arg(folder.path()));
        assert_eq!(output.status.code(), Some(1));
        assert!(text(&output.stderr).contains("cannot read"));
    }

    #[test]
    fn without_all_columns_is_refused() {
        for (head, reason) in [
            (
                "ox,oy,oz,dx,dy,dz,cx,cy,cz\n",
                "line 1: there is no column r",
            ),
            ("", "line 1: there is no column ox"),
            (
                "r,r,ox,oy,oz,dx,dy,dz,cx,cy,cz\n",
                "line 1: there are two columns r",
            ),
        ] {
            let output = answer(head, &[]);
            assert_eq!(output.status.code(), Some(1));
            assert_eq!(text(&output.stdout), "");
            let said = text(&output.stderr);
            assert!(said.contains(reason), "{said}");
        }
    }

    #[test]
    fn has_a_name_that_messages_tell() {
        let folder = TempDir::new().expect("a folder");
        let path = folder.path().join("rays.csv");
        let missing = run(program_with("rtrace", &["hit", "--csv"]).arg(&path));
        assert_eq!(missing.status.code(), Some(1));
        assert!(text(&missing.stderr).contains("cannot read"));
        fs::write(&path, b"ox,oy,oz,dx,dy,dz,cx,cy,cz,r\n\xff\n").expect("the folder takes it");
        let output = run(program_with("rtrace", &["hit", "--csv"]).arg(&path));
        assert_eq!(output.status.code(), Some(1));
        let said = text(&output.stderr);
        assert!(said.contains("rays.csv, line 2: "), "{said}");
    }

    /// Whoever reads the answers may stop, as `head` does.
    #[test]
    fn that_nobody_reads_to_the_end_is_no_error() {
        let rows = "0,0,0,0,0,-1,0,0,-1,0.5\n".repeat(20_000);
        let mut child = start(&["--method", "half_b"]);
        drop(child.stdout.take());
        let mut stdin = child.stdin.take().expect("it is piped");
        let file = format!("ox,oy,oz,dx,dy,dz,cx,cy,cz,r\n{rows}");
        // The program may be gone before it has read all.
        let _ = stdin.write_all(file.as_bytes());
        drop(stdin);
        assert_success(&child.wait_with_output().expect("the program ends"));
    }

    /// Hands `file` to the program's standard input.
    fn answer(file: &str, arguments: &[&str]) -> Output {
        let mut child = start(arguments);
        let mut stdin = child.stdin.take().expect("it is piped");
        let file = file.to_owned();
        // At the same time, because the answers may fill a pipe too.
        let writer = std::thread::spawn(move || {
            let _ = stdin.write_all(file.as_bytes());
        });
        let output = child.wait_with_output().expect("the program ends");
        writer.join().expect("the file was handed over");
        output
    }

    fn start(arguments: &[&str]) -> std::process::Child {
        let mut command: Command = program_with("rtrace", &["hit", "--csv", "-"]);
        command
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts")
    }
}
