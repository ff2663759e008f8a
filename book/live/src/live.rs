//! What can be changed in a figure, and what it answers.

use std::fmt::Write;

use figures::html;
use glam::DVec2;

/// A figure that a reader can move.
#[derive(Clone, Copy, Debug)]
pub struct Live {
    /// The name of the figure that it draws.
    pub name: &'static str,
    /// What a reader is to find out; `*t*` is a number, `**P**` a vector.
    pub question: &'static str,
    /// What can be changed.
    pub numbers: &'static [Number],
    /// Where on the drawing it can be grasped. Of two in the same place the later one is.
    pub handles: &'static [Handle],
    /// What a button does.
    pub actions: &'static [Action],
    /// The figure for these numbers, each within its range.
    pub answer: fn(&[f64]) -> Answer,
}

/// A number that a reader can change.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    /// What it is.
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

/// A place on the drawing that a reader can drag.
#[derive(Clone, Copy, Debug)]
pub struct Handle {
    /// The places of the numbers that it changes: one; or two, across and up.
    pub numbers: &'static [usize],
    /// Changes the numbers so that the handle comes as near as can be to a place on the
    /// sheet.
    pub drag: fn(&mut [f64], DVec2),
}

/// What a button does to all numbers.
#[derive(Clone, Copy, Debug)]
pub struct Action {
    /// What the button says.
    pub name: &'static str,
    /// Changes the numbers.
    pub act: fn(&mut [f64]),
}

/// What a figure answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The drawing.
    pub svg: String,
    /// What is to be seen in it; `*t*` is a number, `**P**` a vector.
    pub sentence: String,
    /// Where each handle is on the sheet.
    pub handles: Vec<DVec2>,
    /// Numbers by name, for the sentences of the page that tell them.
    pub says: Vec<(&'static str, String)>,
}

impl Live {
    /// The numbers of the figure on the page.
    pub fn defaults(&self) -> Vec<f64> {
        self.numbers.iter().map(|number| number.default).collect()
    }

    /// Puts each number into its range, and whole ones on a whole number; what is no number
    /// becomes the default.
    pub fn confine(&self, numbers: &mut [f64]) {
        for (n, number) in self.numbers.iter().enumerate() {
            numbers[n] = number.confine(numbers[n]);
            numbers[n] = numbers[n].min(number.most_among(numbers));
        }
    }

    /// The answer in lines: the drawing, the sentence, and then with a word before them
    /// the places of the handles, the numbers with their words and their greatest values,
    /// and what sentences of the page tell.
    pub fn text(&self, numbers: &[f64]) -> String {
        let answer = (self.answer)(numbers);
        let sentence = html(&answer.sentence);
        let mut text = match numbers == self.defaults() {
            true => answer.svg,
            false => described(&answer.svg, &sentence),
        };
        let _ = write!(text, "\n{sentence}");
        for place in answer.handles {
            let _ = write!(text, "\nhandle\t{}\t{}", place.x, place.y);
        }
        for (number, value) in self.numbers.iter().zip(numbers) {
            let (words, most) = (number.in_words(*value), number.most_among(numbers));
            let _ = write!(text, "\nvalue\t{value}\t{words}\t{most}");
        }
        for (name, value) in answer.says {
            let _ = write!(text, "\nsays\t{name}\t{value}");
        }
        text
    }

    /// Drags a handle to a place on the sheet.
    pub fn drag(&self, handle: &Handle, numbers: &mut [f64], to: DVec2) {
        (handle.drag)(numbers, to);
        for &n in handle.numbers {
            numbers[n] = self.numbers[n].on_a_step(numbers[n]);
        }
        self.confine(numbers);
    }
}

/// The drawing with another description, for whoever cannot see it: the page's was of what
/// the page shows.
fn described(svg: &str, sentence: &str) -> String {
    let plain = ["<i>", "</i>", "<b>", "</b>"]
        .iter()
        .fold(sentence.to_owned(), |text, tag| text.replace(tag, ""));
    match (svg.split_once("description\">"), svg.split_once("</desc>")) {
        (Some((before, _)), Some((_, after))) => {
            format!("{before}description\">{plain}</desc>{after}")
        }
        _ => svg.to_owned(),
    }
}

impl Number {
    /// A number of some unit from `least` to `most`.
    pub(crate) const fn new(name: &'static str, least: f64, most: f64, default: f64) -> Self {
        Self {
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
            None => figures::spoken(value).replace('−', "minus "),
        }
    }
}
