//! The judge of the judge: what an answer is worth, beside the truth.
//!
//! What draws the same bytes as the truth is the truth too, by whatever name.

use check::diagnosis::{self, But, Chosen, Conversion, Explains, Near, Scene, Set, names_of};
use check::judge::{Check, Finding};
use common::rtweekend::*;
use slips::Chapter;
use slips::{Program, Slip};

use super::truth::{self, Case, Rays, Truth, changes_levels, is_a_rounding};

/// What an answer is worth, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Grade {
    /// It says the truth.
    Correct,
    /// It says nothing false, and not the truth.
    Unhelpful,
    /// It names a mistake that was not made, or a choice otherwise than it was.
    Misleading,
    /// It says that a wrong picture is right, that a right one is wrong, or what is not
    /// true of the pixels.
    False,
}

impl Grade {
    pub(super) const ALL: [Self; 4] = [
        Self::Correct,
        Self::Unhelpful,
        Self::Misleading,
        Self::False,
    ];
}

/// What the answer to a case is worth.
pub(super) fn grade(case: &Case, answer: &Check) -> Grade {
    match answer {
        Check::Right(right) => of_all(case, &right.scene),
        Check::Near(finding) => match &finding.diagnosis.near {
            Some(near) => of_near(case, near),
            None => Grade::False,
        },
        Check::Another { scenes, .. } => of_another(case, scenes),
        Check::Wrong(finding) => of_wrong(case, finding),
        Check::WrongShape { finding, .. } | Check::NotAPicture { finding, .. } => finding
            .as_ref()
            .map_or(Grade::False, |finding| of_wrong(case, finding)),
    }
}

/// Right by this scene, to the last bit.
fn of_all(case: &Case, scene: &Scene) -> Grade {
    match draws(case, &scene.program(&[]), Conversion::Clamped) {
        true => Grade::Correct,
        false => Grade::False,
    }
}

/// "Right, but": each thing that is said has to be so, and nothing else may be wrong.
fn of_near(case: &Case, near: &Near) -> Grade {
    let truth = &case.truth;
    let program = near.scene.program(&[]);
    if near.is_exact() {
        return of_all(case, &near.scene);
    }
    if may_have_chosen(case, &near.scene, &program) {
        return Grade::Correct;
    }
    let told = |is: fn(&But) -> bool| near.but.iter().any(is);
    let is_rounded = told(|but| matches!(but, But::Rounded { .. }));
    let is_on_a_curve = told(|but| matches!(but, But::Curve(_)));
    let is_antialiased = told(|but| matches!(but, But::Antialiased { .. }));
    // Several rays smear what is less than a pixel off.
    let are_smeared = || {
        let slipped = truth.program_with(&truth.slips);
        truth.rays.is_some() && of_edition(case, &slipped, &program) == Grade::Correct
    };
    let slips = truth.slips.iter().map(|slip| match is_on_a_curve {
        _ if is_less_exact(slip) || are_smeared() => Grade::Correct,
        true if changes_levels(slip) => Grade::Correct,
        // All that is off is off by a level: so it was said.
        _ if is_rounded => Grade::Unhelpful,
        _ => Grade::False,
    });
    let is_left_out =
        truth.rays.is_some() && !is_antialiased || truth.curve.is_some() && !is_on_a_curve;
    let left_out = is_left_out.then_some(Grade::Unhelpful);
    let said = near.but.iter().map(|but| of_but(truth, but));
    let own = truth.program_with(&[]);
    let beside = [of_colors(&own, &program), of_edition(case, &own, &program)];
    let all = slips.chain(left_out).chain(said).chain(beside);
    all.max().expect("there are some")
}

/// Whether own colors as they are told draw the picture but for single levels: then they
/// are the truth, though a slip turned what was chosen.
fn may_have_chosen(case: &Case, told: &Scene, program: &Program) -> bool {
    told.chosen != Chosen::default()
        && case.truth.scene.chosen != Chosen::default()
        && draws_within(case, program, Conversion::Clamped, 1)
}

fn of_but(truth: &Truth, but: &But) -> Grade {
    match but {
        But::Antialiased { samples } => match truth.rays {
            None => Grade::False,
            Some(rays) => of_samples(rays, *samples),
        },
        But::Curve(curve) => match truth.curve {
            None if truth.slips.iter().any(|slip| changes_levels(slip)) => Grade::Correct,
            None => Grade::False,
            Some(own) => of_curve(own, curve),
        },
        // Whether that is all is asked of slips, rays and curves.
        But::Rounded { .. } => Grade::Correct,
    }
}

/// The power has to be near, and so have the levels that are told.
fn of_curve(own: truth::Curve, told: &diagnosis::Curve) -> Grade {
    let is_power = told
        .power
        .is_none_or(|power| (power - own.power()).abs() <= 0.06);
    let becomes = |level: i16| 256.0 * own.apply((f64::from(level) + 0.5) / 256.0);
    let is_so = |level: i16| (becomes(level) - f64::from(told.apply(level))).abs() <= 6.0;
    match is_power && told.examples().all(|(level, _)| is_so(level)) {
        true => Grade::Correct,
        false => Grade::Misleading,
    }
}

/// A number of rays has to be right within a factor of two, if it is one that can be seen.
/// Of rays on a grid it is said that they may be fewer.
fn of_samples(rays: Rays, told: Option<f64>) -> Grade {
    let Some(told) = told else {
        return Grade::Correct;
    };
    let count = f64::from(rays.count);
    let is_near = match count {
        4.0.. if rays.on_a_grid => told >= count.min(100.0) / 2.0,
        4.0..100.0 => (count / 2.0..=2.0 * count).contains(&told),
        100.0.. => told >= 50.0,
        _ => told < 4.0,
    };
    match is_near {
        true => Grade::Correct,
        false => Grade::Misleading,
    }
}

/// Colors have to be told to a hundredth.
fn of_colors(own: &Program, told: &Program) -> Grade {
    let far = |own: Color, told: Color| (own - told).abs().max_element();
    let far = match own.chapter {
        Chapter::BuildTest => (own.blue - told.blue).abs(),
        _ => far(own.sky[0], told.sky[0])
            .max(far(own.sky[1], told.sky[1]))
            .max(far(own.paint, told.paint)),
    };
    match far {
        // A little more, since they are rounded.
        ..0.0101 => Grade::Correct,
        ..0.03 => Grade::Unhelpful,
        _ => Grade::Misleading,
    }
}

/// An edition whose rays see something else is another one: but several rays smear edges,
/// and nobody can tell where in a pixel they began.
fn of_edition(case: &Case, own: &Program, told: &Program) -> Grade {
    let [Some(own), Some(told)] = [own, told].map(|program| colors(case, program)) else {
        return Grade::Misleading;
    };
    let is_far = |(own, told): &(&Color, &Color)| (**own - **told).abs().max_element() > 0.03;
    let far = own.iter().zip(&told).filter(is_far).count();
    match 50 * far <= own.len() {
        true => Grade::Correct,
        false => Grade::Misleading,
    }
}

/// What the program sees in each pixel, in the colors of the book, if its picture has the
/// right size.
fn colors(case: &Case, program: &Program) -> Option<Vec<Color>> {
    let (width, height) = (case.reading.width, case.reading.height);
    if program.run(width).size() != (width, height) {
        return None;
    }
    let Program { sky, paint, .. } = Program::right(program.chapter);
    let program = Program {
        sky,
        paint,
        blue: 0.0,
        ..*program
    };
    let camera = program.camera(width);
    let places = (0..height).flat_map(|j| (0..width).map(move |i| (i, j)));
    let color = |(i, j)| (program.color)(&program, &camera, i, j);
    Some(places.map(color).collect())
}

/// Whether the slip is no more than another way of rounding, or less precision.
fn is_less_exact(slip: &Slip) -> bool {
    is_a_rounding(slip) || slip.name == "single-precision"
}

fn of_another(case: &Case, scenes: &[Scene]) -> Grade {
    let truth = &case.truth;
    let is_it = |scene: &Scene| {
        (scene.chapter, scene.probe) == (truth.scene.chapter, truth.scene.probe)
            && truth.slips.is_empty()
    };
    // To within a level, as it was looked for.
    let draws_it = |scene: &Scene| draws_within(case, &scene.program(&[]), Conversion::Clamped, 1);
    if scenes.iter().any(is_it) && !truth.is_as_asked() {
        Grade::Correct
    } else if scenes.iter().any(draws_it) {
        match truth.is_as_asked() {
            true => Grade::Unhelpful,
            false => Grade::Correct,
        }
    } else {
        Grade::False
    }
}

fn of_wrong(case: &Case, finding: &Finding) -> Grade {
    let truth = &case.truth;
    let sets = &finding.diagnosis.sets;
    if finding
        .diagnosis
        .sights
        .iter()
        .any(|said| !is_so(finding, said))
    {
        return Grade::False;
    }
    let draws_it = sets.first().is_some_and(|set| set_draws(case, set));
    if truth.is_right() {
        // What is right in a shape of its own has another than the book's, and may be what
        // a slip draws as well.
        return match truth.has_own_shape() {
            true if draws_it || sets.is_empty() => Grade::Unhelpful,
            true => Grade::Misleading,
            false => Grade::False,
        };
    }
    let may_have_chosen = |set: &Set| {
        let program = set.scene.program(&set.mistakes[0]);
        may_have_chosen(case, &set.scene, &program)
    };
    if draws_it || sets.first().is_some_and(may_have_chosen) {
        return Grade::Correct;
    }
    match sets.iter().position(|set| is_named_by(truth, set)) {
        Some(0) => of_what_is_beside(truth, &sets[0]),
        // A slip in the levels is a curve, by another name.
        None if truth.slips.is_empty() && sets.first().is_some_and(is_a_curve) => {
            match (truth.curve, truth.rays) {
                (Some(_), None) if sets[0].is_enough() => Grade::Correct,
                (Some(_), _) => Grade::Unhelpful,
                (None, _) => Grade::Misleading,
            }
        }
        Some(_) => Grade::Unhelpful,
        None if sets.iter().all(|set| is_a_part(truth, set)) => Grade::Unhelpful,
        None => Grade::Misleading,
    }
}

/// Whether one of the set's mistakes draws the very picture.
fn set_draws(case: &Case, set: &Set) -> bool {
    let draws_it = |mistake: &Vec<&Slip>| draws(case, &set.scene.program(mistake), set.conversion);
    set.is_exact() && set.mistakes.iter().any(draws_it)
}

/// Whether the program prints the picture's numbers.
fn draws(case: &Case, program: &Program, conversion: Conversion) -> bool {
    draws_within(case, program, conversion, 0)
}

/// Whether it prints them, but for so many levels.
fn draws_within(case: &Case, program: &Program, conversion: Conversion, levels: u16) -> bool {
    let reading = &case.reading;
    let size = (reading.width, reading.height);
    let outputs = [reading.width, reading.height].map(|width| program.run(width));
    let Some(output) = outputs.into_iter().find(|output| output.size() == size) else {
        return false;
    };
    let in_file = |level: i32| match conversion {
        Conversion::Printed => level.clamp(i16::MIN.into(), i16::MAX.into()) as i16,
        Conversion::Clamped => level.clamp(0, 255) as i16,
        Conversion::Wrapped => i16::from(level as u8),
    };
    output.pixels().zip(&reading.pixels).all(|(drawn, found)| {
        let mut pairs = drawn.map(in_file).into_iter().zip(*found);
        pairs.all(|(drawn, found)| drawn.abs_diff(found) <= levels)
    })
}

/// Whether the truth's slips are one of the set's mistakes, by name in this edition, or
/// by what they draw with one ray a pixel.
fn is_named_by(truth: &Truth, set: &Set) -> bool {
    let names = |slips: &[&Slip]| {
        let mut names: Vec<&str> = slips.iter().map(|slip| slip.name).collect();
        names.sort_unstable();
        names
    };
    let own = names(&truth.slips);
    // Several rays smear what sets the editions apart.
    let may_be_edition =
        truth.rays.is_some() || set.scene.edition.name() == truth.scene.edition.name();
    let mut scene = set.scene;
    scene.chosen = truth.scene.chosen;
    let plain = truth.plain();
    let draws_it = |mistake: &[&Slip]| {
        let output = scene.program(mistake).run(plain.width);
        output.size() == (plain.width, plain.height)
            && output.pixels().eq(plain.pixels.iter().copied())
    };
    let is_it =
        |mistake: &Vec<&'static Slip>| may_be_edition && names(mistake) == own || draws_it(mistake);
    !truth.slips.is_empty() && set.mistakes.iter().any(is_it)
}

fn is_a_curve(set: &Set) -> bool {
    let changes_levels = |slip: &&Slip| changes_levels(slip) && !is_a_rounding(slip);
    let mut mistakes = set.mistakes.iter();
    mistakes.any(|mistake| mistake.iter().all(changes_levels))
}

/// Whether all that the set names was done, if not all that was done is named.
fn is_a_part(truth: &Truth, set: &Set) -> bool {
    let was_made = |slip: &&Slip| truth.slips.iter().any(|own| own.name == slip.name);
    let mut mistakes = set.mistakes.iter();
    mistakes.any(|mistake| mistake.iter().all(was_made))
}

/// The slips are named: and the rays, the curve, the colors?
fn of_what_is_beside(truth: &Truth, set: &Set) -> Grade {
    let are_rays_told = truth.rays.is_none() || set.explains == Explains::Antialiased;
    let colors = of_colors(&truth.program_with(&[]), &set.scene.program(&[]));
    match are_rays_told && truth.curve.is_none() && colors == Grade::Correct {
        true => Grade::Correct,
        false => Grade::Unhelpful,
    }
}

/// Where a place comes from, in a picture of so many columns and rows.
type Turn = fn((u32, u32), (u32, u32)) -> (u32, u32);

/// Whether a sentence that says that the picture is turned is true: of what is the same
/// both ways it is not.
fn is_so(finding: &Finding, said: &str) -> bool {
    let (width, height) = (finding.right.width(), finding.right.height());
    let turn: Turn = if said.contains("is upside down") {
        |(i, j), (_, height)| (i, height - 1 - j)
    } else if said.contains("is mirrored") {
        |(i, j), (width, _)| (width - 1 - i, j)
    } else if said.contains("by half a turn") {
        |(i, j), (width, height)| (width - 1 - i, height - 1 - j)
    } else if said.contains("is transposed") {
        |(i, j), _| (j, i)
    } else {
        return true;
    };
    let at = |picture: &Picture, (i, j): (u32, u32)| {
        let n = 3 * (j * width + i) as usize;
        [0, 1, 2].map(|channel| picture.rgb()[n + channel])
    };
    let are_near = |one: [u8; 3], other: [u8; 3]| {
        let mut pairs = one.iter().zip(other);
        pairs.all(|(one, other)| one.abs_diff(other) <= 2)
    };
    let places = || (0..height).flat_map(|j| (0..width).map(move |i| (i, j)));
    let turned = |place| at(&finding.right, turn(place, (width, height)));
    let all = places().count();
    let shown = places().filter(|&place| are_near(turned(place), at(&finding.yours, place)));
    let same = places().filter(|&place| are_near(turned(place), at(&finding.right, place)));
    10 * shown.count() >= 9 * all && 100 * same.count() <= 97 * all
}

/// The answer in a line.
pub(super) fn said(answer: &Check) -> String {
    match answer {
        Check::Right(right) => format!("right{}", right.scene.edition.said()),
        Check::Another { cause, .. } => cause.problem.clone(),
        Check::Near(finding) => {
            let near = finding.diagnosis.near.as_ref();
            let told = near.map(Near::told).unwrap_or_default();
            let edition = near.map_or(String::new(), |near| near.scene.edition.said());
            format!("right{edition}, but {told}")
        }
        Check::Wrong(finding) => format!("wrong: {}", first_words(finding)),
        Check::WrongShape { cause, finding } | Check::NotAPicture { cause, finding } => {
            let finding = finding.as_deref().map(first_words).unwrap_or_default();
            format!("{}: {finding}", cause.name)
        }
    }
}

fn first_words(finding: &Finding) -> String {
    let pixels = finding.right.rgb().len() / 3;
    let sets = finding.diagnosis.sets.iter().map(|set| {
        let names: Vec<String> = set
            .mistakes
            .iter()
            .take(3)
            .map(|mistake| names_of(mistake))
            .collect();
        let edition = set.scene.edition.said();
        format!("{} {}{edition}", set.title(pixels), names.join(" | "))
    });
    let sights = finding.diagnosis.sights.iter().take(2).cloned();
    sets.chain(sights).collect::<Vec<_>>().join("; ")
}
