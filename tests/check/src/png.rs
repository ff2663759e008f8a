//! PNG encoding; [`reading`](crate::reading) decodes.

use common::rtweekend::Picture;
use png::{ColorType, Compression, Encoder, EncodingError, Filter};

/// The bytes of a PNG file that holds `picture`.
///
/// # Panics
/// If the encoder fails, which for a buffer in memory means a defect in it.
pub fn encode(picture: &Picture) -> Vec<u8> {
    try_encode(picture)
        .expect("a picture has as many bytes as its size says, and memory takes them all")
}

fn try_encode(picture: &Picture) -> Result<Vec<u8>, EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, picture.width(), picture.height());
    encoder.set_color(ColorType::Rgb);
    // A tenth larger than the smallest, in a tenth of the time.
    encoder.set_compression(Compression::Fast);
    encoder.set_filter(Filter::Adaptive);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(picture.rgb())?;
    writer.finish()?;
    Ok(bytes)
}
