//! Half blocks: a picture in the terminal, two pixels to a character.

use std::io::{self, Write};

use anstyle::{AnsiColor, Color, RgbColor, Style};
use common::rtweekend::Picture;
use image::{Rgb, RgbImage, imageops};
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

    fn nearest(self, Rgb([red, green, blue]): Rgb<u8>) -> Color {
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
    let image = reduced(picture, columns, rows);
    let line = |j| {
        let character = |i| {
            let color = |j| Some(palette.nearest(*image.get_pixel_checked(i, j)?));
            let style = Style::new().fg_color(color(j)).bg_color(color(j + 1));
            format!("{style}▀")
        };
        let characters: String = (0..image.width()).map(character).collect();
        characters + "\x1b[0m"
    };
    (0..image.height()).step_by(2).map(line).collect()
}

/// The picture at its own size if it fits into `columns` × `rows` pixels, else
/// as large as fits, with its shape kept.
fn reduced(picture: &Picture, columns: u32, rows: u32) -> RgbImage {
    let (width, height) = (picture.width(), picture.height());
    let image = RgbImage::from_raw(width, height, picture.rgb().to_vec())
        .expect("a picture has as many bytes as its size says");
    let scale = f64::min(
        f64::from(columns) / f64::from(width),
        f64::from(rows) / f64::from(height),
    );
    if scale >= 1.0 {
        return image;
    }
    let fit = |size: u32| ((scale * f64::from(size)) as u32).max(1);
    imageops::thumbnail(&image, fit(width), fit(height))
}
