//! What the directives and formulas of a page become, and what fails the build, in small
//! books. The book itself shows the figures, charts, pictures and slips.

use insta::assert_snapshot;

use suite::small_book::Book;

#[test]
fn a_page_is_woven_as_the_snapshot_shows() {
    let page = book(PAGE).page().expect("it can be woven");
    assert_snapshot!(page);
}

#[test]
fn what_cannot_be_woven_fails_the_build_with_file_line_and_cause() {
    let said = [
        "{{cod shapes.rs}}",
        "{{code shapes.rs",
        "Look: {{code shapes.rs}}",
        "{{code circles.rs}}",
        "{{code shapes.rs perimeter}}",
        "{{code twice.rs double}}",
        "{{code broken.rs a}}",
        "{{figure unicorn}}",
        "T is {{live unicorn t}}.",
        "T is {{live ray unicorn}}.",
        "{{slip unicorn gradient}}",
        "{{slip minus-h gradient}}",
        "{{step unicorn 1}}",
        "{{step normals 4}}",
        "{{snapshot unicorn.snap}}",
        "{{chart unicorn}}",
        "{{changes unicorn}}",
        "{{changes build_test}}",
        "{{value times.csv full_b.ms}}",
        "{{value dates.csv twice.ns}}",
        "{{value uneven.csv 1.b}}",
        r"A formula $\frac{1}$ here.",
        r"A formula $\unicorn$ here.",
        r"$$ a \tag{1} \tag{2} $$",
        r"$$ a \tag{1 $$",
        "It costs $5.",
        r"$$ a \tag{*} $$",
        "$$ a \\tag{1} $$ and $$ b \\tag{1} $$",
        // Every problem is told at once.
        "{{figure a}}\n\n{{figure b}}",
        // mdBook only warns of it.
        "<details><summary>Open</summary>\n\nNever closed.",
    ]
    .map(|wrong| {
        let cause = book(wrong).page().expect_err(wrong);
        format!("{wrong}\n    {}\n", cause.replace('\n', "\n    "))
    });
    assert_snapshot!(said.join("\n"));
}

#[test]
fn a_page_that_is_missing_fails_the_build() {
    let book = book("Text.");
    book.write("SUMMARY.md", "- [Page](page.md)\n- [Other](other.md)\n");
    let cause = book.page().expect_err("a page is missing");
    assert!(cause.contains("other.md"), "{cause}");
}

/// A book of this page, with files to list.
fn book(page: &str) -> Book {
    let book = Book::new(page);
    book.write("shapes.rs", SHAPES);
    book.write("twice.rs", "mod double {}\n\nfn double() {}\n");
    book.write("broken.rs", "fn a() {}\nfn fn\n");
    book.write("times.csv", TIMES);
    book.write("uneven.csv", "a,b\n1\n");
    book.write("kept.snap", "---\nsource: a.rs\n---\nA *kept* text.\n");
    book
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
fn area(disc: &Disc) -> f64 {
    3.0 * disc.radius
}

fn unrelated() {}
"#;
