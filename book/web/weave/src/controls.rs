//! Live figures: HTML around a drawing, with which a reader moves it.
//!
//! Everything is on the page from the start, so nothing jumps when the script comes, and
//! the style sheet hides what does nothing without it.

use std::collections::BTreeMap;

use figures::{ACCURACY, Figure, LESSON, Movable, Parameter, Question, figures, html};

use crate::ground::{escaped, named};

/// Returns a live figure as HTML: a question, its drawing under handles, inputs and buttons, a
/// sentence, the answer, closed, and the caption. `data-figure` is the index of the figure in the
/// module that draws it.
pub(crate) fn around(live: &dyn Movable, question: &Question) -> String {
    let Figure {
        name,
        title,
        caption,
        ..
    } = live.figure();
    let Question { question, solution } = question;
    let is_it = |it: &&dyn Movable| it.name() == *name;
    let modules = [("lesson", LESSON), ("accuracy", ACCURACY)];
    let (module, place) = modules
        .into_iter()
        .find_map(|(module, figures)| Some((module, figures.iter().position(is_it)?)))
        .expect("it is in one of them");
    let answer = live.answer(&live.defaults());
    // What a hand is to do is not printed.
    let asked = question.rfind('?').map_or(0, |at| at + 1);
    let (asked, moved) = question.split_at(asked);
    format!(
        "<figure id=\"{name}\" class=\"live\" aria-label=\"{title}\" data-module=\"{module}\" data-figure=\"{place}\">\
         <p class=\"question\">{question}<span class=\"move\">{moved}</span></p>\
         <div class=\"stage\">{drawing}{handles}</div>\
         <div class=\"controls\">{inputs}{buttons}</div>\
         <p class=\"sentence\" role=\"status\">{sentence}</p>\
         <details class=\"answer\"><summary>Answer</summary>{solution}</details>\
         <figcaption>{caption}</figcaption></figure>",
        title = escaped(title),
        question = html(asked),
        moved = html(moved),
        solution = html(solution),
        handles = handles(live),
        sentence = html(&answer.sentence),
        caption = html(caption),
        drawing = answer.drawing.finish(),
        inputs = inputs(live),
        buttons = buttons(live),
    )
}

/// Returns the HTML of words that the live figure `figure` says under `name`: those of its
/// defaults, until the reader moves the figure.
///
/// # Errors
/// If there is no such figure, or it says no such words.
pub(crate) fn number(figure: &str, name: &str) -> Result<String, String> {
    let kind = format!("number of {figure}");
    let (_, value) = named(&kind, name, says(figure)?, |(name, _)| name)?;
    Ok(followed(figure, name, &value))
}

/// Returns all words, by name, that a live figure says for its defaults.
///
/// # Errors
/// If there is no such figure.
pub(crate) fn says(figure: &str) -> Result<BTreeMap<&'static str, String>, String> {
    let live = named("live figure", figure, figures(), |live| live.name())?;
    Ok(live.answer(&live.defaults()).says)
}

/// Returns words in the text as HTML that the script replaces when the reader moves the figure.
pub(crate) fn followed(figure: &str, name: &str, value: &str) -> String {
    format!("<span class=\"told\" data-told=\"{figure} {name}\">{value}</span>")
}

/// Returns the handles of a figure, each with a slider for every parameter that it changes: for the
/// keyboard, and for a reader who listens. Of two handles that change the same parameters, the Tab
/// key stops only at the first.
fn handles(live: &dyn Movable) -> String {
    let all = live.handles();
    let handle = |(k, places): (usize, &Vec<usize>)| {
        let first = if all[..k].contains(places) { "-1" } else { "0" };
        let sliders = places.iter().zip([first, "-1"]).map(|(&n, order)| {
            let slider = slider(n, &live.parameters()[n]);
            format!("<input tabindex=\"{order}\" {slider}>")
        });
        let sliders: String = sliders.collect();
        format!("<span class=\"handle\">{sliders}</span>")
    };
    all.iter().enumerate().map(handle).collect()
}

/// Returns the attributes of the slider for the parameter at index `n`.
fn slider(n: usize, number: &Parameter) -> String {
    let Parameter {
        name,
        least,
        most,
        default,
        ..
    } = number;
    let downwards = if number.downwards {
        " data-downwards"
    } else {
        ""
    };
    let step = 1.0 / number.steps;
    format!(
        "type=\"range\"{downwards} data-number=\"{n}\" aria-label=\"{name}\" min=\"{least}\" max=\"{most}\" \
         step=\"{step}\" value=\"{default}\""
    )
}

/// Returns a list or a slider for each parameter that no handle changes.
fn inputs(live: &dyn Movable) -> String {
    let handled = live.handles().concat();
    let numbers = live.parameters().iter().enumerate();
    let free = numbers.filter(|(n, _)| !handled.contains(n));
    free.map(|(n, number)| {
        let input = match number.choices {
            [] => format!("<input {}>", slider(n, number)),
            _ => choice(n, number),
        };
        format!("<label>{} {input}</label>", number.name)
    })
    .collect()
}

/// Returns the list of choices for the parameter at index `n`.
fn choice(n: usize, number: &Parameter) -> String {
    let options = number.choices.iter().zip(0..).map(|(choice, value)| {
        let value = number.least + f64::from(value);
        format!("<option value=\"{value}\">{choice}</option>")
    });
    let options: String = options.collect();
    format!("<select data-number=\"{n}\">{options}</select>")
}

/// Returns the buttons of the figure, one that resets it, and the link to its current state.
fn buttons(live: &dyn Movable) -> String {
    let actions = live.actions().into_iter().enumerate();
    let buttons: String = actions
        .map(|(n, action)| format!("<button type=\"button\" data-action=\"{n}\">{action}</button>"))
        .collect();
    buttons
        + "<button type=\"button\" data-action=\"reset\">Reset</button>\
           <a class=\"this-case\">Link to this case</a>"
}
