//! Live figures in real browsers, from a file: mouse, pen, finger and keyboard move them,
//! links lead to a case, and what they show is what the crate `live` answers.

use figures::{ACCURACY, LESSON, Movable, find_live};
use glam::DVec2;
use serde_json::{Value, json};

use super::driver::{Browser, NEXT_FRAME};
use super::{each_browser, list};
use crate::book::woven;
use crate::live::questions;

/// The live figures, and the pages that show them.
const PAGES: [(&str, &str); 11] = [
    ("gradient.html", "ray"),
    ("gradient.html", "camera_frame"),
    ("gradient.html", "viewport_grid"),
    ("red_sphere.html", "discriminant"),
    ("normals.html", "normal"),
    ("normals.html", "normal_colors"),
    ("half_b_sphere.html", "projection"),
    ("hittable_list.html", "nearest"),
    ("hittable_list.html", "face_normal"),
    ("speed_vs_accuracy.html", "digits"),
    ("never_wrong.html", "edge"),
];

#[test]
#[ignore = "drives browsers"]
fn the_browsers_answer_a_thousand_questions_as_the_crate_does() {
    each_browser(|browser| {
        for (page, module, figures) in [
            ("gradient.html#ray", "lessonModule", LESSON),
            ("never_wrong.html#edge", "accuracyModule", ACCURACY),
        ] {
            let (page, behind) = page.split_at(page.find('#').expect("a figure"));
            browser.open(&woven().join(page), behind);
            browser.evaluate(ALIVE);
            for (place, live) in figures.iter().enumerate() {
                let questions = questions(*live, 1000);
                let script = ANSWERS
                    .replace("MODULE", module)
                    .replace("PLACE", &place.to_string())
                    .replace("QUESTIONS", &json!(questions).to_string());
                let sums = browser.evaluate(&script);
                for (numbers, sum) in questions.iter().zip(sums.as_array().expect("a list")) {
                    let expected = fowler_noll_vo(live.text(numbers).as_bytes());
                    assert_eq!(*sum, expected, "{} {numbers:?}", live.name());
                }
            }
        }
    });
}

#[test]
#[ignore = "drives browsers"]
fn a_mouse_a_pen_and_a_finger_drag_each_handle_where_the_crate_says() {
    each_browser(|browser| {
        // Firefox has no pen.
        let pointers = match browser.name {
            "Firefox" => ["touch", "mouse"],
            _ => ["mouse", "pen"],
        };
        let mut pointers = pointers.into_iter().cycle();
        for (page, name) in PAGES {
            let live = find_live(name).expect("a live figure");
            for n in 0..live.handles().len() {
                browser.open(&woven().join(page), &format!("#{name}"));
                let handles = browser.evaluate(&places_of(name));
                let way = way(&handles[n]);
                browser.drag(pointers.next().expect("they go on"), &way);
                assert_dragged(browser, live, n, on_sheet(&way, &handles));
                assert_eq!(browser.complaints(), [""; 0]);
            }
        }
    });
}

#[test]
#[ignore = "drives browsers"]
fn arrows_move_a_handle_and_shift_makes_ten_of_a_step() {
    let [home, up, right, shift] = ['\u{e011}', '\u{e013}', '\u{e014}', '\u{e008}'];
    each_browser(|browser| {
        let ray = find_live("ray").expect("a live figure");
        browser.open(&woven().join("gradient.html"), "#ray");
        browser.evaluate(&places_of("ray"));
        browser.evaluate("document.querySelector('#ray .handle input').focus()");
        browser.press(&[right]);
        browser.press(&[shift, up]);
        assert_shows(browser, ray, &[0.05, 0.5, 1.0, 0.5, 2.0]);
        browser.press(&[home]);
        assert_shows(browser, ray, &[0.05, ray.numbers()[1].least, 1.0, 0.5, 2.0]);
        // The row above has the smaller number.
        let grid = find_live("viewport_grid").expect("a live figure");
        browser.evaluate("document.querySelector('#viewport_grid .handle input').focus()");
        browser.press(&[up]);
        assert_shows(browser, grid, &[8.0, 5.0, 1.0, 0.0]);
    });
}

#[test]
#[ignore = "drives browsers"]
fn an_arrow_turns_the_page_only_where_nothing_has_the_keyboard() {
    let right = '\u{e014}';
    each_browser(|browser| {
        browser.set_width(360);
        browser.open(&woven().join("normals.html"), "#the-code");
        for has_it in [
            ".listing pre > code[tabindex]",
            "#normal [data-action]",
            "details summary",
        ] {
            browser.evaluate(&format!(
                "{ALIVE}.then(() => document.querySelector('{has_it}').focus())"
            ));
            browser.press(&[right]);
            let stays = browser.evaluate("location.pathname.endsWith('normals.html')");
            assert_eq!(stays, true, "{has_it} in {}", browser.name);
        }
        // mdBook takes the key, and leaves; so this is the last question to the page.
        let is_taken = "(document.activeElement.blur(), !document.body.dispatchEvent(
            new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true, cancelable: true })))";
        assert_eq!(browser.evaluate(is_taken), true, "{}", browser.name);
    });
}

#[test]
#[ignore = "drives browsers"]
fn a_button_a_link_and_the_text_agree_with_the_figure() {
    each_browser(|browser| {
        let live = find_live("ray").expect("a live figure");
        browser.open(&woven().join("gradient.html"), "#ray");
        browser.evaluate(&places_of("ray"));
        browser.evaluate("document.querySelector('#ray [data-action=\"0\"]').click()");
        let mut numbers = live.defaults();
        live.act(0, &mut numbers);
        assert_shows(browser, live, &numbers);
        let says = live.answer(&numbers).says.into_iter();
        let says: Vec<String> = says.map(|(_, it)| it).collect();
        let told =
            r#"[...document.querySelectorAll('[data-told^="ray "]')].map((it) => it.textContent)"#;
        assert_eq!(browser.evaluate(told), json!(says));
        let link = browser.evaluate(&link_of("ray"));
        let link = link.as_str().expect("a link");
        browser.open(&woven().join("gradient.html"), link);
        browser.evaluate(&places_of("ray"));
        assert_shows(browser, live, &numbers);
        browser.evaluate("document.querySelector('#ray [data-action=reset]').click()");
        assert_shows(browser, live, &live.defaults());
    });
}

#[test]
#[ignore = "drives browsers"]
fn what_moves_figures_is_loaded_only_where_one_is_near() {
    each_browser(|browser| {
        let is_loaded = "[...document.scripts].some((it) => it.src.endsWith('live/start.js'))";
        // Without a figure, and far above the first.
        for page in ["errata.html", "never_wrong.html"] {
            browser.open(&woven().join(page), "");
            assert_eq!(browser.evaluate(is_loaded), false, "{page}");
        }
        browser.open(&woven().join("hittable_list.html"), "");
        browser.evaluate(ALIVE);
        assert_eq!(browser.evaluate(is_loaded), true);
    });
}

/// Only in Chromium, which can be told that a screen is paper.
#[test]
#[ignore = "drives a browser"]
fn on_paper_a_live_figure_is_a_drawing_with_a_caption() {
    each_browser(|browser| {
        if browser.name != "Chromium" {
            return;
        }
        browser.open(&woven().join("gradient.html"), "#ray");
        browser.set_media("print", "light");
        let shown = "[...document.querySelectorAll('#ray :is(.question, .handle, .sentence, button, svg, figcaption)')]
            .filter((it) => it.checkVisibility()).map((it) => it.localName)";
        let shown = list(&browser.evaluate(shown));
        browser.set_media("", "");
        assert_eq!(shown, ["\"svg\"", "\"figcaption\""]);
    });
}

/// The figure shows what it does when its handle `n` is moved by so much. A browser may move
/// a page by a fraction of a pixel meanwhile: either of two steps is right beside a border.
fn assert_dragged(browser: &mut Browser, live: &dyn Movable, n: usize, by: DVec2) {
    let from = live.answer(&live.defaults()).handles[n];
    let near = [DVec2::ZERO, DVec2::X, -DVec2::X, DVec2::Y, -DVec2::Y].map(|way| {
        let mut numbers = live.defaults();
        live.drag(n, &mut numbers, from + by + 0.2 * way);
        numbers
    });
    let link = browser.evaluate(&link_of(live.name()));
    let shown = near.iter().find(|numbers| link == address(live, numbers));
    assert_shows(browser, live, shown.unwrap_or(&near[0]));
}

/// The figure, the sliders and the sentence are what the crate answers.
fn assert_shows(browser: &mut Browser, live: &dyn Movable, numbers: &[f64]) {
    browser.evaluate(NEXT_FRAME);
    let name = live.name();
    assert_eq!(browser.evaluate(&link_of(name)), address(live, numbers));
    // Some numbers have two sliders.
    let sliders = browser.evaluate(&format!(
        "[...document.querySelectorAll('#{name} [data-number]')].map(
            (input) => [input.dataset.number, input.value].map(Number))"
    ));
    for slider in sliders.as_array().expect("sliders") {
        let place = slider[0].as_u64().expect("a place") as usize;
        assert_eq!(slider[1].as_f64(), Some(numbers[place]), "number {place}");
    }
    let text = live.text(numbers);
    let mut lines = text.lines();
    let drawn = roxmltree::Document::parse(lines.next().expect("a drawing")).expect("an SVG");
    let said = browser.evaluate(&format!(
        "document.querySelector('#{name} .sentence').innerHTML.replaceAll('&nbsp;', ' ')"
    ));
    assert_eq!(said.as_str(), lines.next());
    let labels = browser.evaluate(&format!(
        "document.querySelector('#{name} svg').textContent"
    ));
    let texts = drawn.descendants().filter(|it| it.is_text());
    let words: String = texts.filter_map(|it| it.text()).collect();
    assert_eq!(labels, words);
}

/// From the middle of a handle some whole pixels up, far enough for a row of the grid, and
/// fewer to the left, where the page may end.
fn way(handle: &Value) -> Vec<(f64, f64)> {
    let [x, y] = [0, 1].map(|n| handle[n].as_f64().expect("a place").floor());
    [0.0, 4.0, 8.0]
        .map(|step| (x - step, y - 4.0 * step))
        .into()
}

/// How far a way leads, in units of the sheet.
fn on_sheet(way: &[(f64, f64)], handles: &Value) -> DVec2 {
    let scale = handles[handles.as_array().expect("a list").len() - 1]
        .as_f64()
        .expect("a scale");
    let ((x, y), (to_x, to_y)) = (way[0], way[way.len() - 1]);
    scale * DVec2::new(to_x - x, to_y - y)
}

/// A script: the link to the case that a figure shows.
fn link_of(name: &str) -> String {
    format!("document.querySelector('#{name} .this-case').getAttribute('href')")
}

/// The link to the case of these numbers.
fn address(live: &dyn Movable, numbers: &[f64]) -> String {
    let name = live.name();
    let numbers: Vec<String> = numbers.iter().map(f64::to_string).collect();
    format!("?{name}={}#{name}", numbers.join(","))
}

/// Waits until the figures can be moved.
pub(super) const ALIVE: &str = "new Promise((done) => {
    const look = () => document.querySelector('.alive') ? done(null) : setTimeout(look, 10);
    look();
})";

/// Where the handles of a figure are on the screen once it can be moved; and at last how
/// many units of the sheet are in a pixel.
fn places_of(name: &str) -> String {
    format!(
        "{ALIVE}.then(() => {{
            document.getElementById('{name}').scrollIntoView({{ block: 'center', behavior: 'instant' }});
            const middle = (it) => {{
                const {{ left, right, top, bottom }} = it.getBoundingClientRect();
                return [(left + right) / 2, (top + bottom) / 2];
            }};
            const figure = document.getElementById('{name}');
            const svg = figure.querySelector('svg');
            const scale = svg.viewBox.baseVal.width / svg.getBoundingClientRect().width;
            return [...[...figure.querySelectorAll('.handle')].map(middle), scale];
        }})"
    )
}

/// The sums of the module's answers to questions.
const ANSWERS: &str = "instantiate(MODULE).then((rust) => QUESTIONS.map((numbers) => {
        numbers.forEach((value, n) => rust.set(n, value));
        const length = rust.answer(PLACE);
        const bytes = new Uint8Array(rust.memory.buffer, rust.place(), length);
        return bytes.reduce((sum, byte) => Math.imul(sum ^ byte, 16777619) >>> 0, 2166136261);
    }))";

/// The sum FNV-1a of 32 bits (Fowler, Noll and Vo, 1991), which a script computes as well.
pub(super) fn fowler_noll_vo(bytes: &[u8]) -> u32 {
    let step = |sum: u32, &byte: &u8| (sum ^ u32::from(byte)).wrapping_mul(16_777_619);
    bytes.iter().fold(2_166_136_261, step)
}
