//! Half blocks: a picture in the terminal, two pixels to a character.

use std::io::{self, Write};

use common::rtweekend::Picture;
use image::{Rgb, RgbImage, imageops};

/// Shows `picture`, reduced as far as the terminal asks.
///
/// The character is the upper half block: its own color is the upper pixel, its
/// background the lower one. The terminal must know 24-bit colors, as all but
/// the oldest do; on Windows that is Windows Terminal.
pub(crate) fn show(picture: &Picture, out: &mut dyn Write) -> io::Result<()> {
    let (columns, lines) = terminal_size::terminal_size().map_or((80, 24), |(width, height)| {
        (width.0.into(), height.0.into())
    });
    // The prompt wants a line of its own below the picture.
    let image = reduced(picture, columns, 2 * u32::saturating_sub(lines, 1));
    for j in (0..image.height()).step_by(2) {
        for i in 0..image.width() {
            let Rgb([r, g, b]) = image.get_pixel(i, j);
            write!(out, "\x1b[38;2;{r};{g};{b}m")?;
            if let Some(Rgb([r, g, b])) = image.get_pixel_checked(i, j + 1) {
                write!(out, "\x1b[48;2;{r};{g};{b}m")?;
            }
            write!(out, "▀")?;
        }
        writeln!(out, "\x1b[0m")?;
    }
    Ok(())
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
