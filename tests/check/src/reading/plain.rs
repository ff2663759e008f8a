//! P3, plain PPM: numbers as text.

use super::cause::Cause;
use super::header;
use super::numbers::Reading;
use super::tokens::Tokens;
use crate::pixels::{Pixel, distance, spread};

/// No pixel takes less text than `0 0 0` and a space.
const LEAST_TEXT: usize = 6;

/// Reads a P3 text.
pub(super) fn read(bytes: &[u8]) -> Result<Reading, Cause> {
    let mut tokens = Tokens::after_magic(bytes);
    let header = header::read(bytes, &mut tokens)?;
    if header[2] != 255 {
        return Err(header::wrong_maximum(header, tokens.count() as u64));
    }
    let (width, height) = header::size(header)?;
    let wanted = width as usize * height as usize;
    let mut pixels = Vec::with_capacity(wanted.min(bytes.len() / LEAST_TEXT + 1));
    let mut pixel = [0; 3];
    let mut count = 0;
    for token in tokens {
        let is_complete = count == 3 * wanted;
        let level = token.number().ok_or_else(|| {
            if is_complete {
                token.stray(bytes)
            } else {
                token.cause(bytes)
            }
        })?;
        pixel[count % 3] = level.clamp(i16::MIN.into(), i16::MAX.into()) as i16;
        count += 1;
        if count % 3 == 0 && count <= 3 * wanted {
            pixels.push(pixel);
        }
    }
    if count == 3 * wanted {
        Ok(Reading {
            width,
            height,
            pixels,
            encoding: None,
        })
    } else {
        Err(miscounted(width as usize, height as usize, count, &pixels))
    }
}

/// Why there are `count` numbers, and not three a pixel.
fn miscounted(width: usize, height: usize, count: usize, found: &[Pixel]) -> Cause {
    let wanted = 3 * width * height;
    let name = match count {
        0 => "no-pixels",
        _ if count < wanted => "too-few-numbers",
        _ if count < wanted + 3 * width => "stray-output",
        _ => "too-many-numbers",
    };
    Cause::new(
        name,
        format!("{width} × {height} pixels are {wanted} numbers, but the file has {count}"),
        advice(width, height, count, found),
    )
}

fn advice(width: usize, height: usize, count: usize, found: &[Pixel]) -> String {
    if count == 0 {
        return "The header is there and nothing after it: did the program stop with an error?"
            .to_owned();
    }
    if count == width * height {
        return "That is one number a pixel. Print three: red, green and blue.".to_owned();
    }
    if (3 * width * height..3 * width * (height + 1)).contains(&count) {
        return format!(
            "The picture is complete, and {} more follow the last pixel. Only the picture goes to standard output.",
            count - 3 * width * height
        );
    }
    let pixels = count / 3;
    if count == 3 * (width + 1) * (height + 1) {
        return "That is a column and a row too many: loop while i < image_width and j < image_height, not <=.".to_owned();
    }
    let is_of_whole_lines = pixels.is_multiple_of(width) || pixels.is_multiple_of(height);
    if pixels > width * height && !(count.is_multiple_of(3) && is_of_whole_lines) {
        return format!(
            "That is {} more than the header's size needs. Was an older, longer file not cut off, as where std::fstream opens it? Delete it, and let the program write a new one. Or does the header not say the size that the loops use?",
            count - 3 * width * height
        );
    }
    if !count.is_multiple_of(3) {
        return "That is not a multiple of three: a number is missing somewhere, or the file was cut off.".to_owned();
    }
    if pixels == (width - 1) * (height - 1) {
        return "A column and a row are missing: loop from 0 to below the size.".to_owned();
    }
    // Of a square both may be meant, and of a sky nothing tells which.
    let has_more_columns = width == height
        && pixels > width * height
        && 10.0 * rows_differ(found, pixels / height) < 9.0 * rows_differ(found, width);
    if pixels.is_multiple_of(width) && !has_more_columns {
        let rows = pixels / width;
        // The loops know the book's shape, and the header doesn't.
        if rows == width * 9 / 16 {
            return format!("That is {rows} rows, and the header should say so: {width} {rows}.");
        }
        return format!(
            "That is {rows} rows: let the loop over rows run from 0 to below image_height, and let the program end by itself."
        );
    }
    if pixels.is_multiple_of(height) {
        let columns = pixels / height;
        if rows_differ(found, height) < rows_differ(found, columns) {
            return format!(
                "That is {columns} rows of {height} pixels: width and height are exchanged, in the header or in the loops, and the loop over rows does not run from 0 to below image_height."
            );
        }
        return format!(
            "That is {columns} columns: let the loop over columns run from 0 to below image_width."
        );
    }
    format!(
        "That is {pixels} pixels. Does the header say the size that the loops use, and did the program end by itself?"
    )
}

/// How many pixels are compared with those below them.
const LOOK: u32 = 600;

/// By how many levels pixels differ from those below them on the average, in rows of a length.
fn rows_differ(pixels: &[Pixel], width: usize) -> f64 {
    let count = pixels.len().saturating_sub(width) as u32;
    let places = spread(LOOK, count).map(|n| n as usize);
    let off = places.map(|n| f64::from(distance(pixels[n], pixels[n + width])));
    off.sum::<f64>() / f64::from(count.clamp(1, LOOK))
}
