//! Pictures as PNG files.

use std::io::Cursor;

use common::rtweekend::Picture;
use image::codecs::png::PngEncoder;
use image::error::{UnsupportedError, UnsupportedErrorKind};
use image::{DynamicImage, ExtendedColorType, ImageEncoder, ImageError, ImageFormat, ImageReader};

/// The bytes of a PNG file that holds `picture`.
///
/// # Panics
/// If the encoder fails, which for a buffer in memory means a defect in it.
pub fn encode(picture: &Picture) -> Vec<u8> {
    let mut bytes = Vec::new();
    PngEncoder::new(&mut bytes)
        .write_image(
            picture.rgb(),
            picture.width(),
            picture.height(),
            ExtendedColorType::Rgb8,
        )
        .expect("a picture has as many bytes as its size says, and memory takes them all");
    bytes
}

/// The picture that a PNG file holds, whatever its compression.
///
/// # Errors
/// If `bytes` are not a complete PNG file of three bytes a pixel.
pub fn decode(bytes: &[u8]) -> Result<Picture, ImageError> {
    let image = ImageReader::with_format(Cursor::new(bytes), ImageFormat::Png).decode()?;
    // Dropping an alpha channel or half of 16 bits would hide a difference.
    let DynamicImage::ImageRgb8(rgb) = image else {
        return Err(ImageError::Unsupported(
            UnsupportedError::from_format_and_kind(
                ImageFormat::Png.into(),
                UnsupportedErrorKind::Color(image.color().into()),
            ),
        ));
    };
    let (width, height) = rgb.dimensions();
    Ok(Picture::from_rgb(width, height, rgb.into_raw())
        .expect("the decoder returns three bytes for each pixel"))
}
