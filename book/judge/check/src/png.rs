//! PNG encoding; [`reading`](crate::reading) decodes.

use common::rtweekend::Picture;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};

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
