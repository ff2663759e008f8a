//! PNG, read by the library `png` within limits.

use std::io::{Cursor, ErrorKind};

use png::{BitDepth, ColorType, Decoder, DecodingError, Limits, Transformations};

use super::cause::{AS_BYTES, Cause};
use super::limits::MOST_PIXELS;
use super::numbers::Reading;

const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Reads a PNG file of three or four channels, or gray.
pub(super) fn read(bytes: &[u8]) -> Result<Reading, Cause> {
    if !bytes.starts_with(SIGNATURE) && bytes.len() >= SIGNATURE.len() {
        return Err(Cause::new(
            "line-endings",
            "this was a PNG file, but its line endings have been changed on the way",
            AS_BYTES,
        ));
    }
    let limits = Limits {
        bytes: 8 * MOST_PIXELS as usize,
    };
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), limits);
    // A palette becomes its colors, and a gray of fewer bits one of eight.
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(cause)?;
    let (width, height) = reader.info().size();
    let absurd = || Cause::absurd_size(width.into(), height.into());
    if u64::from(width) * u64::from(height) > MOST_PIXELS {
        return Err(absurd());
    }
    let mut levels = vec![0; reader.output_buffer_size().ok_or_else(absurd)?];
    reader.next_frame(&mut levels).map_err(cause)?;
    Ok(Reading {
        width,
        height,
        pixels: pixels(&levels, reader.output_color_type())?,
    })
}

/// The levels, if nothing is lost by taking three bytes a pixel.
fn pixels(levels: &[u8], kind: (ColorType, BitDepth)) -> Result<Vec<[i16; 3]>, Cause> {
    let rgb = |pixel: &[u8]| [pixel[0], pixel[1], pixel[2]].map(i16::from);
    match kind {
        (ColorType::Rgb, BitDepth::Eight) => Ok(levels.chunks_exact(3).map(rgb).collect()),
        (ColorType::Grayscale, BitDepth::Eight) => {
            Ok(levels.iter().map(|&level| [level.into(); 3]).collect())
        }
        (ColorType::Rgba, BitDepth::Eight)
            if levels.chunks_exact(4).all(|pixel| pixel[3] == 255) =>
        {
            Ok(levels.chunks_exact(4).map(rgb).collect())
        }
        (color, depth) => Err(Cause::new(
            "png-kind",
            format!(
                "this PNG has {} bits a channel, of the kind {color:?}",
                depth as u8
            ),
            "Save it with three bytes a pixel (8-bit RGB) and without transparency.",
        )),
    }
}

fn cause(error: DecodingError) -> Cause {
    match error {
        DecodingError::LimitsExceeded => Cause::new(
            "absurd-size",
            format!("this PNG needs more memory than {MOST_PIXELS} pixels do"),
            "Save a smaller picture: 400 pixels wide, as in the book.",
        ),
        DecodingError::IoError(error) if error.kind() == ErrorKind::UnexpectedEof => truncated(),
        // The library reports an end inside of a chunk as a defect of the format.
        error if error.to_string().to_lowercase().contains("eof") => truncated(),
        error => Cause::new(
            "broken-png",
            format!("this PNG can't be read: {error}"),
            "Save or copy it once more.",
        ),
    }
}

fn truncated() -> Cause {
    Cause::new(
        "truncated-png",
        "this PNG ends too early",
        "Was it copied in full, and did the program end by itself? Save or copy it once more.",
    )
}
