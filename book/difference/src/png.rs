//! PNG files with three bytes a pixel: an encoder, and a decoder for what it has encoded.

use common::rtweekend::Picture;
use png::{BitDepth, ColorType, Compression, Decoder, Encoder, Filter};

/// Encodes a picture as the bytes of a PNG file, three bytes a pixel.
///
/// # Panics
/// If the encoder fails, which for a buffer in memory means a defect in it.
pub fn encode(picture: &Picture) -> Vec<u8> {
    const FITS: &str = "a picture has as many bytes as its size says, and memory takes them all";
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, picture.width(), picture.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Fast);
    encoder.set_filter(Filter::Adaptive);
    let mut writer = encoder.write_header().expect(FITS);
    writer.write_image_data(picture.rgb()).expect(FITS);
    writer.finish().expect(FITS);
    bytes
}

/// Decodes the bytes of a PNG file with three bytes a pixel; `None` if they are none.
pub fn decode(bytes: &[u8]) -> Option<Picture> {
    let mut reader = Decoder::new(std::io::Cursor::new(bytes)).read_info().ok()?;
    let mut rgb = vec![0; reader.output_buffer_size()?];
    let frame = reader.next_frame(&mut rgb).ok()?;
    let is_rgb = (frame.color_type, frame.bit_depth) == (ColorType::Rgb, BitDepth::Eight);
    is_rgb.then(|| Picture::from_rgb(frame.width, frame.height, rgb))?
}
