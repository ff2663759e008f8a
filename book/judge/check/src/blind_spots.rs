//! Blind spots: the known mistakes that draw a right picture, and what shows them.
//!
//! At the book's width a table tells them; at another one they are drawn: a slip is hidden if
//! its program draws the right picture.

use slips::{Output, PROBES, Slip, Unseen};

use crate::pixels::spread;
use crate::task::Task;

/// A picture to draw after a right one.
#[derive(Debug)]
pub struct NextPicture {
    /// Its scene: a probe, or the chapter's own if that was drawn too small.
    pub task: Task,
    /// How wide to draw it, in pixels.
    pub width: u32,
    /// The mistakes that show there, and that the pictures before hide.
    pub slips: Vec<&'static Slip>,
}

/// The mistakes that a right picture of the chapter's own scene, so many pixels wide, can't
/// show.
///
/// Slips that change no picture and break no law are left out: a program with one of them is
/// right.
pub fn hidden(task: &Task, width: u32) -> Vec<&'static Slip> {
    let own = task.without_probe();
    let can_be_wrong =
        |slip: &&Slip| !matches!(slip.why_unseen_in(own.chapter), Some(Unseen::Equivalent(_)));
    let exam = (width != own.chapter.book_width()).then(|| Exam::new(own, width));
    let is_hidden = |slip: &&'static Slip| match &exam {
        Some(exam) => exam.hides(slip),
        None => slip.revealing_probes(own.chapter).is_some(),
    };
    let slips = own.slips().filter(can_be_wrong).filter(is_hidden);
    slips.collect()
}

/// The picture to draw after the right one of `task`, so many pixels wide, of those that show
/// mistakes which may have been made. They follow each other in one order, so that no probe is
/// asked for twice.
pub fn next(task: &Task, width: u32, may_be: impl Fn(&Slip) -> bool) -> Option<NextPicture> {
    let (own, book) = (task.without_probe(), task.chapter.book_width());
    let drawn = if task.probe.is_some() { book } else { width };
    let mut left = hidden(&own, drawn);
    left.retain(|slip| may_be(slip));
    let mut order = Vec::new();
    while let Some(next) = most_telling(&own, drawn, &left) {
        left.retain(|slip| next.slips.iter().all(|shown| shown.name != slip.name));
        order.push(next);
    }
    let passed = order.iter().position(|next| next.task.probe == task.probe);
    let passed = passed.filter(|_| task.probe.is_some());
    order.into_iter().nth(passed.map_or(0, |at| at + 1))
}

/// Chooses the cheapest change that shows a mistake in the chapter's own lines, which were typed
/// last; or else the picture that shows most of these mistakes, of equals the cheapest.
fn most_telling(own: &Task, drawn: u32, hidden: &[&'static Slip]) -> Option<NextPicture> {
    let book = own.chapter.book_width();
    let larger = (drawn < book).then_some((*own, book));
    let probes = PROBES.map(|probe| Some((own.with_probe(probe)?, probe.width)));
    let all = larger.into_iter().chain(probes.into_iter().flatten());
    let nexts = all.filter_map(|(task, width)| {
        let shows = |slip: &&'static Slip| match (task.probe, slip.revealing_probes(own.chapter)) {
            (Some(probe), Some(probes)) => probes.contains(&probe.name),
            (probe, probes) => probe.is_none() && probes.is_none(),
        };
        let slips: Vec<&'static Slip> = hidden.iter().copied().filter(shows).collect();
        (!slips.is_empty()).then_some(NextPicture { task, width, slips })
    });
    let is_own = |slip: &&Slip| slip.chapters().next() == Some(own.chapter);
    let shows_own = |next: &NextPicture| next.slips.iter().any(is_own);
    // Of equals `max_by_key` takes the last one.
    let nexts: Vec<NextPicture> = nexts.collect();
    let most = nexts.into_iter().rev();
    most.max_by_key(|next| {
        (
            shows_own(next),
            if shows_own(next) { 0 } else { next.slips.len() },
        )
    })
}

/// A picture that a program has to draw, and those of its pixels that are looked at.
struct Exam {
    task: Task,
    width: u32,
    right: Vec<(u32, [u8; 3])>,
}

/// How many pixels are looked at first: most slips differ in one of them.
const GLANCE: u32 = 500;
/// How many are looked at in the end, spread over the picture. More would keep the reader
/// waiting.
const LOOK: u32 = 2000;

impl Exam {
    fn new(task: Task, width: u32) -> Self {
        let output = task.program(&[]).run(width);
        let (columns, rows) = output.size();
        let places = spread(GLANCE, columns * rows).chain(spread(LOOK, columns * rows));
        Self {
            task,
            width,
            right: places.map(|n| (n, levels(&output, n))).collect(),
        }
    }

    /// Returns true if a program with the slip draws this very picture.
    fn hides(&self, slip: &'static Slip) -> bool {
        let [right, wrong] =
            [&[][..], &[slip]].map(|slips| self.task.program(slips).run(self.width));
        let is_right = |&(n, right): &(u32, [u8; 3])| levels(&wrong, n) == right;
        wrong.size() == right.size() && self.right.iter().all(is_right)
    }
}

/// The `n`th pixel as Rust draws it, where a conversion to a byte stops at 0 and 255.
fn levels(output: &Output, n: u32) -> [u8; 3] {
    output.pixel(n).map(|level| level.clamp(0, 255) as u8)
}
