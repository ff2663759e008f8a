//! Surfaces in words: measured, and true of the pixels whatever the program was.

use std::cmp::Reverse;
use std::collections::HashMap;
use std::ops::Range;

use glam::DVec4;
use slips::{Chapter, Edition};

use common::rtweekend::{Point3, Vec3};

use super::apart::apart;
use super::background::Background;
use super::cone::{Cone, Eye};
use super::fit::Fit;
use super::terms::{Terms, color, is_books, sums};
use super::{MANY, Surface, surfaces, uniform, wrapped};
use crate::bits::{Pixel, distance};
use crate::explanations::spread;
use crate::reading::Reading;
use crate::scene::Scene;

/// How many surfaces are described.
const SAID: usize = 5;
/// What is smooth is described where it is one pixel in so many.
const PART: usize = 8;
/// Of how many percent that lie in no surface it is told.
const REST: usize = 5;
/// How many pixels of a surface tell what colors it.
const LOOK: u32 = 600;
/// A surface is a chapter's if no more than one pixel in so many is off by more levels.
const ODD: usize = 30;
const LEVELS: u16 = 1;
/// Components are equal if they differ in no more than one pixel of so many.
const UNEQUAL: usize = 50;
/// Levels that differ by less are made of one color, or of nobody knows what.
const CONTRAST: u16 = 12;
/// What is off by more levels than these is made of a vector if it changes by so many times as many.
const NEARLY: f64 = 2.5;
const BESIDE: f64 = 50.0;
/// One pixel in so many has a common color.
const COMMON: usize = 12;
/// What is larger is ground, and only its edge is seen.
const LARGE: f64 = 10.0;
/// The square of which part of its size a place of a surface may be from where it is said to be.
const ASIDE: u64 = 64;
/// More than edges have, in percent.
const MUCH: usize = 30;
/// How near numbers are the same, in units of space or of a component.
pub(super) const NEAR: f64 = 0.015;
/// Chapters that may have what is seen before a background.
const THINGS: [Chapter; 4] = [
    Chapter::Gradient,
    Chapter::RedSphere,
    Chapter::Normals,
    Chapter::HittableList,
];
/// The sphere of the book, and its ground.
const SPHERE: (Point3, f64) = (Point3::new(0.0, 0.0, -1.0), 0.5);
const GROUND: (Point3, f64) = (Point3::new(0.0, -100.5, -1.0), 100.0);

/// What can be seen in a picture, surface by surface; nothing of one that has too few smooth ones.
pub(crate) fn said(reading: &Reading) -> Vec<String> {
    if reading.is_plain() {
        return uniform::everywhere(reading).into_iter().collect();
    }
    let mut all = surfaces(reading);
    let covered: usize = all.iter().map(|it| it.inner.len()).sum();
    if 2 * covered < reading.pixels.len()
        && let Some(wrapped) = wrapped(reading)
    {
        return vec![wrapped];
    }
    if PART * covered < reading.pixels.len() {
        return Vec::new();
    }
    if all.len() > MANY {
        return in_pieces(all.len(), reading);
    }
    let mut background = remove_what_lies_behind(&mut all, reading);
    if let Some(apart) = apart(&background, reading) {
        all = apart;
        background = remove_what_lies_behind(&mut all, reading);
    }
    let covered = background.inner.len() + all.iter().map(|it| it.inner.len()).sum::<usize>();
    let behind = Background::of(&background, reading);
    let others = all.iter().take(SAID - 1);
    let others = others.map(|it| Seen::new(it, reading, behind.eye).with_its_outline());
    let others: Vec<Seen> = others.collect();
    let background = Seen::new(&background, reading, behind.eye);
    let mut chapters = THINGS.into_iter().skip(1);
    let are_books = behind.is_a_chapters
        && chapters.any(|chapter| {
            let mut all = others.iter().chain([&background]);
            all.all(|it| it.chapter([chapter]).is_some())
        });
    let rest = 100 * (reading.pixels.len() - covered) / reading.pixels.len();
    let rest = match rest >= REST {
        _ if are_books && rest < MUCH => Some("So only edges are off, as where several rays are taken, or a picture was enlarged or smoothed.".to_owned()),
        true => Some(format!(
            "The rest, {rest} % of the picture, are edges, grain and pieces that are too small."
        )),
        false => None,
    };
    let before = all.iter().flat_map(|it| &it.inner);
    let before: Vec<&Pixel> = before.map(|&n| &reading.pixels[n as usize]).collect();
    let equal = equal_components(reading, &before);
    let others = others.iter().map(Seen::as_a_thing);
    let all = [behind.said].into_iter().chain(others).chain(rest);
    all.chain(equal).collect()
}

/// Of all surfaces, the one that reaches the top, or the largest.
fn remove_what_lies_behind(all: &mut Vec<Surface>, reading: &Reading) -> Surface {
    let behind = all.iter().position(|it| it.reaches_the_top(reading));
    all.remove(behind.unwrap_or(0))
}

/// That two components are one, and not only black or brightest. A sky of one's own may have equal
/// ones, so what lies before it has them too.
fn equal_components(reading: &Reading, before: &[&Pixel]) -> Option<String> {
    let names = ["Red", "Green", "Blue"];
    let pairs = [(0, 1), (1, 2), (0, 2)];
    let is_end = |level: i16| level <= 0 || level >= 255;
    // Black and white are equal anyway.
    let telling = reading.pixels.iter();
    let telling: Vec<&Pixel> = telling
        .filter(|it| !it.iter().all(|it| is_end(*it)))
        .collect();
    let is_much = UNEQUAL * telling.len() >= reading.pixels.len() && !before.is_empty();
    let mut equal = pairs.into_iter().filter(|&(one, other)| {
        let are_equal = |pixels: &[&Pixel]| {
            let others = pixels.iter().filter(|it| it[one] != it[other]).count();
            UNEQUAL * others <= pixels.len()
        };
        let says_something = telling.iter().any(|it| !is_end(it[one]));
        is_much && says_something && are_equal(&telling) && are_equal(before)
    });
    let (one, other) = equal.next()?;
    Some(match equal.next() {
        None => format!(
            "{} and {} are equal almost everywhere: is a component of a vector taken twice?",
            names[one],
            names[other].to_lowercase()
        ),
        Some(_) => "The picture is gray almost everywhere: is one component printed three times?"
            .to_owned(),
    })
}

/// What falls into many pieces, by its commonest colors.
fn in_pieces(count: usize, reading: &Reading) -> Vec<String> {
    let mut counts: HashMap<Pixel, usize> = HashMap::new();
    for pixel in &reading.pixels {
        *counts.entry(*pixel).or_default() += 1;
    }
    let mut common: Vec<(usize, Pixel)> =
        counts.into_iter().map(|(it, count)| (count, it)).collect();
    common.retain(|(count, _)| COMMON * count >= reading.pixels.len());
    common.sort_by_key(|it| Reverse(*it));
    let pieces = format!(
        "It falls into {count} pieces or more, and the pictures of these chapters into three at most."
    );
    let colors = common.into_iter().map(|(count, color)| {
        let share = 100 * count / reading.pixels.len();
        // What reaches the top has no normal.
        let meant = uniform::of_a_normal(color).filter(|_| color != reading.pixels[0]);
        let meant = meant.map_or(String::new(), |it| format!(", {it}"));
        format!("{share} % of its pixels are {color:?}{meant}.")
    });
    [pieces].into_iter().chain(colors).collect()
}

/// A surface, and some of its pixels.
pub(super) struct Seen<'a> {
    reading: &'a Reading,
    surface: &'a Surface,
    eye: Eye,
    places: Vec<u32>,
    cone: Option<Cone>,
}

impl<'a> Seen<'a> {
    pub(super) fn new(surface: &'a Surface, reading: &'a Reading, eye: Eye) -> Self {
        let places = spread(LOOK, surface.inner.len() as u32);
        Self {
            reading,
            surface,
            eye,
            places: places.map(|n| surface.inner[n as usize]).collect(),
            cone: None,
        }
    }

    fn with_its_outline(self) -> Self {
        Self {
            cone: Cone::of(self.surface, &self.eye),
            ..self
        }
    }

    fn as_a_thing(&self) -> String {
        let colors = match self.chapter(THINGS) {
            Some((chapter, editions)) => {
                let by = Edition::said(&editions);
                format!("is {}{by}", what(chapter))
            }
            None => self.colors(self.fitted(&Terms::OF_A_THING)),
        };
        format!("{} {colors}.", self.place())
    }

    /// Where it lies, and of what it is an image.
    fn place(&self) -> String {
        let Surface { columns, rows, .. } = self.surface;
        let place = format!(
            "columns {} to {} and rows {} to {}",
            columns.start,
            columns.end - 1,
            rows.start,
            rows.end - 1
        );
        let Some((center, radius)) = self.cone.as_ref().map(Cone::sphere) else {
            return format!("Something in the {place}");
        };
        let off = (center - SPHERE.0).abs().max_element();
        if off.max((radius - SPHERE.1).abs()) < NEAR {
            return format!("The book's sphere, in the {place},");
        }
        if radius > LARGE {
            return format!("A ground in the {place}");
        }
        let [x, y, radius] = [center.x, center.y, radius].map(number);
        format!("A sphere in the {place}, as if around ({x}, {y}, -1) with the radius {radius},")
    }

    /// The first of these chapters that has the surface's pixels, and by which editions.
    pub(super) fn chapter(
        &self,
        chapters: impl IntoIterator<Item = Chapter>,
    ) -> Option<(Chapter, Vec<Edition>)> {
        let (width, height) = (self.reading.width, self.reading.height);
        let is_same = |scene: &Scene| {
            let program = scene.program(&[]);
            let camera = program.camera(width);
            let is_odd = |n: &&u32| {
                let (i, j) = (*n % width, *n / width);
                let color = (program.color)(&program, &camera, i, j).to_array();
                let drawn = color.map(|it| (program.level)(it) as i16);
                distance(drawn, self.reading.pixels[**n as usize]) > LEVELS
            };
            ODD * self.places.iter().filter(is_odd).count() <= self.places.len()
        };
        let mut found = chapters.into_iter().filter_map(|chapter| {
            let same = Scene::new(chapter, None)?.by_editions(width, height);
            let same: Vec<Edition> = same.filter(is_same).map(|it| it.edition).collect();
            (!same.is_empty()).then_some((chapter, same))
        });
        found.next()
    }

    /// The fewest terms that make its levels, of as many the nearest.
    pub(super) fn fitted(&self, terms: &[Terms]) -> Option<(Terms, Fit)> {
        let contrast = |channel: usize| {
            let levels = self.places.iter();
            let levels = levels.map(|&n| self.reading.pixels[n as usize][channel]);
            Some(levels.clone().max()?.abs_diff(levels.min()?))
        };
        let contrast = (0..3).filter_map(contrast).max()?;
        let is_flat = contrast < CONTRAST;
        let terms = terms.iter().filter(|&&it| it == Terms::One || !is_flat);
        let fits = terms.filter_map(|&terms| {
            let fit = self.fit(terms)?;
            let is_near = fit.off <= NEARLY || BESIDE * fit.off <= f64::from(contrast);
            let is_made_so = fit.is_simple() && is_near;
            (!terms.is_a_vector() || is_made_so).then_some((terms, fit))
        });
        fits.min_by(|(one, fit), (other, than)| {
            let by_count = one.count().cmp(&other.count());
            by_count.then(fit.off.total_cmp(&than.off))
        })
    }

    pub(super) fn fit(&self, terms: Terms) -> Option<Fit> {
        let values = self.places.iter().map(|&n| {
            let found = self.reading.pixels[n as usize];
            Some((self.values(terms, n)?, found))
        });
        let points: Option<Vec<_>> = values.collect();
        Fit::of(&points?, terms.most_off())
    }

    pub(super) fn values(&self, terms: Terms, n: u32) -> Option<DVec4> {
        let direction = self.eye.direction(n);
        let unit = direction.normalize();
        let (width, height) = (self.reading.width, self.reading.height);
        let x = f64::from(n % width) / f64::from(width);
        let y = 1.0 - f64::from(n / width) / f64::from(height);
        let of = |it: Vec3| DVec4::new(1.0, it.x, it.y, it.z);
        Some(match terms {
            Terms::One => of(Vec3::ZERO),
            Terms::Rows => of(Vec3::new(0.0, y, 0.0)),
            Terms::Columns => of(Vec3::new(x, 0.0, 0.0)),
            Terms::UnitY => of(Vec3::new(0.0, unit.y, 0.0)),
            Terms::Both => of(Vec3::new(x, y, 0.0)),
            Terms::Unit => of(unit),
            Terms::Normal => of(self.normal(unit)?),
            Terms::Red => {
                let [red, ..] = self.reading.pixels[n as usize];
                of(Vec3::new((f64::from(red) + 0.5) / 256.0, 0.0, 0.0))
            }
        })
    }

    /// Of the sphere that is seen, or of the nearest place to it.
    fn normal(&self, unit: Vec3) -> Option<Vec3> {
        let seen = self.cone.as_ref()?.sphere();
        let (center, radius) = if seen.1 > LARGE { GROUND } else { seen };
        let along = unit.dot(center);
        let inside = radius * radius - center.length_squared() + along * along;
        let hit = (along - inside.max(0.0).sqrt()) * unit;
        Some((hit - center).normalize())
    }

    /// Some of the colors at its ends and in its middle; where these are one, also another.
    fn places_and_colors(&self, shown: Range<usize>) -> String {
        let width = self.reading.width;
        let inner = self.surface.inner.iter().copied();
        // What is far from there is somewhere else.
        let size = self.surface.columns.len().max(self.surface.rows.len()) as u64;
        let square = |length: u32| u64::from(length) * u64::from(length);
        let nearest = |i: u32, j: u32| {
            let off =
                move |n: &u32| square((n % width).abs_diff(i)) + square((n / width).abs_diff(j));
            let nearest = inner.clone().min_by_key(off);
            nearest.filter(|n| ASIDE * off(n) <= size * size)
        };
        let all = |range: &Range<u32>| [range.start, (range.start + range.end) / 2, range.end - 1];
        let [left, middle, right] = all(&self.surface.columns);
        let [top, center, bottom] = all(&self.surface.rows);
        let places = [
            ("at its top", nearest(middle, top)),
            ("at its bottom", nearest(middle, bottom)),
            ("at its left", nearest(left, center)),
            ("at its right", nearest(right, center)),
            ("in its middle", nearest(middle, center)),
            ("at its upper left", nearest(left, top)),
            ("at its upper right", nearest(right, top)),
            ("at its lower left", nearest(left, bottom)),
            ("at its lower right", nearest(right, bottom)),
        ];
        let color = |n: u32| self.reading.pixels[n as usize];
        let shown = places[shown].iter();
        let shown = shown.filter_map(|&(place, n)| Some((place.to_owned(), color(n?))));
        let mut shown: Vec<(String, Pixel)> = shown.collect();
        let first = shown.first().map(|(_, it)| *it);
        let first = first.or_else(|| inner.clone().next().map(color));
        let first = first.unwrap_or_default();
        let farthest = inner.clone().max_by_key(|&n| distance(first, color(n)));
        if let Some(n) = farthest.filter(|_| shown.iter().all(|(_, it)| *it == first)) {
            let place = format!("in column {}, row {}", n % width, n / width);
            shown.push((place, color(n)));
        }
        let said = shown.iter().map(|(place, it)| format!("{it:?} {place}"));
        said.collect::<Vec<_>>().join(", ")
    }

    pub(super) fn colors(&self, found: Option<(Terms, Fit)>) -> String {
        let Some((terms, fit)) = found else {
            // What fills a rectangle has corners.
            let Surface { columns, rows, .. } = self.surface;
            let is_round = 10 * self.surface.count < 9 * columns.len() * rows.len();
            return format!(
                "is {}",
                self.places_and_colors(0..if is_round { 5 } else { 9 })
            );
        };
        let at = |x: f64, y: f64, z: f64| fit.color(DVec4::new(1.0, x, y, z));
        match terms {
            Terms::One => {
                let pixel = at(0.0, 0.0, 0.0).map(|it| (256.0 * it - 0.5).round() as i16);
                let mut inner = self.surface.inner.iter();
                let is_it = |n: &u32| distance(pixel, self.reading.pixels[*n as usize]) <= LEVELS;
                let nearly = if inner.all(is_it) { "" } else { "nearly " };
                let meant = match self.cone {
                    Some(_) => uniform::of_a_thing(pixel),
                    None => uniform::of_the_sky(pixel).or_else(|| uniform::of_a_normal(pixel)),
                };
                let meant = meant.map_or(String::new(), |it| format!(", {it}"));
                format!("has {nearly}one color, {pixel:?}{meant}")
            }
            Terms::Rows | Terms::Columns | Terms::Both => {
                let (ways, shown) = match terms {
                    Terms::Rows => ("from row to row", 0..2),
                    Terms::Columns => ("from column to column", 2..4),
                    _ => ("along rows and columns", 5..9),
                };
                let colors = self.places_and_colors(shown);
                let growing = fit.growing().filter(|_| terms == Terms::Both);
                let growing = growing.map_or(String::new(), |it| format!("{it}; "));
                format!("changes in equal steps {ways}: {growing}it is {colors}")
            }
            Terms::UnitY => format!(
                "is a blend by the y of the unit direction, from {} where that is -1 to {} where it is 1",
                color(at(0.0, -1.0, 0.0)),
                color(at(0.0, 1.0, 0.0))
            ),
            Terms::Red if is_books(&fit) => {
                "blends the book's two colors, but not where the book does".to_owned()
            }
            Terms::Red => format!("blends two colors: {}", self.places_and_colors(0..5)),
            Terms::Unit => format!("is made of the unit direction u: {}", sums(&fit, "u")),
            Terms::Normal if fit.is_the_normal() => {
                "is colored by its normal as in the book".to_owned()
            }
            Terms::Normal => format!("is made of the normal N: {}", sums(&fit, "N")),
        }
    }
}

/// What a surface is if it is a chapter's.
pub(super) fn what(chapter: Chapter) -> String {
    match chapter {
        Chapter::Gradient => "the book's sky".to_owned(),
        _ => format!("what {} has there", chapter.name()),
    }
}

/// With two digits that count.
pub(super) fn about(length: f64) -> String {
    if length.abs() < NEAR {
        return number(0.0);
    }
    let scale = 10_f64.powf(length.abs().log10().floor() - 1.0);
    number((length / scale).round() * scale)
}

/// With two digits, of which a last zero is not said.
pub(super) fn number(number: f64) -> String {
    let number = (100.0 * number).round() / 100.0;
    format!("{}", number + 0.0)
}
