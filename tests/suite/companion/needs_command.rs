//! What `cargo rtrace needs` says. Which method is the least is asked of the library, with
//! costs that are given: no clock decides a test.

use std::fs;
use std::path::Path;
use std::process::Output;

use insta::assert_snapshot;
use laws::oracle::Exact;
use measure::needs::{Culprit, Found};
use measure::scene_file::{self, find_scene};
use measure::wrong_pixels;
use speed_vs_accuracy::{METHODS, Method, Precision, Scene};
use tempfile::TempDir;

use suite::command::{
    assert_failed, assert_success, names_in, picture_in, program_with, run, text,
};

/// Of the book: in `f64` only methods draw it right that take several times as long as
/// the others, and in `f32` none does.
const GRAZING: &str = concat!(
    "width = 128\n",
    include_str!("../../../chapters/6_speed_vs_accuracy/scenes/grazing.toml")
);

const NEIGHBORS: &str = include_str!("../../../chapters/6_speed_vs_accuracy/scenes/neighbors.toml");

/// An Earth, from 2.5 m above: its numbers are numbers of an `f32`, those of its hit points
/// are not.
const EARTH: &str = "\
width = 64
sun = [1, 0.25, 0.5]
[camera]
origin = [3678300, 3678300, 3678300]
direction = [-1, -1, -1]
[[sphere]]
center = [0, 0, 0]
radius = 6371000
";

/// A ball so far away that `half_b` sees it where it is not.
const FAR: &str = "\
width = 40
[camera]
zoom = 1e8
[[sphere]]
center = [0.1, 0.2, -3e8]
radius = 1.5
";

/// Dark specks in `f32`: rays that leave a ground for the sun. Only what widens its
/// numbers draws none.
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
    fn is_the_cheapest_that_draws_every_pixel_right() {
        for (scene, precision, least, failing) in [
            (FAR, Precision::Double, "cross_q", "half_b_q"),
            (
                SUNNY,
                Precision::Single,
                "widened_half_b_q_f32",
                "half_b_f32",
            ),
            (GRAZING, Precision::Double, "certified_hit", "adaptive_q"),
        ] {
            // In the order of the list, the later the dearer.
            let found = found(&read(scene), precision, |place| 1.0 + place as f64);
            let name = |row: usize| found.rows[row].view.method.name;
            assert_eq!(found.least.map(name), Some(least), "{scene}");
            let cheaper = found.failing.as_ref().map(|(row, _)| name(*row));
            assert_eq!(cheaper, Some(failing), "{scene}");
            assert!(found.ties.is_empty());
        }
    }

    #[test]
    fn is_the_simplest_of_those_that_cost_the_same() {
        let found = found(&read(FAR), Precision::Double, |_| 1.0);
        let name = |row: &usize| found.rows[*row].view.method.name;
        assert_eq!(found.least.as_ref().map(name), Some("cross_q"));
        let ties: Vec<&str> = found.ties.iter().map(name).collect();
        assert_eq!(ties[..2], ["adaptive_q", "certified_hit"]);
        assert!(
            found
                .ties
                .iter()
                .all(|&row| found.rows[row].view.wrong == 0)
        );
    }

    /// The first pixel at which it fails shows a question, and the oracle has another
    /// answer to it than the method.
    #[test]
    fn is_justified_by_a_question_that_the_next_cheaper_one_gets_wrong() {
        for scene in [FAR, GRAZING] {
            let scene = read(scene);
            let found = found(&scene, Precision::Double, |place| 1.0 + place as f64);
            let (row, culprit) = found.failing.expect("one fails");
            let method = found.rows[row].view.method;
            let Culprit { case, t_min, .. } = culprit;
            let exact = Exact::of(&case);
            let hits = exact.nearest_root_in(t_min, f64::INFINITY).is_some();
            let answer = case.put_to(&method, t_min, f64::INFINITY);
            assert_ne!(answer.is_some(), hits, "{} on {case}", method.name);

            let right = scene.right_picture(scene.width);
            let drawn = scene.picture(method, scene.width);
            let [i, j] = culprit.pixel;
            let first = 3 * (j * scene.width + i) as usize;
            let colors = [&drawn, &right].map(|picture| &picture.rgb()[first..first + 3]);
            assert_eq!(culprit.colors.each_ref().map(|color| &color[..]), colors);
            let before = right.rgb()[..first].iter().zip(drawn.rgb());
            let mut wrong = before.filter(|(right, drawn)| right.abs_diff(**drawn) > 1);
            assert_eq!(wrong.next(), None, "another pixel is wrong before");
        }
    }

    /// What is found where a question takes each method, by its place in the list, so long.
    fn found(scene: &Scene, precision: Precision, cost: impl Fn(usize) -> f64) -> Found {
        let mut times: Vec<(Method, Vec<f64>)> = METHODS
            .iter()
            .enumerate()
            .map(|(place, method)| (*method, vec![cost(place); 4]))
            .collect();
        times.sort_by_key(|(method, _)| method.name != Method::REFERENCE.name);
        let mut methods = METHODS.to_vec();
        methods.retain(|method| method.precision() == precision);
        let drawn = wrong_pixels::drawn(scene, &methods, scene.width, || ());
        Found::new(scene, precision, drawn.by_method, &times)
    }

    /// The scene is the same one, so the picture is.
    #[test]
    fn does_not_depend_on_the_length_of_the_vector_towards_the_sun() {
        let sunny = read(SUNNY).right_picture(64);
        for sun in ["[1000, 250, 500]", "[1e-3, 0.25e-3, 0.5e-3]"] {
            let scene = read(&SUNNY.replace("[1, 0.25, 0.5]", sun));
            let levels = wrong_pixels::levels_off(&sunny, &scene.right_picture(64));
            assert!(levels.iter().all(|&levels| levels <= 1), "{sun}");
        }
    }

    /// Better digits of t for each sphere would not help there.
    #[test]
    fn names_what_helps_where_no_method_for_one_sphere_does() {
        for (scene, words) in [(NEIGHBORS, "certified_nearest"), (EARTH, "proven_offset")] {
            let folder = TempDir::new().expect("a folder");
            let output = needs(folder.path(), scene, &["--width", "64"]);
            assert_success(&output);
            let said = text(&output.stdout);
            assert!(said.contains(words), "{said}");
        }
    }
}

mod a_scene {
    use super::*;

    #[test]
    fn of_chapter_6_is_the_telescope_that_its_picture_shows() {
        assert_eq!(find_scene("telescope"), Some(&Scene::telescope()));
    }

    #[test]
    fn on_the_page_is_read() {
        let page = include_str!("../../../book/notes/speed_vs_accuracy.md");
        let block = page.split("```toml\n").nth(1).expect("the page has one");
        let scene = read(block.split("```").next().unwrap_or_default());
        assert_eq!((scene.width, scene.spheres.len()), (400, 1));
    }

    #[test]
    fn that_is_all_sky_or_as_small_as_can_be_or_seen_from_inside_is_answered() {
        let sphere = "[[sphere]]\ncenter = [0, 0, 0]\nradius = -1\n";
        let away = "width = 9\n[camera]\norigin = [0, 0, 1e9]\ndirection = [0, 0, 1]\n";
        // Directions are as short as 1e-300 then, which an f32 has as 0.
        let huge = sphere.replace("-1", "1e200");
        for (scene, words) in [
            (format!("{away}{sphere}"), "No ray meets a sphere"),
            (format!("width = 1\n{sphere}"), "1 × 1 pixels"),
            (
                format!("width = 9\n[camera]\nzoom = 5e299\n{huge}"),
                "These numbers do not fit into f32",
            ),
        ] {
            let folder = TempDir::new().expect("a folder");
            let output = needs(folder.path(), &scene, &[]);
            assert_success(&output);
            let said = text(&output.stdout);
            assert!(said.contains(words), "{scene}: {said}");
            assert!(!said.contains("NaN") && !said.contains("inf "), "{said}");
        }
    }

    #[test]
    fn with_a_mistake_is_refused_by_line_and_column() {
        let sphere = "[[sphere]]\ncenter = [0, 0, -1]\nradius = 1\n";
        let transcript = [
            "",
            "cx,cy,cz,r\n0,0,-1,1\n",
            "sphere = []",
            "[[sphere]]\ncentre = [0, 0, 0]\n",
            "[[sphere]]\ncenter = [0, 0]\n",
            "[[sphere]]\ncenter = [0, 0, 0]\n",
            "[[sphere]]\ncenter = [0, 0, nan]\nradius=1",
            "[[sphere]]\ncenter = [0, 1e400, 0]\nradius=1",
            "[[sphere]]\r\ncenter = [0, 0, 0]\r\nradius = five\r\n",
            "[[sphere]]\ncenter = 0, 0, 0\n",
            "[[sphere]]\ncenter = [0, 0, 0]\nradius = 0\n",
            "[sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
            "SPHEREsun = [1, 0, 0]\n",
            "SPHEREradius = 2\n",
            "width = 0\nSPHERE",
            "width = 4e2\nSPHERE",
            "sun = [0, 0, 0]\nSPHERE",
            "[camera]\nzoom = -1\nSPHERE",
            "[camera]\nzoom = [1, 2, 3]\nSPHERE",
            "camera = 1\nSPHERE",
        ]
        .map(|text| {
            let text = text.replace("SPHERE", sphere);
            scene_file::read("it", &text).map_or_else(|error| error.to_string(), |_| text)
        });
        assert_snapshot!(transcript.join("\n"));
    }

    #[test]
    fn that_is_no_text_or_too_long_or_not_there_is_refused_by_its_name() {
        let folder = TempDir::new().expect("a folder");
        let path = folder.path().join("scene.toml");
        let refused = |words: &[&str]| {
            let mut command = program_with("rtrace", &["needs"]);
            let command = command.arg(&path).args(["--output", "no folder is made"]);
            assert_failed(command, words);
            assert!(names_in(folder.path()).len() <= 1);
        };
        refused(&["scene.toml", "cannot read"]);
        fs::write(&path, b"# \xc3\xa4\n# \xff\n").expect("the folder takes it");
        refused(&["scene.toml", "UTF-8"]);
        fs::write(&path, "sun = 1").expect("the folder takes it");
        refused(&["scene.toml: TOML parse error at line 1, column 7"]);
        fs::write(&path, vec![b'#'; (1 << 24) + 1]).expect("the folder takes it");
        refused(&["scene.toml", "more than 16777216 bytes"]);
        let sphere = "[[sphere]]\ncenter = [0, 0, -1]\nradius = 1\n";
        fs::write(&path, sphere.repeat(10_001)).expect("the folder takes it");
        refused(&["there are 10001 spheres", "10000"]);
    }
}

mod the_folder {
    use super::*;

    #[test]
    fn has_the_chart_the_right_picture_and_the_wrong_ones() {
        let folder = TempDir::new().expect("a folder");
        assert_success(&needs(folder.path(), FAR, &[]));
        let (out, scene) = (folder.path().join("out"), read(FAR));
        let right = scene.right_picture(scene.width);
        assert!(picture_in(&out.join("right.png")) == right);
        let mut expected = [".rtrace-manifest", "chart.svg", "right.png"]
            .map(str::to_owned)
            .to_vec();
        for method in METHODS {
            let drawn = scene.picture(*method, scene.width);
            let levels = wrong_pixels::levels_off(&right, &drawn);
            if levels.iter().any(|&levels| levels > 1) {
                let name = format!("{}.png", method.name);
                assert!(picture_in(&out.join(&name)) == drawn);
                expected.push(name);
            }
        }
        expected.sort();
        assert_eq!(names_in(&out), expected);
    }

    /// Of any text, the last line but two shows the same ray once more.
    #[test]
    fn comes_with_a_text_that_shows_the_ray_at_which_another_fails() {
        let folder = TempDir::new().expect("a folder");
        let output = needs(folder.path(), GRAZING, &[]);
        assert_success(&output);
        let said = text(&output.stdout);
        assert!(
            said.starts_with("scene: 3 spheres, 128 × 72 pixels\n"),
            "{said}"
        );
        let again = said.lines().find_map(|line| line.split_once("rtrace hit "));
        let (_, again) = again.expect("the same again");
        let microscope = run(program_with("rtrace", &["hit"]).args(again.split(' ')));
        assert_success(&microscope);
        let wrong = said.lines().find(|line| line.contains("WRONG: "));
        let wrong = wrong.expect("a wrong answer").trim();
        let all = text(&microscope.stdout);
        assert!(
            all.lines().any(|line| line.trim() == wrong),
            "{wrong}: {all}"
        );
    }
}

/// Runs it in `folder`, in which it is given a file and writes into `out`.
fn needs(folder: &Path, scene: &str, arguments: &[&str]) -> Output {
    fs::write(folder.join("scene.toml"), scene).expect("the folder takes it");
    let mut command = program_with("rtrace", &["needs", "scene.toml", "--output", "out"]);
    run(command.args(arguments).current_dir(folder))
}

fn read(scene: &str) -> Scene {
    scene_file::read("scene", scene).unwrap_or_else(|error| panic!("{error}"))
}
