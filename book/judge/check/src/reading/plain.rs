//! P3, plain PPM: numbers as text.

use super::cause::Cause;
use super::header;
use super::numbers::Reading;
use super::tokens::Tokens;

/// No pixel takes less text than `0 0 0` and a space.
const LEAST_TEXT: usize = 6;

/// Reads a P3 text.
pub(super) fn read(bytes: &[u8]) -> Result<Reading, Cause> {
    let mut tokens = Tokens::after_magic(bytes);
    let header = header::read(bytes, &mut tokens)?;
    if header.maximum() != 255 {
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
        Err(miscounted(width as usize, height as usize, count))
    }
}

/// Why there are `count` numbers, and not three a pixel.
fn miscounted(width: usize, height: usize, count: usize) -> Cause {
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
        advice(width, height, count),
    )
}

fn advice(width: usize, height: usize, count: usize) -> String {
    let (wanted, pixels) = (3 * width * height, count / 3);
    if count == 0 {
        return "The header is there and nothing after it: did the program stop with an error?"
            .to_owned();
    }
    if count == width * height {
        return "That is one number a pixel. Print three: red, green and blue.".to_owned();
    }
    if (wanted..wanted + 3 * width).contains(&count) {
        return format!(
            "The picture is complete, and {} more follow the last pixel. Only the picture goes to standard output.",
            count - wanted
        );
    }
    if count == 3 * (width + 1) * (height + 1) {
        return "That is a column and a row too many: loop while i < image_width and j < image_height, not <=.".to_owned();
    }
    if !count.is_multiple_of(3) {
        return "That is not a multiple of three: a number is missing somewhere, or the file was cut off.".to_owned();
    }
    if pixels.is_multiple_of(width) {
        return format!(
            "That is {} rows: does the header say the size that the loops use, and does the loop over rows run from 0 to below image_height?",
            pixels / width
        );
    }
    if pixels.is_multiple_of(height) {
        return format!(
            "That is {} columns: does the header say the size that the loops use, and does the loop over columns run from 0 to below image_width?",
            pixels / height
        );
    }
    format!(
        "That is {pixels} pixels. Does the header say the size that the loops use, and did the program end by itself? Was an older, longer file cut off before?"
    )
}
