//! The page *Check your picture* in real browsers, from a file: whatever is dropped there,
//! it says what the judge says natively, to the letter.

use check::png;
use judge::Asked;
use serde_json::{Value, json};
use slips::Chapter;
use suite::drawn::p3;

use super::driver::Browser;
use super::each_browser;
use crate::book::woven;
use crate::live::slips_in;

#[test]
#[ignore = "drives browsers"]
fn the_page_says_of_each_picture_what_the_judge_says() {
    let files: Vec<(String, Vec<u8>)> = right().chain(wrong()).chain(hostile()).collect();
    assert!(files.len() > 300, "only {} pictures", files.len());
    each_browser(|browser| {
        browser.open(&woven().join("check.html"), "");
        browser.evaluate(ALIVE);
        for (name, bytes) in &files {
            let expected = judge::answer(name, bytes, Asked::default()).text;
            let said = said_of(browser, name, bytes);
            let hint = "if what judges has changed, build it again: .ci/live";
            assert_eq!(
                said, expected,
                "{} says something else: {hint}",
                browser.name
            );
        }
        assert_eq!(browser.complaints(), [""; 0]);
    });
}

fn right() -> impl Iterator<Item = (String, Vec<u8>)> {
    let chapters = Chapter::OF_THE_BOOK.into_iter();
    chapters.map(|it| (it.name().to_owned(), p3(&it.picture(64))))
}

fn wrong() -> impl Iterator<Item = (String, Vec<u8>)> {
    Chapter::OF_THE_BOOK.into_iter().flat_map(|chapter| {
        slips_in(chapter).map(move |(_, slip)| {
            let file = slip.program(chapter).run(32).to_string();
            (format!("{} in {}", slip.name, chapter.name()), file.into())
        })
    })
}

/// What is no picture, or promises too much.
fn hostile() -> Vec<(String, Vec<u8>)> {
    let right = Chapter::Normals.picture(64);
    let text = p3(&right);
    let png = png::encode(&right);
    let endless = [&png[..16], &[0, 1, 0, 0, 0, 1, 0, 0], &png[24..]].concat();
    let two_bytes: Vec<u8> = text.iter().flat_map(|&letter| [letter, 0]).collect();
    let carriage_returns: Vec<u8> = text
        .split(|&it| it == b'\n')
        .collect::<Vec<_>>()
        .join(&b'\r');
    let files: [&[u8]; 16] = [
        b"",
        b"P3",
        b"P3\n2 2\n255\n1 2 3\n",
        b"P3\n99999999 99999999\n255\n1 2 3\n",
        b"P6\n4000000000 1\n255\n",
        b"P3\n1 1\n255\n1 2 <script>\n",
        b"\x89PNG\r\n\x1a\n",
        b"\xff\xfeP\x003\x00\n\x001\x00",
        b"\xff\xd8\xff\xe0 no JPEG",
        b"<img src=x onerror=alert(1)>",
        b"P3\n1 1\n255\nnan nan nan\n",
        &png[..png.len() / 2],
        &endless,
        &[b"\xff\xfe", &two_bytes[..]].concat(),
        &carriage_returns,
        &text.repeat(2),
    ];
    (0..)
        .zip(files)
        .map(|(n, bytes)| (format!("<b>hostile</b> {n}"), bytes.to_vec()))
        .collect()
}

#[test]
#[ignore = "drives browsers"]
fn a_pasted_picture_is_judged_and_a_pixel_of_it_shows_its_numbers() {
    let slip = slips::find("far-root").expect("a slip");
    let text = slip.program(Chapter::Normals).run(32).to_string();
    let answered = judge::answer("", text.as_bytes(), Asked::default());
    each_browser(|browser| {
        browser.open(&woven().join("check.html"), "");
        browser.evaluate(ALIVE);
        browser.evaluate(&PASTED.replace("TEXT", &json!(text).to_string()));
        for (key, [column, row]) in [("ArrowRight", [17, 9]), ("ArrowUp", [17, 8])] {
            let numbers = answered.inspect(column, row);
            let (numbers, _) = numbers.rsplit_once('\n').expect("the reader's levels");
            let shown = browser.evaluate(&TOUCHED.replace("KEY", key));
            assert_eq!(shown, numbers, "{}", browser.name);
        }
        let tries = browser.evaluate("document.querySelector('.tries').children.length");
        assert_eq!(tries, 1);
        assert_eq!(browser.complaints(), [""; 0]);
    });
}

fn said_of(browser: &mut Browser, name: &str, bytes: &[u8]) -> Value {
    let script = SAID
        .replace("TITLE", &json!(name).to_string())
        .replace("PICTURE", &json!(bytes).to_string());
    browser.evaluate(&script)
}

const ALIVE: &str = "new Promise((done) => {
    const look = () => document.querySelector('#check.alive') ? done() : setTimeout(look, 5);
    look();
})";

/// The three parts of an answer as Rust gave them.
const SAID: &str = "checkPage.judge.judge({
    name: TITLE, file: new Blob([Uint8Array.from(PICTURE)]), most: MOST_BYTES, asked: [0, 0, 0],
}).then(({ facts, verdict, rest }) => [facts, verdict, rest].join('\\n'))";

/// Puts a text into the field, and waits for the verdict. The pixel in the middle is chosen.
const PASTED: &str = "new Promise((done) => {
    const field = document.querySelector('#check textarea');
    field.value = TEXT;
    field.dispatchEvent(new Event('input', { bubbles: true }));
    const look = () => {
        if (!document.querySelector('#check .verdict strong')) {
            return setTimeout(look, 5);
        }
        checkPage.pixels.choose(16, 9);
        done();
    };
    look();
})";

/// Presses an arrow on the first picture, and waits for the rows of the table.
const TOUCHED: &str = "new Promise((done) => {
    const before = document.querySelector('#check caption')?.textContent;
    const canvas = document.querySelector('#check canvas');
    canvas.dispatchEvent(new KeyboardEvent('keydown', { key: 'KEY', bubbles: true }));
    const look = () => {
        const caption = document.querySelector('#check caption')?.textContent;
        if (!caption || caption === before || caption.startsWith('Column 16')) {
            return setTimeout(look, 5);
        }
        const rows = [...document.querySelectorAll('#check tbody tr')];
        done(rows.map((row) => [...row.cells].map((it) => it.textContent).join('\\t')).join('\\n'));
    };
    look();
})";
