//! What `cargo rtrace laws` says of functions in other languages.

use std::fs;
use std::process::Command;

use insta::assert_snapshot;
use suite::command::{run, text};
use suite::desk::Desk;
use suite::drawn::shown_in;
use suite::left_out::left_out;
use suite::workspace;

use crate::accepted::{VEC3_CC, VEC3_PY};

/// A language of the page: how its block is fenced there, and what stands above that block.
struct Language {
    fence: &'static str,
    file: &'static str,
    functions: [&'static str; 2],
    /// The functions of chapter 5.
    list: [&'static str; 2],
    /// What turns the normal, and what does not.
    turned: [&'static str; 2],
    /// What compiles the file, or shows that it can be run.
    prepare: &'static str,
    run: &'static str,
}

#[test]
fn the_lines_of_the_page_put_a_function_in_python_under_the_laws() {
    let Some(far) = is_judged(&PYTHON) else {
        return;
    };
    shown_in("laws").bind(|| assert_snapshot!("far_root", format!("```text\n{far}```\n")));
}

#[test]
fn the_lines_of_the_page_put_a_function_in_cpp_under_the_laws() {
    is_judged(&CPP);
}

/// In C++ -1 is a miss, or a root that is there by mistake.
#[test]
fn an_answer_that_may_be_a_miss_or_a_root_hides_no_mistake() {
    let desk = Desk::default();
    let program = CPP.functions.concat() + &on_the_page(CPP.fence, 1);
    desk.write(CPP.file, program.replace("auto b = -2.0", "auto b = 2.0"));
    let mut compile = Command::new("g++");
    compile
        .args(["-o", "hit", "hit.cc"])
        .current_dir(desk.path(""));
    match compile.output() {
        Ok(output) => assert!(output.status.success(), "{}", text(&output.stderr)),
        Err(cause) => return left_out(&format!("no C++ compiler: -1 is not asked for ({cause})")),
    }
    let said = text(&desk.run("rtrace laws normals --timeout 60 -- ./hit").stdout);
    assert!(said.contains("b-sign: "), "{said}");
}

/// Judges a right function and one with the far root, and returns what is said of that. In
/// chapter 5 the second part of the page's program, `answer`, gives way to the second block.
fn is_judged(language: &Language) -> Option<String> {
    let right = Desk::default();
    let page = on_the_page(language.fence, 1);
    let program = language.functions.concat() + &page;
    right.write(language.file, &program);
    let mut words = language.prepare.split(' ');
    let mut prepare = Command::new(words.next().expect("a program"));
    match prepare.args(words).current_dir(right.path("")).output() {
        Ok(output) => assert!(output.status.success(), "{}", text(&output.stderr)),
        Err(cause) => {
            let (run, fence) = (language.prepare, language.fence);
            left_out(&format!(
                "{run} does not start, the laws are not asked of {fence} ({cause})"
            ));
            return None;
        }
    }
    let laws = format!("rtrace laws normals --timeout 60 -- {}", language.run);
    let held = right.run(&laws);
    assert!(
        text(&held.stdout).starts_with("The laws hold: "),
        "{}",
        text(&held.stdout)
    );
    assert_eq!(held.status.code(), Some(0));

    right.write(language.file, program.replacen("(-b - ", "(-b + ", 1));
    assert!(run(prepare.current_dir(right.path(""))).status.success());
    let broken = right.run(&laws);
    assert_eq!(broken.status.code(), Some(1));
    let said = text(&broken.stdout);
    assert!(
        said.contains("far-root: (-b + sqrt(discriminant))"),
        "{said}"
    );
    let laws = laws.replace("normals", "hittable_list");
    let mut parts: Vec<String> = page.split("\n\n").map(str::to_owned).collect();
    parts[1] = on_the_page(language.fence, 2);
    let program = language.list.concat() + &parts.join("\n\n");
    let [turned, not] = language.turned;
    for (program, expected) in [
        (program.clone(), "The laws hold: "),
        (program.replacen(turned, not, 1), "points against the ray"),
    ] {
        right.write(language.file, program);
        assert!(run(prepare.current_dir(right.path(""))).status.success());
        let said = text(&right.run(&laws).stdout);
        assert!(said.contains(expected), "{said}");
    }
    Some(said.replace(" --timeout 60", ""))
}

/// The block of that language on the page, the first or the second one.
fn on_the_page(fence: &str, which: usize) -> String {
    let page = workspace().join("book/notes/check.md");
    let page = fs::read_to_string(page).expect("the page");
    let block = page.split(&format!("```{fence}\n")).nth(which);
    let block = block.and_then(|it| it.split("```").next());
    block.expect("a block").to_owned()
}

#[cfg(unix)]
#[test]
fn a_program_that_can_not_be_asked_is_told_what_to_do() {
    let desk = Desk::default();
    desk.write("none.sh", "while read line; do echo None; done");
    desk.write("comma.sh", "while read line; do echo 0,5; done");
    desk.write("slow.sh", "sleep 2.5; while read line; do echo miss; done");
    desk.write("empty.sh", "while read line; do echo; done");
    desk.write(
        "twice.sh",
        "while read line; do printf '1.5\\n2.5\\n'; done",
    );
    desk.write("at_end.sh", "cat > numbers; echo 1.5");
    desk.write("silent.sh", "exec sleep 60");
    desk.write("deaf.sh", "while echo miss; do :; done");
    desk.write(
        "dies.sh",
        "read line; echo miss; read line; echo no more >&2; exit 3",
    );
    desk.write("closes.sh", "exec >&-; exec sleep 60");
    assert_snapshot!(desk.transcript(
        "rtrace laws normals -- sh none.sh
         rtrace laws normals -- sh comma.sh
         rtrace laws normals --timeout 2 -- sh slow.sh
         rtrace laws red_sphere -- sh empty.sh
         rtrace laws normals -- sh twice.sh
         rtrace laws normals --timeout 0.5 -- sh at_end.sh
         rtrace laws hittable_list --timeout 0.5 -- sh silent.sh
         rtrace laws normals -- sh deaf.sh
         rtrace laws normals -- sh dies.sh
         rtrace laws normals -- sh closes.sh
         rtrace laws normals -- true
         rtrace laws normals -- ./no-such-program
         rtrace laws gradient -- true"
    ));
}

const PYTHON: Language = Language {
    fence: "python",
    file: "hit.py",
    prepare: "python3 --version",
    run: "python3 hit.py",
    functions: [VEC3_PY, include_str!("programs/normals.py")],
    list: [VEC3_PY, include_str!("programs/hittable_list.py")],
    turned: ["if rec.front_face else -", "if rec.front_face else "],
};

const CPP: Language = Language {
    fence: "cpp",
    file: "hit.cc",
    prepare: "g++ -o hit hit.cc",
    run: "./hit",
    functions: [VEC3_CC, include_str!("programs/normals.cc")],
    list: [VEC3_CC, include_str!("programs/hittable_list.cc")],
    turned: ["outward_normal : -", "outward_normal : "],
};
