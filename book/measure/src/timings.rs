//! What `cargo bench -p measure --bench clock` measured with a clock: rows of a file.
//!
//! `book/notes/measured/timings.csv` begins with lines `# key: value` that say
//! on what machine, with what compiler and how it was measured. Then it is
//! comma-separated: a line of column names, and rows; no field is quoted.
//!
//! | column | |
//! |---|---|
//! | `what` | the kind of row, below |
//! | `name` | a method, or a way to keep spheres |
//! | `precision` | `f64` or `f32` |
//! | `where` | a regime, or `all_hits`: the rays of `book` that hit |
//! | `n` | how many at a time: rays, or spheres |
//! | `median_ns` | nanoseconds for one test, or for one ray; the median of all rounds |
//! | `least_ns`, `greatest_ns` | the same in the quickest and in the slowest round |
//! | `ratio` | the median, over rounds, of the time divided by that of `half_b` one by one on the same rays in the same round |
//!
//! | `what` | `name` | what one time is of |
//! |---|---|---|
//! | `method` | a method | one ray against one sphere, one after the other |
//! | `batch` | a method | the same by the loop over arrays that the compiler vectorizes |
//! | `limit` | `one_by_one`, `packed` | one √ and one ÷ that wait for nothing but the divider |
//! | `growth` | `boxed_list`, `vec`, `batch`, `bvh` | the nearest hit of one ray among `n` spheres |

use std::collections::BTreeMap;
use std::str::FromStr;

/// A file of timings.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Timings {
    /// The lines `# key: value` at the top.
    pub about: BTreeMap<String, String>,
    /// The rows.
    pub rows: Vec<Timing>,
}

/// A row: one thing that was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Timing {
    /// `method`, `batch`, `limit` or `growth`.
    pub what: String,
    /// A method, or a way to keep spheres.
    pub name: String,
    /// `f64` or `f32`.
    pub precision: String,
    /// A regime, or `all_hits`.
    pub place: String,
    /// How many at a time.
    pub n: usize,
    /// In nanoseconds: half of the rounds took less, half more.
    pub median: f64,
    /// In nanoseconds: the quickest round.
    pub least: f64,
    /// In nanoseconds: the slowest round.
    pub greatest: f64,
    /// How many times as long as `half_b`.
    pub ratio: f64,
}

/// The names of the columns.
pub const COLUMNS: &str = "what,name,precision,where,n,median_ns,least_ns,greatest_ns,ratio";

impl Timings {
    /// The file, which [`Timings::from_str`] reads.
    pub fn text(&self) -> String {
        let about = self.about.iter();
        let mut text: String = about
            .map(|(key, value)| format!("# {key}: {value}\n"))
            .collect();
        text += COLUMNS;
        text.push('\n');
        text.extend(self.rows.iter().map(|row| row.line() + "\n"));
        text
    }

    /// The row of that kind, name and place; for growth, of the largest n.
    pub fn find(&self, what: &str, name: &str, place: &str) -> Option<&Timing> {
        let same = |row: &&Timing| row.what == what && row.name == name && row.place == place;
        self.rows.iter().rfind(same)
    }
}

impl Timing {
    fn line(&self) -> String {
        let Self {
            what,
            name,
            precision,
            place,
            n,
            median,
            least,
            greatest,
            ratio,
        } = self;
        format!(
            "{what},{name},{precision},{place},{n},{median:.3},{least:.3},{greatest:.3},{ratio:.2}"
        )
    }
}

impl FromStr for Timings {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (head, body): (Vec<&str>, Vec<&str>) =
            text.lines().partition(|line| line.starts_with('#'));
        let about = head.iter().filter_map(|line| {
            let (key, value) = line.trim_start_matches("# ").split_once(": ")?;
            Some((key.to_owned(), value.to_owned()))
        });
        match body.split_first() {
            Some((&COLUMNS, rows)) => Ok(Self {
                about: about.collect(),
                rows: rows
                    .iter()
                    .map(|row| row.parse())
                    .collect::<Result<_, _>>()?,
            }),
            _ => Err(format!("the line of column names should be {COLUMNS}")),
        }
    }
}

impl FromStr for Timing {
    type Err = String;

    fn from_str(line: &str) -> Result<Self, String> {
        let fields: Vec<&str> = line.split(',').collect();
        let [
            what,
            name,
            precision,
            place,
            n,
            median,
            least,
            greatest,
            ratio,
        ] = fields[..]
        else {
            return Err(format!("a row has nine fields: {line}"));
        };
        let number = |field: &str| {
            let parsed = field.parse::<f64>();
            parsed.map_err(|_| format!("{field} is no number: {line}"))
        };
        Ok(Self {
            what: what.to_owned(),
            name: name.to_owned(),
            precision: precision.to_owned(),
            place: place.to_owned(),
            n: n.parse().map_err(|_| format!("{n} is no count: {line}"))?,
            median: number(median)?,
            least: number(least)?,
            greatest: number(greatest)?,
            ratio: number(ratio)?,
        })
    }
}
