//! One screen: both pictures small, the answer, and what is new on the list of done things.

use std::io::{IsTerminal, stdout};
use std::time::Duration;
use std::{env, iter};

use check::answer::Answer;
use check::text::{MOST_LINES, answer_lines};

use crate::terminal::{self, Palette};
use crate::wrap::{style, text_width, wrap_hanging};

/// The line to show while a repair is searched.
const SEARCHED: &str = "looking for the line that makes it right …";

/// The width and the height of each picture, in characters.
const PICTURE: (u32, u32) = (32, 9);

/// Writes a screen: the title, both pictures small, the answer, a line while a repair `is_searched`,
/// and the `news` on the list of done things. On a terminal, it begins with the codes that clear the
/// last one.
pub(super) fn compose(
    title: &str,
    answer: &Answer,
    is_searched: bool,
    news: &[String],
    took: Duration,
) -> String {
    let above: Vec<String> = iter::once(head(title, took))
        .chain(pictures(answer))
        .collect();
    let done = news
        .iter()
        .map(|thing| wrap_hanging(&format!("{:<9}  {thing}", "done"), 11));
    let searched = is_searched.then(|| style().dim(SEARCHED));
    let done: Vec<String> = searched.into_iter().chain(done).collect();
    let room = height().saturating_sub(above.len() + done.len());
    let answer = answer_lines(answer, style(), text_width(), room.min(MOST_LINES));
    let clear = if is_cleared() { "\x1b[2J\x1b[H" } else { "" };
    format!("{clear}{}\n", [above, answer, done].concat().join("\n"))
}

/// Returns true if each screen replaces the one before: on a terminal that can be cleared.
pub(super) fn is_cleared() -> bool {
    stdout().is_terminal()
        && env::var_os("TERM").is_some_and(|term| term != "dumb" && !term.is_empty())
}

/// Returns true if nobody reads standard output any more, as behind `| head -1`.
pub(super) fn is_output_closed() -> bool {
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

/// Writes the title, and the time that judging took.
fn head(title: &str, took: Duration) -> String {
    let took = format!("judged in {:.1} s", took.as_secs_f64());
    format!("{}  {}", style().bold(title), style().dim(&took))
}

/// Returns the number of the terminal's lines, but for the one with the cursor.
fn height() -> usize {
    terminal::size().map_or(usize::MAX, |(_, lines)| lines.saturating_sub(1) as usize)
}

/// Returns lines with both pictures: the reader's at the left, the right one at the right.
fn pictures(answer: &Answer) -> Vec<String> {
    let (Some(palette), Some(it)) = (Palette::of_stdout(), &answer.pictures) else {
        return Vec::new();
    };
    if text_width() < 70 {
        return Vec::new();
    }
    let (columns, rows) = PICTURE;
    let [yours, right] =
        [&it.yours, &it.right].map(|it| terminal::picture_lines(it, palette, columns, 2 * rows));
    let both = yours.iter().zip(&right);
    let lines = both.map(|(yours, right)| format!("{yours}  {right}"));
    let label = format!("{:<34}{}", "yours", "what it should be");
    lines.chain([label]).collect()
}
