//! Live figures: HTML around a drawing, with which a reader moves it.
//!
//! Everything is on the page from the start, so nothing jumps when the script comes, and
//! the style sheet hides what does nothing without it.

use std::collections::BTreeMap;

use figures::{ACCURACY, Figure, LESSON, Movable, Parameter, figures, html};

use crate::ground::{escaped, named};

/// The figure `live`: its question, its drawing under handles, what is to be seen, buttons,
/// the answer, closed, and the caption. Its place is that in the module that draws it.
pub(crate) fn around(live: &dyn Movable) -> String {
    let Figure {
        name,
        title,
        caption,
        question,
        solution,
        ..
    } = live.figure();
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

/// A number that the live figure of that name says: at first as it is on the page.
pub(crate) fn number(figure: &str, name: &str) -> Result<String, String> {
    let kind = format!("number of {figure}");
    let (_, value) = named(&kind, name, says(figure)?, |(name, _)| name)?;
    Ok(followed(figure, name, &value))
}

/// Returns what the live figure of that name says at first.
pub(crate) fn says(figure: &str) -> Result<BTreeMap<&'static str, String>, String> {
    let live = named("live figure", figure, figures(), |live| live.name())?;
    Ok(live.answer(&live.defaults()).says)
}

/// A number in the text, in whose place the script puts what the figure says later.
pub(crate) fn followed(figure: &str, name: &str, value: &str) -> String {
    format!("<span class=\"told\" data-told=\"{figure} {name}\">{value}</span>")
}

/// Each handle holds a slider for each number that it changes: for the keyboard, and for
/// a reader who listens. Where two handles change the same, the Tab key stops at the first.
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

/// For each number that no handle changes a list, if it is a choice, or a slider.
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

fn choice(n: usize, number: &Parameter) -> String {
    let options = number.choices.iter().zip(0..).map(|(choice, value)| {
        let value = number.least + f64::from(value);
        format!("<option value=\"{value}\">{choice}</option>")
    });
    let options: String = options.collect();
    format!("<select data-number=\"{n}\">{options}</select>")
}

fn buttons(live: &dyn Movable) -> String {
    let actions = live.actions().into_iter().enumerate();
    let buttons: String = actions
        .map(|(n, action)| format!("<button type=\"button\" data-action=\"{n}\">{action}</button>"))
        .collect();
    buttons
        + "<button type=\"button\" data-action=\"reset\">Reset</button>\
           <a class=\"this-case\">Link to this case</a>"
}
