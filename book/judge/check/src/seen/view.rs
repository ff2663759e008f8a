//! A picture beside the right one, and what can be asked about their pixels.

use std::collections::HashSet;

use common::rtweekend::Picture;
use slips::Output;

use crate::pixels::{distance, spread};
use crate::reading::Reading;
use crate::task::Task;

/// How many pixels are looked at where all would be too many.
const LOOK: u32 = 5000;

/// A reader's picture beside the right one.
pub(super) struct View<'a> {
    pub(super) task: &'a Task,
    pub(super) reading: &'a Reading,
    pub(super) right: &'a Picture,
    /// Pixels to look at.
    pub(super) places: Vec<u32>,
    /// Those of them that are more than one level off.
    pub(super) wrong: Vec<u32>,
    /// Those of which the right program's ray hits something.
    hits: HashSet<u32>,
}

impl<'a> View<'a> {
    pub(super) fn new(task: &'a Task, reading: &'a Reading, right: &'a Picture) -> Self {
        let places: Vec<u32> = spread(LOOK, reading.pixels.len() as u32).collect();
        let mut view = Self {
            task,
            reading,
            right,
            places: Vec::new(),
            wrong: Vec::new(),
            hits: HashSet::new(),
        };
        let is_wrong = |n: &u32| distance(view.expected(*n), view.found(*n)) > 1;
        view.wrong = places.iter().copied().filter(is_wrong).collect();
        let output = view.output();
        view.hits = places.iter().copied().filter(|n| output.hits(*n)).collect();
        view.places = places;
        view
    }
}

impl View<'_> {
    pub(super) fn found(&self, n: u32) -> [i16; 3] {
        self.reading.pixels[n as usize]
    }

    pub(super) fn expected(&self, n: u32) -> [i16; 3] {
        let (right, _) = self.right.rgb().as_chunks::<3>();
        right[n as usize].map(i16::from)
    }

    /// The right program's output.
    pub(super) fn output(&self) -> Output {
        let fitting = self.task.fitting(self.reading.width, self.reading.height);
        fitting.program(&[]).run(self.reading.width)
    }

    pub(super) fn is_hit(&self, n: u32) -> bool {
        self.hits.contains(&n)
    }
}
