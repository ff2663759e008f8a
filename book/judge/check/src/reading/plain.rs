//! P3, plain PPM: a parser of numbers as text.

use super::cause::Cause;
use super::header;
use super::numbers::Reading;
use super::tokens::PpmTokens;

/// The least length of a pixel in bytes: that of `0 0 0` and a space.
const LEAST_TEXT: usize = 6;

/// Reads a P3 text, which begins with `P3`. Names the first fault that it finds.
pub(super) fn read(bytes: &[u8]) -> Result<Reading, Cause> {
    let mut tokens = PpmTokens::after_magic(bytes);
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
            flaw: None,
        })
    } else {
        Err(miscounted(width as usize, height as usize, count))
    }
}

/// Names the fault of a picture of `count` numbers that has more or fewer than three a pixel.
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

/// Guesses from the `count` of numbers what is wrong, and advises what to do.
fn advice(width: usize, height: usize, count: usize) -> String {
    let (wanted, pixels) = (3 * width * height, count / 3);
    let of_size = |filled: String, loops: &str| {
        format!(
            "The numbers fill {filled}: does the header say the size that the loops use, and {loops}?"
        )
    };
    if count == 0 {
        "The header is there and nothing after it: did the program stop with an error?".to_owned()
    } else if count == width * height {
        "The file has one number a pixel. Print three: red, green and blue.".to_owned()
    } else if (wanted..wanted + 3 * width).contains(&count) {
        let follow = match count - wanted {
            1 => "1 more number follows".to_owned(),
            more => format!("{more} more numbers follow"),
        };
        format!(
            "The picture is complete, and {follow} the last pixel. Only the picture goes to standard output."
        )
    } else if count == 3 * (width + 1) * (height + 1) {
        "The numbers fill one column and one row more: loop while i < image_width and j < image_height, not <=."
            .to_owned()
    } else if !count.is_multiple_of(3) {
        "Their count is no multiple of three: a number is missing somewhere, or the file was cut off."
            .to_owned()
    } else if pixels.is_multiple_of(width) {
        of_size(
            counted(pixels / width, "row"),
            "does the loop over rows run from 0 to below image_height",
        )
    } else if pixels.is_multiple_of(height) {
        of_size(
            counted(pixels / height, "column"),
            "does the loop over columns run from 0 to below image_width",
        )
    } else {
        let ended = "did the program end by itself? Was an older, longer file cut off before";
        of_size(counted(pixels, "pixel"), ended)
    }
}

/// Counts things that English puts into the plural by an s: `1 row`, `2 rows`.
fn counted(count: usize, thing: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {thing}{plural}")
}
