//! Live pictures in real browsers, from a file: each chapter's page paints the chapter's
//! picture to the bit, at any width, and beside it what a slip draws.

use ::live::picture::{self, LivePicture, PICTURES, WIDEST};
use common::rtweekend::Picture;
use serde_json::{Value, json};
use slips::{self, Slip};

use super::dragged::{ALIVE, fowler_noll_vo};
use super::{ALL_ALIVE, NEXT_FRAME, Window, browser, firefox};
use crate::live::{opaque, slips_in};
use suite::command::woven;

#[test]
fn each_chapters_page_paints_the_picture_of_the_chapter() {
    each_browser(|window| {
        for live in PICTURES {
            let width = live.chapter.book_width();
            open(window, live.chapter.name(), "");
            assert_painted(window, &[live.chapter.picture(width)]);
            // The least, and more than the most.
            for width in [1, 1921] {
                ask(window, &width.to_string(), "");
                assert_painted(window, &[live.chapter.picture(width.min(WIDEST))]);
            }
            let (_, slip) = slips_in(live.chapter).last().expect("a slip");
            ask(window, "37", slip.name);
            assert_broken(window, live, slip, 37);
            assert_eq!(window.complaints(), [""; 0]);
        }
    });
}

/// Not in Firefox, which asks there how to print, and waits.
#[test]
fn the_page_of_the_whole_book_paints_all_its_pictures() {
    let Some(mut browser) = browser() else { return };
    let mut tab = browser.tab(1200);
    tab.open(&woven().join("print.html"), "");
    tab.evaluate(ALL_ALIVE);
    let of = |live: &LivePicture| live.chapter.picture(live.chapter.book_width());
    let pictures: Vec<Picture> = PICTURES.iter().map(of).collect();
    assert_painted(&mut tab, &pictures);
    assert_eq!(tab.complaints(), [""; 0]);
}

#[test]
fn the_browsers_paint_what_any_slip_draws() {
    each_browser(|window| {
        open(window, "gradient", "");
        window.value_of(DONE);
        for (place, live) in PICTURES.iter().enumerate() {
            let slips: Vec<_> = slips_in(live.chapter).collect();
            let places: Vec<u32> = slips.iter().map(|(place, _)| *place).collect();
            let script = PAINT
                .replace("PLACE", &place.to_string())
                .replace("SLIPS", &json!(places).to_string());
            let sums = window.value_of(&script);
            for ((_, slip), sum) in slips.iter().zip(sums.as_array().expect("a list")) {
                let drawn = slip.program(live.chapter).run(41).picture();
                let expected = fowler_noll_vo(&opaque(&drawn));
                assert_eq!(*sum, expected, "{} in {:?}", slip.name, live.chapter);
            }
        }
    });
}

#[test]
fn a_link_leads_to_a_broken_picture_and_reset_mends_it() {
    each_browser(|window| {
        let live = PICTURES[3];
        open(window, "normals", "?picture=97,far-root#picture");
        let slip = slips::find("far-root").expect("a slip");
        assert_broken(window, &live, slip, 97);
        let link = "document.querySelector('#picture .this-case').getAttribute('href')";
        assert_eq!(window.value_of(link), "?picture=97,far-root#picture");
        window.value_of("document.querySelector('#picture [data-action=reset]').click()");
        assert_painted(window, &[live.chapter.picture(400)]);
        // What is no width and no slip is none.
        open(window, "normals", "?picture=nonsense,nothing#picture");
        assert_painted(window, &[live.chapter.picture(400)]);
    });
}

#[test]
fn whoever_asks_again_before_all_is_painted_sees_only_the_last() {
    each_browser(|window| {
        let live = PICTURES[3];
        open(window, "normals", "");
        let slip = slips::find("far-root").expect("a slip");
        for (width, slip) in [("1920", "normal-inward"), ("1900", ""), ("64", slip.name)] {
            ask(window, width, slip);
            window.value_of(NEXT_FRAME);
        }
        assert_broken(window, &live, slip, 64);
    });
}

fn each_browser(look: impl Fn(&mut dyn Window)) {
    if let Some(mut browser) = browser() {
        look(&mut browser.tab(1200));
    }
    if let Some(mut firefox) = firefox() {
        firefox.set_width(1200);
        look(&mut *firefox);
    }
}

pub(super) fn open(window: &mut dyn Window, chapter: &str, behind: &str) {
    let page = match chapter {
        "build_test" => "setup",
        other => other,
    };
    window.open_file(&woven().join(format!("{page}.html")), behind);
}

/// Asks for a width and a slip, as a reader does who changes the one and the other.
pub(super) fn ask(window: &mut dyn Window, width: &str, slip: &str) {
    let [width, slip] = [width, slip].map(|it| json!(it));
    window.value_of(&format!(
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
fn assert_broken(window: &mut dyn Window, live: &LivePicture, slip: &Slip, width: u32) {
    let right = live.chapter.picture(width);
    let wrong = slip.program(live.chapter).run(width).picture();
    let pixels = right.rgb().chunks(3).zip(wrong.rgb().chunks(3));
    let different = pixels.filter(|(right, wrong)| right != wrong).count() as u32;
    assert_painted(window, &[right, wrong]);
    let said = window.value_of("document.querySelector('#picture .sentence').innerHTML");
    assert_eq!(said, picture::verdict(live, Some(slip), width, different));
}

fn assert_painted(window: &mut dyn Window, pictures: &[Picture]) {
    let sums = window.value_of(&format!("{DONE}.then(() => {SUMS})"));
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
pub(super) const DONE: &str = "new Promise((done) => {
    const look = () => document.querySelector('#picture.alive .sentence')?.ariaBusy === 'false'
        ? done() : setTimeout(look, 5);
    look();
})";

/// Width, height and sum of each picture that is shown.
const SUMS: &str =
    "[...document.querySelectorAll('[data-picture] canvas:not([hidden])')].map((canvas) => {
    const { width, height } = canvas;
    const { data } = canvas.getContext('2d').getImageData(0, 0, width, height);
    const sum = data.reduce((sum, byte) => Math.imul(sum ^ byte, 16777619) >>> 0, 2166136261);
    return [width, height, sum];
})";

/// The sums of the pictures that slips draw.
const PAINT: &str = "instantiate().then((rust) => SLIPS.map((slip) => {
    rust.paint(PLACE, slip, 41);
    let sum = 2166136261;
    for (let length = rust.piece(); length > 0; length = rust.piece()) {
        sum = bytes(rust, length).reduce((sum, byte) => Math.imul(sum ^ byte, 16777619) >>> 0, sum);
    }
    return sum;
}))";
