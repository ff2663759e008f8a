//! Live pictures in real browsers, from a file: each chapter's page paints the chapter's
//! picture to the bit, at any width, and beside it what a slip draws.

use ::live::picture::{self, LivePicture, PICTURES, WIDEST};
use common::rtweekend::Picture;
use serde_json::{Value, json};
use slips::Slip;

use super::dragged::{ALIVE, fowler_noll_vo};
use super::driver::{Browser, NEXT_FRAME};
use super::{ALL_ALIVE, each_browser};
use crate::book::woven;
use crate::live::{opaque, slips_in};

#[test]
#[ignore = "drives browsers"]
fn each_chapters_page_paints_the_picture_of_the_chapter() {
    each_browser(|browser| {
        for live in PICTURES {
            let width = live.chapter.book_width();
            open(browser, live.chapter.name(), "");
            assert_painted(browser, &[live.chapter.picture(width)]);
            // The least, and more than the most.
            for width in [1, 1921] {
                ask(browser, &width.to_string(), "");
                assert_painted(browser, &[live.chapter.picture(width.min(WIDEST))]);
            }
            let (_, slip) = slips_in(live.chapter).last().expect("a slip");
            ask(browser, "37", slip.name);
            assert_broken(browser, live, slip, 37);
            assert_eq!(browser.complaints(), [""; 0]);
        }
    });
}

#[test]
#[ignore = "drives browsers"]
fn a_pixel_of_a_live_picture_shows_its_numbers_right_and_wrong() {
    each_browser(|browser| {
        let live = PICTURES[3];
        open(browser, "normals", "?picture=97,far-root#picture");
        browser.evaluate(DONE);
        let numbers = picture::inspect(&live, slips::find("far-root"), 97, [49, 27]);
        assert_eq!(browser.evaluate(TOUCHED), numbers);
    });
}

/// Not in Firefox, which asks there how to print, and waits.
#[test]
#[ignore = "drives browsers"]
fn the_page_of_the_whole_book_paints_all_its_pictures() {
    each_browser(|browser| {
        if browser.name != "Chromium" {
            return;
        }
        browser.open(&woven().join("print.html"), "");
        browser.evaluate(ALL_ALIVE);
        let of = |live: &LivePicture| live.chapter.picture(live.chapter.book_width());
        let pictures: Vec<Picture> = PICTURES.iter().map(of).collect();
        assert_painted(browser, &pictures);
        assert_eq!(browser.complaints(), [""; 0]);
    });
}

#[test]
#[ignore = "drives browsers"]
fn the_browsers_paint_what_any_slip_draws() {
    each_browser(|browser| {
        open(browser, "gradient", "");
        browser.evaluate(DONE);
        for (place, live) in PICTURES.iter().enumerate() {
            let slips: Vec<_> = slips_in(live.chapter).collect();
            let places: Vec<u32> = slips.iter().map(|(place, _)| *place).collect();
            let script = PAINT
                .replace("PLACE", &place.to_string())
                .replace("SLIPS", &json!(places).to_string());
            let sums = browser.evaluate(&script);
            for ((_, slip), sum) in slips.iter().zip(sums.as_array().expect("a list")) {
                let drawn = slip.program(live.chapter).run(41).picture();
                let expected = fowler_noll_vo(&opaque(&drawn));
                assert_eq!(*sum, expected, "{} in {:?}", slip.name, live.chapter);
            }
        }
    });
}

#[test]
#[ignore = "drives browsers"]
fn a_link_leads_to_a_broken_picture_and_reset_mends_it() {
    each_browser(|browser| {
        let live = PICTURES[3];
        open(browser, "normals", "?picture=97,far-root#picture");
        let slip = slips::find("far-root").expect("a slip");
        assert_broken(browser, &live, slip, 97);
        let link = "document.querySelector('#picture .this-case').getAttribute('href')";
        assert_eq!(browser.evaluate(link), "?picture=97,far-root#picture");
        browser.evaluate("document.querySelector('#picture [data-action=reset]').click()");
        assert_painted(browser, &[live.chapter.picture(400)]);
        // What is no width and no slip is none.
        open(browser, "normals", "?picture=nonsense,nothing#picture");
        assert_painted(browser, &[live.chapter.picture(400)]);
    });
}

#[test]
#[ignore = "drives browsers"]
fn whoever_asks_again_before_all_is_painted_sees_only_the_last() {
    each_browser(|browser| {
        let live = PICTURES[3];
        open(browser, "normals", "");
        let slip = slips::find("far-root").expect("a slip");
        for (width, slip) in [("1920", "normal-inward"), ("1900", ""), ("64", slip.name)] {
            ask(browser, width, slip);
            browser.evaluate(NEXT_FRAME);
        }
        assert_broken(browser, &live, slip, 64);
    });
}

fn open(browser: &mut Browser, chapter: &str, behind: &str) {
    let page = match chapter {
        "build_test" => "setup",
        other => other,
    };
    browser.open(&woven().join(format!("{page}.html")), behind);
}

/// Asks for a width and a slip, as a reader does who changes the one and the other.
fn ask(browser: &mut Browser, width: &str, slip: &str) {
    let [width, slip] = [width, slip].map(|it| json!(it));
    browser.evaluate(&format!(
        "{ALIVE}.then(() => {{
            const figure = document.getElementById('picture');
            figure.querySelector('input[type=number]').value = {width};
            const slip = figure.querySelector('select');
            slip.value = {slip};
            slip.dispatchEvent(new Event('input', {{ bubbles: true }}));
        }})"
    ));
}

/// The picture of the chapter, and beside it what the slip draws; and below how many pixels
/// differ.
fn assert_broken(browser: &mut Browser, live: &LivePicture, slip: &Slip, width: u32) {
    let right = live.chapter.picture(width);
    let wrong = slip.program(live.chapter).run(width).picture();
    let pixels = right.rgb().chunks(3).zip(wrong.rgb().chunks(3));
    let different = pixels.filter(|(right, wrong)| right != wrong).count() as u32;
    assert_painted(browser, &[right, wrong]);
    let said = browser.evaluate("document.querySelector('#picture .sentence').innerHTML");
    assert_eq!(said, picture::verdict(live, Some(slip), width, different));
}

fn assert_painted(browser: &mut Browser, pictures: &[Picture]) {
    let sums = browser.evaluate(&format!("{DONE}.then(() => {SUMS})"));
    let expected: Vec<Value> = pictures
        .iter()
        .map(|picture| {
            let sum = fowler_noll_vo(&opaque(picture));
            json!([picture.width(), picture.height(), sum])
        })
        .collect();
    assert_eq!(sums, json!(expected));
}

/// Waits until all is painted.
const DONE: &str = "new Promise((done) => {
    const look = () => document.querySelector('#picture.alive .sentence')?.ariaBusy === 'false'
        ? done() : setTimeout(look, 5);
    look();
})";

/// Presses an arrow on the right picture, which leads from the middle to the right.
const TOUCHED: &str = "(() => {
    const canvas = document.querySelector('#picture canvas');
    canvas.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true }));
    const rows = [...document.querySelectorAll('#picture .inspector tbody tr')];
    return rows.map((row) => [...row.cells].map((it) => it.textContent).join('\\t')).join('\\n');
})()";

/// Width, height and sum of each picture that is shown.
const SUMS: &str =
    "[...document.querySelectorAll('[data-picture] canvas:not([hidden])')].map((canvas) => {
    const { width, height } = canvas;
    const { data } = canvas.getContext('2d').getImageData(0, 0, width, height);
    const sum = data.reduce((sum, byte) => Math.imul(sum ^ byte, 16777619) >>> 0, 2166136261);
    return [width, height, sum];
})";

/// The sums of the pictures that slips draw.
const PAINT: &str = "instantiate(lessonModule).then((rust) => SLIPS.map((slip) => {
    rust.paint(PLACE, slip, 41);
    let sum = 2166136261;
    for (let length = rust.piece(); length > 0; length = rust.piece()) {
        sum = bytes(rust, length).reduce((sum, byte) => Math.imul(sum ^ byte, 16777619) >>> 0, sum);
    }
    return sum;
}))";
