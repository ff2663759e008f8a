//! Picture files: PNG and P3.

use std::io;
use std::path::Path;

use common::rtweekend::Picture;
use difference::png;

use crate::output;

/// The format of a picture file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PictureFormat {
    /// PNG, compressed, with the extension `png`.
    Png,
    /// PPM as the book writes it: P3, a text of numbers, with the extension `ppm`.
    Ppm,
}

impl PictureFormat {
    /// Returns the format whose extension the path has, in upper or lower case; `None` for any
    /// other, and for a path without an extension.
    pub(crate) fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_ascii_lowercase();
        [Self::Png, Self::Ppm]
            .into_iter()
            .find(|format| extension == format.extension())
    }

    /// Returns the extension of the format's files, without a dot.
    pub(crate) fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Ppm => "ppm",
        }
    }
}

/// Writes `picture` to a file at `path`, in place of an earlier one. The file appears whole or not
/// at all.
pub(crate) fn save(picture: &Picture, format: PictureFormat, path: &Path) -> io::Result<()> {
    output::to_file(path, |out| match format {
        PictureFormat::Png => out.write_all(&png::encode(picture)),
        PictureFormat::Ppm => picture.write_p3(out),
    })
}
