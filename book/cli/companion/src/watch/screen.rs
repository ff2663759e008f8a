//! One screen: both pictures small, the verdict, its cause, and what is next.

use std::io::{IsTerminal, stdout};
use std::time::Duration;
use std::{env, iter};

use check::names;
use check::whole::{Line, Verdict};

use crate::check::Style;
use crate::terminal::{self, Palette};
use crate::wrap::{filled, text_width};

/// No more lines than this, whatever there is to say.
const MOST_LINES: usize = 25;

/// How large each picture is, in characters.
const PICTURE: (u32, u32) = (32, 9);

/// The screen as text; on a terminal it replaces the one before.
pub(super) fn compose(title: &str, verdict: &Verdict, news: &[String], took: Duration) -> String {
    let mut lines = vec![head(title, took)];
    lines.extend(pictures(verdict));
    let headline = filled(&names::visible(&verdict.headline), text_width(), "", "");
    lines.extend(headline.lines().map(|line| colored(line, verdict)));
    let next = match verdict.next.as_str() {
        "" => Vec::new(),
        next => wrapped("next", next),
    };
    let done = news.iter().flat_map(|thing| wrapped("done", thing));
    let below: Vec<String> = next.into_iter().chain(done).collect();
    let above: usize = lines.iter().chain(&below).map(|line| rows(line)).sum();
    let cause = verdict.cause.iter().flat_map(as_lines).collect();
    lines.extend(clipped(cause, most_lines().saturating_sub(above)));
    lines.extend(below);
    let clear = if replaces_the_last() {
        "\x1b[2J\x1b[H"
    } else {
        ""
    };
    format!("{clear}{}\n", lines.join("\n"))
}

/// Whether each screen takes the place of the one before: on a terminal that can.
pub(super) fn replaces_the_last() -> bool {
    stdout().is_terminal()
        && env::var_os("TERM").is_some_and(|term| term != "dumb" && !term.is_empty())
}

/// Whether nobody reads any more what is printed, as behind `| head -1`.
pub(super) fn is_closed() -> bool {
    #[cfg(unix)]
    {
        use rustix::event::{PollFd, PollFlags, Timespec, poll};
        let stdout = stdout();
        let mut asked = [PollFd::new(&stdout, PollFlags::empty())];
        let at_once = Timespec::default();
        let broken = PollFlags::ERR | PollFlags::NVAL | PollFlags::HUP;
        poll(&mut asked, Some(&at_once)).is_ok() && asked[0].revents().intersects(broken)
    }
    #[cfg(not(unix))]
    false
}

/// What is judged, and how long that took.
fn head(title: &str, took: Duration) -> String {
    let style = Style::of_stdout();
    let took = format!("judged in {:.1} s", took.as_secs_f64());
    format!("{}  {}", style.bold(title), style.dim(&took))
}

/// As many of the lines as there is room for, with a mark where some are left out.
fn clipped(lines: Vec<String>, room: usize) -> Vec<String> {
    if lines.iter().map(|line| rows(line)).sum::<usize>() <= room {
        return lines;
    }
    let mut used = 1;
    let fits = |line: &String| {
        used += rows(line);
        used <= room
    };
    let fitting = lines.into_iter().take_while(fits);
    fitting.chain(iter::once("…".to_owned())).collect()
}

/// How many lines of the terminal the line fills.
fn rows(line: &str) -> usize {
    let columns = terminal_size::terminal_size().map_or(usize::MAX, |(width, _)| width.0.into());
    textwrap::core::display_width(line).div_ceil(columns).max(1)
}

/// A line is left for the cursor.
fn most_lines() -> usize {
    let lines = terminal_size::terminal_size().map(|(_, height)| usize::from(height.0));
    lines.map_or(MOST_LINES, |lines| MOST_LINES.min(lines.saturating_sub(1)))
}

fn colored(line: &str, verdict: &Verdict) -> String {
    let style = Style::of_stdout();
    if verdict.is_right {
        style.green(line)
    } else {
        style.bold(line)
    }
}

/// Yours at the left, and at the right what it should be.
fn pictures(verdict: &Verdict) -> Vec<String> {
    let (Some(palette), Some((yours, right))) = (Palette::of_stdout(), &verdict.pictures) else {
        return Vec::new();
    };
    if text_width() < 70 {
        return Vec::new();
    }
    let (columns, rows) = PICTURE;
    let [yours, right] = [yours, right].map(|it| terminal::lines(it, palette, columns, 2 * rows));
    let both = yours.iter().zip(&right);
    let mut lines: Vec<String> = both
        .map(|(yours, right)| format!("{yours}  {right}"))
        .collect();
    let label = format!("{:<34}{}", "yours", "what it should be");
    lines.push(label);
    lines
}

fn as_lines(line: &Line) -> Vec<String> {
    match line {
        Line::Labeled(label, text) => wrapped(label, text),
        Line::Printed(line) => vec![line.clone()],
    }
}

/// The text in as many lines as it takes, with the label before the first.
fn wrapped(label: &str, text: &str) -> Vec<String> {
    let (first, rest) = (format!("{label:<9}  "), " ".repeat(11));
    let lines = filled(&names::visible(text), text_width(), &first, &rest);
    lines.lines().map(str::to_owned).collect()
}
