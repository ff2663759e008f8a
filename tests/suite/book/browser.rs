//! What real browsers make of the book: Chromium and Firefox, on a phone and at a desk,
//! in each theme.

mod dragged;
mod driver;
mod judged;
mod painted;
mod typing;

use std::fs;
use std::path::Path;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use serde_json::Value;

use crate::book::{page_names, woven};
use driver::{Browser, NEXT_FRAME};
use suite::left_out::left_out;

const BARRIERS: &str = include_str!("browser/barriers.js");
const CONTRAST: &str = include_str!("browser/contrast.js");
const FORMULAS: &str = include_str!("browser/formulas.js");
const OVERFLOW: &str = include_str!("browser/overflow.js");

/// The themes of mdBook.
const THEMES: [&str; 5] = ["light", "rust", "coal", "navy", "ayu"];

/// A phone's width, and a desk's.
const WIDTHS: [u32; 2] = [360, 1300];

/// No complaint and no request to others; nothing wider than the window; formulas whole, with
/// their font; in each theme all text can be read; nothing bars a reader who listens or has
/// only a keyboard; and on a phone the words of drawings are large enough.
#[test]
#[ignore = "drives browsers over every page, for minutes"]
fn every_page_can_be_read_at_every_width_and_in_every_theme() {
    let mut problems = Vec::new();
    each_browser(|browser| {
        for width in WIDTHS {
            browser.set_width(width);
            for page in page_names() {
                // They repeat others, or are a frame of others where there are no scripts.
                if ["index.html", "print.html", "toc.html"].contains(&page.as_str()) {
                    continue;
                }
                browser.open(&woven().join(&page), "");
                let place = format!("{}, {width} pixels, {page}", browser.name);
                let found = problems_of_page(browser, width).into_iter();
                problems.extend(found.map(|it| format!("{place}: {it}")));
            }
        }
    });
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

fn problems_of_page(browser: &mut Browser, width: u32) -> Vec<String> {
    browser.evaluate(ALL_ALIVE);
    browser.evaluate("document.querySelectorAll('details').forEach((it) => it.open = true)");
    // Tables fit themselves to the page after it was drawn.
    browser.evaluate(NEXT_FRAME);
    browser.evaluate(NEXT_FRAME);
    let mut problems = list(&browser.evaluate(OVERFLOW));
    problems.extend(list(&browser.evaluate(FORMULAS)));
    // Here Firefox has a scrollbar, which a phone has not.
    if width == WIDTHS[0] && browser.name == "Chromium" {
        problems.extend(list(&browser.evaluate(SMALL_WORDS)));
    }
    // To axe-core a page is the same in every browser.
    if let Some(axe) = axe().filter(|_| browser.name == "Chromium") {
        browser.evaluate(axe);
        problems.extend(list(&browser.evaluate(BARRIERS)));
    }
    for theme in THEMES {
        choose(theme, browser);
        let faint = list(&browser.evaluate(CONTRAST)).into_iter();
        problems.extend(faint.map(|it| format!("{theme}: {it}")));
    }
    choose("default_theme", browser);
    problems.extend(browser.complaints());
    problems
}

/// Chooses a theme, where the page has a list of them.
fn choose(theme: &str, browser: &mut Browser) {
    browser.evaluate(&format!(
        "document.getElementById('mdbook-theme-{theme}')?.click()"
    ));
    browser.evaluate(NEXT_FRAME);
}

/// Names of the code lead to a listing that gives them, and what is typed for a symbol to the
/// page of symbols.
#[test]
#[ignore = "drives browsers"]
fn the_first_that_the_search_finds_is_the_listing_of_a_name() {
    each_browser(|browser| {
        for (words, place) in [
            ("hit_sphere", "listing-hit-sphere"),
            ("viewport_u", "gradient.html#listing-impl-Camera"),
            ("focal_length", "gradient.html#listing-impl-Camera"),
            ("pixel_delta_u", "gradient.html#listing-Camera"),
            ("set_face_normal", "listing-impl-HitRecord"),
            ("P(t)", "symbols.html#a-ray"),
            ("discriminant", "red_sphere.html#what-the-discriminant-says"),
        ] {
            let behind = format!("?search={}", words.replace('(', "%28").replace(')', "%29"));
            browser.open(&woven().join("introduction.html"), &behind);
            let first = browser.evaluate(FIRST_FOUND);
            let first = first.as_str().expect("an address");
            // Behind it stands which words are to be marked.
            let first = first
                .split_once('?')
                .map_or(first.to_owned(), |(page, rest)| {
                    format!("{page}#{}", rest.split_once('#').map_or("", |(_, it)| it))
                });
            assert!(first.contains(place), "{words} leads to {first}");
        }
    });
}

/// The address of the first result of a search, once there is one.
const FIRST_FOUND: &str = "new Promise((done) => {
    const look = () => {
        const found = document.querySelector('#mdbook-searchresults a');
        found ? done(found.getAttribute('href')) : setTimeout(look, 20);
    };
    look();
})";

/// Only in Chromium: a Firefox that nobody looks at shows no focus.
#[test]
#[ignore = "drives a browser"]
fn an_answer_opens_by_keyboard_and_shows_where_the_keyboard_is() {
    each_browser(|browser| {
        if browser.name != "Chromium" {
            return;
        }
        let [tab, enter] = ['\u{e004}', '\u{e007}'];
        // The keyboard goes on from the heading that was jumped to.
        browser.open(&woven().join("normals.html"), "#exercises");
        let at_answer = "document.activeElement.matches('details.answer > summary')";
        let steps = (0..10).find(|_| {
            browser.press(&[tab]);
            browser.evaluate(at_answer) == true
        });
        assert!(steps.is_some(), "no answer is reached with the Tab key");
        let outline = browser.evaluate("getComputedStyle(document.activeElement).outlineStyle");
        assert_ne!(outline, "none");
        let is_open = "document.activeElement.parentElement.open";
        assert_eq!(browser.evaluate(is_open), false);
        browser.press(&[enter]);
        assert_eq!(browser.evaluate(is_open), true);
    });
}

/// Only in Chromium, which can be told that a screen is paper.
#[test]
#[ignore = "drives a browser"]
fn on_paper_every_answer_is_open_and_nothing_is_torn_but_what_is_long() {
    each_browser(|browser| {
        if browser.name != "Chromium" {
            return;
        }
        // As wide as a sheet between its margins.
        browser.set_width(670);
        browser.open(&woven().join("normals.html"), "");
        let height =
            "document.querySelector('#exercises ~ details.answer').getBoundingClientRect().height";
        let closed = browser.evaluate(height).as_f64();
        browser.set_media("print", "light");
        let open = browser.evaluate(height).as_f64();
        assert!(open > closed.map(|it| it + 50.0), "{open:?} on paper");
        let breaks = "[...new Set([...document.querySelectorAll('main pre, main figure')].map(
            (it) => `${it.localName}: ${getComputedStyle(it).breakInside}`))].sort()";
        let breaks = list(&browser.evaluate(breaks));
        assert_eq!(breaks, ["\"figure: avoid\"", "\"pre: auto\""]);
        assert_eq!(list(&browser.evaluate(OVERFLOW)), [""; 0]);
        browser.set_media("", "");
    });
}

/// The items of a list, each on a line.
fn list(values: &Value) -> Vec<String> {
    let values = values.as_array().expect("a list");
    values.iter().map(Value::to_string).collect()
}

/// Lets each browser that is here `look`, 1200 pixels wide; who is not here is named.
fn each_browser(mut look: impl FnMut(&mut Browser)) {
    static BROWSERS: LazyLock<Mutex<Vec<Browser>>> = LazyLock::new(|| {
        let all = [Browser::chromium(), Browser::firefox()].into_iter();
        let here = all.filter_map(|it| {
            it.inspect_err(|cause| left_out(&format!("what a browser makes of the book: {cause}")))
                .ok()
        });
        Mutex::new(here.collect())
    });
    let browsers: Result<MutexGuard<Vec<Browser>>, _> = BROWSERS.lock();
    for browser in browsers.unwrap_or_else(PoisonError::into_inner).iter_mut() {
        browser.set_width(1200);
        look(browser);
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
                "what bars readers from a page: there is no axe-core.\n\
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

/// The drawings and terminals that are shown with words of less than ten pixels, subscripts
/// apart. A terminal's picture is 740 wide with words of 14.
const SMALL_WORDS: &str = "[
    ...[...document.querySelectorAll('svg.drawing')]
        .filter((drawing) => drawing.checkVisibility() && drawing.querySelector('text'))
        .map((drawing) => [drawing.getAttribute('aria-labelledby'), Math.min(
            ...[...drawing.querySelectorAll('text')].map((text) =>
                parseFloat(getComputedStyle(text).fontSize) * text.getScreenCTM().a))]),
    ...[...document.querySelectorAll('img[src*=terminal]')]
        .filter((terminal) => terminal.checkVisibility())
        .map((terminal) => [terminal.src, 14 / 740 * terminal.width]),
].filter(([, size]) => size < 10)";
