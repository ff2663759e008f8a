//! Observations about a picture that no known program draws.
//!
//! Each sentence is true of the pixels; about the code it only asks.

mod pixel;
mod shape;
mod side_by_side;
mod tinted;

use common::rtweekend::Picture;
use slips::SphereCount;

use crate::answer::Row;
use crate::pixels::distance;
use crate::reading::Reading;
use crate::sentences::ONLY_SKY;
use crate::task::Task;

use side_by_side::SideBySide;

/// A picture is nearly of one color if at most one in so many pixels has another.
const ODD: usize = 32;
/// The largest block of equal pixels that is looked for.
const BLOCK: u32 = 8;
/// Two neighboring pixels make an edge if they are more than so many levels apart.
const EDGE: u16 = 16;

/// Observes a picture beside the right one of the task: returns sentences, the most telling first,
/// and rows about the first pixel that differs. No sentences if no pixel of a sample is more than a
/// level off, no rows if no pixel differs.
pub fn observe(task: &Task, reading: &Reading, right: &Picture) -> (Vec<String>, Vec<Row>) {
    let pictures = SideBySide::new(task, reading, right);
    if pictures.wrong.is_empty() {
        return (Vec::new(), pictures.first_pixel());
    }
    if let Some(whole) = pictures.plain().or_else(|| pictures.turned()) {
        return (vec![whole], pictures.first_pixel());
    }
    let edges = pictures.only_at_edges();
    let sights = [
        pictures.unscaled(),
        pictures.only_sky(),
        pictures.rows_alike(),
        pictures.gray(),
        pictures.blocks(),
        pictures.one_component(),
        pictures.disc(),
        edges.or_else(|| pictures.where_it_differs()),
    ];
    let sights = sights.into_iter().flatten().chain(pictures.tints());
    (sights.collect(), pictures.first_pixel())
}

impl SideBySide<'_> {
    /// Notes that all pixels have one color, or nearly all.
    fn plain(&self) -> Option<String> {
        let first = self.found(0);
        let same = self.places.iter().filter(|n| self.found(**n) == first);
        let is_plain = ODD * (self.places.len() - same.count()) <= self.places.len();
        let all = match self.reading.has_one_color() {
            true => "Every pixel",
            false => "Nearly every pixel",
        };
        // Numbers that were cut off may have been any.
        let is_cut = first.contains(&i16::MAX);
        (is_plain && !is_cut).then(|| match first {
            [0, 0, 0] => {
                format!(
                    "{all} is black: is no color ever set, or is the color no number, such as 0 / 0 or the root of a negative one?"
                )
            }
            color => format!("{all} has the same color, {color:?}."),
        })
    }

    /// Notes that the picture shows the sky alone, where there should be a sphere.
    fn only_sky(&self) -> Option<String> {
        if self.task.chapter.sphere_count() == SphereCount::None || self.task.probe.is_some() {
            return None;
        }
        let (width, height) = (self.reading.width, self.reading.height);
        let sky = self.task.sky_picture(width, height);
        let (sky, _) = sky.rgb().as_chunks::<3>();
        let is_sky = |n: &u32| distance(sky[*n as usize].map(i16::from), self.found(*n)) <= 1;
        let is_all = self.places.iter().all(is_sky);
        is_all.then(|| ONLY_SKY.to_owned())
    }

    /// Notes that each row is the first one again, where the right rows differ.
    fn rows_alike(&self) -> Option<String> {
        let width = self.reading.width;
        let is_alike = |pixel: &dyn Fn(u32) -> [i16; 3]| {
            (width..self.reading.pixels.len() as u32).all(|n| pixel(n) == pixel(n % width))
        };
        let is_it = is_alike(&|n| self.found(n)) && !is_alike(&|n| self.expected(n));
        let said = "All rows are alike: does each pixel begin anew, from its own row j?";
        is_it.then(|| said.to_owned())
    }

    /// Notes that the picture is made of blocks of equal pixels.
    fn blocks(&self) -> Option<String> {
        let (width, height) = (self.reading.width, self.reading.height);
        let is_made_of = |size: u32| {
            let first = |n: u32| {
                let (i, j) = (n % width, n / width);
                j / size * size * width + i / size * size
            };
            let is_first = |n: u32| self.found(n) == self.found(first(n));
            width % size == 0 && height % size == 0 && self.places.iter().all(|n| is_first(*n))
        };
        let has_edges = self.places.iter().any(|n| self.found(*n) != self.found(0));
        let size = (2..=BLOCK).rev().find(|size| is_made_of(*size));
        let said = |size| {
            format!(
                "The picture is made of blocks of {size} × {size} equal pixels: is each pixel written {size} times?"
            )
        };
        size.filter(|_| has_edges).map(said)
    }

    /// Notes which components are right in every pixel, if not all are, and whether a wrong one
    /// equals one of these.
    fn one_component(&self) -> Option<String> {
        const COLORS: [&str; 3] = ["red", "green", "blue"];
        let is_everywhere = |is_it: &dyn Fn([i16; 3], [i16; 3]) -> bool| {
            let mut places = self.places.iter();
            places.all(|&n| is_it(self.expected(n), self.found(n)))
        };
        let is_right = |c: &usize| is_everywhere(&|right, found| right[*c] == found[*c]);
        let (right, wrong): (Vec<usize>, Vec<usize>) = (0..3).partition(is_right);
        let names = |all: &[usize]| {
            all.iter()
                .map(|c| COLORS[*c])
                .collect::<Vec<_>>()
                .join(" and ")
        };
        let equals = |&c: &usize| {
            let equal =
                |other: &usize| *other != c && is_everywhere(&|_, found| found[c] == found[*other]);
            let other = (0..3).find(equal)?;
            Some(format!(" {} equals {}.", COLORS[c], COLORS[other]))
        };
        let equal = wrong.first().filter(|_| wrong.len() == 1).and_then(equals);
        let verb = if wrong.len() == 1 { "is" } else { "are" };
        (!right.is_empty() && !wrong.is_empty()).then(|| {
            format!(
                "Only {} {verb} wrong: {} {} right in every pixel.{}",
                names(&wrong),
                names(&right),
                if right.len() == 1 { "is" } else { "are" },
                equal.unwrap_or_default()
            )
        })
    }

    /// Notes that all levels are 0 or 1, as of components that are not scaled.
    fn unscaled(&self) -> Option<String> {
        let most = self.reading.pixels.iter().flatten().max()?;
        let said = format!("No level is above {most}: is each component multiplied by 255.999?");
        (0..=1).contains(most).then_some(said)
    }

    /// Notes that only pixels at edges are wrong, that these are few, and that most of them have a
    /// color of their own, as with several rays through a pixel.
    fn only_at_edges(&self) -> Option<String> {
        if 4 * self.wrong.len() > self.places.len() {
            return None;
        }
        let (width, count) = (self.reading.width, self.reading.pixels.len() as u32);
        let from = |n: u32, other: u32| match other < count {
            true => distance(self.found(other), self.found(n)),
            false => 0,
        };
        // Above and below, left and right.
        let around = |n: u32| {
            let pairs = [
                [n.wrapping_sub(width), n + width],
                [n.wrapping_sub(1), n + 1],
            ];
            pairs.map(|pair| pair.map(|other| from(n, other)))
        };
        let is_at_edge = |&n: &u32| around(n).as_flattened().iter().any(|it| *it > EDGE);
        let is_between = |pair: [u16; 2]| pair.iter().all(|it| *it > 1);
        let is_mixed = |&&n: &&u32| around(n).into_iter().any(is_between);
        let mixed = self.wrong.iter().filter(is_mixed).count();
        (self.wrong.iter().all(is_at_edge) && 2 * mixed >= self.wrong.len()).then(|| {
            "Only pixels at edges are wrong: does your program send several rays through a pixel? \
             Send one."
                .to_owned()
        })
    }

    /// Notes that all wrong pixels are on the spheres, or none is.
    fn where_it_differs(&self) -> Option<String> {
        let (spheres, sky): (Vec<u32>, Vec<u32>) =
            self.wrong.iter().partition(|&&n| self.is_hit(n));
        let said = match (spheres.len(), sky.len()) {
            _ if self.task.chapter.sphere_count() == SphereCount::None => return None,
            (_, 0) => "Only where spheres should be are pixels wrong by more than a level.",
            (0, _) => {
                "Where spheres should be, all pixels are right; beside the spheres some are wrong."
            }
            _ => return None,
        };
        Some(said.to_owned())
    }
}
