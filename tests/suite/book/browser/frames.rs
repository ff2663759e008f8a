//! How smooth a drag is: the frames that a reader sees, and what the page's main thread
//! does meanwhile. It measures and decides nothing.

use std::f64::consts::TAU;

use ::live::picture::PICTURES;
use serde_json::Value;

use super::browser;
use super::dragged::{PAGES, places_of};
use super::painted::{DONE, ask, open};
use suite::command::woven;

#[test]
#[ignore = "measures: best alone, on an idle machine, with --nocapture"]
fn how_smooth_a_drag_is() {
    let Some(mut browser) = browser() else { return };
    println!("{HEAD}");
    for (page, name) in PAGES {
        let live = live::find(name).expect("a live figure");
        for n in 0..live.handles.len() {
            let mut tab = browser.tab(1200);
            tab.open(&woven().join(page), &format!("#{name}"));
            let way = circle(&tab.evaluate(&places_of(name))[n]);
            tab.evaluate(COUNT_FRAMES);
            let tasks = tab.tasks_during(|tab| tab.drag("mouse", &way));
            report(&format!("{name} {n}"), &tab.evaluate("frames"), &tasks);
        }
    }
    for live in PICTURES {
        let mut tab = browser.tab(1200);
        open(&mut tab, live.chapter.name(), "");
        tab.evaluate(DONE);
        tab.evaluate(COUNT_FRAMES);
        let tasks = tab.tasks_during(|tab| {
            ask(tab, "1920", "times-256");
            tab.evaluate(DONE);
        });
        let name = format!("{}, 1920 wide", live.chapter.name());
        report(&name, &tab.evaluate("frames"), &tasks);
    }
}

/// Once around where a handle is, in 120 steps.
fn circle(handle: &Value) -> Vec<(f64, f64)> {
    let [x, y] = [0, 1].map(|n| handle[n].as_f64().expect("a place"));
    let at = |step| TAU * f64::from(step) / 120.0;
    (0..=120)
        .map(|step| (x + 40.0 * at(step).sin(), y + 40.0 * at(step).cos()))
        .collect()
}

const HEAD: &str = "\
    figure, handle           frames/s   longest  tasks of the main thread, ms: 99 of 100 below, longest;  the same of processor time";

fn report(name: &str, frames: &Value, tasks: &[[f64; 2]]) {
    let frames: Vec<f64> = frames
        .as_array()
        .expect("a list")
        .iter()
        .filter_map(Value::as_f64)
        .collect();
    let mut gaps: Vec<f64> = frames.windows(2).map(|pair| pair[1] - pair[0]).collect();
    gaps.sort_by(f64::total_cmp);
    assert!(gaps.len() > 1, "{name} shows no frames");
    let mean = gaps.iter().sum::<f64>() / gaps.len() as f64;
    let [clock, processor] = [0, 1].map(|n| {
        let mut times: Vec<f64> = tasks.iter().map(|task| task[n]).collect();
        times.sort_by(f64::total_cmp);
        [times[99 * times.len() / 100], times[times.len() - 1]]
    });
    println!(
        "{name:<24} {:>8.1} {:>9.1}  {clock:>6.1?}  {processor:>6.1?}",
        1000.0 / mean,
        gaps[gaps.len() - 1],
    );
}

/// Notes when each frame begins.
const COUNT_FRAMES: &str = "(() => {
    globalThis.frames = [];
    const note = (now) => { frames.push(now); requestAnimationFrame(note); };
    requestAnimationFrame(note);
})()";
