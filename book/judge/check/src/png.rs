//! A PNG encoder; [`reading`](crate::reading) has the decoder.

use common::rtweekend::Picture;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};

/// Encodes a picture as the bytes of a PNG file, three bytes a pixel.
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
