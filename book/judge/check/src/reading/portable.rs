//! PNG: a decoder with limits on size and memory, around that of the crate `image`.

use std::io::{Cursor, ErrorKind};

use image::codecs::png::PngDecoder;
use image::{DynamicImage, ImageDecoder, ImageError, Limits};

use super::cause::{AS_BYTES, Cause};
use super::limits::MOST_PIXELS;
use super::numbers::Reading;

/// The first eight bytes of a PNG file.
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Reads a PNG file of three or four channels, or gray. Names the first fault that it finds.
pub(super) fn read(bytes: &[u8]) -> Result<Reading, Cause> {
    if !bytes.starts_with(SIGNATURE) && bytes.len() >= SIGNATURE.len() {
        return Err(Cause::new(
            "line-endings",
            "this was a PNG file, but its line endings have been changed on the way",
            AS_BYTES,
        ));
    }
    // First of all: with addresses of 32 bits the library refuses a size in other words.
    if let Some([width, height]) = size(bytes)
        && u64::from(width) * u64::from(height) > MOST_PIXELS
    {
        return Err(Cause::absurd_size([width, height].map(|it| it.to_string())));
    }
    let mut limits = Limits::default();
    limits.max_alloc = Some(8 * MOST_PIXELS);
    let decoder = PngDecoder::with_limits(Cursor::new(bytes), limits).map_err(cause)?;
    let (width, height) = decoder.dimensions();
    let image = DynamicImage::from_decoder(decoder).map_err(cause)?;
    let (pixels, flaw) = pixels(image)?;
    Ok(Reading {
        width,
        height,
        pixels,
        flaw,
    })
}

/// Reads width and height in pixels from the first chunk; `None` if that is no header.
fn size(bytes: &[u8]) -> Option<[u32; 2]> {
    let chunk = bytes.strip_prefix(SIGNATURE)?.get(4..)?;
    let (numbers, _) = chunk.strip_prefix(b"IHDR")?.as_chunks();
    let [width, height] = numbers.first_chunk()?;
    Some([width, height].map(|number| u32::from_be_bytes(*number)))
}

/// Returns the levels of an image, three a pixel, and a remark if some pixels are transparent:
/// these are taken as on black. Refuses an image of which more than half is transparent.
fn pixels(image: DynamicImage) -> Result<(Vec<[i16; 3]>, Option<Cause>), Cause> {
    // The upper byte is the level, both where 8 bits became 16 and where a component was scaled
    // by 65535.999.
    if let DynamicImage::ImageRgb16(image) = image {
        let upper = |level: u16| i16::from((level >> 8) as u8);
        let pixels = image.pixels().map(|pixel| pixel.0.map(upper));
        return Ok((pixels.collect(), None));
    }
    let kind = image.color();
    let image = image.into_rgba8();
    let transparent = image.pixels().filter(|pixel| pixel.0[3] < 255).count();
    let cause = |taken| {
        Cause::new(
            "png-kind",
            format!(
                "this PNG has pixels of the kind {kind:?}, {transparent} of them transparent{taken}"
            ),
            "Save it with three bytes a pixel (8-bit RGB) and without transparency. If it is a screenshot, check the file that the program wrote instead.",
        )
    };
    if 2 * transparent > image.pixels().len() {
        return Err(cause(""));
    }
    let on_black = |[red, green, blue, alpha]: [u8; 4]| {
        [red, green, blue].map(|level| (u16::from(level) * u16::from(alpha) / 255) as i16)
    };
    let pixels = image.pixels().map(|pixel| on_black(pixel.0)).collect();
    let taken = (transparent > 0).then(|| cause(", which were taken as on black"));
    Ok((pixels, taken))
}

/// Names the cause of an error of the decoder.
fn cause(error: ImageError) -> Cause {
    match error {
        ImageError::Limits(_) => Cause::new(
            "absurd-size",
            format!("this PNG needs more memory than {MOST_PIXELS} pixels do"),
            "Save a smaller picture: 400 pixels wide, as in the book.",
        ),
        ImageError::IoError(error) if error.kind() == ErrorKind::UnexpectedEof => truncated(),
        // The library reports an end inside of a chunk as a defect of the format.
        error if error.to_string().to_lowercase().contains("eof") => truncated(),
        error => Cause::new(
            "broken-png",
            format!("this PNG can't be read: {error}"),
            "Save or copy it once more.",
        ),
    }
}

/// Refuses a file that ends before its picture does.
fn truncated() -> Cause {
    Cause::new(
        "truncated-png",
        "this PNG ends too early",
        "Was it copied in full, and did the program end by itself? Save or copy it once more.",
    )
}
