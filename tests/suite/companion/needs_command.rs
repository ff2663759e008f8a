//! What `cargo rtrace needs` says: scenes that are not the book's, by the real program,
//! beside pictures that the library draws and answers of the exact oracle.

use std::fs;
use std::path::Path;
use std::process::{Output, Stdio};

use common::rtweekend::*;
use figures::number::three_digits;
use laws::oracle::Exact;
use serde_json::Value;
use speed_vs_accuracy::{Case, METHODS, Method, Precision, Scene, find};
use tempfile::TempDir;

use suite::command::{
    assert_failed, assert_success, names_in, picture_in, program_with, run, text,
};
use suite::random::Random;

/// Of the book: in `f64` only methods draw it right that take several times as long as
/// the others, and in `f32` none does.
const GRAZING: &str = concat!(
    "width = 128\n",
    include_str!("../../../chapters/6_speed_vs_accuracy/scenes/grazing.toml")
);

/// A ball so far away that `half_b` sees it where it is not.
const FAR: &str = "\
width = 40
[camera]
zoom = 1e8
[[sphere]]
center = [0.1, 0.2, -3e8]
radius = 1.5
";

/// Dark specks in `f32`: rays that leave a ground for the sun. Only the slowest method
/// in `f32`, which takes twice as long as the others, draws none.
const SUNNY: &str = "\
width = 64
sun = [1, 0.25, 0.5]
[[sphere]]
center = [0, -20000.5, -1]
radius = 20000
";

mod the_least {
    use super::*;

    #[test]
    fn draws_every_pixel_right_and_what_is_cheaper_fails_or_ties() {
        for scene in [FAR, SUNNY] {
            let said = json_of(scene);
            for precision in ["f64", "f32"] {
                let found = &said[precision];
                let rows = found["methods"].as_array().expect("rows");
                let least = found["least"].as_str().expect("one suffices");
                let place = rows.iter().position(|row| row["name"] == least);
                let place = place.expect("it is one of the methods");
                assert_eq!(rows[place]["wrong_pixels"], 0);
                for row in &rows[..place] {
                    let ties = found["ties"].as_array().expect("names");
                    let is_tie = ties.contains(&row["name"]);
                    assert_eq!(row["wrong_pixels"] == 0, is_tie, "{found:#}");
                }
                let costs: Vec<f64> = rows
                    .iter()
                    .map(|row| number(&row["times_half_b"]))
                    .collect();
                assert!(costs.is_sorted() && costs[0] > 0.0, "{costs:?}");
            }
        }
    }

    #[test]
    fn is_chosen_by_the_pixels_that_the_library_draws() {
        let scene = read(FAR);
        let said = json_of(FAR);
        for method in METHODS {
            let right = scene.right_picture(method.precision(), scene.width);
            let drawn = scene.picture(*method, scene.width);
            let [mut wrong, mut near, mut worst] = [0; 3];
            for (right, drawn) in right.rgb().chunks(3).zip(drawn.rgb().chunks(3)) {
                let off = (0..3).map(|n| i32::from(right[n]) - i32::from(drawn[n]));
                let levels = off.map(i32::abs).max().unwrap_or(0);
                wrong += i32::from(levels > 1);
                near += i32::from(levels == 1);
                worst = worst.max(levels);
            }
            let row = row(&said, method);
            assert_eq!(
                [
                    &row["wrong_pixels"],
                    &row["a_level_off"],
                    &row["worst_levels"]
                ],
                [wrong, near, worst],
                "{}",
                method.name
            );
        }
        assert!(number(&row(&said, &Method::HALF_B)["wrong_pixels"]) > 100.0);
        assert_eq!(row(&said, &Method::HALF_B)["times_half_b"], 1.0);
    }

    /// The first pixel at which it fails shows a question, and the oracle has another
    /// answer to it than the method.
    #[test]
    fn is_justified_by_a_question_that_the_next_cheaper_one_gets_wrong() {
        for (scene, precision) in [
            (GRAZING, Precision::Double),
            (GRAZING, Precision::Single),
            (SUNNY, Precision::Single),
        ] {
            let fails = &json_of(scene)[precision.name()]["fails"];
            let method = find(fails["method"].as_str().expect("one fails")).expect("it exists");
            let case = Case {
                center: vector(&fails["center"]),
                radius: number(&fails["radius"]),
                ray: Ray::new(vector(&fails["origin"]), vector(&fails["direction"])),
            };
            let t_min = number(&fails["t_min"]);
            let exact = Exact::of(&case.rounded(precision));
            let hits = exact.nearest_root_in(t_min, f64::INFINITY).is_some();
            let answer = case.put_to(&method, t_min, f64::INFINITY);
            assert_ne!(answer.is_some(), hits, "{fails:#}");

            let scene = read(scene);
            let [i, j] = [0, 1].map(|n| number(&fails["pixel"][n]) as usize);
            let first = 3 * (j * scene.width as usize + i);
            let right = scene.right_picture(precision, scene.width);
            let drawn = scene.picture(method, scene.width);
            for (picture, key) in [(&right, "right"), (&drawn, "drawn")] {
                assert_eq!(fails[key], Value::from(&picture.rgb()[first..first + 3]));
            }
            let wrong = right.rgb()[..first]
                .iter()
                .zip(drawn.rgb())
                .find(|(right, drawn)| right.abs_diff(**drawn) > 1);
            assert_eq!(wrong, None, "another pixel is wrong before");
        }
    }

    #[test]
    fn of_the_books_row_of_balls_is_certified_in_both_precisions() {
        let said = json_of(GRAZING);
        assert_eq!(said["size"], Value::from([128, 72]));
        for precision in Precision::ALL {
            let least = said[precision.name()]["least"].as_str().and_then(find);
            assert!(least.is_some_and(|least| least.is_certified), "{said:#}");
        }
    }

    #[test]
    fn is_told_with_the_ray_at_which_the_next_cheaper_one_fails() {
        let folder = TempDir::new().expect("a folder");
        let output = needs(folder.path(), GRAZING, &[]);
        assert_success(&output);
        let said = text(&output.stdout);
        assert!(
            said.starts_with("scene: 3 spheres, 128 × 72 pixels\n"),
            "{said}"
        );
        for words in [
            "In f64, the least that suffices is ",
            "÷ half_b",
            " profile, ",
        ] {
            assert!(said.contains(words), "{said}");
        }
        let mut lines = said.lines();
        let again = lines.find_map(|line| Some(line.split_once("rtrace hit ")?.1));
        let again: Vec<&str> = again.expect("the same again").split(' ').collect();
        let microscope = run(program_with("rtrace", &["hit"]).args(again));
        assert_success(&microscope);
        let wrong = |line: &&str| line.contains("WRONG: ");
        let shown = said.lines().find(wrong).expect("a wrong answer").trim();
        let all = text(&microscope.stdout);
        assert!(
            all.lines().any(|line| line.trim() == shown),
            "{shown}: {all}"
        );
    }
}

mod the_page {
    use super::*;

    const PAGE: &str = include_str!("../../../book/notes/speed_vs_accuracy.md");

    #[test]
    fn has_a_scene_that_is_read() {
        let scene = read(block("toml"));
        assert_eq!((scene.width, scene.spheres.len()), (400, 1));
        assert!(scene.sun.is_some());
    }

    /// But for the times, which are of some machine.
    #[test]
    fn says_of_the_row_of_balls_what_the_program_does() {
        let said = json_of(&GRAZING.replace("128", "400"));
        let lines = block("text").lines().skip(5);
        assert!(lines.clone().count() > 3);
        for line in lines {
            let words: Vec<&str> = line.trim_start_matches('→').split_whitespace().collect();
            let method = find(words[0]).expect("a method");
            let row = row(&said, &method);
            for (word, key) in
                words[1..4]
                    .iter()
                    .zip(["wrong_pixels", "a_level_off", "worst_levels"])
            {
                assert_eq!(row[key].to_string(), *word, "{line}");
            }
            assert_eq!(
                three_digits(number(&row["worst_radii"])),
                words[4],
                "{line}"
            );
        }
    }

    /// The first block in that language.
    fn block(language: &str) -> &'static str {
        let fence = format!("```{language}\n");
        let (_, rest) = PAGE.split_once(&fence).expect("the page has one");
        rest.split("```").next().unwrap_or_default()
    }
}

mod a_scene {
    use super::*;

    #[test]
    fn that_is_all_sky_or_as_small_as_can_be_or_seen_from_inside_is_answered() {
        let outside = "[camera]\norigin = [0, 0, 1e9]\ndirection = [0, 0, 1]\n";
        for (before, width, words) in [
            (outside, 9, "No ray meets a sphere"),
            ("", 1, "1 × 1 pixels"),
            (
                "[camera]\norigin = [0.5, 0, 0]\n",
                9,
                "the least that suffices is",
            ),
            ("[camera]\nzoom = 5e299\n", 9, "f32 has no such numbers"),
            ("[camera]\ndirection = [0, 5e-324, 0]\n", 9, "In f32"),
            (
                "[camera]\ndirection = [1e308, 1e308, -1e308]\n",
                9,
                "In f32",
            ),
        ] {
            let sphere = "[[sphere]]\ncenter = [0, 0, 0]\nradius = -1\n";
            let scene = format!("width = {width}\n{before}{}", sphere.repeat(3));
            let scene = match words {
                // Directions are as short as 1e-300 then, which an f32 has as 0.
                "f32 has no such numbers" => scene.replace("radius = -1", "radius = 1e200"),
                _ => scene,
            };
            let folder = TempDir::new().expect("a folder");
            let output = needs(folder.path(), &scene, &[]);
            assert_success(&output);
            let said = text(&output.stdout);
            assert!(said.contains(words), "{scene}: {said}");
            assert!(!said.contains("NaN") && !said.contains("inf "), "{said}");
        }
    }

    #[test]
    fn with_a_mistake_is_refused_by_line_column_and_fix() {
        let sphere = "[[sphere]]\ncenter = [0, 0, -1]\nradius = 1\n";
        for (scene, place, words) in [
            ("", "1:1", &["no sphere", "[[sphere]]"][..]),
            ("cx,cy,cz,r\n0,0,-1,1\n", "1:3", &["no TOML", "[[sphere]]"]),
            (
                "[[sphere]]\ncentre = [0, 0, 0]\n",
                "2:1",
                &["`centre`", "center, radius"],
            ),
            (
                "[[sphere]]\ncenter = [0, 0]\n",
                "2:10",
                &["these are 2", "[x, y, z]"],
            ),
            ("[[sphere]]\ncenter = [0, 0, 0]\n", "1:1", &["no radius"]),
            (
                "[[sphere]]\ncenter = [0, 0, nan]\nradius=1",
                "2:17",
                &["no number", "1e-9"],
            ),
            (
                "[[sphere]]\ncenter = [0, 1e400, 0]\nradius=1",
                "2:14",
                &["too large"],
            ),
            (
                "[[sphere]]\r\ncenter = [0, 0, 0]\r\nradius = five\r\n",
                "3:10",
                &["no TOML"],
            ),
            (
                "[[sphere]]\n\tcenter = 0, 0, 0\n",
                "2:12",
                &["no TOML", "[x, y, z]"],
            ),
            (
                "[[sphere]]\ncenter = [0, 0, 0]\nradius = 0\n",
                "3:10",
                &["radius 0"],
            ),
            (
                "[sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
                "1:1",
                &["[[sphere]]"],
            ),
            ("SPHEREsun = [1, 0, 0]\n", "4:1", &["`sun`", "above"]),
            ("SPHEREradius = 2\n", "4:1", &["duplicate", "one of them"]),
            ("width = 0\nSPHERE", "1:9", &["from 1 to 3840"]),
            ("width = 4e2\nSPHERE", "1:9", &["whole number"]),
            ("sun = [0, 0, 0]\nSPHERE", "1:7", &["length 0"]),
            ("[camera]\nzoom = -1\nSPHERE", "2:8", &["above 0"]),
            (
                "[camera]\nzoom = [1, 2, 3]\nSPHERE",
                "2:8",
                &["one number or two"],
            ),
            (
                "[camera]\ndirection = [0, 0, 0]\nSPHERE",
                "2:13",
                &["length 0"],
            ),
            ("camera = 1\nSPHERE", "1:10", &["[camera]"]),
            ("sky = 1\nSPHERE", "1:1", &["`sky`", "camera"]),
        ] {
            let scene = scene.replace("SPHERE", sphere);
            let folder = TempDir::new().expect("a folder");
            let output = needs(folder.path(), &scene, &[]);
            assert_eq!(output.status.code(), Some(1), "{scene}");
            let said = text(&output.stderr);
            let place = format!("scene.toml:{place}: ");
            for words in words.iter().chain([&&place[..], &"^\n"]) {
                assert!(said.contains(words), "{words} in {said}");
            }
            assert!(output.stdout.is_empty());
            assert_eq!(names_in(folder.path()), ["scene.toml"]);
        }
    }

    #[test]
    fn however_it_is_spoiled_is_read_or_refused_at_a_place_that_is_there() {
        let pieces = "[ ] [[ = , . - e 9 0 \n \" ' # nan 1e999 0x1 sun sphere \u{e4} \t";
        let pieces: Vec<&str> = pieces.split(' ').collect();
        let mut random = Random(1);
        let [mut read, mut refused] = [0; 2];
        for _ in 0..5000 {
            let mut scene = SUNNY.to_owned();
            for _ in 0..=random.below(3) {
                let [from, length] = [scene.len() + 1, 5].map(|most| random.below(most));
                let from = scene.floor_char_boundary(from);
                let to = scene.floor_char_boundary((from + length).min(scene.len()));
                scene.replace_range(from..to.max(from), pieces[random.below(pieces.len())]);
            }
            match Scene::read("it", &scene) {
                Ok(scene) => {
                    read += 1;
                    assert!(scene.fits(Precision::Double), "{scene:?}");
                }
                Err(mistake) => {
                    refused += 1;
                    let line = scene.split('\n').nth(mistake.line - 1);
                    let line = line.unwrap_or_else(|| panic!("{mistake} in {scene:?}"));
                    assert!(mistake.column <= line.chars().count() + 1, "{mistake}");
                    assert!(!mistake.what.is_empty() && mistake.fix.ends_with('.'));
                }
            }
        }
        assert!(read > 50 && refused > 50, "{read} and {refused}");
    }

    #[test]
    fn that_is_no_text_or_too_long_or_not_there_is_refused_by_its_name() {
        let folder = TempDir::new().expect("a folder");
        let path = folder.path().join("scene.toml");
        let needs = || {
            let mut command = program_with("rtrace", &["needs"]);
            command.arg(&path).args(["--output", "no folder is made"]);
            command
        };
        assert_failed(&mut needs(), &["scene.toml", "cannot read"]);
        fs::write(&path, b"# \xc3\xa4\n# \xff\n").expect("the folder takes it");
        assert_failed(&mut needs(), &["scene.toml:2:3: ", "UTF-8"]);
        fs::write(&path, vec![b'#'; (1 << 24) + 1]).expect("the folder takes it");
        assert_failed(&mut needs(), &["scene.toml", "more than 16777216 bytes"]);
        let sphere = "[[sphere]]\ncenter = [0, 0, -1]\nradius = 1\n";
        fs::write(&path, sphere.repeat(10_001)).expect("the folder takes it");
        assert_failed(
            &mut needs(),
            &["scene.toml:1:1: ", "10001 spheres", "10000"],
        );
        fs::remove_file(&path).expect("it is there");
        fs::create_dir(&path).expect("a folder");
        assert_failed(&mut needs(), &["scene.toml", "cannot read"]);
    }
}

mod the_folder {
    use super::*;

    #[test]
    fn has_the_chart_the_right_pictures_and_the_wrong_ones() {
        let folder = TempDir::new().expect("a folder");
        let said = json_in(folder.path(), FAR);
        let out = folder.path().join("out");
        let scene = read(FAR);
        for precision in Precision::ALL {
            let name = format!("right_{}.png", precision.name());
            let right = scene.right_picture(precision, scene.width);
            assert!(picture_in(&out.join(name)) == right);
        }
        let mut expected = 3;
        for method in METHODS {
            let path = out.join(method.name).with_extension("png");
            let is_wrong = row(&said, method)["wrong_pixels"] != 0;
            assert_eq!(path.is_file(), is_wrong, "{}", method.name);
            if is_wrong {
                expected += 1;
                assert!(picture_in(&path) == scene.picture(*method, scene.width));
            }
        }
        assert_eq!(said["files"].as_array().map(Vec::len), Some(expected));
        let chart = fs::read_to_string(out.join("chart.svg")).expect("the chart");
        let chart = roxmltree::Document::parse(&chart).expect("SVG is XML");
        for method in METHODS {
            let is_name = |label: &str| label.split(',').next() == Some(method.name);
            let named = chart
                .descendants()
                .filter_map(|node| node.text())
                .any(is_name);
            let has_hit = row(&said, method)["worst_radii"] != Value::Null;
            assert!(named || !has_hit, "{} is not named", method.name);
        }
    }

    #[test]
    fn is_replaced_by_the_next_one_unless_it_holds_something_else() {
        let folder = TempDir::new().expect("a folder");
        for _first_then_again in 0..2 {
            assert_success(&needs(folder.path(), SUNNY, &["--width=2"]));
        }
        let mine = folder.path().join("out").join("mine.txt");
        fs::write(&mine, "mine").expect("the folder takes it");
        let refused = needs(folder.path(), SUNNY, &["--width=2"]);
        assert_eq!(refused.status.code(), Some(2));
        let said = text(&refused.stderr);
        assert!(
            said.contains("mine.txt") && refused.stdout.is_empty(),
            "{said}"
        );
        assert_eq!(fs::read_to_string(mine).ok().as_deref(), Some("mine"));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn is_written_also_if_nobody_reads_what_is_said_or_the_disk_is_full() {
        let folder = TempDir::new().expect("a folder");
        fs::write(folder.path().join("scene.toml"), SUNNY).expect("the folder takes it");
        let mut command = program_with("rtrace", &["needs", "scene.toml", "--width=2"]);
        command.args(["-o", "out"]).current_dir(folder.path());
        let mut child = command.stdout(Stdio::piped()).spawn().expect("it starts");
        drop(child.stdout.take());
        assert!(child.wait().expect("it ends").success());
        assert!(folder.path().join("out/chart.svg").is_file());
        let full = fs::OpenOptions::new().write(true).open("/dev/full");
        command.stdout(full.expect("Linux has it"));
        let output = run(&mut command);
        assert_eq!(output.status.code(), Some(1));
        assert!(text(&output.stderr).contains("standard output"));
    }
}

/// What the program says in JSON of a scene.
fn json_of(scene: &str) -> Value {
    json_in(TempDir::new().expect("a folder").path(), scene)
}

fn json_in(folder: &Path, scene: &str) -> Value {
    let output = needs(folder, scene, &["--json"]);
    assert_success(&output);
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// Runs it in `folder`, in which it is given a file and writes into `out`.
fn needs(folder: &Path, scene: &str, arguments: &[&str]) -> Output {
    fs::write(folder.join("scene.toml"), scene).expect("the folder takes it");
    let mut command = program_with("rtrace", &["needs", "scene.toml", "--output", "out"]);
    run(command.args(arguments).current_dir(folder))
}

fn read(scene: &str) -> Scene {
    Scene::read("scene", scene).expect("it is well-formed")
}

fn row<'a>(said: &'a Value, method: &Method) -> &'a Value {
    let rows = said[method.precision().name()]["methods"].as_array();
    let mut rows = rows.expect("rows").iter();
    rows.find(|row| row["name"] == method.name)
        .expect("a row for each method")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn vector(value: &Value) -> Vec3 {
    Vec3::from_array([0, 1, 2].map(|n| number(&value[n])))
}
