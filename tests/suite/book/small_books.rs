//! What the directives and formulas of a page become, and what fails the build, in small
//! books. The book itself shows the figures, charts and pictures.

use std::fs;
use std::io::Read;
use std::path::MAIN_SEPARATOR;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use flate2::read::GzDecoder;
use insta::assert_snapshot;
use tempfile::TempDir;

#[test]
fn a_page_is_woven_as_the_snapshot_shows() {
    let page = Book::new(PAGE).page().expect("it can be woven");
    assert_snapshot!(page);
}

#[test]
fn what_cannot_be_woven_fails_the_build_with_file_line_and_cause() {
    let said = [
        "{{cod shapes.rs}}",
        "{{code shapes.rs",
        "{{code circles.rs}}",
        "{{code shapes.rs perimeter}}",
        "{{code twice.rs double}}",
        "{{code broken.rs a}}",
        "T is {{live ray unicorn}}.",
        "{{changes build_test}}",
        "{{value times.csv full_b.ms}}",
        "{{value uneven.csv 1.b}}",
        r"A formula $\unicorn$ here.",
        "It costs $5.",
        r"$$ a \tag{*} $$",
        // All problems are named at once.
        "{{figure a}}\n\n{{figure b}}",
        // mdBook only warns of it.
        "<details><summary>Open</summary>\n\nNever closed.",
    ]
    .map(|wrong| {
        let cause = Book::new(wrong).page().expect_err(wrong);
        format!("{wrong}\n    {}\n", cause.replace('\n', "\n    "))
    });
    assert_snapshot!(said.join("\n"));
}

#[test]
fn a_page_that_is_missing_fails_the_build() {
    let book = Book::new("Text.");
    book.write("SUMMARY.md", "- [Page](page.md)\n- [Other](other.md)\n");
    let cause = book.page().expect_err("a page is missing");
    assert!(cause.contains("other.md"), "{cause}");
}

/// A browser reads the script of a page that was opened from a file, and not the module.
#[test]
fn a_module_is_packed_into_a_script() {
    let book = Book::new("Text.");
    let module = b"\0asm\x01\0\0\0".repeat(100);
    for folder in ["web/page/modules", "notes/live"] {
        fs::create_dir_all(book.0.path().join(folder)).expect("a folder");
    }
    fs::write(book.0.path().join("web/page/modules/ray.wasm"), &module).expect("a file");
    book.page().expect("it can be woven");
    let script = fs::read_to_string(book.0.path().join("woven/live/ray.module.js"));
    let script = script.expect("it is beside the pages");
    let text = script.strip_prefix("globalThis.rayModule = \"");
    let text = text.and_then(|it| it.strip_suffix("\";\n"));
    let gzip = BASE64_STANDARD.decode(text.expect("a text"));
    let mut unpacked = Vec::new();
    GzDecoder::new(&*gzip.expect("base64"))
        .read_to_end(&mut unpacked)
        .expect("gzip");
    assert_eq!(unpacked, module);
}

/// A book of one page in a temporary folder; the page begins with a heading and an empty line.
struct Book(TempDir);

impl Book {
    /// Makes a book of this page, with some files to list.
    fn new(page: &str) -> Self {
        let book = Self(TempDir::new().expect("a folder"));
        fs::create_dir(book.0.path().join("notes")).expect("a folder");
        let settings = "book.src = \"notes\"\nbuild.create-missing = false\n\
                        output.html.playground.runnable = false\n";
        for (name, text) in [
            ("../book.toml", settings),
            ("SUMMARY.md", "- [Page](page.md)\n"),
            ("page.md", &format!("# Page\n\n{page}\n")),
            ("shapes.rs", SHAPES),
            ("twice.rs", "mod double {}\n\nfn double() {}\n"),
            ("broken.rs", "fn a() {}\nfn fn\n"),
            ("times.csv", TIMES),
            ("uneven.csv", "a,b\n1\n"),
            ("kept.snap", "---\nsource: a.rs\n---\nA *kept* text.\n"),
        ] {
            book.write(name, text);
        }
        book
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.0.path().join("notes").join(name), text).expect("a file");
    }

    /// Weaves the book; returns the main part of the page as HTML.
    ///
    /// # Errors
    /// All complaints, with paths seen from the folder of the book.
    fn page(&self) -> Result<String, String> {
        let folder = self.0.path();
        let here = format!("{}{MAIN_SEPARATOR}", folder.display());
        let woven = folder.join("woven");
        fs::create_dir_all(&woven).expect("a folder");
        weave::weave(folder, &woven)
            .map_err(|cause| in_any_system(&cause.to_string().replace(&here, "")))?;
        let page = fs::read_to_string(woven.join("page.html")).expect("a page");
        let (_, main) = page.split_once("<main>").expect("a main part");
        Ok(main.split("</main>").next().unwrap_or(main).to_owned())
    }
}

/// Makes a complaint the same in any system: with slashes, and without the system's own words.
fn in_any_system(cause: &str) -> String {
    let line = |line: &str| match line.split_once(" (os error ") {
        Some((said, _)) => {
            let (of, _) = said.rsplit_once(": ").expect("what went wrong");
            format!("{of}: THE SYSTEM'S WORDS")
        }
        None => line.to_owned(),
    };
    let lines: Vec<String> = cause.lines().map(line).collect();
    lines.join("\n").replace("notes\\", "notes/")
}

const PAGE: &str = r#"Items with their comments, and beside which they stand:

{{code shapes.rs Disc, area, NAMES, Radius}}

* In a list, methods by the header of their block:

  {{code shapes.rs Disc::new, impl Shape for Disc::size}}

> [!NOTE]
> {{code shapes.rs use std::fmt, use std::io::{self, Write}, impl From<[f64; 1]> for Disc, Shape::size}}

It takes {{value times.csv near/half_b.ns}} ns on {{value times.csv machine}}, and errs by
{{value times.csv far/half_b.error}}.

{{snapshot kept.snap}}

Both $a_1 * b_2 * c' \cdot [d](e)$ and `$f$` and \$3, with ($a$), and `{{nothing}}`.

$$ a^2 = -b + c \tag{7} $$

$$ |a| < \sqrt{b + c}, \quad d > e $$

$$ a (b + c) \le [d - e] $$

$$ \frac{a + b}{c} = \left(d + e\right) $$

| formula |
|---|
| $a + b = c$ |

```text
{{nothing}} $x$
```
"#;

const TIMES: &str = "# machine: an abacus
scene,method,ns,error
near,full_b,3.5,0
near,half_b,2.25,0
far,half_b,2.5,2.5e-16
";

const SHAPES: &str = r#"//! Shapes.

use std::fmt;
use std::io::{self, Write};

/// A disc.
#[derive(Clone)]
pub struct Disc {
    radius: f64,
}

pub const NAMES: [&str; 1] = ["disc"];

type Radius = f64;

impl Disc {
    fn new(radius: f64) -> Self {
        Self { radius }
    }
}

trait Shape {
    /// How large it is.
    fn size(&self) -> f64;
}

impl Shape for Disc {
    /// As large as its area.
    fn size(&self) -> f64 {
        area(self)
    }
}

impl From<[f64; 1]> for Disc {
    fn from([radius]: [f64; 1]) -> Self {
        Self { radius }
    }
}

/// Its area.
///
/// Cost: 1 ×. Error: that of a rough π.
fn area(disc: &Disc) -> f64 {
    3.0 * disc.radius
}

fn unrelated() {}
"#;
