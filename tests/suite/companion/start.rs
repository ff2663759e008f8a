//! A crate of the reader's own: made, typed, carried on, and put under the laws.

use std::fs;

use common::rtweekend::Picture;
use insta::assert_snapshot;
use suite::command::{
    assert_refused, assert_success, cargo, files, names_in, program_with, run, text, transcript,
};
use suite::drawn::p3;
use suite::mine::Mine;
use suite::workspace;
use tempfile::TempDir;

/// The chapters that are typed.
const TYPED: [&str; 5] = [
    "gradient",
    "red_sphere",
    "normals",
    "half_b_sphere",
    "hittable_list",
];

#[test]
#[ignore = "builds five crates of a reader"]
fn every_chapter_can_be_typed_and_begins_with_the_one_before() {
    let mine = Mine::empty();
    type_all_chapters(&mine, &[]);
    // What was typed in chapter 1 is still what the sky is.
    let last = fs::read_to_string(mine.lib("hittable_list")).expect("the chapter");
    assert!(
        last.contains("pub fn sky(ray: &Ray) -> Color {\n    let up"),
        "{last}"
    );
}

/// Vectors, rays, the camera and the text of a picture.
#[test]
#[ignore = "builds five crates of a reader"]
fn a_reader_may_type_the_prelude_as_well() {
    type_all_chapters(&Mine::empty(), &["--own-prelude"]);
}

/// Each listing of the pages, and what it takes from the prelude.
#[test]
#[ignore = "builds five crates of a reader"]
fn the_listings_of_the_pages_do_with_a_prelude_of_the_readers_own() {
    let mine = Mine::empty();
    for (folder, chapter) in ["1_", "2_", "3_", "4_", "5_"].into_iter().zip(TYPED) {
        assert_success(&run(&mut mine.start(chapter, &["--own-prelude"])));
        if chapter == "gradient" {
            type_prelude(&mine);
        }
        let chapters = workspace().join(format!("chapters/{folder}{chapter}/src"));
        for file in files(&chapters) {
            let own = mine
                .lib(chapter)
                .with_file_name(file.file_name().expect("a name"));
            let listed = fs::read_to_string(&file).expect("our chapter");
            let listed = listed.replace("use common::rtweekend::*;", "use crate::rtweekend::*;");
            match file.file_stem() {
                Some(stem) if stem == "main" => {}
                Some(stem) if stem == "lib" => {
                    fs::write(own, listed + LISTED_PRELUDE).expect("it is typed");
                }
                _ => fs::write(own, listed).expect("it is typed"),
            }
        }
        let camera =
            fs::read_to_string(workspace().join("common/src/camera.rs")).expect("our camera");
        let own = mine.lib(chapter).with_file_name("camera.rs");
        fs::write(own, camera).expect("it is typed");
        let said = mine.watch_once(chapter);
        assert!(said.contains("The laws hold."), "{chapter}:\n{said}");
    }
}

/// What is on the page of chapter 1, or in the files that `start` made.
const LISTED_PRELUDE: &str = "
pub mod camera;
pub mod ray;
pub mod render;
pub mod rtweekend;
pub mod vec3;

pub fn sky(ray: &Ray) -> Color {
    let unit_direction = ray.direction.normalize();
    let a = 0.5 * (unit_direction.y + 1.0);
    (1.0 - a) * Color::new(1.0, 1.0, 1.0) + a * Color::new(0.5, 0.7, 1.0)
}
";

#[test]
fn a_crate_is_made_once_and_nothing_that_was_typed_is_written_over() {
    let mine = Mine::empty();
    fs::create_dir(mine.path()).expect("a folder");
    fs::write(mine.path().join("file"), "").expect("a file");
    let said = transcript(&mut [
        mine.start("normals", &[]),
        mine.start("3", &[]),
        mine.start("chapters/3_normals/", &["--into", "mine/file/deeper"]),
    ]);
    fs::write(mine.lib("normals"), "// mine").expect("a file");
    let again = transcript(&mut [mine.start("normals", &["--again"])]);
    assert_snapshot!(said + &again);
    let kept = fs::read_to_string(mine.path().join("normals.1/src/lib.rs"));
    assert_eq!(kept.expect("what was there"), "// mine");
    let new = fs::read_to_string(mine.lib("normals")).expect("the chapter");
    assert!(new.contains("todo!()"), "{new}");
}

/// To cargo two crates are one if they have the same name and version, in whatever folders.
#[test]
#[ignore = "builds two crates of a reader"]
fn crates_of_one_name_in_two_folders_do_not_take_the_place_of_each_other() {
    let mine = Mine::empty();
    assert_success(&run(&mut mine.start("gradient", &[])));
    assert_success(&run(&mut mine.start("gradient", &["--into", "other"])));
    type_all(&mine, "gradient");
    let other = run(&mut mine.rtrace(&["watch", "gradient", "--in", "other", "--once"]));
    assert!(text(&other.stdout).contains("Not written yet"));
    let said = mine.watch_once("gradient");
    assert!(said.contains("to the last bit."), "{said}");
}

#[test]
fn what_cannot_be_read_is_not_carried_over_and_that_is_said() {
    let mine = Mine::empty();
    assert_success(&run(&mut mine.start("gradient", &[])));
    fs::write(mine.lib("gradient"), "pub fn ray_color(").expect("a file");
    let started = run(&mut mine.start("red_sphere", &[]));
    assert_success(&started);
    let said = text(&started.stdout);
    assert!(
        said.contains("Nothing is carried over from gradient"),
        "{said}"
    );

    // An editor has it open, and a note is no text.
    let beside = |name: &str| mine.lib("gradient").with_file_name(name);
    fs::write(beside(".lib.rs.swp"), b"\xff").expect("a file");
    fs::write(beside("note.bin"), b"\xff").expect("a file");
    fs::remove_file(mine.lib("gradient")).expect("it goes");
    assert_success(&run(&mut mine.start("red_sphere", &["--again"])));
    let source = mine.lib("red_sphere");
    assert!(source.is_file() && source.with_file_name("note.bin").is_file());
    assert!(!source.with_file_name(".lib.rs.swp").exists());
    let left = names_in(&mine.path());
    let expected = ["gradient", "red_sphere", "red_sphere.1"];
    assert_eq!(left, expected, "and nothing beside");
}

/// Modes and links, and two items on a line.
#[cfg(unix)]
#[test]
fn what_is_private_stays_private_and_what_is_no_file_stays_where_it_is() {
    use std::os::unix::fs::{PermissionsExt, symlink};

    let mine = Mine::empty();
    assert_success(&run(&mut mine.start("gradient", &[])));
    let lib = mine.lib("gradient");
    let source = fs::read_to_string(&lib).expect("the chapter");
    let deep = format!("fn deep() {{ {}1{} }}", "(".repeat(3000), ")".repeat(3000));
    fs::write(
        &lib,
        format!("{source}\nfn one() {{}} fn two() {{}} // both\n{deep}\n"),
    )
    .expect("it is typed");
    symlink(".", lib.with_file_name("itself")).expect("a link");
    let pipe = std::process::Command::new("mkfifo")
        .arg(lib.with_file_name("pipe"))
        .status();
    assert!(pipe.expect("mkfifo starts").success());
    let modes = |chapter: &str| {
        let lib = mine.lib(chapter);
        let modes = [mine.path().join(chapter), lib].map(|it| fs::metadata(it).expect("it"));
        modes.map(|it| it.permissions().mode() & 0o777)
    };
    for (path, mode) in [(lib.clone(), 0o600), (mine.path().join("gradient"), 0o700)] {
        fs::set_permissions(path, fs::Permissions::from_mode(mode)).expect("its mode is set");
    }
    for (chapter, again) in [("red_sphere", &[][..]), ("gradient", &["--again"])] {
        assert_success(&run(&mut mine.start(chapter, again)));
        assert_eq!(modes(chapter), [0o700, 0o600], "{chapter}");
    }
    let carried = fs::read_to_string(mine.lib("red_sphere")).expect("the chapter");
    for item in ["fn one() {}", "fn two() {} // both", "fn deep()"] {
        assert_eq!(carried.matches(item).count(), 1, "{item} in\n{carried}");
    }
    let names = names_in(mine.lib("red_sphere").parent().expect("src"));
    assert_eq!(names, ["lib.rs", "main.rs"]);
}

#[test]
fn from_anywhere_below_the_same_crates_are_meant() {
    let mine = Mine::empty();
    assert_success(&run(&mut mine.start("gradient", &[])));
    let inside = mine.path().join("gradient/src");
    for words in [&["start", "red_sphere"][..], &["done", "-b was b"]] {
        assert_success(&run(mine.rtrace(words).current_dir(&inside)));
    }
    let names = names_in(&mine.path());
    assert_eq!(names, ["done.md", "gradient", "red_sphere"]);
}

#[test]
fn a_folder_of_the_workspace_is_refused() {
    let chapters = fs::canonicalize(workspace().join("chapters")).expect("our chapters");
    let before = names_in(&chapters);
    let into = chapters.to_str().expect("a name in UTF-8");
    let mut start = program_with("rtrace", &["start", "gradient", "--into", into]);
    assert_refused(&mut start, &["belongs to this workspace"]);
    assert_eq!(names_in(&chapters), before);
}

#[test]
fn the_list_of_done_things_has_what_came_out_right_once_and_the_readers_own_lines() {
    let here = TempDir::new().expect("a folder");
    let file = here.path().join("white.ppm");
    let white = Picture::from_rgb(32, 18, vec![255; 3 * 32 * 18]);
    fs::write(&file, p3(&white.expect("three bytes a pixel"))).expect("a file");
    let rtrace = |words: &[&str]| {
        let mut command = program_with("rtrace", words);
        command.current_dir(here.path());
        command
    };
    let prints: &[&str] = match cfg!(windows) {
        true => &["cmd", "/c", "type"],
        false => &["cat"],
    };
    let watch = ["watch", "gradient", "--once", "--"];
    let watch = [&watch, prints, &["white.ppm"]].concat();
    for _twice in 0..2 {
        let said = text(&run(&mut rtrace(&watch)).stdout);
        assert!(said.contains("step 1"), "{said}");
    }
    assert_success(&run(&mut rtrace(&["done", "red and green\nwere swapped"])));
    let undated = |text: &str| {
        let lines = text.lines().map(|line| match line.split_once("- 20") {
            Some((before, date)) => format!("{before}- …{}\n", &date[8..]),
            None => format!("{line}\n"),
        });
        lines.collect::<String>()
    };
    let list = fs::read_to_string(here.path().join("done.md")).expect("the list");
    let said = transcript(&mut [rtrace(&["done"])]);
    assert_snapshot!(undated(&list) + "\n" + &undated(&said));
}

/// A report ends with a test to paste, and that is where it came from.
#[test]
#[ignore = "builds ten crates of a reader"]
fn the_test_that_a_report_shows_compiles_where_it_is_pasted() {
    for prelude in [&[][..], &["--own-prelude"]] {
        let mine = Mine::empty();
        for chapter in TYPED {
            start_and_type(&mine, chapter, prelude);
        }
        let of_prelude = ("gradient", "+ self.z * other.z", "");
        let of_prelude = (!prelude.is_empty()).then_some(of_prelude);
        for (chapter, right, wrong) in MISTAKES.iter().copied().chain(of_prelude) {
            let (mistyped, right_source) = mine.source_with(chapter, right);
            mine.edit(chapter, right, wrong);
            let law = mine.path().join(chapter).join("tests/laws.rs");
            let test = |words: &[&str]| {
                let mut cargo = cargo();
                cargo
                    .args(["test", "--quiet", "--test", "laws"])
                    .args(words);
                cargo.env_remove("RUST_BACKTRACE");
                run(cargo.current_dir(mine.path().join(chapter)))
            };
            let said = test(&[]).stdout;
            let said = text(&said);
            let (_, pasted) = said.split_once("#[test]\n").expect("a test to paste");
            let (pasted, _) = pasted.split_once("\n}\n").expect("its end");
            let source = fs::read_to_string(&law).expect("the test");
            fs::write(&law, format!("{source}\n#[test]\n{pasted}\n}}\n")).expect("it is pasted");
            let said = test(&["this_case_is_right"]);
            let said = text(&said.stdout) + &text(&said.stderr);
            assert!(
                said.contains("0 passed; 1 failed"),
                "{chapter}: {pasted}\n{said}"
            );
            fs::write(&law, source).expect("the test as it was");
            fs::write(&mistyped, right_source).expect("the chapter as it was");
        }
    }
}

/// One in each kind of function that is put under laws: the line, and what is typed for it.
const MISTAKES: &[(&str, &str, &str)] = &[
    ("red_sphere", "4.0 * a * c", "a * c"),
    ("normals", "2.0 * a)", "a)"),
    ("normals", "Some(t) if t > 0.0", "Some(t) if t > -9.0"),
    (
        "hittable_list",
        "t = (h + sqrtd) / a;",
        "t = (h - sqrtd) / a;",
    ),
    (
        "hittable_list",
        "point = ray.at(t);",
        "point = ray.at(1.0);",
    ),
    (
        "hittable_list",
        "closest = nearest.map_or(t_max, |record| record.t);",
        "closest = t_max;",
    ),
    (
        "hittable_list",
        "world.hit(ray, 0.0, f64::INFINITY)",
        "world.hit(ray, 0.0, 100.0)",
    ),
];

/// Cargo puts the settings of all folders above together.
#[test]
#[ignore = "builds the companion again, if the settings differ"]
fn in_a_crate_inside_the_workspace_cargo_rtrace_is_the_same() {
    let mine = TempDir::new_in(workspace().join("target")).expect("a folder");
    let into = mine.path().to_str().expect("a name in UTF-8");
    assert_success(&run(&mut Mine::empty().start("normals", &["--into", into])));
    let mut cargo = cargo();
    cargo.args(["rtrace", "slips", "minus-h"]);
    let said = run(cargo.current_dir(mine.path().join("normals/src")));
    assert!(
        text(&said.stdout).starts_with("minus-h"),
        "{}",
        text(&said.stderr)
    );
}

/// Types one chapter after the other, each of which is right in the end, and says so.
fn type_all_chapters(mine: &Mine, prelude: &[&str]) {
    for chapter in TYPED {
        start_and_type(mine, chapter, prelude);
        let said = mine.watch_once(chapter);
        let right = match chapter {
            "gradient" => "to the last bit.",
            _ => "to the last bit. The laws hold.",
        };
        assert!(said.contains(right), "{chapter}:\n{said}");
    }
}

fn start_and_type(mine: &Mine, chapter: &str, prelude: &[&str]) {
    assert_success(&run(&mut mine.start(chapter, prelude)));
    if chapter == "gradient" && !prelude.is_empty() {
        type_prelude(mine);
    }
    type_all(mine, chapter);
}

/// Types all that is missing.
fn type_all(mine: &Mine, chapter: &str) {
    match chapter {
        "gradient" => mine.edit(chapter, "todo!()", "let up = 0.5 * (ray.direction.normalize().y + 1.0);\n    (1.0 - up) * Color::new(1.0, 1.0, 1.0) + up * Color::new(0.5, 0.7, 1.0)"),
        "red_sphere" => mine.edit(chapter, "todo!()", DECISION),
        "normals" => {
            fill(mine, chapter, "pub fn ray_color(ray: &Ray) -> Color", NORMAL_AS_COLOR);
            fill(mine, chapter, "-> Option<f64>", FULL);
        }
        "half_b_sphere" => mine.edit(chapter, "todo!()", HALF),
        _ => {
            fill(mine, chapter, "world: &dyn Hittable) -> Color", "match world.hit(ray, 0.0, f64::INFINITY) {\n        Some(record) => 0.5 * (record.normal + Vec3::new(1.0, 1.0, 1.0)),\n        None => sky(ray),\n    }");
            fill(mine, chapter, "outward_normal: Vec3)", "self.front_face = ray.direction.dot(outward_normal) < 0.0;\n        self.normal = if self.front_face { outward_normal } else { -outward_normal };");
            fill(mine, chapter, "impl Hittable for Sphere", SPHERE);
            fill(mine, chapter, "impl Hittable for HittableList", LIST);
            mine.edit(chapter, "    world\n}", "    world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0));\n    world\n}");
        }
    }
}

/// Puts `body` in the place of the first `todo!()` behind `place`.
fn fill(mine: &Mine, chapter: &str, place: &str, body: &str) {
    let (file, source) = mine.source_with(chapter, place);
    let (before, behind) = source.split_once(place).expect("the place");
    let behind = behind.replacen("todo!()", body, 1);
    fs::write(&file, format!("{before}{place}{behind}")).expect("the chapter is saved");
}

const DECISION: &str = "let oc = center - ray.origin;
    let a = ray.direction.dot(ray.direction);
    let b = -2.0 * ray.direction.dot(oc);
    let c = oc.dot(oc) - radius * radius;
    b * b - 4.0 * a * c >= 0.0";

pub(crate) const FULL: &str = "let oc = center - ray.origin;
    let a = ray.direction.dot(ray.direction);
    let b = -2.0 * ray.direction.dot(oc);
    let c = oc.dot(oc) - radius * radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    Some((-b - discriminant.sqrt()) / (2.0 * a))";

const NORMAL_AS_COLOR: &str = "let center = Point3::new(0.0, 0.0, -1.0);
    match hit_sphere(center, 0.5, ray) {
        Some(t) if t > 0.0 => {
            let normal = (ray.at(t) - center).normalize();
            0.5 * (normal + Vec3::new(1.0, 1.0, 1.0))
        }
        _ => sky(ray),
    }";

const HALF: &str = "let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    let discriminant = h * h - a * c;
    if discriminant < 0.0 {
        return None;
    }
    Some((h - discriminant.sqrt()) / a)";

/// As the book compares: NaN passes, which no law minds.
const SPHERE: &str = "let oc = self.center - ray.origin;
        let a = ray.direction.length_squared();
        let h = ray.direction.dot(oc);
        let c = oc.length_squared() - self.radius * self.radius;
        let discriminant = h * h - a * c;
        if discriminant < 0.0 {
            return None;
        }
        let sqrtd = discriminant.sqrt();
        let mut t = (h - sqrtd) / a;
        if t <= t_min || t_max <= t {
            t = (h + sqrtd) / a;
            if t <= t_min || t_max <= t {
                return None;
            }
        }
        let point = ray.at(t);
        let mut record = HitRecord { t, point, ..HitRecord::default() };
        record.set_face_normal(ray, (1.0 / self.radius) * (point - self.center));
        Some(record)";

const LIST: &str = "let mut nearest: Option<HitRecord> = None;
        for object in &self.objects {
            let closest = nearest.map_or(t_max, |record| record.t);
            nearest = object.hit(ray, t_min, closest).or(nearest);
        }
        nearest";

fn type_prelude(mine: &Mine) {
    let source = mine.path().join("gradient/src");
    let answers: [(&str, &[(&str, &str)]); 3] = [
        (
            "vec3.rs",
            &[
                (
                    "fn dot(self, other: Self) -> f64",
                    "self.x * other.x + self.y * other.y + self.z * other.z",
                ),
                ("fn length_squared(self) -> f64", "self.dot(self)"),
                ("fn length(self) -> f64", "self.length_squared().sqrt()"),
                ("fn normalize(self) -> Self", "(1.0 / self.length()) * self"),
                (
                    "fn add(self, other: Self)",
                    "Self::new(self.x + other.x, self.y + other.y, self.z + other.z)",
                ),
                ("fn sub(self, other: Self)", "self + -other"),
                ("fn neg(self)", "-1.0 * self"),
                (
                    "fn mul(self, v: Vec3)",
                    "Vec3::new(self * v.x, self * v.y, self * v.z)",
                ),
            ],
        ),
        (
            "ray.rs",
            &[("fn at(&self, t: f64)", "self.origin + t * self.direction")],
        ),
        (
            "render.rs",
            &[("ray_color: impl Fn(&Ray) -> Color) -> Picture", RENDER)],
        ),
    ];
    for (name, functions) in answers {
        let file = source.join(name);
        let mut text = fs::read_to_string(&file).expect("the prelude");
        for (place, body) in functions {
            let (before, behind) = text.split_once(place).expect("the place");
            text = format!("{before}{place}{}", behind.replacen("todo!()", body, 1));
        }
        fs::write(file, text).expect("the prelude is saved");
    }
}

const RENDER: &str = "use crate::vec3::Vec3;

    let height = ((f64::from(width) / (16.0 / 9.0)) as u32).max(1);
    let viewport = 2.0 * (f64::from(width) / f64::from(height));
    let (u, v) = (Vec3::new(viewport, 0.0, 0.0), Vec3::new(0.0, -2.0, 0.0));
    let delta_u = (1.0 / f64::from(width)) * u;
    let delta_v = (1.0 / f64::from(height)) * v;
    let eye = Vec3::new(0.0, 0.0, 0.0);
    let corner = eye - Vec3::new(0.0, 0.0, 1.0) - 0.5 * u - 0.5 * v;
    let first = corner + 0.5 * (delta_u + delta_v);
    let mut text = format!(\"P3\\n{width} {height}\\n255\\n\");
    for j in 0..height {
        for i in 0..width {
            let pixel = first + f64::from(i) * delta_u + f64::from(j) * delta_v;
            let color = ray_color(&Ray::new(eye, pixel - eye));
            for component in [color.x, color.y, color.z] {
                text += &format!(\"{} \", (255.999 * component) as u8);
            }
            text.push('\\n');
        }
    }
    text";
