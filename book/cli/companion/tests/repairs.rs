//! Repairs of whole crates, typed as newcomers do: which line is named, and what is not searched.

use std::fs;
use std::time::{Duration, Instant};

use fixtures::reader::TestReader;
use fixtures::typing::{Typing, typings};
use slips::Chapter;

/// The share of mistakes whose own line is the first repair, in percent. Others are repaired in
/// another place to the same effect, or are among the next.
const FIRST: usize = 80;

#[test]
#[ignore = "builds a reader's crate some hundred times"]
fn the_mistyped_line_is_named_in_crates_of_many_styles() {
    let reader = TestReader::empty();
    let mistakes = typings(include_str!("programs/repairs/mistakes.txt"));
    let mut missed = Vec::new();
    for mistake in &mistakes {
        let (style, rest) = mistake
            .title
            .split_once(' ')
            .expect("a style and a chapter");
        let (chapter, _) = rest.split_once(':').expect("a chapter and a title");
        type_right(&reader, style, chapter);
        reader.make_changes(chapter, mistake);
        let start = Instant::now();
        let said = reader.watch_once(chapter);
        println!(
            "{}  {:.1} s\n{said}",
            mistake.title,
            start.elapsed().as_secs_f64()
        );
        if !names(&said, mistake) {
            missed.push(format!("{}\n{said}", mistake.title));
        }
        fs::remove_dir_all(reader.path().join(chapter)).expect("the crate goes");
    }
    let found = mistakes.len() - missed.len();
    println!("{found} of {}", mistakes.len());
    assert!(
        100 * found >= FIRST * mistakes.len(),
        "{}",
        missed.join("\n")
    );
}

/// Makes the reader's crate of a chapter, right, in a style.
fn type_right(reader: &TestReader, style: &str, chapter: &str) {
    let chapter_of = |name: &str| Chapter::TYPED.into_iter().find(|it| it.name() == name);
    let known = chapter_of(chapter).expect("a chapter");
    match style {
        "given" => {
            reader.make(chapter, &[]);
            reader.type_all(known);
        }
        "own" => {
            reader.make(chapter, &["--own-prelude"]);
            for typing in typings(include_str!("programs/own_prelude.txt")) {
                reader.make_changes(chapter, &typing);
            }
            let sky = "pub fn sky(ray: &Ray) -> Color {\n    ";
            let blend = "let a = 0.5 * (ray.direction.normalize().y + 1.0);
    (1.0 - a) * Color::new(1.0, 1.0, 1.0) + a * Color::new(0.5, 0.7, 1.0)";
            reader.edit(chapter, &format!("{sky}todo!()"), &format!("{sky}{blend}"));
            reader.type_all(known);
        }
        _ => {
            let own: &[&str] = if style == "generic" {
                &["--own-prelude"]
            } else {
                &[]
            };
            reader.make(chapter, own);
            let src = reader.path().join(chapter).join("src");
            for file in fs::read_dir(&src).expect("its sources").flatten() {
                if file.file_name() != "main.rs" {
                    fs::remove_file(file.path()).expect("it goes");
                }
            }
            let text = match style {
                "gradient" => include_str!("programs/repairs/gradient.rs"),
                "normals" => include_str!("programs/repairs/normals.rs"),
                "hittable_list" => include_str!("programs/repairs/hittable_list.rs"),
                _ => include_str!("programs/repairs/generic.rs"),
            };
            fs::write(src.join("lib.rs"), text).expect("it is typed");
            if style == "generic" {
                // Its vectors are not those that the laws ask.
                fs::remove_dir_all(src.join("../tests")).expect("the laws go");
            }
        }
    }
}

/// Returns true if the line as it was is what should be there.
fn names(said: &str, mistake: &Typing) -> bool {
    let named = ["should be  ", "missing    "].into_iter();
    let mut named = named.filter_map(|it| Some(said.split_once(it)?.1));
    let squeezed = |text: &str| text.split_whitespace().collect::<String>();
    let line = squeezed(&mistake.changes[0].old);
    named.any(|it| squeezed(it).contains(&line)) && said.contains("tried  ")
}

/// What a crate has beside its mistake, by file, and the word that says why it is not searched.
const REACHING: [(&str, &str, &str); 8] = [
    (
        "src/lib.rs",
        "pub fn f() { let _ = std::fs::remove_file(\"kept\"); }",
        "`fs`",
    ),
    (
        "src/lib.rs",
        "use std::process as p; pub fn f() { p::Command::new(\"sh\"); }",
        "`process`",
    ),
    (
        "src/lib.rs",
        "pub fn f() { let _ = std::net::TcpStream::connect(\"::1:80\"); }",
        "`net`",
    ),
    (
        "src/lib.rs",
        "pub fn f() -> u8 { unsafe { *std::ptr::from_ref(&1) } }",
        "`unsafe`",
    ),
    ("src/lib.rs", "pub extern \"C\" fn f() {}", "`extern`"),
    ("src/lib.rs", "pub use std::*;", "`std`"),
    (
        "src/lib.rs",
        "pub const TEXT: &str = include_str!(\"lib.rs\");",
        "`include_str`",
    ),
    ("build.rs", "fn main() {}", "a build script"),
];

#[test]
#[ignore = "builds a reader's crate ten times"]
fn a_crate_that_reaches_further_is_not_searched_and_says_why() {
    let reader = TestReader::empty();
    reader.make("gradient", &[]);
    reader.type_all(Chapter::Gradient);
    reader.edit(
        "gradient",
        "unit_direction.y + 1.0",
        "unit_direction.x + 1.0",
    );
    let folder = reader.path().join("gradient");
    fs::write(folder.join("kept"), "").expect("a file of the reader's");
    for (name, text, why) in REACHING {
        let file = folder.join(name);
        let before = fs::read_to_string(&file).unwrap_or_default();
        fs::write(&file, format!("{before}\n{text}\n")).expect("it is typed");
        let said = squeezed(&reader.watch_once("gradient"));
        let not = "no line is looked for that makes it right: ";
        let reason = said.split_once(not).map(|it| it.1);
        assert!(reason.is_some_and(|it| it.contains(why)), "{text}\n{said}");
        assert!(!said.contains("with this change"), "{text}\n{said}");
        match before.is_empty() {
            true => fs::remove_file(&file).expect("it goes"),
            false => fs::write(&file, before).expect("it is as it was"),
        }
    }
    assert!(folder.join("kept").exists());
    reader.edit(
        "gradient",
        "use common",
        "use std::io::Write as _;\nuse common",
    );
    assert!(
        reader.watch_once("gradient").contains("with this change"),
        "printing is harmless"
    );
}

#[test]
#[cfg(target_os = "linux")]
#[ignore = "builds a reader's crate and searches it twice"]
fn a_newer_save_and_ctrl_c_stop_all_that_a_search_has_started() {
    use std::process::{Command, Stdio};

    let reader = TestReader::empty();
    reader.make("normals", &[]);
    reader.type_all(Chapter::Normals);
    assert!(reader.watch_once("normals").contains("Right"));
    let (right, wrong) = ("-2.0 * ray", "2.0 * ray");
    reader.edit("normals", right, wrong);
    let mut watch = reader.rtrace(&["watch", "normals"]);
    watch.stdout(Stdio::null()).stderr(Stdio::null());
    let mut watch = watch.spawn().expect("it starts");
    wait_until(60, || searching() > 0);
    // A save comes at each moment of a search.
    for _ in 0..5 {
        std::thread::sleep(Duration::from_millis(700));
        reader.edit("normals", "//! 1.", "//!\n//! 1.");
    }
    reader.edit("normals", wrong, right);
    wait_until(20, || searching() == 0);
    reader.edit("normals", right, wrong);
    wait_until(60, || searching() > 0);
    let stopped = Command::new("kill")
        .args(["-INT", &watch.id().to_string()])
        .status();
    assert!(stopped.expect("there is kill").success());
    watch.wait().expect("it ends");
    wait_until(5, || searching() == 0);
}

/// Counts the processes that run in a copy of a crate.
#[cfg(target_os = "linux")]
fn searching() -> usize {
    let processes = fs::read_dir("/proc").expect("the processes").flatten();
    let folders = processes.filter_map(|it| fs::read_link(it.path().join("cwd")).ok());
    folders
        .filter(|it| it.to_string_lossy().contains("/repair/repair_"))
        .count()
}

#[cfg(target_os = "linux")]
fn wait_until(seconds: u64, mut is_so: impl FnMut() -> bool) {
    let end = Instant::now() + Duration::from_secs(seconds);
    while !is_so() {
        assert!(Instant::now() < end, "not within {seconds} s");
        std::thread::sleep(Duration::from_millis(20));
    }
}

fn squeezed(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
