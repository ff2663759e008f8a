//! Text: writes for the terminal which method a scene needs, and why.

use std::fmt::Write;

use common::rtweekend::*;
use figures::Spot;
use figures::number::three_digits;
use launcher::names::{self, companion_command};
use launcher::terminal;
use speed_vs_accuracy::{Method, Precision, Scene};
use textwrap::{Options, WordSplitter};

use super::WITHIN;
use crate::hit;
use measure::needs::{Culprit, Place, PrecisionNeeds, RECORDED, RatedMethod, least_of_all};

/// Writes the whole answer for the terminal: first the method to take, last whose times these are.
pub(super) fn answer(
    scene: &Scene,
    place: &Place,
    found: &[PrecisionNeeds],
    with_acne: usize,
) -> String {
    let mut text = paragraph(&advice(scene, found, with_acne)) + "\n" + &described(scene);
    let mut rows = found.iter().flat_map(|found| &found.rows);
    if rows.all(|row| row.view.off.is_none()) {
        text += "No ray meets a sphere: the picture shows only sky.\n";
    }
    for precision in Precision::ALL {
        text.push('\n');
        match found.iter().find(|found| found.precision == precision) {
            Some(found) => text += &one_precision(found),
            None => text += "These numbers do not fit into f32: they overflow, or become 0.\n",
        }
    }
    text + "\n" + &paragraph(&standing(place))
}

/// Describes the scene, the ranges of t, and which errors count as right; warns of a range that
/// begins too late for the scene.
fn described(scene: &Scene) -> String {
    let camera = Camera::new(scene.width);
    let [eye, sun] = scene.t_min;
    let (with_sun, shadows) = match scene.sun {
        Some(_) => (
            " and a sun",
            format!(", and above {sun:?} on the way to the sun"),
        ),
        None => ("", String::new()),
    };
    let about = format!(
        "{}: {}{with_sun}, {} × {} pixels. A hit counts at t above {eye:?}{shadows}. A distance is right if at \
         most {WITHIN:?} of t is wrong.",
        names::escape_for_terminal(&scene.name),
        counted(scene.spheres.len(), "sphere"),
        camera.image_width,
        camera.image_height
    );
    let radii = scene.spheres.iter().map(|(_, radius)| *radius);
    let least = radii.fold(f64::INFINITY, f64::min);
    let of_eye = (eye, "things are seen only from t =");
    let of_sun = (sun, "things cast a shadow only from a distance of");
    let ranges = [Some(of_eye), scene.sun.map(|_| of_sun)];
    let late = ranges
        .into_iter()
        .flatten()
        .filter(|(t_min, _)| *t_min > least);
    let warnings = late.map(|(t_min, what)| {
        paragraph(&format!(
            "WARNING: {what} {t_min:?} on, and the smallest radius is {least:?}. Set a t_min that is \
             small beside it."
        ))
    });
    paragraph(&about) + &warnings.collect::<String>()
}

fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// Writes where the scene stands on the book's map, and whose times were taken.
fn standing(place: &Place) -> String {
    let Place { situation, hardest } = place;
    let power = |exponent: i32| match exponent {
        0 => "1".to_owned(),
        _ => format!("1e{exponent}"),
    };
    let starts = match *hardest {
        Spot::Above(n) => format!("{} radii above the surface", power(-n)),
        Spot::Inside(n) => format!("inside, {} radii below the surface", power(-n)),
        Spot::Away(k, n) => format!(
            "{} radii away, and passes within {} radii of the rim",
            power(k),
            power(-n)
        ),
    };
    let least = RECORDED.least(*hardest, Precision::Double, 3);
    let least = least.map_or("no method", |method| method.name);
    format!(
        "On the map of chapter 6: the hardest ray of the camera starts {starts}. There {least} \
         suffices for three digits in f64. The times are the book's, recorded on rays like these: \
         those of {situation}."
    )
}

/// Names the method to take and why, or other help if no method draws every pixel right.
fn advice(scene: &Scene, found: &[PrecisionNeeds], with_acne: usize) -> String {
    if with_acne > 0 {
        let [_, t_min] = scene.t_min;
        let pixels = counted(with_acne, "pixel");
        return format!(
            "Raise t_min: above {t_min:?}, the surface casts its shadow on itself in {pixels}, also by \
             exact arithmetic. Rays to the sun start at rounded points there, and hit at once."
        );
    }
    let failing = |it: &PrecisionNeeds| Some(it.rows[it.failing.as_ref()?.0].view.method.name);
    match least_of_all(found).map(|(it, row)| (row.view.method.name, failing(it))) {
        Some((name, Some(failing))) => {
            format!("Take {name}: it draws this picture right, and {failing} does not.")
        }
        // It may cost a twentieth more than another of its precision, and that as much again.
        Some((name, None)) => format!(
            "Take {name}: it draws this picture right, and no method that does is cheaper by a tenth."
        ),
        None => match found.first().and_then(|it| it.failing.as_ref()) {
            Some((_, culprit)) if needs_order(culprit) => "Take certified_nearest: two spheres \
                 are nearer to each other than an f64 can tell, and it compares their roots."
                .to_owned(),
            _ => "No method draws every pixel of this picture right.".to_owned(),
        },
    }
}

/// Returns true if a pixel is wrong although t is as exact as it can be: two spheres are too near
/// to each other.
fn needs_order(culprit: &Culprit) -> bool {
    !culprit.is_shadow && culprit.error <= hit::ORDINARY
}

fn one_precision(found: &PrecisionNeeds) -> String {
    let mut text = paragraph(&verdict(found)) + TABLE_HEAD;
    for (n, row) in found.rows.iter().enumerate() {
        text += &line(row, found.least == Some(n));
    }
    if let Some((n, culprit)) = &found.failing {
        let least = found.least.map(|least| &found.rows[least]);
        text += &why(&found.rows[*n], least, culprit);
    }
    text
}

/// Names the methods to take for colors and for distances, and the error of t by the one for
/// colors.
fn verdict(found: &PrecisionNeeds) -> String {
    let precision = found.precision.name();
    let row = |n: usize| &found.rows[n].view;
    let colors = match found.least {
        None => format!("In {precision}, no method draws every pixel right."),
        Some(n) => format!(
            "In {precision}, the least for colors is {}.",
            row(n).method.name
        ),
    };
    let distances = match found.least_of_t {
        None => "For distances, no method suffices.".to_owned(),
        Some(n) => format!("For distances, it is {}.", row(n).method.name),
    };
    let off = found.least.and_then(|n| row(n).off);
    match off.filter(|off| off.t > WITHIN) {
        None => format!("{colors} {distances}"),
        Some(off) => format!(
            "{colors} {distances} By the first, t is off by {} of itself.",
            part(off.t)
        ),
    }
}

fn part(part: f64) -> String {
    if part.is_infinite() {
        "> 1e308".to_owned()
    } else {
        three_digits(part)
    }
}

const TABLE_HEAD: &str = "
                           wrong   worst,     worst,    worst,
  method                  pixels   levels      radii         t  ÷ half_b
";

fn line(row: &RatedMethod, is_least: bool) -> String {
    let RatedMethod { view, ratio } = row;
    let mark = if is_least { "→" } else { " " };
    let [radii, t] = match view.off {
        None => ["-", "-"].map(str::to_owned),
        Some(off) => [off.radii, off.t].map(part),
    };
    format!(
        "{mark} {:<22}{:>8}{:>9}{radii:>11}{t:>10}{ratio:>10.2}\n",
        view.method.name, view.wrong, view.levels,
    )
}

/// Shows why the method of `row` fails: its first wrong pixel, with the ray and the sphere, beside
/// the answer of the `least` method that suffices.
fn why(row: &RatedMethod, least: Option<&RatedMethod>, culprit: &Culprit) -> String {
    let name = row.view.method.name;
    let [i, j] = culprit.pixel;
    let [drawn, right] = culprit
        .colors
        .map(|[red, green, blue]| format!("{red} {green} {blue}"));
    let which = match least {
        Some(least) if row.ratio < least.ratio => {
            format!("The next cheaper one is {name}: it fails")
        }
        Some(_) => format!("{name} costs no more, and fails"),
        None => format!("{name} comes nearest, and fails"),
    };
    let ray = if culprit.is_to_sun {
        "ray to the sun"
    } else {
        "ray of the camera"
    };
    let mut text = paragraph(&format!(
        "{which} first in column {i}, row {j}, where it draws {drawn} and {right} is right. \
         The {ray} there, and sphere {}, under the microscope:",
        culprit.sphere + 1
    ));
    let methods = [Some(row), least].into_iter().flatten();
    let methods: Vec<Method> = methods.map(|row| row.view.method).collect();
    let precision = row.view.method.precision();
    for line in hit::compare_methods(&culprit.case, precision, &methods, culprit.t_min).lines() {
        let _ = writeln!(text, "  {line}");
    }
    if least.is_none() && (culprit.is_shadow || culprit.error <= hit::ORDINARY) {
        text += &paragraph(cure(culprit, precision));
    }
    text + &again(culprit)
}

/// Names what helps where no method for one sphere does.
fn cure(culprit: &Culprit, precision: Precision) -> &'static str {
    match precision {
        _ if culprit.is_shadow => {
            "A better t would not help: the ray to the sun starts at a rounded point. \
             A larger t_min passes over the surface that it leaves."
        }
        Precision::Double => {
            "So t is as exact as an f64 can be there, but two spheres are nearer to each other. \
             certified_nearest of chapter 6 compares their roots, and draws the right picture."
        }
        Precision::Single => "So t is as exact as an f32 can be there: this picture needs f64.",
    }
}

/// Writes the command that shows the ray and the sphere by all methods.
fn again(culprit: &Culprit) -> String {
    let vector = |v: Vec3| v.to_array().map(|number| format!("{number:?}")).join(",");
    let Culprit { case, t_min, .. } = culprit;
    let range = if culprit.is_to_sun {
        format!(" --t-min={t_min:?}")
    } else {
        String::new()
    };
    format!(
        "  {} hit --origin={} --direction={} --center={} --radius={:?}{range}\n",
        companion_command(),
        vector(case.ray.origin),
        vector(case.ray.direction),
        vector(case.center),
        case.radius,
    )
}

fn paragraph(text: &str) -> String {
    // A size stays on one line.
    let text = text.replace(" × ", "\u{a0}×\u{a0}");
    let width = terminal::text_width();
    let options = Options::new(width)
        .break_words(false)
        .word_splitter(WordSplitter::NoHyphenation);
    textwrap::fill(&text, options).replace('\u{a0}', " ") + "\n"
}
