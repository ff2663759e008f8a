//! A parser of the PPM header: width, height and the highest level.

use super::cause::Cause;
use super::limits::MOST_PIXELS;
use super::tokens::{PpmToken, PpmTokens};

/// The three numbers of a header.
#[derive(Clone, Copy)]
pub(super) struct Header<'a> {
    /// Width and height in pixels, and the highest level.
    pub(super) numbers: [i64; 3],
    /// The words of the three numbers as they stand in the file, which may be beyond 64 bits.
    words: [PpmToken<'a>; 3],
}

impl Header<'_> {
    /// Returns the highest level, which should be 255.
    pub(super) fn maximum(&self) -> i64 {
        self.numbers[2]
    }
}

/// Reads the three numbers; names the first fault that it finds.
pub(super) fn read<'a>(bytes: &[u8], tokens: &mut PpmTokens<'a>) -> Result<Header<'a>, Cause> {
    if bytes.get(2).is_some_and(u8::is_ascii_alphanumeric) {
        return Err(Cause::new(
            "header",
            "the first two letters are not followed by white space",
            ORDER,
        ));
    }
    let mut next = |what| {
        let token = tokens.next().ok_or_else(|| {
            Cause::new(
                "header",
                format!("the file ends before the {what}, inside the header"),
                ORDER,
            )
        })?;
        let number = token.number().ok_or_else(|| token.cause(bytes))?;
        Ok((number, token))
    };
    let [width, height, maximum] = [next("width")?, next("height")?, next("maximum")?];
    Ok(Header {
        numbers: [width.0, height.0, maximum.0],
        words: [width.1, height.1, maximum.1],
    })
}

/// Returns width and height in pixels, if both are at least 1 and a picture of that size is read.
pub(super) fn size(header: Header) -> Result<(u32, u32), Cause> {
    let [width, height, _] = header.numbers;
    if width < 0 || height < 0 {
        return Err(Cause::new(
            "negative-size",
            format!("the header promises {width} × {height} pixels"),
            "Print width and height after they are computed.",
        ));
    }
    if width == 0 || height == 0 {
        return Err(Cause::new(
            "no-pixels",
            format!("the header promises {width} × {height} pixels, which are none"),
            "Keep the height at 1 or more, as the book does: image_height = (image_height < 1) ? 1 : image_height. (Slip height-may-be-zero.)",
        ));
    }
    match (u32::try_from(width), u32::try_from(height)) {
        (Ok(width), Ok(height)) if u64::from(width) * u64::from(height) <= MOST_PIXELS => {
            Ok((width, height))
        }
        _ => {
            let [width, height, _] = header.words.map(|word| word.shown());
            Err(Cause::absurd_size([width, height]))
        }
    }
}

/// Names the fault of a header whose third number is not 255, guessed from how many numbers follow
/// it.
pub(super) fn wrong_maximum(header: Header, following: u64) -> Cause {
    let [first, second, third] = header.numbers;
    let pixels = |width: i64, height: i64| match (u64::try_from(width), u64::try_from(height)) {
        (Ok(width), Ok(height)) => width.saturating_mul(height),
        _ => 0,
    };
    let row = pixels(first, 3);
    let fits = |width, height| pixels(width, height).saturating_mul(3) == following;
    // A number too few in the header is taken from the pixels.
    let (name, problem) = if pixels(first, second).saturating_mul(3) == following.saturating_add(1)
    {
        let place = format!("after the size {first} × {second} comes {third}");
        let problem = format!("{place} where the maximum, 255, should be");
        ("missing-header-number", problem)
    } else if second == 255 && row > 0 && (following + 1).is_multiple_of(row) {
        let problem = format!("the header has {first} and 255: width or height is missing");
        ("missing-header-number", problem)
    } else if (first == 255 && fits(second, third)) || (second == 255 && fits(first, third)) {
        let numbers = format!("the header says {first}, {second}, {third}");
        let problem = format!("{numbers}: its numbers are in another order");
        ("swapped-header-numbers", problem)
    } else {
        let level = header.words[2].shown();
        return Cause::new(
            "wrong-maximum",
            format!("the header says that the highest level is {level}"),
            "Write 255 after the size, and levels from 0 to 255: int(255.999 * r).",
        );
    };
    Cause::new(name, problem, ORDER)
}

/// The fix for a header whose numbers are not in their order.
const ORDER: &str =
    "The header is P3 (or P6), then width and height, then 255, such as \"P3\\n400 225\\n255\\n\".";
