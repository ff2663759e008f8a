//! A picture beside the right one, with a sample of pixels.

use std::collections::HashSet;

use common::rtweekend::Picture;
use slips::Output;

use crate::pixels::{distance, spread};
use crate::reading::Reading;
use crate::task::Task;

/// The size of the sample, where all pixels would be too many.
const LOOK: u32 = 5000;

/// A reader's picture beside the right one.
pub(super) struct SideBySide<'a> {
    /// The task that the picture should fulfill.
    pub(super) task: &'a Task,
    /// The reader's picture.
    pub(super) reading: &'a Reading,
    /// The right picture, of the same size.
    pub(super) right: &'a Picture,
    /// The sample: indices of pixels, `j * width + i` from the top.
    pub(super) places: Vec<u32>,
    /// The pixels of the sample that are more than one level off.
    pub(super) wrong: Vec<u32>,
    /// The pixels of the sample in which the ray of the right program hits a sphere.
    hits: HashSet<u32>,
}

impl<'a> SideBySide<'a> {
    /// Takes the sample, and runs the right program to know what its rays hit.
    pub(super) fn new(task: &'a Task, reading: &'a Reading, right: &'a Picture) -> Self {
        let mut pictures = Self {
            task,
            reading,
            right,
            places: spread(LOOK, reading.pixels.len() as u32).collect(),
            wrong: Vec::new(),
            hits: HashSet::new(),
        };
        let (places, output) = (pictures.places.iter().copied(), pictures.output());
        let is_wrong = |n: &u32| distance(pictures.expected(*n), pictures.found(*n)) > 1;
        pictures.wrong = places.clone().filter(is_wrong).collect();
        pictures.hits = places.filter(|n| output.hits(*n)).collect();
        pictures
    }

    /// Returns the pixel of the reader's picture at an index.
    pub(super) fn found(&self, n: u32) -> [i16; 3] {
        self.reading.pixels[n as usize]
    }

    /// Returns the pixel of the right picture at an index.
    pub(super) fn expected(&self, n: u32) -> [i16; 3] {
        let (right, _) = self.right.rgb().as_chunks::<3>();
        right[n as usize].map(i16::from)
    }

    /// Runs the right program in the size of the picture.
    pub(super) fn output(&self) -> Output {
        let fitting = self.task.fitting(self.reading.width, self.reading.height);
        fitting.program(&[]).run(self.reading.width)
    }

    /// Returns true if the ray of the right program hits a sphere in this pixel of the sample.
    pub(super) fn is_hit(&self, n: u32) -> bool {
        self.hits.contains(&n)
    }
}
