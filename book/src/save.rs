//! Picture files: PNG and P3.

use std::io;
use std::path::Path;

use check::png;
use common::engine::output;
use common::rtweekend::Picture;

/// What a picture file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// Compressed, for viewers and pages.
    Png,
    /// The book's own: P3, a text of numbers.
    Ppm,
}

impl Format {
    /// The format that the name of a file asks for.
    pub(crate) fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_ascii_lowercase();
        [Self::Png, Self::Ppm]
            .into_iter()
            .find(|format| extension == format.extension())
    }

    pub(crate) fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Ppm => "ppm",
        }
    }
}

/// Writes `picture` to `path`, whole or not at all.
pub(crate) fn save(picture: &Picture, format: Format, path: &Path) -> io::Result<()> {
    match format {
        Format::Png => {
            let bytes = png::encode(picture);
            output::to_file(path, |out| out.write_all(&bytes))
        }
        Format::Ppm => output::to_file(path, |out| picture.write_p3(out)),
    }
}
