//! The editor of a chapter in real browsers, from a file and by the keyboard.

use serde_json::json;

use super::driver::Browser;
use super::{each_browser, list};
use crate::book::woven;

const TAB: char = '\u{e004}';
const ENTER: char = '\u{e007}';
const CONTROL: char = '\u{e009}';

#[test]
#[ignore = "drives browsers"]
fn a_chapter_is_typed_in_its_page() {
    each_browser(|browser| {
        let place = browser.name;
        browser.open(&woven().join("normals.html"), "");
        browser.evaluate("localStorage.clear()");
        // By one key; but a Firefox that nobody looks at has no focus.
        match place {
            "Chromium" => {
                browser.evaluate("document.querySelector('button.type').focus()");
                browser.press(&[ENTER]);
            }
            _ => drop(browser.evaluate("document.querySelector('button.type').click()")),
        }
        let said = said(browser);
        assert!(
            said.starts_with("Not written yet: todo!() at src/lib.rs"),
            "{place}: {said}"
        );

        // No trap: after the text comes the next field.
        browser.press(&[TAB]);
        assert_eq!(
            browser.evaluate("document.activeElement.localName"),
            "button"
        );

        browser.evaluate("document.querySelector('[data-action=full]').click()");
        assert!(self::said(browser).contains("to the last bit. The laws hold."));
        assert_eq!(browser.evaluate(DRAWN), "400 225");

        // A wrong sign, with the reader's own line and the chapter's.
        type_over(browser, "-2.0", "2.0");
        let said = self::said(browser);
        assert!(said.starts_with("Wrong: "), "{place}: {said}");
        assert!(said.contains("let b = 2.0"), "{place}: {said}");
        assert!(said.contains("let b = -2.0"), "{place}: {said}");

        type_over(browser, "return None;", "return false;");
        let said = self::said(browser);
        assert!(said.starts_with("It does not compile."), "{place}: {said}");
        assert!(said.contains("mismatched types"), "{place}: {said}");
        assert_eq!(browser.evaluate(UNDERLINED), "false");

        type_over(browser, "return false;", "loop {}");
        let said = self::said(browser);
        assert!(said.contains("without end"), "{place}: {said}");

        // What was there can be had again, after a visit too.
        browser.press(&[CONTROL, 'z']);
        let kept = browser.evaluate(TEXT);
        browser.evaluate("new Promise((done) => setTimeout(done, 500))");
        browser.open(&woven().join("normals.html"), "");
        browser.evaluate("document.querySelector('button.type').click()");
        self::said(browser);
        assert_eq!(browser.evaluate(TEXT), kept);
        assert_eq!(browser.complaints(), [""; 0]);
    });
}

#[test]
#[ignore = "drives browsers"]
fn whatever_is_pasted_is_answered_and_the_page_lives() {
    each_browser(|browser| {
        browser.set_width(360);
        browser.open(&woven().join("hittable_list.html"), "");
        browser.evaluate("localStorage.clear()");
        browser.evaluate("document.querySelector('button.type').click()");
        said(browser);
        for text in [
            "\"[\".repeat(1 << 20)",
            "\"(\".repeat(50000)",
            "\"fn f() { \" + \"-\".repeat(90000)",
            "\"fn a\" + \"\\ud800\" + \"() {}\"",
            "\"fn <img src=x onerror=alert(1)>() {}\"",
            "\"\\0\"",
            "\"use common::rtweekend::*; pub fn picture(width: u32) -> Picture { picture(width) }\"",
        ] {
            browser.evaluate(&PASTE.replace("TEXT", text));
            let said = said(browser);
            assert!(!said.is_empty(), "{}: {text}", browser.name);
        }
        let images = "document.querySelectorAll('.typing .verdict img, .typing .rest img').length";
        assert_eq!(browser.evaluate(images), 0);
        assert_eq!(list(&browser.evaluate(super::OVERFLOW)), [""; 0]);
    });
}

/// Types one text in the place of another, key by key.
fn type_over(browser: &mut Browser, old: &str, new: &str) {
    browser.evaluate(&SELECT.replace("OLD", &json!(old).to_string()));
    for letter in new.chars() {
        browser.press(&[letter]);
    }
}

/// What is said once all is judged: the headline, and the rest.
fn said(browser: &mut Browser) -> String {
    let said = browser.evaluate(SAID);
    said.as_str().expect("a text").to_owned()
}

const SAID: &str = "new Promise((done) => {
    const look = () => {
        const desk = document.querySelector('.typing');
        const [verdict, rest] = ['.verdict', '.rest'].map((it) => desk?.querySelector(it).textContent);
        verdict && desk.ariaBusy === 'false' ? done(`${verdict} ${rest}`) : setTimeout(look, 20);
    };
    setTimeout(look, 50);
})";

const DRAWN: &str =
    "(({ width, height }) => `${width} ${height}`)(document.querySelector('.typing canvas'))";

const UNDERLINED: &str = "document.querySelector('.typing .faults mark').textContent";

const TEXT: &str = "document.querySelector('.typing textarea').value";

const SELECT: &str = "(() => {
    const area = document.querySelector('.typing textarea');
    const start = area.value.indexOf(OLD);
    area.focus();
    area.setSelectionRange(start, start + OLD.length);
})()";

const PASTE: &str = "(() => {
    const area = document.querySelector('.typing textarea');
    area.value = TEXT;
    area.dispatchEvent(new Event('input'));
})()";
