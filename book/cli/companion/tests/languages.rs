//! Programs in other languages: right ones get the verdict and no remark, and the lines of a page
//! put their functions under the laws.

use std::fs;
use std::process::Command;

use fixtures::command::text;
use fixtures::desk::Desk;
use fixtures::drawn::shown_in;
use fixtures::left_out::left_out;
use fixtures::typing::{Typing, typings};
use fixtures::workspace;
use insta::assert_snapshot;

/// A language in which a reader has a program.
struct Language {
    /// The word that marks its blocks on the page.
    fence: &'static str,
    file: &'static str,
    /// The command that compiles the file, or shows that it can be run.
    prepare: &'static str,
    run: &'static str,
    vec3: &'static str,
    normals: &'static str,
    list: &'static str,
    /// The program that prints the picture.
    main: &'static str,
    /// Right programs in other words.
    spellings: &'static str,
    /// The end of what turns the normal, and what does not turn it.
    turned: [&'static str; 2],
}

const PYTHON: Language = Language {
    fence: "python",
    file: "hit.py",
    prepare: "python3 --version",
    run: "python3 hit.py",
    vec3: include_str!("programs/vec3.py"),
    normals: include_str!("programs/normals.py"),
    list: include_str!("programs/hittable_list.py"),
    main: include_str!("programs/main.py"),
    spellings: include_str!("programs/spellings.py.txt"),
    turned: ["if rec.front_face else -", "if rec.front_face else "],
};

const CPP: Language = Language {
    fence: "cpp",
    file: "hit.cc",
    prepare: "g++ -std=c++17 -o hit hit.cc",
    run: "./hit",
    vec3: include_str!("programs/vec3.cc"),
    normals: include_str!("programs/normals.cc"),
    list: include_str!("programs/hittable_list.cc"),
    main: include_str!("programs/main.cc"),
    spellings: include_str!("programs/spellings.cc.txt"),
    turned: ["outward_normal : -", "outward_normal : "],
};

impl Language {
    /// Returns the functions of the chapter, with the program that calls them.
    fn program(&self, chapter: &str, main: &str) -> String {
        let functions = match chapter {
            "normals" => self.normals,
            _ => self.list,
        };
        [self.vec3, functions, main].concat()
    }

    /// Saves and compiles a program. Says so, and returns false, where nothing is there for that.
    fn is_built(&self, desk: &Desk, program: &str) -> bool {
        desk.write(self.file, program);
        let mut words = self.prepare.split(' ');
        let mut prepare = Command::new(words.next().expect("a program"));
        match prepare.args(words).current_dir(desk.path("")).output() {
            Ok(output) => assert!(output.status.success(), "{}", text(&output.stderr)),
            Err(cause) => {
                let (prepare, fence) = (self.prepare, self.fence);
                left_out(&format!("no program in {fence}: {prepare}: {cause}"));
                return false;
            }
        }
        true
    }

    /// Returns the program of the page. For chapter 5, the second block replaces its second part,
    /// `answer`.
    fn of_the_page(&self, chapter: &str) -> String {
        let page = self.on_the_page(1);
        let mut parts: Vec<&str> = page.split("\n\n").collect();
        let answer = self.on_the_page(2);
        if chapter == "hittable_list" {
            parts[1] = &answer;
        }
        self.program(chapter, &parts.join("\n\n"))
    }

    /// Returns the block of this language on the page, the first or the second one.
    fn on_the_page(&self, which: usize) -> String {
        let page = workspace().join("book/notes/check.md");
        let page = fs::read_to_string(page).expect("the page");
        let block = page.split(&format!("```{}\n", self.fence)).nth(which);
        let block = block.and_then(|it| it.split("```").next());
        block.expect("a block").to_owned()
    }

    fn laws(&self, chapter: &str) -> String {
        format!("rtrace laws {chapter} --timeout 60 -- {}", self.run)
    }
}

#[test]
#[ignore = "checks two dozen programs, some seconds each"]
fn right_programs_in_python_and_cpp_get_no_remark() {
    let numpy = Command::new("python3")
        .args(["-c", "import numpy"])
        .output();
    let has_numpy = numpy.is_ok_and(|it| it.status.success());
    for language in [PYTHON, CPP] {
        for spelling in typings(language.spellings) {
            let desk = Desk::default();
            let program = language.program(&spelling.title, language.main);
            let program = spelling.made_in(&program);
            if program.contains("numpy") && !has_numpy {
                left_out("there is no numpy here, and no right program with it is checked");
            } else if language.is_built(&desk, &program) {
                assert_right(&desk, &spelling, language.run);
            }
        }
    }
}

/// Panics unless the program is right, and nothing more is said than which probe to draw next.
fn assert_right(desk: &Desk, spelling: &Typing, command: &str) {
    let output = desk.run(&format!("rtrace check {} -- {command}", spelling.title));
    let said = text(&output.stdout) + &text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{spelling:?}: {said}");
    let (_, more) = said.split_once("bit.\n").expect("the verdict");
    let is_more_to_draw = more.starts_with("probe      to test more, draw ");
    assert!(more.is_empty() || is_more_to_draw, "{spelling:?}: {said}");
}

#[test]
fn the_lines_of_the_page_put_a_function_in_python_and_cpp_under_the_laws() {
    for language in [PYTHON, CPP] {
        let desk = Desk::default();
        let program = language.of_the_page("normals");
        let far_root = program.replacen("(-b - ", "(-b + ", 1);
        let laws = language.laws("normals");
        if !language.is_built(&desk, &program) {
            continue;
        }
        let held = desk.run(&laws);
        let said = text(&held.stdout);
        assert!(said.starts_with("The laws hold: "), "{said}");
        assert_eq!(held.status.code(), Some(0));

        assert!(language.is_built(&desk, &far_root));
        let broken = desk.run(&laws);
        let said = text(&broken.stdout).replace(" --timeout 60", "");
        let name = "far-root: return (-b + std::sqrt(discriminant))";
        assert!(said.contains(name), "{said}");
        assert_eq!(broken.status.code(), Some(1));
        if language.fence == "python" {
            let shown = format!("```text\n{said}```\n");
            shown_in("laws").bind(|| assert_snapshot!("far_root", shown));
        }
    }
}

#[test]
fn the_lines_of_the_page_put_a_record_in_python_and_cpp_under_the_laws() {
    for language in [PYTHON, CPP] {
        let desk = Desk::default();
        let right = language.of_the_page("hittable_list");
        let [turned, not] = language.turned;
        for (program, expected) in [
            (right.clone(), "The laws hold: "),
            (right.replacen(turned, not, 1), "points against the ray"),
        ] {
            if language.is_built(&desk, &program) {
                let said = text(&desk.run(&language.laws("hittable_list")).stdout);
                assert!(said.contains(expected), "{said}");
            }
        }
    }
}

/// In C++ -1 is a miss, or a root that is there by mistake.
#[test]
fn an_answer_that_may_be_a_miss_or_a_root_hides_no_mistake() {
    let desk = Desk::default();
    let program = CPP.of_the_page("normals");
    let mistaken = program.replace("auto b = -2.0", "auto b = 2.0");
    if CPP.is_built(&desk, &mistaken) {
        let said = text(&desk.run(&CPP.laws("normals")).stdout);
        assert!(said.contains("b-sign: "), "{said}");
    }
}

#[cfg(unix)]
#[test]
fn a_program_that_can_not_be_asked_is_told_what_to_do() {
    let desk = Desk::default();
    for (file, script) in [
        ("none.sh", "while read line; do echo None; done"),
        ("comma.sh", "while read line; do echo 0,5; done"),
        ("slow.sh", "sleep 2.5; while read line; do echo miss; done"),
        ("empty.sh", "while read line; do echo; done"),
        ("twice.sh", r"while read line; do printf '1.5\n2.5\n'; done"),
        ("at_end.sh", "cat > numbers; echo 1.5"),
        ("silent.sh", "exec sleep 60"),
        ("deaf.sh", "while echo miss; do :; done"),
        (
            "dies.sh",
            "read it; echo miss; read it; echo no more >&2; exit 3",
        ),
        ("closes.sh", "exec >&-; exec sleep 60"),
    ] {
        desk.write(file, script);
    }
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
