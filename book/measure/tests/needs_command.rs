//! Answers of `cargo rtrace needs`, which are the same on every machine: the times are recorded.

use std::io::{BufRead, BufReader};
use std::process::Stdio;

use figures::least;
use figures::records::WrongPixels;
use figures::table::Table;
use fixtures::command::text;
use fixtures::desk::Desk;
use insta::assert_snapshot;
use measure::needs::{Place, PrecisionNeeds, RECORDED};
use measure::scene_file::{self, SCENES};
use measure::wrong_pixels;
use speed_vs_accuracy::{METHODS, Precision, REGIMES, Scene};

/// A scene of chapter 6: in `f64` only methods that take several times as long as the others draw
/// it right, and in `f32` no method does.
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

/// Dark specks in `f32`: rays that leave a ground for the sun. Only what widens its
/// numbers draws none.
const SUNNY: &str = "\
width = 64
sun = [1, 0.25, 0.5]
[[sphere]]
center = [0, -20000.5, -1]
radius = 20000
";

#[test]
fn the_least_is_the_cheapest_that_draws_every_pixel_right() {
    let widened = "widened_half_b_q_f32";
    for (scene, precision, least, failing) in [
        (FAR, Precision::Double, "cross_q", "half_b_q"),
        (SUNNY, Precision::Single, widened, "half_b_f32"),
        (GRAZING, Precision::Double, "certified_hit", "cross_q"),
    ] {
        let found = found(&read(scene), precision);
        let name = |row: usize| found.rows[row].view.method.name;
        assert_eq!(found.least.map(name), Some(least), "{scene}");
        let cheaper = found.failing.as_ref().map(|(row, _)| name(*row));
        assert_eq!(cheaper, Some(failing), "{scene}");
    }
}

fn found(scene: &Scene, precision: Precision) -> PrecisionNeeds {
    let mut methods = METHODS.to_vec();
    methods.retain(|method| method.precision() == precision);
    let drawn = wrong_pixels::draw(scene, &methods, scene.width, &|_, _| ());
    let situation = Place::of(scene).situation;
    PrecisionNeeds::new(scene, precision, situation, drawn.by_method, 0.001)
}

/// Each scene of chapter 6 is like the situation of its name, and gets the method that the table
/// marks. The map says the same at the scene's place; it has `half_b_q` where `half_b` does.
#[test]
#[ignore = "draws each scene by each method"]
fn mark_map_and_needs_agree_about_every_scene() {
    let cells = include_str!("../../notes/measured/scenes.snap.csv");
    let cells = Table::<WrongPixels>::read(cells)
        .expect("the file is well-formed")
        .rows;
    let situations = REGIMES.map(|regime| regime.name);
    for scene in SCENES
        .iter()
        .filter(|scene| situations.contains(&&scene.name[..]))
    {
        let scene = Scene {
            width: 128,
            ..scene.clone()
        };
        assert_eq!(Place::of(&scene).situation, scene.name);
        for precision in Precision::ALL {
            let found = found(&scene, precision);
            let taken = found.least.map(|row| found.rows[row].view.method.name);
            let marked = least(&scene.name, precision, &cells, &RECORDED.timings);
            assert_eq!(taken, marked.map(|method| method.name), "{}", scene.name);
        }
        assert_as_the_map(&scene);
    }
    for (center, radius, zoom) in [
        ("0, 0, -1e5", 1.0, 3e4),
        ("1, 0, -1e10", 1.0, 5e9),
        ("0, 30, -1e11", 100.0, 5e8),
        ("0, -6371001, 0", 6371000.0, 1.0),
        ("0.3, 0, -20", 1.0, 8.0),
    ] {
        assert_as_the_map(&read(&format!(
            "width = 100\n[camera]\nzoom = {zoom:?}\n[[sphere]]\ncenter = [{center}]\nradius = {radius:?}"
        )));
    }
}

fn assert_as_the_map(scene: &Scene) {
    let found = found(scene, Precision::Double);
    let taken = found.least.map(|row| found.rows[row].view.method.name);
    let place = Place::of(scene);
    let on_the_map = RECORDED.least(place.hardest, Precision::Double, 3);
    let taken = taken.map(|name| if name == "half_b" { "half_b_q" } else { name });
    assert_eq!(
        taken,
        on_the_map.map(|method| method.name),
        "{scene:?} at {place:?}"
    );
}

/// The text shows the ray at which the next cheaper method fails, and the command that shows
/// it once more.
#[test]
fn a_scene_is_answered_with_a_ray_to_look_at() {
    let desk = Desk::default();
    desk.write("far.toml", FAR);
    let said = text(&desk.run("methods needs far.toml").stdout);
    assert!(
        said.starts_with("Take cross_q: it draws this picture right, and "),
        "{said}"
    );
    let again = said.lines().find_map(|line| line.split_once("rtrace hit "));
    let (_, again) = again.expect("the same again");
    let microscope = text(&desk.run(&format!("methods hit {again}")).stdout);
    let wrong = said
        .lines()
        .map(str::trim)
        .find(|line| line.contains("WRONG: "));
    let wrong = wrong.expect("a wrong answer");
    let has = microscope.lines().any(|line| line.trim() == wrong);
    assert!(has, "{wrong}: {microscope}");
}

/// All is sky, and directions are as short as 1e-300, which an `f32` has as 0.
#[test]
fn a_scene_that_shows_nothing_is_answered() {
    let scene = "width = 1\n[camera]\norigin = [0, 0, 1e205]\ndirection = [0, 0, 1]\n\
                 zoom = 5e299\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1e200\n";
    let desk = Desk::default();
    desk.write("odd.toml", scene);
    let output = desk.run("methods needs odd.toml");
    let said = text(&output.stdout) + &text(&output.stderr);
    for words in ["No ray meets a sphere", "do not fit into f32"] {
        assert!(said.contains(words), "{said}");
    }
    assert!(!said.contains("NaN") && !said.contains("inf "), "{said}");
}

/// A unit of its own needs a t_min of its own, and exact arithmetic is no cure for acne.
#[test]
fn a_t_min_that_does_not_fit_the_scene_is_named() {
    let balls = |t_min: &str, unit: &str| {
        format!(
            "width = 40\nsun = [1, 1, 1]\n{t_min}\n[[sphere]]\ncenter = [0, 0, -3{unit}]\n\
             radius = 1{unit}\n[[sphere]]\ncenter = [0, -100{unit}, 0]\nradius = 99{unit}\n"
        )
    };
    let desk = Desk::default();
    desk.write("molecules.toml", balls("", "e-9"));
    desk.write("acne.toml", balls("t_min = 0", ""));
    let said = |scene: &str| text(&desk.run(&format!("methods needs {scene}")).stdout);
    assert!(said("molecules.toml").contains("WARNING: things cast a shadow only from"));
    let acne = said("acne.toml");
    assert!(acne.starts_with("Raise t_min: above 0.0, "), "{acne}");
    assert!(!acne.contains("WARNING"), "{acne}");
}

#[test]
fn the_scene_in_its_help_is_read() {
    let help = text(&Desk::default().run("methods needs --help").stdout);
    let scene = help.split("are needed:\n").nth(1).expect("a scene");
    let scene = read(scene.split("\n\nThe columns").next().unwrap_or_default());
    assert_eq!((scene.width, scene.spheres.len()), (400, 1));
}

#[test]
fn a_scene_with_a_mistake_is_refused_by_line_and_column() {
    let sphere = "[[sphere]]\ncenter = [0, 0, -1]\nradius = 1\n";
    let transcript = [
        "[[sphere]]\ncentre = [0, 0, 0]\n",
        "[[sphere]]\ncenter = [0, 0, nan]\nradius=1",
        "[[sphere]]\ncenter = [0, 0, 0]\nradius = 0\n",
        "[[sphere]]\ncenter = [0, 0, 0]\nradius = -1\n",
        "width = 0\nSPHERE",
        "sun = [0, 0, 0]\nSPHERE",
        "[camera]\nzoom = -1\nSPHERE",
        "[camera]\nzoom = [1, 2, 3]\nSPHERE",
    ]
    .map(|text| {
        let text = text.replace("SPHERE", sphere);
        scene_file::parse("it", &text).map_or_else(|error| error.to_string(), |_| text)
    });
    assert_snapshot!(transcript.join("\n"));
}

#[test]
fn a_scene_that_can_not_be_read_is_refused_by_its_name() {
    let desk = Desk::default();
    desk.write("no-text.toml", b"# \xff\n");
    desk.write("sun.toml", "sun = 1");
    assert_snapshot!(desk.transcript(
        "methods needs missing.toml
         methods needs no-text.toml
         methods needs sun.toml"
    ));
}

#[test]
#[ignore = "draws for some seconds"]
fn a_scene_that_takes_long_says_how_far_it_is() {
    let sphere = |n| {
        let (x, y) = (n % 50, n / 50);
        format!("[[sphere]]\ncenter=[{x}, {y}, -9]\nradius=0.4\n")
    };
    let desk = Desk::default();
    desk.write("scene.toml", (0..2500).map(sphere).collect::<String>());
    let mut needs = desk.command("methods needs scene.toml --width 1000");
    let mut child = needs.stderr(Stdio::piped()).spawn().expect("it starts");
    let mut first = String::new();
    let errors = child.stderr.take().expect("it is piped");
    let read = BufReader::new(errors).read_line(&mut first);
    child.kill().expect("it runs");
    child.wait().expect("it ends");
    read.expect("a line");
    assert!(first.contains("% of the picture is drawn"), "{first}");
}

/// A file up to its limit is read, and one that is a byte longer is refused.
#[test]
fn a_scene_that_is_longer_than_its_limit_is_not_read() {
    let scene = "width = 8\n[[sphere]]\ncenter = [0, 0, -1]\nradius = 0.5\n";
    let desk = Desk::default();
    for (length, is_read) in [(1 << 17, true), ((1 << 17) + 1, false)] {
        desk.write(
            "s.toml",
            scene.to_owned() + &" ".repeat(length - scene.len()),
        );
        let output = desk.run("methods needs s.toml");
        let refused = text(&output.stderr).contains("the file has more than 131072 bytes");
        assert_eq!((output.status.success(), !refused), (is_read, is_read));
    }
}

fn read(scene: &str) -> Scene {
    scene_file::parse("scene", scene).unwrap_or_else(|error| panic!("{error}"))
}
