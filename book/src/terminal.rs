//! Half blocks: a picture in the terminal, two pixels to a character.

use std::io::{self, Write};

use anstyle::{AnsiColor, Color, RgbColor, Style};
use common::rtweekend::Picture;
use supports_color::Stream;

/// The colors that a terminal has.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Palette {
    /// 24 bits: all.
    All,
    /// 256 of them.
    Xterm,
    /// The sixteen with names.
    Ansi,
}

impl Palette {
    /// The colors of the terminal that shows standard output, if there is one, if it
    /// has colors, and if the reader wants them.
    pub(crate) fn of_stdout() -> Option<Self> {
        let level = supports_color::on(Stream::Stdout)?;
        Some(if level.has_16m {
            Self::All
        } else if level.has_256 {
            Self::Xterm
        } else {
            Self::Ansi
        })
    }

    fn nearest(self, [red, green, blue]: [u8; 3]) -> Color {
        let color = RgbColor(red, green, blue);
        match self {
            Self::All => color.into(),
            Self::Xterm => anstyle_lossy::rgb_to_xterm(color).into(),
            Self::Ansi => {
                let nearest: AnsiColor =
                    anstyle_lossy::rgb_to_ansi(color, anstyle_lossy::palette::VGA);
                nearest.into()
            }
        }
    }
}

/// How wide text should be, in characters: as the terminal, but no wider than is easy to
/// read.
pub(crate) fn text_width() -> usize {
    let columns = terminal_size::terminal_size().map_or(80, |(width, _)| usize::from(width.0));
    columns.clamp(30, 96)
}

/// `text` in lines that are no wider than that, those after the first with this indent.
pub(crate) fn hanging(text: &str, indent: usize) -> String {
    let indent = " ".repeat(indent);
    let options = textwrap::Options::new(text_width()).subsequent_indent(&indent);
    textwrap::fill(text, options)
}

/// Shows `picture`, reduced as far as the terminal asks.
///
/// The character is the upper half block: its own color is the upper pixel, its
/// background the lower one.
pub(crate) fn show(picture: &Picture, palette: Palette, out: &mut dyn Write) -> io::Result<()> {
    let (columns, terminal_lines) = terminal_size::terminal_size()
        .map_or((80, 24), |(width, height)| {
            (width.0.into(), height.0.into())
        });
    // The prompt wants a line of its own below the picture.
    let rows = 2 * u32::saturating_sub(terminal_lines, 1);
    for line in lines(picture, palette, columns, rows) {
        writeln!(out, "{line}")?;
    }
    Ok(())
}

/// The lines that show `picture`, reduced to at most `columns` × `rows` pixels.
pub(crate) fn lines(picture: &Picture, palette: Palette, columns: u32, rows: u32) -> Vec<String> {
    let (width, height) = fitting(picture, columns, rows);
    let line = |j| {
        let character = |i| {
            let color = |j| {
                let is_there = j < height;
                is_there.then(|| palette.nearest(mean(picture, [i, j], [width, height])))
            };
            let style = Style::new().fg_color(color(j)).bg_color(color(j + 1));
            format!("{style}▀")
        };
        let characters: String = (0..width).map(character).collect();
        characters + "\x1b[0m"
    };
    (0..height).step_by(2).map(line).collect()
}

/// The picture's own size if it fits into `columns` × `rows` pixels, else the largest of
/// the same shape that does.
fn fitting(picture: &Picture, columns: u32, rows: u32) -> (u32, u32) {
    let size = [picture.width(), picture.height()];
    let scale = (f64::from(columns) / f64::from(size[0]))
        .min(f64::from(rows) / f64::from(size[1]))
        .min(1.0);
    let [width, height] = size.map(|size| ((scale * f64::from(size)) as u32).max(1));
    (width, height)
}

/// The mean of those pixels that one in column `i` and row `j` stands for, where the
/// picture is reduced to `size` (a box filter).
fn mean(picture: &Picture, [i, j]: [u32; 2], size: [u32; 2]) -> [u8; 3] {
    let range = |n: u32, size: u32, whole: u32| {
        let edge = |n: u32| (u64::from(n) * u64::from(whole) / u64::from(size)) as usize;
        edge(n)..edge(n + 1)
    };
    let (columns, rows) = (
        range(i, size[0], picture.width()),
        range(j, size[1], picture.height()),
    );
    let (pixels, _) = picture.rgb().as_chunks::<3>();
    let count = columns.len() * rows.len();
    let mut sums = [0; 3];
    for row in rows {
        let start = row * picture.width() as usize;
        for pixel in &pixels[start + columns.start..start + columns.end] {
            for (sum, &level) in sums.iter_mut().zip(pixel) {
                *sum += usize::from(level);
            }
        }
    }
    sums.map(|sum| (sum / count) as u8)
}
