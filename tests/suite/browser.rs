//! What a real browser makes of the book.

mod devtools;

use std::fs;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use serde_json::Value;
use tempfile::TempDir;

use crate::book::{page_names, woven};
use crate::left_out::left_out;
use devtools::{Browser, Tab};

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
fn every_text_can_be_read_in_the_light() {
    assert_none(|visit| &visit.faint_in_the_light);
}

#[test]
fn every_text_can_be_read_in_the_dark() {
    assert_none(|visit| &visit.faint_in_the_dark);
}

#[test]
fn formulas_are_drawn_with_their_font_and_as_large_as_the_text() {
    assert_none(|visit| &visit.formulas);
}

/// On a phone it is hidden.
#[test]
fn the_table_of_contents_can_be_read_in_the_light_and_in_the_dark() {
    let Some(mut browser) = browser() else { return };
    let mut tab = browser.tab(1200);
    tab.open(&woven().join("normals.html"), "");
    for scheme in ["light", "dark"] {
        tab.set_media("screen", scheme);
        assert_eq!(list(&tab.evaluate(CONTRAST)), [""; 0], "{scheme}");
    }
}

/// A check that finds nothing in a good page must find something in a bad one.
#[test]
fn a_page_that_breaks_the_rules_is_noticed() {
    let Some(mut browser) = browser() else { return };
    let folder = TempDir::new().expect("a folder");
    let file = folder.path().join("bad.html");
    fs::write(&file, BAD_PAGE).expect("a file");
    let mut tab = browser.tab(360);
    let events = tab.open(&file, "");
    let said = complaints(&events).join("\n");
    assert!(
        said.contains("a complaint") && said.contains("an accident"),
        "{said}"
    );
    let asked = requests_to_others(&events).join("\n");
    assert!(asked.contains("http://127.0.0.1:9/picture.png"), "{asked}");
    let wide = list(&tab.evaluate(OVERFLOW)).join("\n");
    assert!(
        wide.contains("too wide") && !wide.contains("scrolls"),
        "{wide}"
    );
    let faint = list(&tab.evaluate(CONTRAST)).join("\n");
    assert!(
        faint.contains("gray on white") && faint.contains("a pale label"),
        "{faint}"
    );
    for readable in ["black on white", "a dark label", "a label on black"] {
        assert!(!faint.contains(readable), "{faint}");
    }
    let wrong = list(&tab.evaluate(FORMULAS)).join("\n");
    assert!(
        wrong.contains("font is not loaded") && wrong.contains("lacks"),
        "{wrong}"
    );
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
    tab.evaluate("document.getElementById('mdbook-theme-light').click()");
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

/// What is wrong with a page as a phone shows it.
struct Visit {
    page: String,
    complaints: Vec<String>,
    wide: Vec<String>,
    formulas: Vec<String>,
    faint_in_the_light: Vec<String>,
    faint_in_the_dark: Vec<String>,
}

impl Visit {
    fn to(page: String, tab: &mut Tab) -> Self {
        tab.set_media("screen", "light");
        let events = tab.open(&woven().join(&page), "");
        tab.evaluate("document.querySelectorAll('details').forEach((it) => it.open = true)");
        let mut complaints = complaints(&events);
        complaints.extend(requests_to_others(&events));
        let wide = list(&tab.evaluate(OVERFLOW));
        let formulas = list(&tab.evaluate(FORMULAS));
        let faint_in_the_light = list(&tab.evaluate(CONTRAST));
        tab.set_media("screen", "dark");
        let faint_in_the_dark = list(&tab.evaluate(CONTRAST));
        Self {
            page,
            complaints,
            wide,
            formulas,
            faint_in_the_light,
            faint_in_the_dark,
        }
    }
}

/// Visits every page, once for all tests, and fails with what is wrong with them.
fn assert_none(problems: impl Fn(&Visit) -> &Vec<String>) {
    static VISITS: LazyLock<Vec<Visit>> = LazyLock::new(|| {
        let Some(mut browser) = browser() else {
            return Vec::new();
        };
        let mut tab = browser.tab(360);
        let mut pages = page_names();
        // It repeats all others.
        pages.retain(|page| page != "print.html");
        let visit = |page| Visit::to(page, &mut tab);
        pages.into_iter().map(visit).collect()
    });
    let all: Vec<String> = VISITS
        .iter()
        .flat_map(|visit| {
            problems(visit)
                .iter()
                .map(|it| format!("{}: {it}", visit.page))
        })
        .collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
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

/// The items of a list, each on a line.
fn list(values: &Value) -> Vec<String> {
    let values = values.as_array().expect("a list");
    values.iter().map(Value::to_string).collect()
}

/// The browser of all tests; without one it says so, and they check nothing.
fn browser() -> Option<MutexGuard<'static, Browser>> {
    static BROWSER: LazyLock<Option<Mutex<Browser>>> = LazyLock::new(|| match Browser::start() {
        Ok(browser) => Some(Mutex::new(browser)),
        Err(cause) => {
            left_out(&format!(
                "what a browser makes of the book (tests/suite/browser.rs): {cause}.\n\
                 Install Chromium or Chrome, or say in CHROMIUM where it is."
            ));
            None
        }
    });
    let browser = BROWSER.as_ref()?;
    Some(browser.lock().unwrap_or_else(PoisonError::into_inner))
}

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
<img alt=\"\" src=\"http://127.0.0.1:9/picture.png\">
</main>
<script>console.error('a complaint'); throw new Error('an accident');</script>
";
