//! Half blocks: a picture in the terminal, two pixels to a character.

use std::io::{self, Write};
use std::ops::Range;

use anstyle::{AnsiColor, Color, RgbColor, Style};
use common::rtweekend::Picture;
use supports_color::Stream;

/// The colors that a terminal can show: all of 24 bits, 256 or 16.
#[derive(Clone, Copy, Debug)]
pub enum Palette {
    /// All colors of 24 bits, shown as they are.
    All,
    /// The 256 colors of xterm, of which the most similar is shown.
    Xterm,
    /// The 16 colors that have names in ANSI, of which the most similar is shown.
    Ansi,
}

impl Palette {
    /// Returns the colors of the terminal that shows standard output. Returns `None` if standard
    /// output goes elsewhere, if the terminal has no colors, or if the reader asks for none, such
    /// as by `NO_COLOR`.
    pub fn of_stdout() -> Option<Self> {
        let level = supports_color::on(Stream::Stdout)?;
        // A console of Windows reads escapes only if asked to, and then it has all colors.
        #[cfg(windows)]
        if let Some(reads_escapes) = anstyle_query::windows::enable_ansi_colors() {
            return reads_escapes.then_some(Self::All);
        }
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

/// Returns the columns and the lines of the terminal; `None` if there is none, or it does not say.
pub fn size() -> Option<(u32, u32)> {
    let (columns, lines) = terminal_size::terminal_size()?;
    Some((columns.0.into(), lines.0.into()))
}

/// Returns the width of text in characters: as wide as the terminal, but at least 30 and at most
/// 96.
pub fn text_width() -> usize {
    let columns = size().map_or(80, |(columns, _)| columns);
    columns.clamp(30, 96) as usize
}

/// Writes `picture` to `out` as lines of [`picture_lines`], reduced to the columns of the terminal
/// and to its lines less one, or to 80 columns and 23 lines if its size is unknown.
///
/// # Errors
/// If `out` can't be written to.
pub fn show_picture(picture: &Picture, palette: Palette, out: &mut dyn Write) -> io::Result<()> {
    let (columns, terminal_lines) = size().unwrap_or((80, 24));
    // The prompt wants a line of its own below the picture.
    let rows = 2 * u32::saturating_sub(terminal_lines, 1);
    for line in picture_lines(picture, palette, columns, rows) {
        writeln!(out, "{line}")?;
    }
    Ok(())
}

/// Returns the picture as lines of colored characters, from the top, without line breaks; the
/// colors are escapes of ANSI. It is reduced to at most `columns` × `rows` pixels (0 counts as 1),
/// with its aspect ratio kept, and never enlarged. A character is the upper half block: it shows
/// the upper of two pixels in its own color, the lower as its background.
pub fn picture_lines(picture: &Picture, palette: Palette, columns: u32, rows: u32) -> Vec<String> {
    let pixels = reduced(picture, columns, rows);
    let line = |rows: &[Vec<[u8; 3]>]| {
        let character = |i: usize| {
            let color = |row: &Vec<[u8; 3]>| palette.nearest(row[i]);
            let style = Style::new()
                .fg_color(rows.first().map(color))
                .bg_color(rows.get(1).map(color));
            format!("{style}▀")
        };
        let characters: String = (0..rows[0].len()).map(character).collect();
        characters + "\x1b[0m"
    };
    pixels.chunks(2).map(line).collect()
}

/// Returns the rows of the picture, from the top, at its own size if that fits into `columns` ×
/// `rows` pixels, or else as large as fits with its aspect ratio kept.
fn reduced(picture: &Picture, columns: u32, rows: u32) -> Vec<Vec<[u8; 3]>> {
    let (width, height) = (picture.width(), picture.height());
    let scale = f64::min(
        f64::from(columns) / f64::from(width),
        f64::from(rows) / f64::from(height),
    );
    let fit = |size: u32| ((scale.min(1.0) * f64::from(size)) as u32).max(1);
    let row = |rows: Range<u32>| {
        let pixel = |columns| average(picture, columns, rows.clone());
        blocks(width, fit(width)).map(pixel).collect()
    };
    blocks(height, fit(height)).map(row).collect()
}

/// Cuts the pixels from 0 to `pixels` into `count` ranges that are as equal as can be.
fn blocks(pixels: u32, count: u32) -> impl Iterator<Item = Range<u32>> {
    let end = move |n: u32| (n * pixels).div_ceil(count);
    (0..count).map(move |n| end(n)..end(n + 1))
}

/// Returns the mean color of a block of pixels.
fn average(picture: &Picture, columns: Range<u32>, rows: Range<u32>) -> [u8; 3] {
    let count = (columns.len() * rows.len()) as u32;
    let component = |n: u32| {
        let column = |j: u32| {
            columns
                .clone()
                .map(move |i| 3 * (j * picture.width() + i) + n)
        };
        let all = rows.clone().flat_map(column);
        let sum: u32 = all.map(|at| u32::from(picture.rgb()[at as usize])).sum();
        ((sum + count / 2) / count) as u8
    };
    [0, 1, 2].map(component)
}
