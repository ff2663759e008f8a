//! What `cargo rtrace laws` says of functions in other languages.

use std::fs;
use std::process::Command;

use insta::assert_snapshot;
use suite::command::{run, text};
use suite::desk::Desk;
use suite::drawn::shown_in;
use suite::left_out::left_out;
use suite::workspace;

/// A language of the page: how its block is fenced there, and what stands above that block.
struct Language {
    fence: &'static str,
    file: &'static str,
    functions: &'static str,
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

#[test]
fn the_lines_of_the_page_put_a_function_in_javascript_under_the_laws() {
    is_judged(&JAVASCRIPT);
}

/// Judges a right function and one with the far root, and returns what is said of that.
fn is_judged(language: &Language) -> Option<String> {
    let right = Desk::default();
    let program = language.functions.to_owned() + &on_the_page(language.fence);
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
    Some(said.replace(" --timeout 60", ""))
}

/// The block of that language on the page.
fn on_the_page(fence: &str) -> String {
    let page = workspace().join("book/notes/check.md");
    let page = fs::read_to_string(page).expect("the page");
    let (_, after) = page.split_once(&format!("```{fence}\n")).expect("a block");
    let (block, _) = after.split_once("```").expect("its end");
    block.to_owned()
}

#[cfg(unix)]
#[test]
fn a_program_that_can_not_be_asked_is_told_what_to_do() {
    let desk = Desk::default();
    desk.write("none.sh", "while read line; do echo None; done");
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
    functions: "\
import math

class vec3:
    def __init__(self, x, y, z):
        self.x, self.y, self.z = x, y, z

    def __sub__(self, v):
        return vec3(self.x - v.x, self.y - v.y, self.z - v.z)

class ray:
    def __init__(self, origin, direction):
        self.origin, self.direction = origin, direction

def dot(u, v):
    return u.x * v.x + u.y * v.y + u.z * v.z

def hit_sphere(center, radius, r):
    oc = center - r.origin
    a = dot(r.direction, r.direction)
    b = -2.0 * dot(r.direction, oc)
    c = dot(oc, oc) - radius * radius
    discriminant = b * b - 4 * a * c
    if discriminant < 0:
        return None
    return (-b - math.sqrt(discriminant)) / (2.0 * a)

",
};

const CPP: Language = Language {
    fence: "cpp",
    file: "hit.cc",
    prepare: "g++ -o hit hit.cc",
    run: "./hit",
    functions: "\
#include <cmath>

struct vec3 {
    double e[3];
    vec3(double x, double y, double z) : e{x, y, z} {}
    vec3 operator-(const vec3& v) const { return vec3(e[0] - v.e[0], e[1] - v.e[1], e[2] - v.e[2]); }
};

struct ray {
    vec3 orig, dir;
    ray(const vec3& origin, const vec3& direction) : orig(origin), dir(direction) {}
    const vec3& origin() const { return orig; }
    const vec3& direction() const { return dir; }
};

double dot(const vec3& u, const vec3& v) {
    return u.e[0] * v.e[0] + u.e[1] * v.e[1] + u.e[2] * v.e[2];
}

double hit_sphere(const vec3& center, double radius, const ray& r) {
    vec3 oc = center - r.origin();
    auto a = dot(r.direction(), r.direction());
    auto b = -2.0 * dot(r.direction(), oc);
    auto c = dot(oc, oc) - radius*radius;
    auto discriminant = b*b - 4*a*c;
    return discriminant < 0 ? -1.0 : (-b - std::sqrt(discriminant)) / (2.0*a);
}

",
};

const JAVASCRIPT: Language = Language {
    fence: "js",
    file: "hit.js",
    prepare: "node --version",
    run: "node hit.js",
    functions: "\
class vec3 {
  constructor(x, y, z) { this.x = x; this.y = y; this.z = z; }
  minus(v) { return new vec3(this.x - v.x, this.y - v.y, this.z - v.z); }
}
class ray {
  constructor(origin, direction) { this.origin = origin; this.direction = direction; }
}
const dot = (u, v) => u.x * v.x + u.y * v.y + u.z * v.z;

function hit_sphere(center, radius, r) {
  const oc = center.minus(r.origin);
  const a = dot(r.direction, r.direction);
  const b = -2 * dot(r.direction, oc);
  const c = dot(oc, oc) - radius * radius;
  const discriminant = b * b - 4 * a * c;
  return discriminant < 0 ? null : (-b - Math.sqrt(discriminant)) / (2 * a);
}

",
};
