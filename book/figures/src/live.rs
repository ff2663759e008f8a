//! Live figures: what can be changed in a figure, and what it answers.
//!
//! A page shows a figure as a drawing that was made when the book was woven. Where a figure
//! is live, a reader may move what is in it, and the same function draws it anew in the page,
//! compiled to WebAssembly (package `live`). A figure's file has all that is known about it:
//! its words, its parameters with their ranges, where on the sheet they can be grasped and
//! what a drag does to them, the drawing, and the sentence below.
//!
//! To make another figure live: state its [`parameters!`], make a [`Live`] of it, and name
//! that in [`LESSON`](crate::LESSON). From then on `{{figure NAME}}` weaves it
//! with its handles. `.ci/live` builds the module of the pages anew.

use std::fmt::Write;

use glam::DVec2;

use crate::figure::{Figure, html};
use crate::number::spoken;
use crate::svg::Svg;

/// A number that a reader can change.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    /// The field of the parameters that it is.
    pub field: &'static str,
    /// What it is, in words.
    pub name: &'static str,
    /// The least value.
    pub least: f64,
    /// The greatest value.
    pub most: f64,
    /// How many steps of the slider make 1.
    pub steps: f64,
    /// What the figure on the page shows.
    pub default: f64,
    /// The greatest value beside these numbers, if they leave less room.
    pub most_beside: Option<fn(&[f64]) -> f64>,
    /// Whether more is farther down on the drawing.
    pub downwards: bool,
    /// What the values are called, from `least` on, if it is a choice.
    pub choices: &'static [&'static str],
}

/// The parameters of a figure, each a number.
pub(crate) trait Parameters: Sized + 'static {
    /// The numbers, in the order of the fields.
    const NUMBERS: &'static [Number];

    /// Reads them from a list in that order.
    fn of(numbers: &[f64]) -> Self;

    /// Writes them to such a list.
    fn to(&self, numbers: &mut [f64]);
}

/// Declares the parameters of a figure, each field with the [`Number`] that it is.
macro_rules! parameters {
    ($($field:ident: $number:expr,)*) => {
        /// What can be changed.
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct Parameters {
            $($field: f64,)*
        }

        impl crate::live::Parameters for Parameters {
            const NUMBERS: &'static [Number] =
                &[$(Number { field: stringify!($field), ..$number }),*];

            fn of(numbers: &[f64]) -> Self {
                let mut numbers = numbers.iter().copied();
                Self { $($field: numbers.next().expect("a number for each field")),* }
            }

            fn to(&self, numbers: &mut [f64]) {
                numbers.copy_from_slice(&[$(self.$field),*]);
            }
        }
    };
}
pub(crate) use parameters;

/// A figure that a reader can move by changing parameters of type `P`.
#[derive(Debug)]
pub(crate) struct Live<P: 'static> {
    /// The figure, as the page shows it.
    pub(crate) figure: Figure,
    /// What a reader is to find out; `*t*` is a number, `**P**` a vector.
    pub(crate) question: &'static str,
    /// What a reader finds out: closed on the page, until it is asked for.
    pub(crate) solution: &'static str,
    /// Where on the drawing it can be grasped. Of two in the same place the later one is.
    pub(crate) handles: &'static [Handle<P>],
    /// What a button does.
    pub(crate) actions: &'static [Action<P>],
    /// The figure for these parameters, each within its range.
    pub(crate) answer: fn(&P) -> Answer,
}

/// A place on the drawing that a reader can drag.
#[derive(Debug)]
pub(crate) struct Handle<P> {
    fields: &'static [&'static str],
    drag: fn(&mut P, DVec2),
}

impl<P> Handle<P> {
    /// A handle that changes one field, or two, across and up, so that it comes as near as can
    /// be to a place on the sheet.
    pub(crate) const fn new(fields: &'static [&'static str], drag: fn(&mut P, DVec2)) -> Self {
        Self { fields, drag }
    }
}

/// What a button does to all parameters.
#[derive(Debug)]
pub(crate) struct Action<P> {
    name: &'static str,
    act: fn(&mut P),
}

impl<P> Action<P> {
    /// What a button does that says this.
    pub(crate) const fn new(name: &'static str, act: fn(&mut P)) -> Self {
        Self { name, act }
    }
}

/// What a figure answers.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The drawing.
    pub drawing: Svg,
    /// What is to be seen in it; `*t*` is a number, `**P**` a vector.
    pub sentence: String,
    /// Where each handle is on the sheet.
    pub handles: Vec<DVec2>,
    /// Numbers by name, for the sentences of the page that tell them.
    pub says: Vec<(&'static str, String)>,
}

/// A live figure, whatever its parameters are: they go in and come out as a list of numbers.
///
/// A page does not call these functions of a figure, but those of `dyn Movable`, which keep
/// each number within its range.
pub trait Movable: Sync {
    /// How pages name the figure.
    fn name(&self) -> &'static str;

    /// What it shows, in a few words.
    fn title(&self) -> &'static str;

    /// What a reader is to find out.
    fn question(&self) -> &'static str;

    /// What a reader finds out.
    fn solution(&self) -> &'static str;

    /// What can be changed.
    fn numbers(&self) -> &'static [Number];

    /// The fields that a handle changes, if there is such a handle.
    fn fields(&self, handle: usize) -> Option<&'static [&'static str]>;

    /// What each button says.
    fn actions(&self) -> Vec<&'static str>;

    /// Moves a handle to a place on the sheet.
    fn moved(&self, handle: usize, numbers: &mut [f64], to: DVec2);

    /// Does what a button says.
    fn acted(&self, action: usize, numbers: &mut [f64]);

    /// The figure for these numbers.
    fn drawn(&self, numbers: &[f64]) -> Answer;
}

/// What is the same for all figures.
impl dyn Movable + '_ {
    /// The numbers of the figure on the page.
    pub fn defaults(&self) -> Vec<f64> {
        self.numbers().iter().map(|it| it.default).collect()
    }

    /// For each handle the places of the numbers that it changes.
    pub fn handles(&self) -> Vec<Vec<usize>> {
        let is = |field| self.numbers().iter().position(|it| it.field == field);
        let handles = (0..).map_while(|handle| self.fields(handle));
        handles
            .map(|fields| fields.iter().filter_map(|&it| is(it)).collect())
            .collect()
    }

    /// Drags a handle to a place on the sheet: what it changes comes onto a step.
    pub fn drag(&self, handle: usize, numbers: &mut [f64], to: DVec2) {
        self.moved(handle, numbers, to);
        for &place in &self.handles()[handle] {
            numbers[place] = self.numbers()[place].on_a_step(numbers[place]);
        }
        self.confine(numbers);
    }

    /// Does what a button says.
    pub fn act(&self, action: usize, numbers: &mut [f64]) {
        self.acted(action, numbers);
        self.confine(numbers);
    }

    /// Puts each number into its range, and whole ones on a whole number; what is no number
    /// becomes the default.
    pub fn confine(&self, numbers: &mut [f64]) {
        for (n, number) in self.numbers().iter().enumerate() {
            numbers[n] = number.confine(numbers[n]);
            numbers[n] = numbers[n].min(number.most_among(numbers));
        }
    }

    /// The figure for these numbers, each within its range.
    pub fn answer(&self, numbers: &[f64]) -> Answer {
        let mut answer = self.drawn(numbers);
        // The figure's own description is of what the page shows.
        if numbers != self.defaults() {
            answer.drawing.describe(&answer.sentence);
        }
        answer
    }

    /// The answer in lines: the drawing, the sentence, and then with a word before them
    /// the places of the handles, the numbers with their words and their greatest values,
    /// and what sentences of the page tell.
    pub fn text(&self, numbers: &[f64]) -> String {
        let answer = self.answer(numbers);
        let mut text = format!("{}\n{}", answer.drawing.finish(), html(&answer.sentence));
        for place in answer.handles {
            let _ = write!(text, "\nhandle\t{}\t{}", place.x, place.y);
        }
        for (number, value) in self.numbers().iter().zip(numbers) {
            let (words, most) = (number.in_words(*value), number.most_among(numbers));
            let _ = write!(text, "\nvalue\t{value}\t{words}\t{most}");
        }
        for (name, value) in answer.says {
            let _ = write!(text, "\nsays\t{name}\t{value}");
        }
        text
    }
}

impl<P: Parameters> Live<P> {
    /// The drawing on the page.
    pub(crate) fn on_page(&self) -> String {
        let live: &dyn Movable = self;
        live.answer(&live.defaults()).drawing.finish()
    }
}

impl<P: Parameters> Movable for Live<P> {
    fn name(&self) -> &'static str {
        self.figure.name
    }

    fn title(&self) -> &'static str {
        self.figure.title
    }

    fn question(&self) -> &'static str {
        self.question
    }

    fn solution(&self) -> &'static str {
        self.solution
    }

    fn numbers(&self) -> &'static [Number] {
        P::NUMBERS
    }

    fn fields(&self, handle: usize) -> Option<&'static [&'static str]> {
        self.handles.get(handle).map(|handle| handle.fields)
    }

    fn actions(&self) -> Vec<&'static str> {
        self.actions.iter().map(|action| action.name).collect()
    }

    fn moved(&self, handle: usize, numbers: &mut [f64], to: DVec2) {
        let mut parameters = P::of(numbers);
        (self.handles[handle].drag)(&mut parameters, to);
        parameters.to(numbers);
    }

    fn acted(&self, action: usize, numbers: &mut [f64]) {
        let mut parameters = P::of(numbers);
        (self.actions[action].act)(&mut parameters);
        parameters.to(numbers);
    }

    fn drawn(&self, numbers: &[f64]) -> Answer {
        (self.answer)(&P::of(numbers))
    }
}

impl Number {
    /// A number of some unit from `least` to `most`.
    pub(crate) const fn new(name: &'static str, least: f64, most: f64, default: f64) -> Self {
        Self {
            field: "",
            name,
            least,
            most,
            steps: 20.0,
            default,
            most_beside: None,
            downwards: false,
            choices: &[],
        }
    }

    /// A whole number from `least` to `most`.
    pub(crate) const fn whole(name: &'static str, least: f64, most: f64, default: f64) -> Self {
        Self {
            steps: 1.0,
            ..Self::new(name, least, most, default)
        }
    }

    /// A choice of these, of which the first is on the page.
    pub(crate) const fn choice(name: &'static str, choices: &'static [&'static str]) -> Self {
        Self {
            choices,
            ..Self::whole(name, 0.0, (choices.len() - 1) as f64, 0.0)
        }
    }

    /// The greatest value beside the others.
    fn most_among(&self, numbers: &[f64]) -> f64 {
        let most = self.most_beside.map(|most_beside| most_beside(numbers));
        most.map_or(self.most, |most| most.min(self.most))
    }

    fn confine(&self, value: f64) -> f64 {
        match value.is_finite() {
            true if self.steps == 1.0 => value.clamp(self.least, self.most).round(),
            true => value.clamp(self.least, self.most),
            false => self.default,
        }
    }

    /// The nearest value on a step: the quotient is the double nearest to a short decimal.
    fn on_a_step(&self, value: f64) -> f64 {
        self.confine((value * self.steps).round() / self.steps)
    }

    /// The value in words, for whoever cannot see the slider.
    fn in_words(&self, value: f64) -> String {
        match self.choices.get((value - self.least) as usize) {
            Some(&choice) => choice.to_owned(),
            None => spoken(value).replace('−', "minus "),
        }
    }
}
