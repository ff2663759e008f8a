//! What each directive becomes, and what fails the build, in small books.

use std::fs;
use std::path::Path;
use suite::small_book::Book;

use figures::{CHARTS, FIGURES};
use scraper::{Html, Selector};
use slips;

use suite::command::woven;

#[test]
fn a_listing_is_the_item_with_its_comment_and_attributes() {
    let book = Book::new("{{code shapes.rs Disc, area, NAMES, Radius}}");
    book.write("shapes.rs", SHAPES);
    let page = book.page();
    for listed in [
        "/// A disc.\n#[derive(Clone)]\npub struct Disc {\n    radius: f64,\n}\n\n",
        "/// Its area.\nfn area(disc: &amp;Disc) -&gt; f64 {\n    3.0 * disc.radius\n}\n\n",
        "pub const NAMES: [&amp;str; 1] = [\"disc\"];\n\ntype Radius = f64;",
    ] {
        assert!(page.contains(listed), "{listed} is missing from\n{page}");
    }
    assert!(!page.contains("unrelated"), "{page}");
}

#[test]
fn a_listing_without_items_is_the_whole_file() {
    let book = Book::new("{{code shapes.rs}}");
    book.write("shapes.rs", SHAPES);
    let page = book.page();
    assert!(
        page.contains("//! Shapes.") && page.contains("fn unrelated() {}</code>"),
        "{page}"
    );
}

#[test]
fn methods_go_by_the_header_of_their_block_and_are_shown_inside_it() {
    let book = Book::new(
        "{{code shapes.rs Disc::new, impl Shape for Disc::size}}\n\n\
         {{code shapes.rs impl From<[f64; 1]> for Disc, Shape::size}}",
    );
    book.write("shapes.rs", SHAPES);
    let page = book.page();
    for listed in [
        "impl Disc {\n    fn new(radius: f64) -&gt; Self {\n        Self { radius }\n    }\n}\n\nimpl Shape for Disc {\n    /// As large as its area.\n    fn size(&amp;self) -&gt; f64 {\n        area(self)\n    }\n}</code>",
        "impl From&lt;[f64; 1]&gt; for Disc {\n    fn from([radius]: [f64; 1])",
        "trait Shape {\n    /// How large it is.\n    fn size(&amp;self) -&gt; f64;\n}</code>",
    ] {
        assert!(page.contains(listed), "{listed} is missing from\n{page}");
    }
}

#[test]
fn methods_of_one_block_share_it_and_imports_stand_together() {
    let book =
        Book::new("{{code two.rs use std::fmt, use std::io::{self, Write}, Two::b, Two::a}}");
    book.write(
        "two.rs",
        "use std::fmt;\nuse std::io::{self, Write};\n\nstruct Two;\n\nimpl Two {\n    fn a() {}\n\n    fn b() {}\n}\n",
    );
    let page = book.page();
    let listed = "use std::fmt;\nuse std::io::{self, Write};\n\nimpl Two {\n    fn b() {}\n\n    fn a() {}\n}</code>";
    assert!(page.contains(listed), "{page}");
}

#[test]
fn a_listing_says_beside_which_of_the_others_it_stands() {
    let book = Book::new(
        "{{code shapes.rs NAMES}}\n\n{{code shapes.rs area, Disc::new}}\n\n\
         {{code shapes.rs Disc}}\n\n{{code shapes.rs impl Shape for Disc}}",
    );
    book.write("shapes.rs", SHAPES);
    let page = book.page();
    let sources: Vec<&str> = page.split("class=\"file\">").skip(1).collect();
    let beside = [
        "",
        ", below <b>NAMES</b>",
        ", above <b>NAMES</b>",
        ", below <b>impl Disc</b>",
    ];
    assert_eq!(sources.len(), beside.len());
    for (source, beside) in sources.iter().zip(beside) {
        let expected = format!("shapes.rs</span>{beside}</p>");
        let (place, _) = source.split_once('\n').expect("a line");
        assert!(
            place.ends_with(&expected),
            "{place} does not end with {expected}"
        );
    }
}

#[test]
fn a_listing_follows_its_source() {
    let book = Book::new("{{code shapes.rs area}}");
    book.write("shapes.rs", SHAPES);
    assert!(book.page().contains("3.0 * disc.radius"));
    book.write("shapes.rs", &SHAPES.replace("3.0", "3.25"));
    assert!(book.page().contains("3.25 * disc.radius"));
}

#[test]
fn a_listing_stays_in_its_list_and_in_its_note() {
    let book = Book::new(
        "* one\n\n  {{code shapes.rs Radius}}\n\n  still one\n\n> [!NOTE]\n> {{code shapes.rs area}}\n>\n> still a note",
    );
    book.write("shapes.rs", SHAPES);
    let page = book.page();
    let place = |what: &str| {
        page.find(what)
            .unwrap_or_else(|| panic!("{what} in {page}"))
    };
    assert!(place("<ul>") < place("type Radius"));
    assert!(place("type Radius") < place("still one"));
    assert!(place("still one") < place("</ul>"));
    assert!(place("<blockquote") < place("fn area"));
    assert!(place("fn area") < place("still a note"));
    assert!(place("still a note") < place("</blockquote>"));
}

#[test]
fn a_figure_is_drawn_into_the_page_with_its_caption() {
    let figures = FIGURES.iter();
    let all: String = figures
        .map(|figure| format!("{{{{figure {}}}}}\n\n", figure.name))
        .collect();
    let page = Book::new(&all).page();
    for figure in FIGURES {
        let shown = shown_as(figure.name, &page);
        let name = figure.name;
        let is_drawn = shown.contains("<svg") && shown.contains("</svg>");
        assert!(is_drawn, "{name} is not drawn:\n{shown}");
        let is_live = live::find(name).is_some();
        assert_eq!(shown.contains("class=\"handle\""), is_live, "{name}");
        let has_caption = shown.contains("<figcaption>");
        assert!(has_caption, "{name} has no caption:\n{shown}");
    }
}

#[test]
fn a_slip_is_drawn_into_the_page_with_its_name() {
    let page = Book::new("{{slip minus-h hittable_list}}").page();
    assert!(page.contains("src=\"data:image/png;base64,"), "{page}");
    assert!(
        page.contains("minus-h</a> in <code>hittable_list"),
        "{page}"
    );
}

#[test]
fn a_step_is_drawn_into_the_page_with_what_to_type() {
    let page = Book::new("{{step gradient 1}}").page();
    assert!(page.contains("src=\"data:image/png;base64,"), "{page}");
    assert!(page.contains("alt=\"A white rectangle"), "{page}");
    assert!(page.contains("<code>ray_color</code> returns"), "{page}");
}

#[test]
fn the_gallery_shows_every_sight_and_names_every_slip() {
    let page = fs::read_to_string(woven().join("slips.html")).expect("a page");
    let drawings = page.matches("<img class=\"pixels\"").count();
    assert_eq!(drawings, slips::sights().len(), "drawings in the gallery");
    for slip in slips::all() {
        assert!(page.contains(&format!(">{}</a>", slip.name)), "{slip:?}");
    }
}

#[test]
fn a_chart_is_drawn_into_the_page_with_a_table_of_its_numbers() {
    let notes = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes");
    let charts = CHARTS.iter();
    let all: String = charts
        .map(|chart| format!("{{{{chart {}}}}}\n\n", chart.name))
        .collect();
    let book = Book::new(&all);
    for file in CHARTS.iter().flat_map(|chart| chart.files) {
        let text = fs::read_to_string(Path::new(notes).join(file)).expect("a measurement");
        book.write(file, &text);
    }
    let page = book.page();
    for chart in CHARTS {
        let shown = shown_as(chart.name, &page);
        let name = chart.name;
        assert!(shown.contains("<svg"), "{name} is not drawn:\n{shown}");
        assert!(shown.contains("<table>"), "{name} has no table:\n{shown}");
    }
}

#[test]
fn a_snapshot_is_shown_without_its_header() {
    let book = Book::new("{{snapshot kept.snap}}");
    book.write("kept.snap", "---\nsource: a.rs\n---\nA *kept* text.\n");
    let page = book.page();
    assert!(page.contains("<p>A <em>kept</em> text.</p>"), "{page}");
    assert!(!page.contains("a.rs"), "{page}");
}

#[test]
fn a_measured_value_comes_from_its_file() {
    let book = Book::new(
        "It takes {{value times.csv near/half_b.ns}} ns on {{value times.csv machine}}, \
         and errs by {{value times.csv far/half_b.error}}.",
    );
    book.write("times.csv", TIMES);
    let page = book.page();
    let expected = "It takes 2.25 ns on an abacus, and errs by 2.5·10<sup>−16</sup>.";
    assert!(page.contains(expected), "{page}");
}

#[test]
fn formulas_become_mathml_that_markdown_leaves_alone() {
    let page = Book::new(r"Both $a_1 * b_2 * c' \cdot [d](e)$ and `$f$` and \$3 or \$4.").page();
    let math = &page[page.find("<math>").expect("a formula")..];
    let math = &math[..math.find("</math>").expect("its end")];
    for letter in ["a", "b", "c", "d", "e"] {
        assert!(
            math.contains(&format!("<mi>{letter}</mi>")),
            "{letter} in {math}"
        );
    }
    assert!(!math.contains("<em>") && !math.contains("<a "), "{math}");
    assert!(page.contains("<code>$f$</code>"), "{page}");
    assert!(page.contains("$3 or $4"), "{page}");
}

#[test]
fn punctuation_stays_with_its_formula() {
    let page = Book::new("The root ($a$), and $b$ too.").page();
    assert!(page.contains("<mi>a</mi></math>),</span>"), "{page}");
    assert!(page.contains("<mi>b</mi></math> too."), "{page}");
}

#[test]
fn an_equation_parts_between_its_sides_and_then_between_its_terms() {
    for (formula, parts) in [
        ("a", "a"),
        ("a + b - c = d", "[[a][+b][−c]][=d]"),
        ("a = -b + c", "[a][[=−b][+c]]"),
        ("a (b + c) \\le [d - e]", "[a(b+c)][≤[d−e]]"),
        (
            "|a| < \\sqrt{b + c}, \\quad d > e",
            "[[|a|][<b+c,]][[d][>e]]",
        ),
        ("\\frac{a + b}{c} = \\left(d + e\\right)", "[a+bc][=(d+e)]"),
    ] {
        let page = Book::new(&format!("$$ {formula} $$")).page();
        let page = page
            .replace("<span class=\"part\">", "[")
            .replace("</span>", "]");
        let page = Html::parse_document(&page);
        let equation = Selector::parse(".formula").expect("CSS");
        let shown = page.select(&equation).next().expect("an equation");
        assert_eq!(shown.text().collect::<String>(), parts, "{formula}");
    }
}

#[test]
fn a_sign_between_two_terms_is_no_sign_of_the_second() {
    let page = Book::new("$$ a + b = -c $$").page();
    for sign in ["+", "="] {
        let marked = format!("<mo form=\"infix\">{sign}</mo>");
        assert!(page.contains(&marked), "{page}");
    }
    assert!(!page.contains("infix\">−"), "{page}");
}

#[test]
fn a_tagged_equation_has_a_number_that_links_to_it() {
    let page = Book::new("Before.\n\n$$ a^2 \\tag{7} $$\n\n$$ b $$").page();
    let equation = &page[page
        .find("<div class=\"equation\" id=\"eq-7\">")
        .expect("a number")..];
    assert!(
        equation.contains("<math displaystyle=\"true\">"),
        "{equation}"
    );
    assert!(equation.contains("href=\"#eq-7\""), "{equation}");
    assert!(equation.contains(">(7)</a>"), "{equation}");
    assert!(page.contains("<div class=\"equation\">"), "{page}");
}

#[test]
fn braces_and_dollars_in_code_are_only_code() {
    let page =
        Book::new("```text\n{{nothing}} $x$\n```\n\n`{{nothing}}` and\n\n    {{nothing}}\n").page();
    assert_eq!(page.matches("{{nothing}}").count(), 3, "{page}");
    assert!(page.contains("$x$"), "{page}");
}

#[test]
fn what_cannot_be_woven_fails_the_build_with_file_line_and_cause() {
    for (wrong, cause) in [
        ("{{cod shapes.rs}}", "no directive `cod`"),
        ("{{code shapes.rs", "ends with }}"),
        ("Look: {{code shapes.rs}}", "a line of its own"),
        ("{{code circles.rs}}", "circles.rs"),
        (
            "{{code shapes.rs perimeter}}",
            "no item `perimeter`; it has",
        ),
        (
            "{{code twice.rs double}}",
            "several items `double`, in lines 1 and 3",
        ),
        ("{{code Broken.rs a}}", "Broken.rs: line 2"),
        ("{{figure unicorn}}", "no figure `unicorn`: there are"),
        (
            "T is {{live unicorn t}}.",
            "no live figure `unicorn`: there are",
        ),
        ("T is {{live ray unicorn}}.", "tells no `unicorn`: it tells"),
        ("{{slip unicorn gradient}}", "no slip `unicorn`"),
        ("{{slip minus-h gradient}}", "can't be made in a chapter"),
        ("{{step unicorn 1}}", "no chapter `unicorn`"),
        ("{{step normals 4}}", "normals has no step 4: it has 3"),
        ("{{snapshot unicorn.snap}}", "unicorn.snap"),
        ("{{chart unicorn}}", "no chart `unicorn`: there are"),
        ("{{changes unicorn}}", "no chapter `unicorn`"),
        (
            "{{changes build_test}}",
            "no chapter `build_test` comes after",
        ),
        ("{{value times.csv full_b.ms}}", "no value `full_b.ms`"),
        ("{{value dates.csv twice.ns}}", "dates.csv"),
        (
            "{{value uneven.csv 1.b}}",
            "uneven.csv: CSV error: record 1 (line: 2",
        ),
        (r"A formula $\frac{1}$ here.", r"`\frac{1}` is wrong"),
        (r"A formula $\unicorn$ here.", r"`\unicorn` is wrong"),
        (r"$$ a \tag{1} \tag{2} $$", r"one formula has one \tag"),
        (r"$$ a \tag{1 $$", "belongs to no formula"),
        ("It costs $5.", "belongs to no formula"),
        (r"$$ a \tag{*} $$", "is no number"),
    ] {
        let book = Book::new(wrong);
        book.write("shapes.rs", SHAPES);
        book.write("twice.rs", "mod double {}\n\nfn double() {}\n");
        book.write("Broken.rs", "fn a() {}\nfn fn\n");
        book.write("times.csv", TIMES);
        book.write("uneven.csv", "a,b\n1\n");
        book.assert_refused(&["page.md:3", cause]);
    }
}

#[test]
fn an_equation_number_is_given_once_in_the_whole_book() {
    let book = Book::new("$$ a \\tag{1} $$");
    book.write("other.md", "# Other\n\nText.\n\n$$ b \\tag{1} $$\n");
    book.write("SUMMARY.md", "- [Page](page.md)\n- [Other](other.md)\n");
    book.assert_refused(&["other.md:5", "equation (1)", "the first is at", "page.md:3"]);
}

#[test]
fn every_problem_is_reported_at_once() {
    let book = Book::new("{{figure a}}\n\n{{figure b}}");
    book.assert_refused(&["page.md:3", "`a`", "page.md:5", "`b`"]);
}

#[test]
fn what_mdbook_only_warns_about_fails_the_build_too() {
    Book::new("<details><summary>Open</summary>\n\nNever closed.").assert_refused(&["details"]);
}

#[test]
fn a_page_that_is_missing_fails_the_build() {
    let book = Book::new("Text.");
    book.write("SUMMARY.md", "- [Page](page.md)\n- [Other](other.md)\n");
    book.assert_refused(&["other.md"]);
}

#[test]
fn a_book_that_cannot_be_woven_leaves_the_old_one() {
    let book = Book::new("The old text.");
    assert!(book.page().contains("The old text."));
    book.write("page.md", "# Page\n\n{{figure unicorn}}\n");
    assert_eq!(book.weave(&book.output()).status.code(), Some(1));
    let old = fs::read_to_string(book.output().join("page.html")).expect("the old page");
    assert!(old.contains("The old text."));
}

const TIMES: &str = "# machine: an abacus
scene,method,ns,error
near,full_b,3.5,0
near,half_b,2.25,0
far,half_b,2.5,2.5e-16
";

const SHAPES: &str = r#"//! Shapes.

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

/// The figure of that name, and what follows until the next one.
fn shown_as<'a>(name: &str, page: &'a str) -> &'a str {
    let start = format!("<figure id=\"{name}\"");
    let mut rest = page.split(&start).skip(1);
    let shown = rest.next().expect("it is shown");
    assert_eq!(rest.next(), None, "{name} is shown twice");
    shown.split("<figure id=").next().unwrap_or(shown)
}
