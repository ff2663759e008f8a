//! Ramps: a build test whose components are the reader's own, each rising or falling in a straight
//! line along columns or rows, or the same everywhere.

use ::slips::Chapter;

use super::colors::is_rescaled;
use super::{Evidence, Explanation, Hypothesis, Seen, spread};
use crate::bits::{Pixel, commonest, number};
use crate::reading::Reading;

/// That the components are others: less likely than a slip.
const NAME: f64 = 14.0;
/// One of 32 ramps.
const RAMP: f64 = 5.0;
/// How many pixels choose the ramps.
const LOOK: u32 = 400;

/// What a component is.
#[derive(Clone, Copy)]
enum Component {
    /// The same everywhere.
    Level(i16),
    Ramp {
        is_across: bool,
        is_falling: bool,
        /// Whether it is divided by the other size.
        is_by_other: bool,
        /// From which number on pixels are counted.
        first: u32,
        /// By how much less than their count they are divided.
        less: u32,
    },
}

/// The picture as three ramps, in whatever scale of the levels is the nearest.
pub(crate) fn ramps(evidence: &Evidence, right: &Hypothesis) -> Option<Explanation> {
    let reading = evidence.reading;
    if right.scene.chapter != Chapter::BuildTest || evidence.has_no_levels || reading.is_plain() {
        return None;
    }
    let program = right.scene.program(&[]);
    let slips = evidence.slips(&right.scene);
    let slips = slips.filter(|slip| is_rescaled(&program, &slip.put_to(program)));
    let scaled = slips.map(|slip| {
        let wrong = evidence.known.words(slip, &right.scene).wrong;
        (slip.put_to(program).level, Some(wrong))
    });
    let nearest = |(level, line)| {
        let found = [0, 1, 2].map(|channel| nearest(reading, channel, level));
        let off: usize = found.iter().map(|(off, _)| off).sum();
        (off, found.map(|(_, component)| component), level, line)
    };
    let all = [(program.level, None)]
        .into_iter()
        .chain(scaled)
        .map(nearest);
    let (_, components, level, line) = all.min_by_key(|(off, ..)| *off)?;
    let pixel = |n| components.map(|it| it.level(n, reading, level));
    let drawn: Vec<Pixel> = (0..reading.pixels.len() as u32).map(pixel).collect();
    let mut explanation = right.explaining(reading, &drawn);
    let names = components.map(Component::name).iter().sum::<f64>();
    explanation.name = NAME + names + line.as_ref().map_or(0.0, |_| RAMP);
    let rest = match explanation.left.off {
        0 => String::new(),
        _ => format!(", but for {}", explanation.left.placed(drawn.len())),
    };
    let said = said(components, reading, line.as_deref(), &rest);
    explanation.seen = Some(Seen::Said(said));
    Some(explanation)
}

/// What leaves fewest levels of a channel wrong, and how many of those that are looked at.
fn nearest(reading: &Reading, channel: usize, level: fn(f64) -> i32) -> (usize, Component) {
    let places: Vec<u32> = spread(LOOK, reading.pixels.len() as u32).collect();
    let found = |n: u32| reading.pixels[n as usize][channel];
    let off = |it: &Component| {
        let is_off = |n: &&u32| it.level(**n, reading, level) != found(**n);
        places.iter().filter(is_off).count()
    };
    let [common, ..] = commonest(places.iter().map(|n| [found(*n); 3]));
    let all = [Component::Level(common)]
        .into_iter()
        .chain(Component::ramps());
    let all = all.map(|it| (off(&it), it));
    all.min_by_key(|(off, _)| *off).expect("there is a level")
}

impl Component {
    fn ramps() -> impl Iterator<Item = Self> {
        (0..32).map(|n| Self::Ramp {
            is_by_other: n & 16 > 0,
            is_across: n & 1 == 0,
            is_falling: n & 2 > 0,
            first: u32::from(n & 4 > 0),
            less: u32::from(n & 8 == 0),
        })
    }

    fn level(self, n: u32, reading: &Reading, level: fn(f64) -> i32) -> i16 {
        match self {
            Self::Level(same) => same,
            Self::Ramp {
                is_across,
                is_falling,
                is_by_other,
                first,
                less,
            } => {
                let (count, other) = sizes(reading, is_across);
                let whole = if is_by_other { other } else { count };
                let at = match is_across {
                    true => n % reading.width,
                    false => n / reading.width,
                };
                let at = if is_falling { count - 1 - at } else { at };
                let component = f64::from(at + first) / f64::from((whole - less).max(1));
                level(component).clamp(0, 255) as i16
            }
        }
    }

    fn name(self) -> f64 {
        match self {
            Self::Level(same) => number(f64::from(same) / 255.0),
            Self::Ramp { .. } => RAMP,
        }
    }

    fn said(self, reading: &Reading) -> String {
        match self {
            Self::Level(same) => format!("is {same} everywhere"),
            Self::Ramp {
                is_across,
                is_falling,
                is_by_other,
                first,
                less,
            } => {
                let ways = match is_across {
                    true => ["to the right", "to the left"],
                    false => ["downwards", "upwards"],
                };
                let way = ways[usize::from(is_falling)];
                let (count, other) = sizes(reading, is_across);
                let whole = if is_by_other { other } else { count };
                let whole = (whole - less).max(1);
                let last = count - 1 + first;
                format!("rises {way} from {first}/{whole} to {last}/{whole}")
            }
        }
    }
}

/// How many pixels lie along the ramp, and how many across it.
fn sizes(reading: &Reading, is_across: bool) -> (u32, u32) {
    match is_across {
        true => (reading.width, reading.height),
        false => (reading.height, reading.width),
    }
}

fn said(components: [Component; 3], reading: &Reading, line: Option<&str>, rest: &str) -> String {
    let [red, green, blue] = components.map(|it| it.said(reading));
    let scaled = line.map_or(String::new(), |line| format!(", and levels are {line}"));
    format!(
        "Each component is a ramp of its own: red {red}, green {green}, and blue {blue}{scaled}{rest}."
    )
}
