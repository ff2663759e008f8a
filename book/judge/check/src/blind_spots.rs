//! Blind spots: the known mistakes that a right picture hides, and the next picture that shows most
//! of them.
//!
//! At the book's width a table lists them. At another width each slip is drawn: it is hidden if its
//! program draws the right picture.

use slips::{Output, PROBES, Slip, Unseen};

use crate::pixels::spread;
use crate::task::Task;

/// The picture to draw next, after a right one.
#[derive(Debug)]
pub struct NextPicture {
    /// The task to draw: the chapter with a probe (a changed scene), or the chapter itself if that
    /// was drawn smaller than in the book.
    pub task: Task,
    /// The width to draw, in pixels.
    pub width: u32,
    /// The known mistakes that this picture shows and all pictures before it hide, at least one.
    pub slips: Vec<&'static Slip>,
}

/// Finds the known mistakes with which the chapter of the task, without its probe, still draws the
/// right picture `width` pixels wide; only a sample of its pixels is compared if `width` is not the
/// book's. Empty if there is none.
///
/// Slips that change no picture and break no law are left out: a program with one of them is
/// right.
pub fn hidden_slips(task: &Task, width: u32) -> Vec<&'static Slip> {
    let own = Task::of(task.chapter);
    let can_be_wrong =
        |slip: &&Slip| !matches!(slip.why_unseen_in(own.chapter), Some(Unseen::Equivalent(_)));
    let sample = (width != own.chapter.book_width()).then(|| Sample::new(own, width));
    let is_hidden = |slip: &&'static Slip| match &sample {
        Some(sample) => sample.hides(slip),
        None => slip.revealing_probes(own.chapter).is_some(),
    };
    let slips = own.slips().filter(can_be_wrong).filter(is_hidden);
    slips.collect()
}

/// Chooses the picture to draw after the right one of the task, `width` pixels wide: one that shows
/// mistakes for which `may_be` holds and that are still hidden. The pictures follow each other in
/// one order, so that no probe is asked for twice; `None` after the last.
pub fn next_picture(
    task: &Task,
    width: u32,
    may_be: impl Fn(&Slip) -> bool,
) -> Option<NextPicture> {
    let (own, book) = (Task::of(task.chapter), task.chapter.book_width());
    let drawn = if task.probe.is_some() { book } else { width };
    let mut left = hidden_slips(&own, drawn);
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

/// Chooses the first change, in the order of effort, that shows a hidden mistake in the chapter's
/// own lines, which were typed last; or else the picture that shows most hidden mistakes, and of
/// equals the first. `None` if no picture shows any.
fn most_telling(own: &Task, drawn: u32, hidden: &[&'static Slip]) -> Option<NextPicture> {
    let book = own.chapter.book_width();
    let larger = (drawn < book).then_some((*own, book));
    let probes = PROBES.map(|probe| Some((Task::new(own.chapter, Some(probe))?, probe.width)));
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
    most.max_by_key(|next| match shows_own(next) {
        true => usize::MAX,
        false => next.slips.len(),
    })
}

/// A sample of pixels of the right picture of a task, to compare programs with.
struct Sample {
    task: Task,
    width: u32,
    right: Vec<(u32, [u8; 3])>,
}

/// How many pixels are compared first: most slips differ in one of them.
const GLANCE: u32 = 500;
/// How many pixels are compared in the end, spread over the picture. More would keep the reader
/// waiting.
const LOOK: u32 = 2000;

impl Sample {
    /// Draws the sample of the right picture, `width` pixels wide.
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

    /// Returns true if a program with the slip draws the same pixels.
    fn hides(&self, slip: &'static Slip) -> bool {
        let [right, wrong] =
            [&[][..], &[slip]].map(|slips| self.task.program(slips).run(self.width));
        let is_right = |&(n, right): &(u32, [u8; 3])| levels(&wrong, n) == right;
        wrong.size() == right.size() && self.right.iter().all(is_right)
    }
}

/// Returns the `n`th printed pixel as Rust draws it: a conversion to a byte stops at 0 and 255.
fn levels(output: &Output, n: u32) -> [u8; 3] {
    output.pixel(n).map(|level| level.clamp(0, 255) as u8)
}
