//! TOML: a scene as a person writes it, and where it is wrong.
//!
//! ```toml
//! width = 400             # pixels; the picture is 16:9
//! sun = [1, 0.25, 0.5]    # towards it; without it nothing has a shadow
//!
//! [camera]                # all of it may be left out
//! origin = [0, 0, 0]
//! direction = [0, 0, -1]  # of any length
//! zoom = 1                # or [across, up]
//!
//! [[sphere]]              # as often as there are spheres
//! center = [0, 0, -1]
//! radius = 0.5
//! ```

use std::fmt;
use std::ops::{Range, RangeInclusive};

use common::rtweekend::*;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::scenes::{Lens, Scene};

/// The widest picture that is drawn by every method, in pixels. All of these pictures
/// together take half a gigabyte then.
pub const WIDEST: u32 = 3840;

/// The most spheres. Each method is asked about each of them in each pixel: ten
/// thousand take minutes in the smallest picture.
const MOST_SPHERES: usize = 10_000;

/// How far a lens may zoom, either way. The directions of all rays are finite then.
const ZOOMS: RangeInclusive<f64> = 1e-300..=1e300;

/// What is wrong with a file, where, and what helps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// Counted from 1, as editors do.
    pub line: usize,
    /// In characters, from 1.
    pub column: usize,
    /// What is wrong, without a stop at the end.
    pub what: String,
    /// What to write instead, as a sentence.
    pub fix: String,
    /// The line, or as much of it as can be shown, and below it a caret.
    excerpt: String,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, column, .. } = self;
        writeln!(f, "{line}:{column}: {}", self.what)?;
        write!(f, "{}{}", self.excerpt, self.fix)
    }
}

impl Scene {
    /// The scene in `text`, the content of a file.
    ///
    /// # Errors
    /// The first mistake: what is no TOML, a key that is not known or is missing,
    /// or a number that is out of range. All numbers of a scene are finite.
    pub fn read(name: &str, text: &str) -> Result<Self, Mistake> {
        read(name, text).map_err(|wrong| wrong.shown_in(text))
    }
}

fn read(name: &str, text: &str) -> Result<Scene, Wrong> {
    let document = DeTable::parse(text).map_err(|error| syntax(text, &error))?;
    let document = Spanned::new(0..0, DeValue::Table(document.into_inner()));
    let mut keys = Keys::of(document, "scene", &["width", "sun", "camera", "sphere"])?;
    Ok(Scene {
        name: name.to_owned(),
        width: keys.may_have("width", width)?.unwrap_or(400),
        sun: keys.may_have("sun", direction)?,
        lens: keys.may_have("camera", lens)?.unwrap_or_default(),
        spheres: keys
            .take("sphere")
            .ok_or_else(|| wrong(0..0, "there is no sphere", EXAMPLE))
            .and_then(spheres)?,
    })
}

const EXAMPLE: &str = "A scene is a line [[sphere]] for each sphere, and below it two lines \
    such as center = [0, 0, -1] and radius = 0.5.";

/// What is not even TOML. Its reader has words for what it expected, and none for what
/// a scene needs.
fn syntax(text: &str, error: &toml::de::Error) -> Wrong {
    let span = error.span().unwrap_or_default();
    let before = &text[..text.floor_char_boundary(span.start)];
    let is_in_line = before
        .rsplit('\n')
        .next()
        .is_some_and(|line| line.contains('='));
    let fix = match error.message() {
        "duplicate key" => "Keep one of them. Each sphere begins with a [[sphere]] of its own.",
        _ if is_in_line => "After the = stands a number, such as 0.5, -3 or 1e-9, or [x, y, z].",
        _ => EXAMPLE,
    };
    wrong(span, format!("this is no TOML: {}", error.message()), fix)
}

/// What is wrong in which bytes of the text.
struct Wrong {
    span: Range<usize>,
    what: String,
    fix: String,
}

fn wrong(span: Range<usize>, what: impl Into<String>, fix: impl Into<String>) -> Wrong {
    let (what, fix) = (what.into(), fix.into());
    Wrong { span, what, fix }
}

type Value<'a> = Spanned<DeValue<'a>>;

/// A table whose keys are taken one by one.
struct Keys<'a> {
    table: DeTable<'a>,
    of: &'static str,
    span: Range<usize>,
}

impl<'a> Keys<'a> {
    /// The table that is `value`, all of whose keys are `known`.
    fn of(value: Value<'a>, of: &'static str, known: &[&str]) -> Result<Self, Wrong> {
        let span = value.span();
        let DeValue::Table(table) = value.into_inner() else {
            let fix = match of {
                "sphere" => EXAMPLE.to_owned(),
                _ => format!("Write [{of}] on a line of its own, and its keys below."),
            };
            return Err(wrong(span, format!("this is no {of}"), fix));
        };
        let unknown = table
            .keys()
            .filter(|key| !known.contains(&key.get_ref().as_ref()));
        if let Some(key) = unknown.min_by_key(|key| key.span().start) {
            let fix = match key.get_ref().as_ref() {
                "sun" | "width" => "Write it above the first line with brackets: what is below \
                    belongs to them."
                    .to_owned(),
                _ => format!("A {of} may have: {}.", known.join(", ")),
            };
            let what = format!("`{}` is no key of a {of}", key.get_ref());
            return Err(wrong(key.span(), what, fix));
        }
        Ok(Self { table, of, span })
    }

    fn take(&mut self, key: &str) -> Option<Value<'a>> {
        self.table.remove(key)
    }

    fn may_have<T>(
        &mut self,
        key: &str,
        read: fn(Value) -> Result<T, Wrong>,
    ) -> Result<Option<T>, Wrong> {
        self.take(key).map(read).transpose()
    }

    fn must_have<T>(&mut self, key: &str, read: fn(Value) -> Result<T, Wrong>) -> Result<T, Wrong> {
        let value = self.take(key).ok_or_else(|| {
            let what = format!("this {} has no {key}", self.of);
            wrong(self.span.clone(), what, EXAMPLE)
        })?;
        read(value)
    }
}

fn spheres(value: Value) -> Result<Vec<(Point3, f64)>, Wrong> {
    let span = value.span();
    match value.into_inner() {
        DeValue::Array(array) if array.is_empty() => {
            Err(wrong(span, "there is no sphere", EXAMPLE))
        }
        DeValue::Array(array) if array.len() > MOST_SPHERES => {
            let what = format!("there are {} spheres", array.len());
            Err(wrong(span, what, format!("Keep {MOST_SPHERES} at most.")))
        }
        DeValue::Array(array) => array.into_iter().map(sphere).collect(),
        _ => Err(wrong(
            span,
            "one pair of brackets is for one thing",
            EXAMPLE,
        )),
    }
}

fn sphere(value: Value) -> Result<(Point3, f64), Wrong> {
    let mut keys = Keys::of(value, "sphere", &["center", "radius"])?;
    Ok((
        keys.must_have("center", vector)?,
        keys.must_have("radius", radius)?,
    ))
}

/// Below 0 too: the same sphere, with the normal inwards.
fn radius(value: Value) -> Result<f64, Wrong> {
    match number(&value)? {
        0.0 => Err(wrong(
            value.span(),
            "a sphere of radius 0 is a point, which no picture shows",
            "Write a radius above 0, or below for a sphere that is colored inside out.",
        )),
        radius => Ok(radius),
    }
}

fn lens(value: Value) -> Result<Lens, Wrong> {
    let mut keys = Keys::of(value, "camera", &["origin", "direction", "zoom"])?;
    let origin = keys.may_have("origin", vector)?.unwrap_or(Point3::ZERO);
    let forward = keys.may_have("direction", direction)?;
    let zoom = keys.may_have("zoom", zooms)?.unwrap_or([1.0; 2]);
    Ok(Lens::new(origin, forward.unwrap_or(Vec3::NEG_Z), zoom))
}

/// The same both ways, or two of them.
fn zooms(value: Value) -> Result<[f64; 2], Wrong> {
    const FIX: &str = "Write zoom = 2, or two such numbers: zoom = [across, up].";
    match value.get_ref() {
        DeValue::Array(array) => match &array[..] {
            [across, up] => Ok([zoom(across)?, zoom(up)?]),
            _ => Err(wrong(value.span(), "a zoom is one number or two", FIX)),
        },
        _ => zoom(&value).map(|zoom| [zoom; 2]),
    }
}

fn zoom(value: &Value) -> Result<f64, Wrong> {
    let zoom = number(value)?;
    ZOOMS.contains(&zoom).then_some(zoom).ok_or_else(|| {
        wrong(
            value.span(),
            "no lens zooms like that",
            "Write a number above 0: 1 is the book's view, 2 shows everything twice as large. \
             It may be from 1e-300 to 1e300.",
        )
    })
}

fn width(value: Value) -> Result<u32, Wrong> {
    let width = match value.get_ref() {
        DeValue::Integer(width) if width.radix() == 10 => width.as_str().parse().ok(),
        _ => None,
    };
    let possible = width.filter(|width| (1..=WIDEST).contains(width));
    possible.ok_or_else(|| {
        wrong(
            value.span(),
            "no picture is so wide",
            format!("Write a whole number of pixels from 1 to {WIDEST}, such as 400."),
        )
    })
}

fn direction(value: Value) -> Result<Vec3, Wrong> {
    let span = value.span();
    match vector(value)? {
        Vec3::ZERO => Err(wrong(
            span,
            "a direction of length 0 points nowhere",
            "At least one of the three numbers must not be 0, as in [0, 0, -1].",
        )),
        direction => Ok(direction),
    }
}

fn vector(value: Value) -> Result<Vec3, Wrong> {
    match value.get_ref() {
        DeValue::Array(array) => match &array[..] {
            [x, y, z] => return Ok(Vec3::new(number(x)?, number(y)?, number(z)?)),
            others => Err(format!(
                "three numbers are needed, and these are {}",
                others.len()
            )),
        },
        _ => Err("three numbers are needed".to_owned()),
    }
    .map_err(|what| wrong(value.span(), what, "Write [x, y, z], such as [0, 0, -1]."))
}

/// The `f64` nearest to a decimal number.
fn number(value: &Value) -> Result<f64, Wrong> {
    let text = match value.get_ref() {
        DeValue::Integer(integer) if integer.radix() == 10 => Some(integer.as_str()),
        DeValue::Float(float) => Some(float.as_str()),
        _ => None,
    };
    match text.and_then(|text| text.parse::<f64>().ok()) {
        Some(number) if number.is_finite() => Ok(number),
        Some(number) if !number.is_nan() && !text.is_some_and(|text| text.contains("inf")) => {
            Err(wrong(
                value.span(),
                "this is too large for a number",
                "The largest is 1.7976931348623157e308.",
            ))
        }
        _ => Err(wrong(
            value.span(),
            "this is no number",
            "Write one such as 0.5, -3 or 1e-9, without quotation marks.",
        )),
    }
}

impl Wrong {
    /// With line, column and excerpt.
    fn shown_in(self, text: &str) -> Mistake {
        let start = text.floor_char_boundary(self.span.start);
        let end = text.floor_char_boundary(self.span.end.max(start));
        let before = &text[..start];
        let begin = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = before.matches('\n').count() + 1;
        let column = text[begin..start].chars().count() + 1;
        let whole = text[begin..].lines().next().unwrap_or_default();
        let carets = text[start..end].lines().next().unwrap_or_default();
        Mistake {
            line,
            column,
            what: self.what,
            fix: self.fix,
            excerpt: excerpt(line, whole, column, carets.chars().count()),
        }
    }
}

/// The most characters of a line that are shown.
const SHOWN: usize = 72;

/// The line with carets below `count` characters from `column` on.
fn excerpt(line: usize, whole: &str, column: usize, count: usize) -> String {
    let skipped = if column > SHOWN {
        column - SHOWN / 2
    } else {
        0
    };
    let plain = |c: char| if c.is_control() { ' ' } else { c };
    let shown: String = whole.chars().skip(skipped).take(SHOWN).map(plain).collect();
    let number = line.to_string();
    let margin = " ".repeat(number.len());
    let before = " ".repeat(column - 1 - skipped);
    let carets = "^".repeat(count.clamp(1, SHOWN / 2));
    format!("  {number} | {shown}\n  {margin} | {before}{carets}\n")
}
