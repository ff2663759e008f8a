//! The lines of a page put a function of any language under the laws.

use std::fs;
use std::process::Command;

use fixtures::command::text;
use fixtures::desk::Desk;
use fixtures::drawn::shown_in;
use fixtures::left_out::left_out;
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
    /// A chapter, a piece of its program and what is typed instead, and what is said then.
    mistakes: &'static [[&'static str; 4]],
}

const FAR_ROOT: &str = "far-root: return (-b + std::sqrt(discriminant))";

const PYTHON: Language = Language {
    fence: "python",
    file: "hit.py",
    prepare: "python3 --version",
    run: "python3 hit.py",
    vec3: include_str!("programs/vec3.py"),
    normals: include_str!("programs/normals.py"),
    list: include_str!("programs/hittable_list.py"),
    mistakes: &[
        ["normals", "(-b - ", "(-b + ", FAR_ROOT],
        [
            "hittable_list",
            "front_face else -",
            "front_face else ",
            "points against the ray",
        ],
    ],
};

/// In C++ -1 is a miss, or a root that is there by mistake.
const CPP: Language = Language {
    fence: "cpp",
    file: "hit.cc",
    prepare: "g++ -std=c++17 -o hit hit.cc",
    run: "./hit",
    vec3: include_str!("programs/vec3.cc"),
    normals: include_str!("programs/normals.cc"),
    list: include_str!("programs/hittable_list.cc"),
    mistakes: &[
        ["normals", "(-b - ", "(-b + ", FAR_ROOT],
        ["normals", "auto b = -2.0", "auto b = 2.0", "b-sign: "],
        [
            "hittable_list",
            "outward_normal : -",
            "outward_normal : ",
            "points against the ray",
        ],
    ],
};

#[test]
fn a_function_in_python_comes_under_the_laws() {
    let broken = PYTHON.are_asked();
    if let Some(broken) = broken.first() {
        let shown = format!("```text\n{broken}```\n");
        shown_in("laws").bind(|| assert_snapshot!("far_root", shown));
    }
}

#[test]
#[ignore = "compiles C++"]
fn a_function_in_cpp_comes_under_the_laws() {
    CPP.are_asked();
}

impl Language {
    /// Asks the right programs of both chapters, and each mistaken one. Returns what is said of the
    /// latter; nothing where the language is not there.
    fn are_asked(&self) -> Vec<String> {
        let desk = Desk::default();
        for chapter in ["normals", "hittable_list"] {
            if !self.is_built(&desk, &self.program(chapter)) {
                return Vec::new();
            }
            let said = self.asked(&desk, chapter, 0);
            assert!(said.starts_with("The laws hold: "), "{said}");
        }
        let broken = self
            .mistakes
            .iter()
            .map(|[chapter, right, wrong, expected]| {
                let program = self.program(chapter);
                assert!(self.is_built(&desk, &program.replacen(right, wrong, 1)));
                let said = self.asked(&desk, chapter, 1);
                assert!(said.contains(expected), "{said}");
                said
            });
        broken.collect()
    }

    fn asked(&self, desk: &Desk, chapter: &str, code: i32) -> String {
        let laws = format!("rtrace laws {chapter} --timeout 60 -- {}", self.run);
        let output = desk.run(&laws);
        assert_eq!(output.status.code(), Some(code));
        text(&output.stdout).replace(" --timeout 60", "")
    }

    /// Returns the functions of the chapter below the lines of the page. For chapter 5, the second
    /// block of the page replaces the second part of the first, `answer`.
    fn program(&self, chapter: &str) -> String {
        let [page, answer] = [1, 2].map(|which| self.on_the_page(which));
        let mut parts: Vec<&str> = page.split("\n\n").collect();
        let functions = match chapter {
            "normals" => self.normals,
            _ => {
                parts[1] = &answer;
                self.list
            }
        };
        [self.vec3, functions, &parts.join("\n\n")].concat()
    }

    /// Returns the block of this language on the page, the first or the second one.
    fn on_the_page(&self, which: usize) -> String {
        let page = workspace().join("book/notes/check.md");
        let page = fs::read_to_string(page).expect("the page");
        let block = page.split(&format!("```{}\n", self.fence)).nth(which);
        let block = block.and_then(|it| it.split("```").next());
        block.expect("a block").to_owned()
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
}

#[cfg(unix)]
#[test]
fn a_program_that_can_not_be_asked_is_told_what_to_do() {
    let desk = Desk::default();
    for (file, script) in [
        ("none.sh", "while read line; do echo None; done"),
        ("comma.sh", "while read line; do echo 0,5; done"),
        ("slow.sh", "sleep 1.3; while read line; do echo miss; done"),
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
    assert_snapshot!(desk.transcript_at_once(
        "rtrace laws normals -- sh none.sh
         rtrace laws normals -- sh comma.sh
         rtrace laws normals --timeout 1 -- sh slow.sh
         rtrace laws red_sphere -- sh empty.sh
         rtrace laws normals -- sh twice.sh
         rtrace laws normals --timeout 0.4 -- sh at_end.sh
         rtrace laws hittable_list --timeout 0.4 -- sh silent.sh
         rtrace laws normals -- sh deaf.sh
         rtrace laws normals -- sh dies.sh
         rtrace laws normals -- sh closes.sh
         rtrace laws normals -- true
         rtrace laws normals -- ./no-such-program
         rtrace laws gradient -- true"
    ));
}
