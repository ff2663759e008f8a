//! Live figures in real browsers, from a file: mouse, finger and keyboard move them, links
//! lead to a case, and what they show is what the crate `live` answers.

use ::live::{FIGURES, Live};
use glam::DVec2;
use serde_json::{Value, json};

use super::{Window, browser, firefox, list};
use crate::live::questions;
use suite::command::woven;

/// The live figures, and the pages that show them.
pub(super) const PAGES: [(&str, &str); 8] = [
    ("gradient.html", "ray"),
    ("gradient.html", "viewport_grid"),
    ("red_sphere.html", "discriminant"),
    ("normals.html", "normal_colors"),
    ("hittable_list.html", "nearest"),
    ("hittable_list.html", "face_normal"),
    ("speed_vs_accuracy.html", "digits"),
    ("never_wrong.html", "edge"),
];

#[test]
fn the_browsers_answer_a_thousand_questions_as_the_crate_does() {
    if let Some(mut browser) = browser() {
        let mut tab = browser.tab(1200);
        tab.open(&woven().join("gradient.html"), "#ray");
        assert_same_answers(&mut tab);
    }
    if let Some(mut firefox) = firefox() {
        firefox.open(&woven().join("gradient.html"), "#ray");
        assert_same_answers(&mut *firefox);
    }
}

fn assert_same_answers(window: &mut dyn Window) {
    window.value_of(ALIVE);
    for (place, live) in FIGURES.iter().enumerate() {
        let questions = questions(live, 1000);
        let script = ANSWERS
            .replace("PLACE", &place.to_string())
            .replace("QUESTIONS", &json!(questions).to_string());
        let sums = window.value_of(&script);
        for (numbers, sum) in questions.iter().zip(sums.as_array().expect("a list")) {
            let text = live.text(numbers);
            assert_eq!(
                *sum,
                fowler_noll_vo(text.as_bytes()),
                "{} {numbers:?}",
                live.name
            );
        }
    }
}

#[test]
fn a_mouse_or_a_pen_drags_each_handle_where_the_crate_says() {
    let Some(mut browser) = browser() else { return };
    for (page, name) in PAGES {
        let live = live::find(name).expect("a live figure");
        let pointers = ["mouse", "pen"].into_iter().cycle();
        for (n, pointer) in (0..live.handles.len()).zip(pointers) {
            let mut tab = browser.tab(1200);
            tab.open(&woven().join(page), &format!("#{name}"));
            let handles = tab.evaluate(&places_of(name));
            let way = way(&handles[n]);
            tab.drag(pointer, &way);
            assert_dragged(&mut tab, live, n, on_sheet(&way, &handles));
            assert_eq!(tab.complaints(), [""; 0]);
        }
    }
}

#[test]
fn a_finger_drags_each_handle_where_the_crate_says() {
    let Some(mut firefox) = firefox() else { return };
    firefox.set_width(360);
    for (page, name) in PAGES {
        let live = live::find(name).expect("a live figure");
        for n in 0..live.handles.len() {
            firefox.open(&woven().join(page), &format!("#{name}"));
            let handles = firefox.evaluate(&places_of(name));
            let way = way(&handles[n]);
            firefox.drag(&way);
            assert_dragged(&mut *firefox, live, n, on_sheet(&way, &handles));
            assert_eq!(firefox.complaints(), [""; 0]);
        }
    }
}

#[test]
fn arrows_move_a_handle_and_shift_makes_ten_of_a_step() {
    let live = live::find("ray").expect("a live figure");
    let page = woven().join("gradient.html");
    let focus = "document.querySelectorAll('#ray .handle input')[0].focus()";
    let moved = [0.05, 0.5, 1.0, 0.5, 2.0];
    if let Some(mut browser) = browser() {
        let mut tab = browser.tab(1200);
        tab.open(&page, "#ray");
        tab.evaluate(&places_of("ray"));
        tab.evaluate(focus);
        for key in ["ArrowRight", "Shift+ArrowUp"] {
            tab.press(key);
        }
        assert_shows(&mut tab, live, &moved);
        assert_eq!(tab.evaluate("document.activeElement.ariaValueText"), "0.5");
        tab.press("Home");
        assert_shows(
            &mut tab,
            live,
            &[0.05, live.numbers[1].least, 1.0, 0.5, 2.0],
        );
    }
    if let Some(mut firefox) = firefox() {
        firefox.set_width(1200);
        firefox.open(&page, "#ray");
        firefox.evaluate(&places_of("ray"));
        firefox.evaluate(focus);
        let [shift, up, right] = ['\u{e008}', '\u{e013}', '\u{e014}'];
        firefox.press_together(&[right]);
        firefox.press_together(&[shift, up]);
        assert_shows(&mut *firefox, live, &moved);
    }
}

#[test]
fn the_arrow_up_leads_to_the_row_above_and_a_slider_widens_the_grid() {
    let Some(mut browser) = browser() else { return };
    let live = live::find("viewport_grid").expect("a live figure");
    let mut tab = browser.tab(1200);
    tab.open(&woven().join("gradient.html"), "#viewport_grid");
    tab.evaluate(&places_of("viewport_grid"));
    tab.evaluate("document.querySelector('#viewport_grid .handle input').focus()");
    tab.press("ArrowUp");
    assert_shows(&mut tab, live, &[8.0, 5.0, 1.0, 0.0]);
    tab.evaluate("document.querySelector('#viewport_grid .controls input').focus()");
    tab.press("Shift+ArrowRight");
    assert_shows(&mut tab, live, &[18.0, 5.0, 1.0, 0.0]);
    // The marked pixel stays in the picture.
    tab.press("Home");
    assert_shows(&mut tab, live, &[1.0, 0.0, 0.0, 0.0]);
}

#[test]
fn a_button_a_link_and_the_text_agree_with_the_figure() {
    let Some(mut browser) = browser() else { return };
    let live = live::find("ray").expect("a live figure");
    let mut tab = browser.tab(1200);
    tab.open(&woven().join("gradient.html"), "#ray");
    tab.evaluate(&places_of("ray"));
    tab.evaluate("document.querySelector('#ray [data-action=\"0\"]').click()");
    let mut numbers = live.defaults();
    (live.actions[0].act)(&mut numbers);
    assert_shows(&mut tab, live, &numbers);
    let says: Vec<String> = (live.answer)(&numbers)
        .says
        .into_iter()
        .map(|(_, it)| it)
        .collect();
    let told =
        r#"[...document.querySelectorAll('[data-told^="ray "]')].map((it) => it.textContent)"#;
    assert_eq!(tab.evaluate(told), json!(says));
    let link = tab.evaluate("document.querySelector('#ray .this-case').getAttribute('href')");
    tab.open(
        &woven().join("gradient.html"),
        link.as_str().expect("a link"),
    );
    tab.evaluate(&places_of("ray"));
    assert_shows(&mut tab, live, &numbers);
    tab.evaluate("document.querySelector('#ray [data-action=reset]').click()");
    assert_shows(&mut tab, live, &live.defaults());
}

#[test]
fn what_moves_figures_is_loaded_only_where_one_is_near() {
    let Some(mut browser) = browser() else { return };
    let mut tab = browser.tab(1200);
    let is_loaded = "[...document.scripts].some((it) => it.src.endsWith('live/module.js'))";
    // Without a figure, and far above the first.
    for page in ["errata.html", "never_wrong.html"] {
        tab.open(&woven().join(page), "");
        assert_eq!(tab.evaluate(is_loaded), false, "{page}");
    }
    tab.open(&woven().join("hittable_list.html"), "");
    tab.evaluate(ALIVE);
    assert_eq!(tab.evaluate(is_loaded), true);
}

#[test]
fn on_paper_a_live_figure_is_a_drawing_with_a_caption() {
    let Some(mut browser) = browser() else { return };
    let mut tab = browser.tab(670);
    tab.open(&woven().join("gradient.html"), "#ray");
    tab.set_media("print", "light");
    let shown = "[...document.querySelectorAll('#ray :is(.question, .handle, .sentence, button, svg, figcaption)')]
        .filter((it) => it.checkVisibility()).map((it) => it.localName)";
    assert_eq!(list(&tab.evaluate(shown)), ["\"svg\"", "\"figcaption\""]);
}

/// The figure shows what it does when its handle `n` is moved by so much. A browser may move
/// a page by a fraction of a pixel meanwhile: either of two steps is right beside a border.
fn assert_dragged(window: &mut dyn Window, live: &Live, n: usize, by: DVec2) {
    window.value_of(super::NEXT_FRAME);
    let from = (live.answer)(&live.defaults()).handles[n];
    let near = [DVec2::ZERO, DVec2::X, -DVec2::X, DVec2::Y, -DVec2::Y].map(|way| {
        let mut numbers = live.defaults();
        live.drag(&live.handles[n], &mut numbers, from + by + 0.2 * way);
        numbers
    });
    let link = window.value_of(&link_of(live.name));
    let shown = near.iter().find(|numbers| link == address(live, numbers));
    assert_shows(window, live, shown.unwrap_or(&near[0]));
}

/// The figure, the sliders and the sentence are what the crate answers.
fn assert_shows(window: &mut dyn Window, live: &Live, numbers: &[f64]) {
    window.value_of(super::NEXT_FRAME);
    let text = live.text(numbers);
    let mut lines = text.lines();
    let (svg, sentence) = (lines.next(), lines.next());
    let name = live.name;
    let link = window.value_of(&link_of(name));
    assert_eq!(link, address(live, numbers));
    // Some numbers have two sliders.
    let sliders = window.value_of(&format!(
        "[...document.querySelectorAll('#{name} [data-number]')].map(
            (input) => [input.dataset.number, input.value].map(Number))"
    ));
    for slider in sliders.as_array().expect("sliders") {
        let place = slider[0].as_u64().expect("a place") as usize;
        assert_eq!(slider[1].as_f64(), Some(numbers[place]), "number {place}");
    }
    let said = window.value_of(&format!(
        "document.querySelector('#{name} .sentence').innerHTML"
    ));
    assert_eq!(
        Some(said.as_str().expect("text").replace("&nbsp;", " ").as_str()),
        sentence
    );
    let labels = window.value_of(&format!(
        "document.querySelector('#{name} svg').textContent"
    ));
    let drawn = roxmltree::Document::parse(svg.expect("a drawing")).expect("an SVG");
    let words: String = drawn
        .descendants()
        .filter(|it| it.is_text())
        .filter_map(|it| it.text())
        .collect();
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
fn address(live: &Live, numbers: &[f64]) -> String {
    let name = live.name;
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
pub(super) fn places_of(name: &str) -> String {
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
const ANSWERS: &str = "instantiate().then((rust) => QUESTIONS.map((numbers) => {
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
