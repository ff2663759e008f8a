//! The book is whole: nothing is missing, stale, broken or fetched from afar.
//!
//! `weave.rs` tests how a page is woven, `browser.rs` what a browser makes of it.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use scraper::{ElementRef, Html, Node, Selector};
use slips::Chapter;

use suite::command::{files, names_in, woven};

/// The sources of the book.
const NOTES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes");

#[test]
fn every_page_in_the_folder_is_in_the_summary() {
    let written: Vec<String> = names_in(Path::new(NOTES))
        .into_iter()
        .filter(|name| name.ends_with(".md") && name != "SUMMARY.md")
        .map(|name| name.replace(".md", ".html"))
        .collect();
    let pages = pages();
    let woven: Vec<&String> = chapters(&pages).map(|page| &page.name).collect();
    assert_eq!(written.iter().collect::<Vec<_>>(), woven);
}

/// Each page is called the same where it is listed and where it is read.
#[test]
fn every_title_in_the_sidebar_is_that_of_its_page() {
    let summary = fs::read_to_string(Path::new(NOTES).join("SUMMARY.md")).expect("the summary");
    for line in summary.lines() {
        let Some((title, file)) = line
            .trim_start_matches(['-', ' ', '['])
            .strip_suffix(')')
            .and_then(|link| link.split_once("]("))
        else {
            continue;
        };
        let page = fs::read_to_string(Path::new(NOTES).join(file)).expect("a page");
        assert_eq!(page.lines().next(), Some(&*format!("# {title}")), "{file}");
    }
}

/// What is longer is read in the file.
#[test]
fn no_listing_of_chapter_6_is_longer_than_60_lines() {
    let of_chapter_6 = [
        "speed_vs_accuracy",
        "methods",
        "never_wrong",
        "shadows",
        "measurements",
        "many",
    ];
    for page in chapters(&pages()) {
        if !of_chapter_6.contains(&page.name.trim_end_matches(".html")) {
            continue;
        }
        for listing in page.all(".listing code") {
            let lines = text_of(listing).lines().count();
            let first = text_of(listing);
            assert!(lines <= 60, "{lines} lines in {}: {first}", page.name);
        }
    }
}

/// mdBook sends who follows an old link on, but does not look where.
#[test]
fn every_redirect_leads_to_a_heading() {
    let pages = pages();
    let book = fs::read_to_string(Path::new(NOTES).join("../book.toml")).expect("book.toml");
    let redirects = book
        .lines()
        .filter(|line| line.starts_with("\"/"))
        .map(|line| {
            let ends: Vec<&str> = line.split('"').collect();
            (ends[1], ends[3])
        });
    let mut count = 0;
    for (from, to) in redirects {
        let (path, fragment) = from
            .trim_start_matches('/')
            .split_once('#')
            .expect("an anchor");
        let old = pages.iter().find(|page| page.name == path).expect("a page");
        assert!(!old.has(fragment), "{from} is still there");
        let (path, fragment) = to.split_once('#').unwrap_or((to, ""));
        let new = pages.iter().find(|page| page.name == path).expect("a page");
        assert!(fragment.is_empty() || new.has(fragment), "{to}");
        count += 1;
    }
    assert!(count > 10, "only {count} redirects");
}

#[test]
fn no_page_is_empty() {
    for page in chapters(&pages()) {
        let words = page.prose().split_whitespace().count();
        assert!(words > 100, "{} has {words} words", page.name);
    }
}

#[test]
fn nothing_is_left_that_should_have_been_woven() {
    for page in chapters(&pages()) {
        let prose = page.prose();
        for raw in ["{{", "}}", "$", "\\tag", "[!"] {
            assert!(!prose.contains(raw), "{raw} is left in {}", page.name);
        }
        // In a code span no directive is seen: `{{value …}}` stands there as it is.
        let all: String = page.all("main").into_iter().map(text_of).collect();
        for directive in [
            "value", "code", "figure", "chart", "changes", "snapshot", "slip",
        ] {
            let raw = format!("{{{{{directive}");
            assert!(!all.contains(&raw), "{raw} is left in {}", page.name);
        }
    }
}

#[test]
fn each_equation_has_its_number_once() {
    let pages = pages();
    for n in 1..=15 {
        let equation = select(&format!("#eq-{n}"));
        let count: usize = chapters(&pages)
            .map(|page| page.html.select(&equation).count())
            .sum();
        assert_eq!(count, 1, "equation ({n}) of the notes");
    }
}

#[test]
fn each_figure_is_shown_once() {
    assert_shown_once(figures::FIGURES.iter().map(|figure| figure.name));
}

#[test]
fn every_public_function_is_shown_by_a_listing() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let pages = pages();
    let listings: Vec<String> = chapters(&pages)
        .flat_map(|page| page.all(".listing code"))
        .map(text_of)
        .collect();
    let explained =
        ["camera.rs", "color.rs", "ray.rs"].map(|file| root.join("common/src").join(file));
    for file in files(&root.join("chapters")).into_iter().chain(explained) {
        if file.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        let source = fs::read_to_string(&file).expect("a source");
        for line in source.lines().map(str::trim) {
            let is_function = line.starts_with("pub fn ") || line.starts_with("pub const fn ");
            let is_shown = || listings.iter().any(|listing| listing.contains(line));
            assert!(
                !is_function || is_shown(),
                "no page shows `{line}` of {}",
                file.display()
            );
        }
    }
}

/// Code that is typed into a page is code that nobody compiles: `rust,ignore` says
/// that it need not be.
#[test]
fn every_rust_listing_comes_from_a_source() {
    for page in chapters(&pages()) {
        let all: Vec<String> = page
            .all("code.language-rust:not(.ignore)")
            .into_iter()
            .map(text_of)
            .collect();
        let listed: Vec<String> = page.all(".listing code").into_iter().map(text_of).collect();
        for code in all {
            assert!(listed.contains(&code), "typed into {}:\n{code}", page.name);
        }
    }
}

#[test]
fn every_exercise_has_a_hint_and_an_answer_that_say_what_they_are() {
    for page in chapters(&pages()) {
        let [hints, answers] = ["Hint", "Answer"].map(|word| {
            let summaries = page.all(&format!("details.{} > summary", word.to_lowercase()));
            for summary in &summaries {
                assert!(text_of(*summary).contains(word), "{}", page.name);
            }
            summaries.len()
        });
        assert_eq!(hints, answers, "hints and answers in {}", page.name);
    }
}

#[test]
fn every_picture_says_what_there_is_to_see() {
    for page in chapters(&pages()) {
        for picture in page.all("main img") {
            let [file, alt] = ["src", "alt"].map(|name| picture.attr(name).unwrap_or(""));
            let words = alt.split_whitespace().count();
            assert!(words >= 4, "{file} in {} is called {alt:?}", page.name);
        }
        for drawing in page.all("main figure svg") {
            let [title, description] = ["title", "desc"].map(|name| {
                let words: String = drawing.select(&select(name)).map(text_of).collect();
                words
            });
            assert!(
                !title.is_empty(),
                "a drawing without title in {}",
                page.name
            );
            assert!(
                description.len() > 20,
                "{title} in {} has no description",
                page.name
            );
        }
    }
}

/// What can be read on two printed pages.
const WORDS_WITHOUT_A_PICTURE: usize = 800;

#[test]
fn whoever_reads_a_chapter_sees_a_picture_at_least_every_two_pages() {
    let pages = pages();
    for chapter in &Chapter::OF_THE_BOOK[1..] {
        let name = format!("{}.html", chapter.name());
        let page = pages.iter().find(|page| page.name == name).expect("a page");
        let main = page.all("main").pop().expect("a page has a main part");
        let (mut words, mut heading) = (0, String::new());
        for node in main.descendants() {
            let parent = node.parent().and_then(ElementRef::wrap);
            let is_in_a_list = parent.is_some_and(|parent| parent.value().name() == "option");
            match (node.value(), ElementRef::wrap(node)) {
                (_, Some(element)) => match element.value().name() {
                    "img" => words = 0,
                    // Those without a role are icons.
                    "svg" if element.attr("role") == Some("img") => words = 0,
                    "h2" => heading = text_of(element),
                    _ => {}
                },
                // What can be chosen is not read.
                (Node::Text(text), _) if !is_in_a_list => {
                    words += text.split_whitespace().count();
                }
                _ => {}
            }
            if heading == "What the tests promise" {
                break;
            }
            assert!(
                words <= WORDS_WITHOUT_A_PICTURE,
                "{words} words without a picture in {name}, under {heading:?}"
            );
        }
    }
}

#[test]
fn every_link_inside_the_book_leads_somewhere() {
    let pages = pages();
    for page in pages.iter() {
        for link in page.attributes("a[href]", "href") {
            if is_elsewhere(link) {
                continue;
            }
            let (path, fragment) = link.split_once('#').unwrap_or((link, ""));
            let target = match path {
                "" => page.name.clone(),
                path => resolve(&page.name, path),
            };
            assert!(woven().join(&target).is_file(), "{link} in {}", page.name);
            let target = pages.iter().find(|page| page.name == target);
            let exists = target.is_none_or(|target| target.has(fragment));
            assert!(
                exists || fragment.is_empty(),
                "{link} in {}: no heading there is called #{fragment}",
                page.name
            );
        }
    }
}

#[test]
fn every_id_is_given_once_on_its_page() {
    for page in pages().iter() {
        let mut ids = BTreeSet::new();
        for id in page.ids() {
            assert!(ids.insert(id), "{id} is twice in {}", page.name);
        }
    }
}

#[test]
fn every_resource_is_a_file_of_the_book() {
    for page in pages().iter() {
        for attribute in ["src", "data", "poster", "srcset", "background"] {
            for resource in page.attributes(&format!("[{attribute}]"), attribute) {
                assert_is_in_the_book(&page.name, resource);
            }
        }
        // Links that load something; use and image are parts of drawings.
        for resource in page.attributes("link, use, image", "href") {
            assert_is_in_the_book(&page.name, resource);
        }
        for style in page.all("style") {
            assert_style_stays_here(&page.name, &text_of(style));
        }
        for style in page.attributes("[style]", "style") {
            assert_style_stays_here(&page.name, style);
        }
    }
    for file in files(woven()) {
        if matches!(
            file.extension().and_then(OsStr::to_str),
            Some("css" | "svg")
        ) {
            let name = file.strip_prefix(woven()).expect("a file of the book");
            let style = fs::read_to_string(&file).expect("a style");
            assert_style_stays_here(&name.to_string_lossy().replace('\\', "/"), &style);
        }
    }
}

/// Speed and accuracy are read from where they were measured: `{{value FILE KEY}}`.
#[test]
fn no_measured_number_is_typed_into_a_page() {
    let units = ["ns", "µs", "ms", "ulp", "ulps"];
    for name in names_in(Path::new(NOTES)) {
        if !name.ends_with(".md") {
            continue;
        }
        let text = fs::read_to_string(Path::new(NOTES).join(&name)).expect("a page");
        for line in outside_code(&text) {
            let words: Vec<&str> = line.split_whitespace().collect();
            for [number, unit] in words.array_windows() {
                let is_number = number
                    .trim_start_matches(['(', '~', '≈', '*'])
                    .parse::<f64>()
                    .is_ok();
                let unit = unit.trim_end_matches(['.', ',', ';', ':', ')', '*', '|']);
                let typed = is_number && units.contains(&unit);
                assert!(!typed, "{number} {unit} is typed into {name}");
            }
        }
    }
}

#[test]
fn no_page_names_a_folder_of_this_machine() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .expect("the workspace");
    for name in page_names() {
        let text = fs::read_to_string(woven().join(&name)).expect("a page");
        assert!(!text.contains(&*here.to_string_lossy()), "{name}");
    }
}

fn assert_shown_once(names: impl Iterator<Item = &'static str>) {
    let pages = pages();
    for name in names {
        let shown = select(&format!("figure#{name}"));
        let count: usize = chapters(&pages)
            .map(|page| page.html.select(&shown).count())
            .sum();
        assert_eq!(count, 1, "how often {name} is shown");
    }
}

/// The names of all pages, those of mdBook's own included.
pub(crate) fn page_names() -> Vec<String> {
    names_in(woven())
        .into_iter()
        .filter(|name| name.ends_with(".html"))
        .collect()
}

/// A page as it was woven.
pub(crate) struct Page {
    /// The name of its file.
    pub(crate) name: String,
    html: Html,
}

/// All pages, read once for all tests; one test at a time looks at them.
pub(crate) fn pages() -> MutexGuard<'static, Vec<Page>> {
    static PAGES: LazyLock<Mutex<Vec<Page>>> =
        LazyLock::new(|| Mutex::new(page_names().into_iter().map(Page::read).collect()));
    // A test that failed has changed nothing.
    PAGES.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The pages that were written, without those that mdBook makes of them.
fn chapters(pages: &[Page]) -> impl Iterator<Item = &Page> {
    let made = ["index.html", "print.html", "toc.html", "404.html"];
    pages
        .iter()
        .filter(move |page| !made.contains(&page.name.as_str()))
}

impl Page {
    fn read(name: String) -> Self {
        let text = fs::read_to_string(woven().join(&name)).expect("a page");
        let html = Html::parse_document(&text);
        Self { name, html }
    }

    pub(crate) fn all(&self, selector: &str) -> Vec<ElementRef<'_>> {
        self.all_of(&select(selector))
    }

    pub(crate) fn all_of(&self, selector: &Selector) -> Vec<ElementRef<'_>> {
        self.html.select(selector).collect()
    }

    fn attributes(&self, selector: &str, name: &str) -> Vec<&str> {
        let elements = self.all(selector).into_iter();
        elements.filter_map(|element| element.attr(name)).collect()
    }

    fn ids(&self) -> Vec<&str> {
        self.attributes("[id]", "id")
    }

    /// Whether an element has this id.
    fn has(&self, id: &str) -> bool {
        let mut elements = self.html.tree.values().filter_map(Node::as_element);
        elements.any(|element| element.id() == Some(id))
    }

    /// The text that is no code.
    fn prose(&self) -> String {
        let is_code = |element: ElementRef| matches!(element.value().name(), "code" | "style");
        let main = self.all("main").pop().expect("a page has a main part");
        let texts = main.descendants().filter(|node| {
            let mut around = node.ancestors().filter_map(ElementRef::wrap);
            node.value().is_text() && !around.any(is_code)
        });
        texts
            .filter_map(|node| node.value().as_text().map(|text| text.to_string()))
            .collect()
    }
}

pub(crate) fn select(selector: &str) -> Selector {
    Selector::parse(selector).expect("a selector")
}

pub(crate) fn text_of(element: ElementRef) -> String {
    element.text().collect()
}

/// Whether the link names a protocol, or a computer.
fn is_elsewhere(link: &str) -> bool {
    link.contains("://") || link.starts_with("//") || link.starts_with("mailto:")
}

/// The file that `link` leads to from the file `from`, both seen from the folder
/// of the book.
fn resolve(from: &str, link: &str) -> String {
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in link.split('/') {
        match part {
            "." | "" => {}
            ".." => assert!(parts.pop().is_some(), "{link} in {from} leaves the book"),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

/// Every `url(…)` is a file of the book, or part of the style sheet.
fn assert_style_stays_here(name: &str, style: &str) {
    assert!(!style.contains("@import"), "{name} imports a style sheet");
    for url in style.split("url(").skip(1) {
        let url = url
            .split(')')
            .next()
            .unwrap_or("")
            .trim_matches(['"', '\'']);
        assert_is_in_the_book(name, url);
    }
}

fn assert_is_in_the_book(from: &str, resource: &str) {
    if resource.starts_with("data:") || resource.starts_with('#') {
        return;
    }
    assert!(!is_elsewhere(resource), "{from} loads {resource}");
    let path = resource.split(['?', '#']).next().unwrap_or("");
    let file = woven().join(resolve(from, path));
    assert!(file.is_file(), "{from} loads {resource}, which is missing");
}

/// The lines of a page of Markdown that are no code.
fn outside_code(text: &str) -> impl Iterator<Item = &str> {
    let mut inside = false;
    text.lines().filter(move |line| {
        let is_fence = line.trim_start().starts_with("```");
        inside ^= is_fence;
        !inside && !is_fence
    })
}
