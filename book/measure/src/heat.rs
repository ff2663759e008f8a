//! What a race against C++ measured: as a line of text.

use std::str::FromStr;

/// Our program and the C++ rival drew the same picture in turns.
#[derive(Clone, Debug, PartialEq)]
pub struct Heat {
    /// The picture.
    pub chapter: String,
    /// Its width in pixels.
    pub width: u32,
    /// Where the text went: `nowhere`, or into a `file`.
    pub to: String,
    /// How long our program took, from start to end.
    pub ours: Spread,
    /// How long the rival took.
    pub rival: Spread,
}

/// What came out when something was measured several times, in milliseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Half took less, half took more.
    pub median: f64,
    /// The shortest time.
    pub least: f64,
    /// The longest time.
    pub greatest: f64,
}

impl Spread {
    /// The spread of an odd number of `times`.
    pub fn of(mut times: Vec<f64>) -> Self {
        times.sort_by(f64::total_cmp);
        Self {
            median: times[times.len() / 2],
            least: times[0],
            greatest: times[times.len() - 1],
        }
    }
}

impl Heat {
    /// How many times as long the rival takes.
    pub fn ratio(&self) -> f64 {
        self.rival.median / self.ours.median
    }

    /// The heat as a line, which [`Heat::from_str`] reads.
    pub fn line(&self) -> String {
        let Self {
            chapter,
            width,
            to,
            ours,
            rival,
        } = self;
        format!(
            "{chapter} {width} {to} {:.2} {:.2} {:.2} {:.2} {:.2} {:.2}",
            ours.median, ours.least, ours.greatest, rival.median, rival.least, rival.greatest
        )
    }
}

impl FromStr for Heat {
    type Err = String;

    fn from_str(line: &str) -> Result<Self, String> {
        let words: Vec<&str> = line.split(' ').collect();
        let [chapter, width, to, times @ ..] = &words[..] else {
            return Err(format!("a heat has nine words: {line}"));
        };
        let times: Vec<f64> = times.iter().filter_map(|time| time.parse().ok()).collect();
        let [a, b, c, d, e, f] = times[..] else {
            return Err(format!("a heat has six times: {line}"));
        };
        let spread = |median, least, greatest| Spread {
            median,
            least,
            greatest,
        };
        Ok(Self {
            chapter: (*chapter).to_owned(),
            width: width
                .parse()
                .map_err(|_| format!("{width} is no width: {line}"))?,
            to: (*to).to_owned(),
            ours: spread(a, b, c),
            rival: spread(d, e, f),
        })
    }
}
