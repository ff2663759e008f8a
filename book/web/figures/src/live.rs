//! Live figures: parameters that a reader changes, and the drawing that follows.
//!
//! A page shows a figure as a drawing that was made when the book was woven. When a reader changes
//! the figure, the same function draws it anew in the page, compiled to WebAssembly (package
//! `page`). A figure consists of two files: `walk.md` has its words, and `walk.rs` its parameters
//! with their ranges, the handles to be dragged, the drawing, and the sentence below.
//!
//! To make another figure: write its words, declare its `parameters!`, make a [`Live`] of them, and
//! add that to [`LESSON`](crate::LESSON). From then on `{{figure NAME}}` weaves it with its
//! handles. `.ci/live` builds the module of the pages anew.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use glam::DVec2;

use crate::figure::Figure;
use crate::parameters::{FigureParameters, Parameter};
use crate::svg::Svg;
use crate::text::html;

/// A place on a drawing that a reader can drag, and the field of the parameters that follows.
#[derive(Debug)]
pub(crate) struct Handle<P> {
    /// The name of the field that dragging changes.
    pub(crate) field: &'static str,
    /// Returns the place of the handle on the sheet.
    pub(crate) at: fn(&P) -> DVec2,
    /// Changes the field so that the handle comes as near as possible to a place on the sheet.
    pub(crate) drag: fn(&mut P, DVec2),
}

/// Makes the handle of a field: a point of a plane, a number on an axis, or a vector that starts at
/// such a point.
macro_rules! point {
    ($frame:expr, $field:ident) => {
        crate::live::Handle {
            field: stringify!($field),
            at: |it| $frame.point(it.$field),
            drag: |it, to| it.$field = $frame.place(to),
        }
    };
    ($frame:expr, $field:ident from $origin:ident) => {
        crate::live::Handle {
            field: stringify!($field),
            at: |it| $frame.point(it.$origin + it.$field),
            drag: |it, to| it.$field = $frame.place(to) - it.$origin,
        }
    };
}
pub(crate) use point;

/// The words on a button, and the change that it makes to the parameters.
pub(crate) type Action<P> = (&'static str, fn(&mut P));

/// A figure that a reader can move by changing parameters of type `P`.
#[derive(Debug)]
pub(crate) struct Live<P: 'static> {
    /// The words of the figure.
    pub(crate) figure: LazyLock<Figure>,
    /// The places at which the drawing can be dragged. Where two coincide, a reader drags the later
    /// one.
    pub(crate) handles: &'static [Handle<P>],
    /// The buttons below the drawing.
    pub(crate) actions: &'static [Action<P>],
    /// Draws the figure for parameters that are each within their ranges.
    pub(crate) answer: fn(&P) -> DrawnFigure,
}

/// Words by name, for sentences of the page and for the lines of a listing.
pub(crate) type Says = BTreeMap<&'static str, String>;

/// A figure as drawn for certain parameters, and all that the page says of it.
#[derive(Clone, Debug)]
pub struct DrawnFigure {
    /// The drawing, which [`Svg::finish`] turns into an `<svg>` element.
    pub drawing: Svg,
    /// A sentence that says what the drawing shows, as plain text with marks: `*t*` is a number,
    /// `**P**` a vector.
    pub sentence: String,
    /// The place of each handle (a spot that a reader can drag), in the order of
    /// [`Movable::handles`]: x to the right, y down, in units of the SVG's viewBox.
    pub handles: Vec<DVec2>,
    /// Plain texts by name, such as values of t, that the page puts into its sentences and beside
    /// listings; empty if it needs none.
    pub says: BTreeMap<&'static str, String>,
}

impl DrawnFigure {
    /// Makes a drawn figure without its handles, which [`Movable::answer`] adds.
    pub(crate) fn new(drawing: Svg, sentence: String, says: impl Into<Says>) -> Self {
        Self {
            drawing,
            sentence,
            handles: Vec::new(),
            says: says.into(),
        }
    }
}

/// A live figure: a drawing with parameters that a reader changes. Whatever these are, callers pass
/// their values as a list of numbers, in the order of [`Movable::parameters`].
pub trait Movable: Sync {
    /// Returns the figure's name, title, caption and other words.
    fn figure(&self) -> &Figure;

    /// Returns the name, range and default of each parameter, in the order of all lists of numbers
    /// here.
    fn parameters(&self) -> &'static [Parameter];

    /// Returns one list per handle (a spot of the drawing that a reader can drag): the indices, in
    /// [`Movable::parameters`] from 0, of those that dragging it changes. Empty without handles.
    fn handles(&self) -> Vec<Vec<usize>>;

    /// Returns the label of each button below the drawing; [`Movable::act`] takes its index, from
    /// 0. Empty without buttons.
    fn actions(&self) -> Vec<&'static str>;

    /// Sets `numbers` as dragging the handle with this index, from 0, to the point `to` of the
    /// drawing does (x to the right, y down, in units of the viewBox). The changed parameters come
    /// onto the nearest step of their sliders, within their ranges.
    ///
    /// # Panics
    /// If there is no such handle, or the list has another length than the parameters.
    fn drag(&self, handle: usize, numbers: &mut [f64], to: DVec2);

    /// Sets `numbers` as pressing the button with this index, from 0, does, within their ranges.
    ///
    /// # Panics
    /// If there is no such button, or the list has another length than the parameters.
    fn act(&self, action: usize, numbers: &mut [f64]);

    /// Draws the figure for these values of its parameters, each of which has to be within its
    /// range: [`Movable::confine`] brings it there.
    ///
    /// # Panics
    /// If the list is shorter than that of the parameters.
    fn answer(&self, numbers: &[f64]) -> DrawnFigure;

    /// Returns the name by which pages and links call the figure, such as `walk`.
    fn name(&self) -> &'static str {
        self.figure().name
    }

    /// Returns the default of each parameter, with which the page first shows the figure.
    fn defaults(&self) -> Vec<f64> {
        self.parameters().iter().map(|it| it.default).collect()
    }

    /// Brings each number into its parameter's range, and rounds a whole one. NaN and infinity
    /// become the default.
    ///
    /// # Panics
    /// If the list is shorter than that of the parameters.
    fn confine(&self, numbers: &mut [f64]) {
        for (n, number) in self.parameters().iter().enumerate() {
            numbers[n] = number.confine(numbers[n]);
            numbers[n] = numbers[n].min(number.most_among(numbers));
        }
    }

    /// Draws the figure for `numbers` as [`Movable::answer`] does, and writes all that a script
    /// needs, in lines: the `<svg>` element; the sentence as HTML; and then, with tabs between
    /// fields, `handle`, x, y for each handle; `value`, the number, its words, its greatest value
    /// for each parameter; and `says`, name, text for each text.
    fn text(&self, numbers: &[f64]) -> String {
        let answer = self.answer(numbers);
        let mut text = format!("{}\n{}", answer.drawing.finish(), html(&answer.sentence));
        for place in answer.handles {
            text += &format!("\nhandle\t{}\t{}", place.x, place.y);
        }
        for (number, value) in self.parameters().iter().zip(numbers) {
            let (words, most) = (number.in_words(*value), number.most_among(numbers));
            text += &format!("\nvalue\t{value}\t{words}\t{most}");
        }
        for (name, value) in answer.says {
            text += &format!("\nsays\t{name}\t{value}");
        }
        text
    }
}

impl<P: FigureParameters> Movable for Live<P> {
    fn figure(&self) -> &Figure {
        &self.figure
    }

    fn parameters(&self) -> &'static [Parameter] {
        P::PARAMETERS
    }

    fn handles(&self) -> Vec<Vec<usize>> {
        let places = |handle: &Handle<P>| {
            let places = 0..P::PARAMETERS.len();
            let is_changed = |place: &usize| P::PARAMETERS[*place].field == handle.field;
            places.filter(is_changed).collect()
        };
        self.handles.iter().map(places).collect()
    }

    fn actions(&self) -> Vec<&'static str> {
        self.actions.iter().map(|(name, _)| *name).collect()
    }

    fn drag(&self, handle: usize, numbers: &mut [f64], to: DVec2) {
        let mut parameters = P::of(numbers);
        (self.handles[handle].drag)(&mut parameters, to);
        numbers.copy_from_slice(&parameters.numbers());
        for &place in &self.handles()[handle] {
            numbers[place] = P::PARAMETERS[place].on_a_step(numbers[place]);
        }
        self.confine(numbers);
    }

    fn act(&self, action: usize, numbers: &mut [f64]) {
        let mut parameters = P::of(numbers);
        (self.actions[action].1)(&mut parameters);
        numbers.copy_from_slice(&parameters.numbers());
        self.confine(numbers);
    }

    fn answer(&self, numbers: &[f64]) -> DrawnFigure {
        let parameters = P::of(numbers);
        let mut answer = (self.answer)(&parameters);
        // The figure's own description is of what the page shows.
        if numbers != self.defaults() {
            answer.drawing.describe(&answer.sentence);
        }
        let handles = self.handles.iter().map(|it| (it.at)(&parameters));
        answer.handles = handles.collect();
        answer
    }
}
