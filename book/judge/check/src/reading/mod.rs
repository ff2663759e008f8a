//! Pictures that come from anywhere: P3 and P6 text and bytes, and PNG.
//!
//! [`read`] trusts nothing. Whatever the bytes are, it ends soon, with a picture
//! or with the [`Cause`] why there is none, and it takes no memory for what a
//! header merely promises:
//!
//! ```
//! use check::reading::read;
//!
//! let picture = read(b"P3\n1 1\n255\n128 179 255\n").unwrap();
//! assert_eq!(picture.pixels, [[128, 179, 255]]);
//!
//! let cause = read(b"P3\n1 1\n255\n128 179\n").unwrap_err();
//! assert_eq!(cause.name, "too-few-numbers");
//! ```

mod binary;
mod cause;
mod foreign;
mod header;
mod limits;
mod numbers;
mod plain;
mod portable;
mod tokens;

pub use cause::Cause;
pub use limits::{MOST_BYTES, MOST_PIXELS};
pub use numbers::{InvalidLevels, Reading};

/// Reads the picture in the bytes of a file: P3, P6 or PNG; also P3 in UTF-16 or behind a
/// byte-order mark, as a shell may write it. The highest level of a P3 or P6 must be 255.
///
/// # Errors
/// The [`Cause`] why the bytes can't be read as a picture, and what to do: of the faults, the first
/// that is found. A file of more than [`MOST_BYTES`] bytes, or a picture of more than
/// [`MOST_PIXELS`] pixels or of none, is refused.
pub fn read(bytes: &[u8]) -> Result<Reading, Cause> {
    if bytes.len() > MOST_BYTES {
        return Err(Cause::too_large());
    }
    if let Some((text, encoding)) = foreign::before_a_shell(bytes) {
        if !text.starts_with(b"P3") {
            return Err(encoding);
        }
        return Ok(Reading {
            flaw: Some(encoding),
            ..plain::read(&text)?
        });
    }
    match bytes {
        [b'P', b'3', ..] => plain::read(bytes),
        [b'P', b'6', ..] => binary::read(bytes),
        [0x89, b'P', b'N', b'G', ..] => portable::read(bytes),
        _ => Err(foreign::cause(bytes)),
    }
}
