//! What real browsers make of the book: Chromium and Firefox, on a phone and at a desk,
//! in each theme.

mod bidi;
mod devtools;
mod dragged;
mod frames;
mod painted;

use std::path::Path;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};
use std::{fs, iter, thread};

use serde_json::Value;
use tempfile::TempDir;

use crate::book::page_names;
use bidi::Firefox;
use devtools::{Browser, NEXT_FRAME, Tab};
use suite::command::woven;
use suite::left_out::left_out;

const BARRIERS: &str = include_str!("browser/barriers.js");
const CONTRAST: &str = include_str!("browser/contrast.js");
const FORMULAS: &str = include_str!("browser/formulas.js");
const OVERFLOW: &str = include_str!("browser/overflow.js");

#[test]
fn every_page_opens_without_a_complaint_and_asks_nobody_else() {
    assert_none(|visit| &visit.complaints);
}

#[test]
fn nothing_is_wider_than_a_phone() {
    assert_none(|visit| &visit.wide);
}

#[test]
fn every_text_can_be_read_in_each_theme() {
    assert_none(|visit| &visit.faint);
}

#[test]
fn formulas_are_whole_and_drawn_with_their_font_and_as_large_as_the_text() {
    assert_none(|visit| &visit.formulas);
}

#[test]
fn nothing_bars_a_reader_who_listens_or_has_only_a_keyboard() {
    assert_none(|visit| &visit.barriers);
}

/// A check that finds nothing in a good page must find something in a bad one.
#[test]
fn a_page_that_breaks_the_rules_is_noticed() {
    let folder = TempDir::new().expect("a folder");
    let file = folder.path().join("bad.html");
    fs::write(&file, BAD_PAGE).expect("a file");
    if let Some(mut browser) = browser() {
        assert_noticed(&file, &mut browser.tab(360));
    }
    if let Some(mut firefox) = firefox() {
        firefox.set_width(360);
        assert_noticed(&file, &mut *firefox);
    }
}

fn assert_noticed(file: &Path, window: &mut dyn Window) {
    window.open_file(file, "");
    window.value_of("new Promise((done) => setTimeout(() => done(null), 600))");
    let said = window.complaints().join("\n");
    for complaint in [
        "a complaint",
        "an accident",
        "a late one",
        "nobody.invalid/picture.png",
    ] {
        assert!(said.contains(complaint), "{complaint} is not in\n{said}");
    }
    let wide = list(&window.value_of(OVERFLOW)).join("\n");
    assert!(
        wide.contains("too wide") && !wide.contains("scrolls"),
        "{wide}"
    );
    let faint = list(&window.value_of(CONTRAST)).join("\n");
    assert!(
        faint.contains("gray on white") && faint.contains("a pale label"),
        "{faint}"
    );
    for readable in ["black on white", "a dark label", "a label on black"] {
        assert!(!faint.contains(readable), "{faint}");
    }
    let wrong = list(&window.value_of(FORMULAS)).join("\n");
    for fault in [
        "font is not loaded",
        "lacks",
        "cut off",
        "mfrac has 1 of 2 parts",
    ] {
        assert!(wrong.contains(fault), "{fault} is not in\n{wrong}");
    }
    if let Some(axe) = axe() {
        window.value_of(axe);
        let barriers = list(&window.value_of(BARRIERS)).join("\n");
        assert!(barriers.contains("image-alt"), "{barriers}");
    }
}

#[test]
fn the_search_finds_the_discriminant() {
    let Some(mut browser) = browser() else { return };
    let mut tab = browser.tab(1200);
    tab.open(&woven().join("index.html"), "?search=discriminant");
    let found = tab.evaluate(
        "new Promise((resolve) => {
            const look = () => {
                const links = [...document.querySelectorAll('#mdbook-searchresults a')];
                links.some((link) => link.href.includes('red_sphere')) ? resolve(links.map((link) => link.href)) : setTimeout(look, 20);
            };
            look();
            setTimeout(() => resolve([]), 10000);
        })",
    );
    assert!(
        !list(&found).is_empty(),
        "nothing in red_sphere.html is found"
    );
}

#[test]
fn an_answer_opens_by_keyboard_and_shows_where_the_keyboard_is() {
    let Some(mut browser) = browser() else { return };
    let mut tab = browser.tab(1200);
    // The keyboard goes on from the heading that was jumped to.
    tab.open(&woven().join("normals.html"), "#exercises");
    let at_answer = "document.activeElement.matches('details.answer > summary')";
    let steps = (0..10).find(|_| {
        tab.press("Tab");
        tab.evaluate(at_answer) == true
    });
    assert!(steps.is_some(), "no answer is reached with the Tab key");
    let outline = tab.evaluate("getComputedStyle(document.activeElement).outlineStyle");
    assert_ne!(outline, "none");
    let is_open = "document.activeElement.parentElement.open";
    assert_eq!(tab.evaluate(is_open), false);
    tab.press("Enter");
    assert_eq!(tab.evaluate(is_open), true);
}

#[test]
fn the_sidebar_goes_and_comes_by_keyboard() {
    let Some(mut browser) = browser() else { return };
    let mut tab = browser.tab(1200);
    tab.open(&woven().join("normals.html"), "");
    let is_there = "document.documentElement.classList.contains('sidebar-visible')";
    assert_eq!(tab.evaluate(is_there), true);
    tab.evaluate("document.querySelector('[aria-controls=mdbook-sidebar]').focus()");
    for expected in [false, true] {
        tab.press("Enter");
        assert_eq!(tab.evaluate(is_there), expected);
        let said = "document.activeElement.ariaExpanded";
        assert_eq!(tab.evaluate(said), expected.to_string());
    }
}

#[test]
fn a_table_that_is_too_wide_is_restacked_and_each_field_has_its_label() {
    let Some(mut browser) = browser() else { return };
    let label = "(() => {
        const field = document.querySelector('table tbody td:nth-child(3)');
        return getComputedStyle(field, '::before').content;
    })()";
    for (width, expected) in [(360, "\"1: \""), (1300, "none")] {
        let mut tab = browser.tab(width);
        tab.open(
            &woven().join("caught.html"),
            "#slips-that-begin-in-build_test",
        );
        tab.evaluate(NEXT_FRAME);
        let table = label.replace("table tbody", "table:has(th:nth-child(5)) tbody");
        assert_eq!(tab.evaluate(&table), expected, "{width} pixels");
    }
}

#[test]
fn the_words_of_drawings_and_terminals_are_large_enough_on_a_phone() {
    let Some(mut browser) = browser() else { return };
    let mut tab = browser.tab(360);
    let mut seen = 0;
    for page in page_names() {
        tab.open(&woven().join(page), "");
        let sizes = tab.evaluate(WORDS);
        for size in sizes.as_array().expect("a list") {
            let [name, size] = [&size[0], &size[1]];
            assert!(
                size.as_f64() >= Some(10.0),
                "{name} has words of {size} pixels"
            );
            seen += 1;
        }
    }
    assert!(seen > 20, "{seen} drawings");
}

#[test]
fn figures_take_on_the_theme_of_the_page() {
    let Some(mut browser) = browser() else { return };
    let mut tab = browser.tab(1200);
    tab.set_media("screen", "light");
    tab.open(&woven().join("gradient.html"), "");
    let color = "getComputedStyle(document.querySelector('figure svg .ray')).color";
    let light = tab.evaluate(color);
    tab.set_media("screen", "dark");
    let dark = tab.evaluate(color);
    assert!(light.is_string() && dark.is_string());
    assert_ne!(light, dark);
    tab.evaluate("document.getElementById('mdbook-theme-light')?.click()");
    assert_eq!(tab.evaluate(color), light);
}

#[test]
fn on_paper_every_answer_is_open() {
    let Some(mut browser) = browser() else { return };
    let mut tab = browser.tab(1200);
    tab.open(&woven().join("normals.html"), "");
    let height = "document.querySelector('details.answer').getBoundingClientRect().height";
    let closed = tab.evaluate(height).as_f64().expect("a height");
    tab.set_media("print", "light");
    let open = tab.evaluate(height).as_f64().expect("a height");
    assert!(
        open > closed + 50.0,
        "{closed} pixels on the screen, {open} on paper"
    );
}

/// Where there is most to tear apart.
#[test]
fn on_paper_nothing_is_torn_but_what_is_long() {
    let Some(mut browser) = browser() else { return };
    // As wide as a sheet between its margins.
    let mut tab = browser.tab(670);
    tab.open(&woven().join("speed_vs_accuracy.html"), "");
    tab.set_media("print", "light");
    let breaks = "[...document.querySelectorAll('main pre, main figure')].map(
        (it) => `${it.localName}: ${getComputedStyle(it).breakInside}`)";
    let mut kinds = list(&tab.evaluate(breaks));
    kinds.sort();
    kinds.dedup();
    assert_eq!(kinds, ["\"figure: avoid\"", "\"pre: auto\""]);
    assert_eq!(list(&tab.evaluate(OVERFLOW)), [""; 0]);
    let tallest = "Math.max(...[...document.querySelectorAll('main figure')].map(
        (it) => it.getBoundingClientRect().height))";
    let tallest = tab.evaluate(tallest).as_f64().expect("a height");
    assert!(
        tallest < 800.0,
        "a figure takes {tallest} pixels of a thousand"
    );
}

/// A window in which a page is open.
trait Window {
    /// Opens the page, with a query or a fragment behind it.
    fn open_file(&mut self, file: &Path, behind: &str);

    /// What the browser complains of since then, and each request to others.
    fn complaints(&mut self) -> Vec<String>;

    /// The value of a script.
    fn value_of(&mut self, script: &str) -> Value;
}

impl Window for Tab<'_> {
    fn open_file(&mut self, file: &Path, behind: &str) {
        self.open(file, behind);
    }

    fn complaints(&mut self) -> Vec<String> {
        let events = self.events();
        let mut complaints = complaints(&events);
        complaints.extend(requests_to_others(&events));
        complaints
    }

    fn value_of(&mut self, script: &str) -> Value {
        self.evaluate(script)
    }
}

impl Window for Firefox {
    fn open_file(&mut self, file: &Path, behind: &str) {
        self.open(file, behind);
    }

    fn complaints(&mut self) -> Vec<String> {
        let events = self.events();
        events.iter().filter_map(complaint_of_firefox).collect()
    }

    fn value_of(&mut self, script: &str) -> Value {
        self.evaluate(script)
    }
}

/// The themes of mdBook.
const THEMES: [&str; 5] = ["light", "rust", "coal", "navy", "ayu"];

/// A phone's width, and a desk's.
const WIDTHS: [u32; 2] = [360, 1300];

/// What is wrong with a page in a browser at a width.
struct Visit {
    place: String,
    complaints: Vec<String>,
    wide: Vec<String>,
    formulas: Vec<String>,
    faint: Vec<String>,
    barriers: Vec<String>,
}

impl Visit {
    fn to(page: &str, place: String, axe: Option<&str>, window: &mut dyn Window) -> Self {
        window.open_file(&woven().join(page), "");
        window.value_of(ALL_ALIVE);
        window.value_of("document.querySelectorAll('details').forEach((it) => it.open = true)");
        // Tables fit themselves to the page after it was drawn.
        window.value_of(NEXT_FRAME);
        window.value_of(NEXT_FRAME);
        let wide = list(&window.value_of(OVERFLOW));
        let formulas = list(&window.value_of(FORMULAS));
        let barriers = axe.map_or(Vec::new(), |axe| {
            window.value_of(axe);
            list(&window.value_of(BARRIERS))
        });
        let mut faint = Vec::new();
        for theme in THEMES {
            choose(theme, window);
            let found = list(&window.value_of(CONTRAST)).into_iter();
            faint.extend(found.map(|it| format!("{theme}: {it}")));
        }
        choose("default_theme", window);
        Self {
            place,
            faint,
            complaints: window.complaints(),
            wide,
            formulas,
            barriers,
        }
    }
}

/// Chooses a theme, where the page has a list of them.
fn choose(theme: &str, window: &mut dyn Window) {
    window.value_of(&format!(
        "document.getElementById('mdbook-theme-{theme}')?.click()"
    ));
    window.value_of(NEXT_FRAME);
}

/// Visits every page, once for all tests, and fails with what is wrong with them.
fn assert_none(problems: impl Fn(&Visit) -> &Vec<String>) {
    static VISITS: LazyLock<Vec<Visit>> = LazyLock::new(|| {
        thread::scope(|scope| {
            let firefox = scope.spawn(visits_with_firefox);
            let mut visits = visits_with_chromium();
            visits.extend(firefox.join().expect("Firefox visits every page"));
            visits
        })
    });
    let all: Vec<String> = VISITS
        .iter()
        .flat_map(|visit| iter::repeat(&visit.place).zip(problems(visit)))
        .map(|(place, problem)| format!("{place}: {problem}"))
        .collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
}

fn visits_with_chromium() -> Vec<Visit> {
    let Some(mut browser) = browser() else {
        return Vec::new();
    };
    let at = |width| {
        let place = format!("Chromium, {width} pixels");
        visits(&place, axe(), &mut browser.tab(width))
    };
    WIDTHS.into_iter().flat_map(at).collect()
}

/// Without axe-core, to which a page is the same in every browser.
fn visits_with_firefox() -> Vec<Visit> {
    let Some(mut firefox) = firefox() else {
        return Vec::new();
    };
    let at = |width| {
        firefox.set_width(width);
        visits(&format!("Firefox, {width} pixels"), None, &mut *firefox)
    };
    WIDTHS.into_iter().flat_map(at).collect()
}

fn visits(place: &str, axe: Option<&str>, window: &mut dyn Window) -> Vec<Visit> {
    let mut pages = page_names();
    // Two repeat others, and one is a frame of others where there are no scripts.
    let none = ["index.html", "print.html", "toc.html"];
    pages.retain(|page| !none.contains(&page.as_str()));
    let visit = |page: &String| Visit::to(page, format!("{place}, {page}"), axe, window);
    pages.iter().map(visit).collect()
}

/// Errors and warnings in the console, and scripts that broke off.
fn complaints(events: &[Value]) -> Vec<String> {
    let is_complaint = |event: &&Value| match event["method"].as_str() {
        Some("Runtime.consoleAPICalled") => ["error", "warning", "assert"]
            .iter()
            .any(|kind| event["params"]["type"] == *kind),
        Some("Log.entryAdded") => event["params"]["entry"]["level"] == "error",
        Some("Runtime.exceptionThrown" | "Network.loadingFailed") => true,
        _ => false,
    };
    let complaints = events.iter().filter(is_complaint);
    complaints
        .map(|event| event["params"].to_string())
        .collect()
}

fn requests_to_others(events: &[Value]) -> Vec<String> {
    let requests = events
        .iter()
        .filter(|event| event["method"] == "Network.requestWillBeSent")
        .filter_map(|event| event["params"]["request"]["url"].as_str());
    requests
        .filter(|url| !url.starts_with("file://") && !url.starts_with("data:"))
        .map(|url| format!("asks for {url}"))
        .collect()
}

fn complaint_of_firefox(event: &Value) -> Option<String> {
    let said = &event["params"];
    match event["method"].as_str()? {
        "log.entryAdded" if ["error", "warn"].contains(&said["level"].as_str()?) => {
            let text = said["text"].as_str()?;
            // Firefox may draw a page of which it has read the half, and then it says so of
            // a half fraction too. Whether a whole one has two parts, FORMULAS looks.
            (!text.starts_with("Invalid markup: Incorrect number of children for <m"))
                .then(|| text.to_owned())
        }
        "network.fetchError" => Some(said["errorText"].to_string()),
        "network.beforeRequestSent" => {
            let url = said["request"]["url"].as_str()?;
            let is_ours = url.starts_with("file:") || url.starts_with("data:");
            (!is_ours).then(|| format!("asks for {url}"))
        }
        _ => None,
    }
}

/// The items of a list, each on a line.
fn list(values: &Value) -> Vec<String> {
    let values = values.as_array().expect("a list");
    values.iter().map(Value::to_string).collect()
}

/// The Chromium of all tests; without one it says so, and they check nothing.
fn browser() -> Option<MutexGuard<'static, Browser>> {
    static BROWSER: LazyLock<Option<Mutex<Browser>>> =
        LazyLock::new(|| started(Browser::start(), "Chromium or Chrome", "CHROMIUM"));
    let browser = BROWSER.as_ref()?;
    Some(browser.lock().unwrap_or_else(PoisonError::into_inner))
}

/// The same for Firefox.
fn firefox() -> Option<MutexGuard<'static, Firefox>> {
    static FIREFOX: LazyLock<Option<Mutex<Firefox>>> =
        LazyLock::new(|| started(Firefox::start(), "Firefox", "FIREFOX"));
    let firefox = FIREFOX.as_ref()?;
    Some(firefox.lock().unwrap_or_else(PoisonError::into_inner))
}

fn started<B>(browser: Result<B, String>, name: &str, variable: &str) -> Option<Mutex<B>> {
    match browser {
        Ok(browser) => Some(Mutex::new(browser)),
        Err(cause) => {
            left_out(&format!(
                "what a browser makes of the book (tests/suite/book/browser.rs): {cause}.\n\
                 Install {name}, or say in {variable} where it is."
            ));
            None
        }
    }
}

/// The script of axe-core, which looks for what bars a reader from a page; the value is
/// of no use. `.ci/run` fetches it: two thirds of a megabyte that others keep well.
fn axe() -> Option<&'static str> {
    static AXE: LazyLock<Option<String>> = LazyLock::new(|| {
        let tools = Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("tools");
        let script = fs::read_to_string(tools.join("node_modules/axe-core/axe.min.js"));
        if script.is_err() {
            left_out(&format!(
                "what bars readers from a page (tests/suite/book/browser.rs): there is no axe-core.\n\
                 npm install --no-save --prefix {} axe-core",
                tools.display()
            ));
        }
        script
            .ok()
            .map(|script| format!("(() => {{ {script}; }})()"))
    });
    AXE.as_deref()
}

/// Brings the first live figure near the screen, and waits until all that can move does,
/// and all pictures are painted.
const ALL_ALIVE: &str = "new Promise((done, fail) => {
    document.querySelector('figure.live')?.scrollIntoView();
    const waiting = () => document.querySelector(
        'figure.live:not(.alive), figure.live:has(.sentence[aria-busy=true])');
    const look = () => waiting() ? setTimeout(look, 5) : done();
    look();
    setTimeout(() => fail(`${waiting()?.id} does not come alive, or is never painted`), 30000);
})";

/// Of each drawing that is shown the size of its smallest words, but for subscripts; and
/// that of a terminal, whose picture is 740 wide with words of 14.
const WORDS: &str = "[
    ...[...document.querySelectorAll('svg.drawing')]
        .filter((drawing) => drawing.checkVisibility() && drawing.querySelector('text'))
        .map((drawing) => [drawing.getAttribute('aria-labelledby'), Math.min(
            ...[...drawing.querySelectorAll('text')].map((text) =>
                parseFloat(getComputedStyle(text).fontSize) * text.getScreenCTM().a))]),
    ...[...document.querySelectorAll('img[src*=terminal]')]
        .filter((terminal) => terminal.checkVisibility())
        .map((terminal) => [terminal.src, 14 / 740 * terminal.width]),
]";

const BAD_PAGE: &str = "<!doctype html>
<title>Bad</title>
<main style=\"background: white\">
<p style=\"color: #999\">gray on white</p>
<p style=\"color: #000\">black on white</p>
<svg width=\"90\" height=\"40\"><text y=\"9\" fill=\"#ccc\">a pale label</text>
<text y=\"20\" fill=\"#fff\" stroke=\"#000\" paint-order=\"stroke\">a dark label</text>
<rect y=\"22\" width=\"90\" height=\"18\"/><text y=\"36\" fill=\"#fff\">a label on black</text></svg>
<p style=\"width: 500px\">too wide</p>
<div style=\"overflow-x: auto\"><p style=\"width: 500px\">scrolls</p></div>
<p><math style=\"font-family: serif\"><mi>x</mi></math></p>
<p><math><mfrac><mi>x</mi></mfrac></math></p>
<p style=\"width: 20px; overflow: hidden\"><math><mi>a</mi><mo>=</mo><mi>b</mi></math></p>
<img src=\"http://nobody.invalid/picture.png\">
</main>
<script>setTimeout(() => console.error('a late one'), 500);
console.error('a complaint'); throw new Error('an accident');</script>
";
