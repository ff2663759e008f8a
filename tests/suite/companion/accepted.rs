//! Right programs in other words: each gets the verdict, and no remark.

use std::process::Command;

use page::typed::Text;
use slips::Chapter;
use suite::command::{run, text};
use suite::desk::Desk;
use suite::left_out::left_out;

#[test]
#[ignore = "checks a dozen programs, some seconds each"]
fn right_programs_in_python_get_no_remark() {
    let has_numpy = works("python3", &["-c", "import numpy"]);
    if !works("python3", &["--version"]) {
        return left_out("there is no Python here, and no right program of it is checked");
    }
    for (chapter, others) in spellings(include_str!("programs/spellings.py.txt")) {
        if !has_numpy && others.iter().any(|(_, new)| new.contains("numpy")) {
            left_out("there is no numpy here, and no right program with it is checked");
            continue;
        }
        let desk = Desk::default();
        let program = match chapter {
            Chapter::Normals => include_str!("programs/normals.py"),
            _ => include_str!("programs/hittable_list.py"),
        };
        let [before, main] = [VEC3_PY, include_str!("programs/main.py")];
        let program = [before, program, main].concat();
        desk.write("main.py", in_other_words(program, &others));
        assert_right(&desk, chapter, "python3 main.py", &others);
    }
}

#[test]
#[ignore = "checks ten programs, some seconds each"]
fn right_programs_in_cpp_get_no_remark() {
    if !works("g++", &["--version"]) {
        return left_out("there is no g++ here, and no right program in C++ is checked");
    }
    for (chapter, others) in spellings(include_str!("programs/spellings.cc.txt")) {
        let desk = Desk::default();
        let program = match chapter {
            Chapter::Normals => include_str!("programs/normals.cc"),
            _ => include_str!("programs/hittable_list.cc"),
        };
        let [before, main] = [VEC3_CC, include_str!("programs/main.cc")];
        let program = [before, program, main].concat();
        desk.write("main.cc", in_other_words(program, &others));
        let mut compiler = Command::new("g++");
        compiler.args(["-std=c++17", "-o", "main", "main.cc"]);
        let built = run(compiler.current_dir(desk.path("")));
        assert!(built.status.success(), "{}", text(&built.stderr));
        assert_right(&desk, chapter, "./main", &others);
    }
}

#[test]
fn right_programs_in_rust_get_no_remark() {
    for (chapter, others) in spellings(include_str!("programs/spellings.rs.txt")) {
        let mut typed = Text::full(chapter);
        for (old, new) in &others {
            let found = typed
                .files
                .iter_mut()
                .find(|(_, text)| text.contains(&**old));
            let (_, file) = found.unwrap_or_else(|| panic!("{old} is in no file"));
            *file = file.replace(old, new);
        }
        let program = typed.read().expect("it is Rust");
        let picture = typed.draw(&program, 64).expect("it draws");
        let verdict = typed.verdict(&program, &picture);
        assert!(verdict.is_right, "{others:?}: {}", verdict.headline);
        assert!(verdict.cause.is_empty(), "{others:?} has a remark");
    }
}

pub(crate) const VEC3_PY: &str = include_str!("programs/vec3.py");
pub(crate) const VEC3_CC: &str = include_str!("programs/vec3.cc");

/// What stands in a right program in the place of what.
type Spelling = Vec<(String, String)>;

/// The chapters in a table, each with lines that begin with `-`, and those with `+` that take
/// their place.
fn spellings(table: &str) -> impl Iterator<Item = (Chapter, Spelling)> {
    table.split("== ").skip(1).map(|block| {
        let (name, lines) = block.split_once('\n').expect("lines");
        let mut spelling = Spelling::new();
        let mut is_new = true;
        for (sign, line) in lines.lines().map(|line| line.split_at(1)) {
            if sign == "-" && is_new {
                spelling.push(Default::default());
            }
            is_new = sign == "+";
            let (old, new) = spelling.last_mut().expect("what it replaces comes first");
            *if is_new { new } else { old } += &format!("{line}\n");
        }
        for text in spelling.iter_mut().flat_map(|(old, new)| [old, new]) {
            text.pop();
        }
        (Chapter::find(name).expect("a chapter"), spelling)
    })
}

fn works(program: &str, words: &[&str]) -> bool {
    let output = Command::new(program).args(words).output();
    output.is_ok_and(|output| output.status.success())
}

fn in_other_words(program: String, others: &Spelling) -> String {
    others.iter().fold(program, |program, (old, new)| {
        assert!(program.contains(old), "{old} is not in\n{program}");
        program.replace(old, new)
    })
}

/// It is right, and beside that no more is said than what to draw to test more.
fn assert_right(desk: &Desk, chapter: Chapter, command: &str, others: &Spelling) {
    let output = desk.run(&format!("rtrace check {} -- {command}", chapter.name()));
    let said = text(&output.stdout) + &text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{others:?}: {said}");
    let (_, more) = said.split_once("to the last bit.\n").expect("the verdict");
    let is_more_to_draw = more.starts_with("\nTo test more, draw ") && more.lines().count() == 2;
    assert!(more.is_empty() || is_more_to_draw, "{others:?}: {said}");
    for label in ["yours", "should be", "probably", "warned"] {
        assert!(!said.contains(label), "{others:?}: {said}");
    }
}
