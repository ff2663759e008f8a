//! What lies behind all else, and the camera through which it is told most simply.

use slips::{Chapter, Edition};

use super::cone::Eye;
use super::fit::Fit;
use super::said::{NEAR, Seen, about, what};
use super::terms::Terms;
use super::{Surface, view};
use crate::reading::Reading;
use crate::words::INTEGERS;

/// Who is off by no more is off by roundings.
const EXACT: f64 = 1.0;
/// Levels that are a little too dark move a sky up or down by less than such a part of its height,
/// and change its size by less; it is its own mirror image, so they don't move it aside.
const ASIDE: f64 = 0.01;
const MOVED: f64 = 0.03;

/// The colors of the book's sky, below and above.
const SKY: [[f64; 3]; 2] = [[1.0; 3], [0.5, 0.7, 1.0]];
/// A blend comes so near to the book's after gamma correction, which is none.
const CORRECTED: f64 = 0.03;
/// Gamma corrected or measured through JPEG, a blend ends no farther beyond white or black.
const BEYOND: f64 = 0.05;

/// What lies behind all else.
pub(super) struct Background {
    /// What it is, in words.
    pub(super) said: String,
    pub(super) eye: Eye,
    /// Whether it is a chapter's, seen as there.
    pub(super) is_a_chapters: bool,
}

impl Background {
    /// A chapter's, the book's sky through another camera, or else what it is.
    pub(super) fn of(surface: &Surface, reading: &Reading) -> Self {
        let share = 100 * surface.inner.len() / reading.pixels.len();
        let subject = match surface.reaches_the_top(reading) {
            true => format!("What reaches the top, {share} % of the picture,"),
            false => format!("The largest surface, {share} % of the picture,"),
        };
        let [books, ..] = viewports(reading).map(|viewport| Eye::new(reading, viewport));
        let seen = Seen::new(surface, reading, books);
        let sky = view::of(surface, reading).map(|eye| (through(&eye, &books), eye));
        let chapter = seen.chapter([Chapter::Gradient, Chapter::BuildTest]);
        // What is moved by a few pixels, may be off by no more than a level.
        let moved = sky.as_ref().filter(|(through, _)| !through.is_empty());
        let is_like_one = chapter.is_some();
        if let (Some((chapter, editions)), None) = (chapter, moved) {
            let (said, by) = (what(chapter), Edition::said(&editions));
            return Self {
                said: format!("{subject} is {said}{by}."),
                eye: books,
                is_a_chapters: true,
            };
        }
        let own = seen
            .fitted(&Terms::BEHIND)
            .filter(|(_, fit)| fit.off <= EXACT);
        let (said, eye) = match sky.filter(|_| own.is_none() || is_like_one) {
            Some((through, eye)) => (format!("is the book's sky{through}"), eye),
            None => otherwise(surface, reading, own),
        };
        Self {
            said: format!("{subject} {said}."),
            eye,
            is_a_chapters: false,
        }
    }
}

/// What makes its colors, through the book's viewport or another, in words.
fn otherwise(surface: &Surface, reading: &Reading, own: Option<(Terms, Fit)>) -> (String, Eye) {
    let [books, ..] = viewports(reading).map(|viewport| Eye::new(reading, viewport));
    let own = own.map(|found| (found, books));
    let found = own.or_else(|| through_a_viewport(surface, reading));
    let (found, eye) = match found {
        Some((found, eye)) => (Some(found), eye),
        None => (None, books),
    };
    let unlike = match found {
        Some((Terms::Rows, _)) => {
            ", as where a direction is not divided by its length, or in a narrow view".to_owned()
        }
        Some((Terms::Columns | Terms::Both, _)) => {
            "; of the book's pictures only build_test does so: there red grows to the right, and green downwards, or in older editions upwards".to_owned()
        }
        Some((Terms::UnitY | Terms::Unit, _)) if eye.sides() != books.sides() => {
            through(&eye, &books)
        }
        _ => String::new(),
    };
    let beyond = match &found {
        Some((Terms::UnitY, fit)) if fit.beyond_colors() > BEYOND => {
            "; these are no colors, as where the weight of blue is not 0.5 * (y + 1)"
        }
        _ => "",
    };
    let corrected = match &found {
        Some((Terms::UnitY, fit)) if fit.blends(SKY.map(|it| it.map(f64::sqrt))) < CORRECTED => {
            ", nearly the book's sky after gamma correction"
        }
        _ => "",
    };
    let colors = match &found {
        Some((Terms::UnitY, fit)) if fit.blends(SKY) < NEAR => "is the book's sky".to_owned(),
        _ => Seen::new(surface, reading, eye).colors(found),
    };
    (format!("{colors}{corrected}{unlike}{beyond}"), eye)
}

type Found = ((Terms, Fit), Eye);

/// The terms of which its colors are sums, and the eye that sees them so.
fn through_a_viewport(surface: &Surface, reading: &Reading) -> Option<Found> {
    let [books, others @ ..] = viewports(reading).map(|viewport| Eye::new(reading, viewport));
    let fitted = |eye: Eye, terms: &[Terms]| {
        let found = Seen::new(surface, reading, eye).fitted(terms)?;
        Some((found, eye))
    };
    // Through one viewport or another much looks nearly like a blend that is none.
    let typed = others.iter().filter_map(|eye| fitted(*eye, &Terms::BEHIND));
    let zooms = zooms(reading).map(|it| Eye::new(reading, it));
    let zooms = zooms.filter_map(|eye| fitted(eye, &[Terms::UnitY]));
    let exact = typed.chain(zooms).filter(|((_, fit), _)| fit.off <= EXACT);
    let blends = || {
        let blends = others.iter();
        let blends = blends.filter_map(|eye| fitted(*eye, &[Terms::UnitY]));
        nearest(blends.filter(|((_, fit), _)| fit.beyond_colors() < NEAR))
    };
    let sums = || {
        let mut eyes = [books].into_iter().chain(others);
        eyes.find_map(|eye| fitted(eye, &[Terms::Unit]))
    };
    nearest(exact)
        .or_else(|| fitted(books, &Terms::SIMPLE))
        .or_else(blends)
        .or_else(sums)
        .or_else(|| fitted(books, &[Terms::Red]))
}

fn nearest(fits: impl Iterator<Item = Found>) -> Option<Found> {
    fits.min_by(|((_, one), _), ((_, other), _)| one.off.total_cmp(&other.off))
}

/// Where an eye's pixels lie, if that is not where they are in the book.
fn through(eye: &Eye, books: &Eye) -> String {
    let ([across, down], [books_across, books_down]) = (eye.sides(), books.sides());
    let leans = across.y.abs() > 2.0 * NEAR * across.length();
    if leans || down.x.abs() > 2.0 * NEAR * down.length() || across.x < 0.0 {
        return leaning(eye);
    }
    let [width, height] = [across.x, down.y.abs()];
    let larger = [width / books_across.x, -height / books_down.y];
    let is_as_large = larger.iter().all(|it| (it - 1.0).abs() < MOVED);
    let size = (!is_as_large).then(|| {
        let ratio = -books_across.x / books_down.y;
        let is_square = (width / height - 1.0).abs() < MOVED;
        let by_integers = match is_square && ratio > 1.0 + MOVED && ratio < 2.0 {
            true => INTEGERS,
            false => "",
        };
        let [width, height] = [width, height].map(about);
        format!("seen through a viewport about {width} wide and {height} high{by_integers}")
    });
    let turned = (down.y > 0.0).then(|| "seen upside down".to_owned());
    let [aside, along] = eye.middle();
    let moved = [
        (aside, ASIDE, ["to the left", "to the right"]),
        (along, MOVED, ["upwards", "downwards"]),
    ];
    let moved = moved
        .into_iter()
        .filter_map(|((by, part), least, [one, other])| {
            let way = if by > 0.0 { one } else { other };
            let pixels = (10.0 * by.abs()).round() / 10.0;
            (part.abs() > least).then(|| format!("moved by {pixels} pixels {way}"))
        });
    let all = size.into_iter().chain(turned).chain(moved);
    all.map(|it| format!(", {it}")).collect()
}

/// Where pixels lie on the viewport, if not in level rows.
fn leaning(eye: &Eye) -> String {
    let [across, down] = eye.sides();
    let [first, across, down] = [eye.first, across, down].map(|it| {
        let least = 2.0 * NEAR * it.x.abs().max(it.y.abs());
        let [x, y] = [it.x, it.y].map(|it| about(if it.abs() < least { 0.0 } else { it }));
        format!("({x}, {y})")
    });
    format!(
        ", seen as if on the viewport the first pixel lay at {first}, a row led along {across} and a column along {down}"
    )
}

/// The book's, and others that people type, also by the width, by an integer ratio or as printed.
pub(super) fn viewports(reading: &Reading) -> [[f64; 2]; 8] {
    let ratio = f64::from(reading.width) / f64::from(reading.height);
    let by_height = |height: f64| [height * ratio, height];
    let by_width = |width: f64| [width, width / ratio];
    [
        by_height(2.0),
        by_height(1.0),
        by_height(4.0),
        by_width(2.0),
        by_width(4.0),
        by_width(1.0),
        [2.0 * ratio.floor().max(1.0), 2.0],
        [4.0, 2.0],
    ]
}

/// Viewports of any size.
fn zooms(reading: &Reading) -> impl Iterator<Item = [f64; 2]> {
    let ratio = f64::from(reading.width) / f64::from(reading.height);
    let heights = (-80..=192).map(|n| (f64::from(n) / 32.0).exp2());
    heights.map(move |height| [height * ratio, height])
}
