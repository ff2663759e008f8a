//! The list of chapter 5, typed by somebody else.
use crate::hittable::{HitRecord, Hittable};
use common::rtweekend::*;

/// A list.
#[derive(Default)]
pub struct HittableList { things: Vec<Box<dyn Hittable + Send + Sync>> }

impl HittableList
{
    /// Adds a thing.
    pub fn add(&mut self, thing: impl Hittable + Send + Sync + 'static) { self.things.push(Box::new(thing)); }
}

impl Hittable for HittableList
{
    fn hit(&self, r: &Ray, low: f64, high: f64) -> Option<HitRecord>
    {
        self.things.iter().fold(None, |best: Option<HitRecord>, thing| {
            let end = best.map_or(high, |b| b.t);
            thing.hit(r, low, end).or(best)
        })
    }
}
