//! P6, raw PPM: a parser of the same header as that of P3, and of three bytes a pixel.

use super::cause::{AS_BYTES, Cause};
use super::header;
use super::numbers::Reading;
use super::tokens::PpmTokens;

/// Reads a P6 file, which begins with `P6`. Names the first fault that it finds.
pub(super) fn read(bytes: &[u8]) -> Result<Reading, Cause> {
    let mut tokens = PpmTokens::after_magic(bytes);
    let header = header::read(bytes, &mut tokens)?;
    let (header_text, body) = bytes.split_at(tokens.body().min(bytes.len()));
    if is_numbers(body) && !fits(header, body) {
        return Err(Cause::new(
            "p6-over-text",
            "the header says P6, which is followed by bytes, but numbers as text follow",
            "Write P3 in the first line.",
        ));
    }
    if header.maximum() != 255 {
        return Err(header::wrong_maximum(header, body.len() as u64));
    }
    let (width, height) = header::size(header)?;
    let wanted = 3 * width as usize * height as usize;
    if body.len() != wanted {
        return Err(miscounted(wanted, header_text, body));
    }
    let (pixels, _) = body.as_chunks::<3>();
    Ok(Reading {
        width,
        height,
        pixels: pixels.iter().map(|pixel| pixel.map(i16::from)).collect(),
        flaw: None,
    })
}

/// Returns true if the body has as many bytes as the header promises. Only such a body may look
/// like text and be none: that of a dark picture.
fn fits(header: header::Header, body: &[u8]) -> bool {
    let [width, height, _] = header.numbers;
    let pixels = width
        .checked_mul(height)
        .and_then(|pixels| pixels.checked_mul(3));
    pixels == i64::try_from(body.len()).ok()
}

/// Returns true if the body is text of whole numbers alone.
fn is_numbers(body: &[u8]) -> bool {
    !body.is_empty()
        && body
            .iter()
            .all(|byte| byte.is_ascii_digit() || byte.is_ascii_whitespace() || *byte == b'-')
}

/// Names the fault of a body that has not the `wanted` number of bytes, three a pixel.
fn miscounted(wanted: usize, header: &[u8], body: &[u8]) -> Cause {
    let found = body.len();
    let problem = format!("the picture needs {wanted} bytes after the header, but {found} follow");
    if let Some(change) = changed_ends_of_line(wanted, header, body) {
        return Cause::new("line-endings", format!("{problem}: {change}"), AS_BYTES);
    }
    if body.windows(3).any(|three| three == "\u{fffd}".as_bytes()) {
        return Cause::new(
            "text-conversion",
            format!("{problem}: bytes have passed through something that took them for UTF-8 text"),
            "PowerShell's > does that. Let the program write the file itself, or print P3.",
        );
    }
    if found < wanted {
        let fix = "Was the file cut off? Let the program end by itself, and flush its output.";
        Cause::new("too-few-bytes", problem, fix)
    } else {
        let fix = "One byte a level, three a pixel, nothing after the last: no text, no new line.";
        Cause::new("too-many-bytes", problem, fix)
    }
}

/// Says how ends of lines were changed in bytes that were taken for text, if the number of bytes
/// shows it. Windows ends a line with 13 and 10, other systems with 10 alone.
fn changed_ends_of_line(wanted: usize, header: &[u8], body: &[u8]) -> Option<&'static str> {
    // The second half of the end of the header's last line.
    let rest = body.strip_prefix(b"\n").filter(|_| header.ends_with(b"\r"));
    let levels = rest.unwrap_or(body);
    let newlines = levels.iter().filter(|&&byte| byte == b'\n').count();
    let pairs = levels.windows(2).filter(|pair| pair == b"\r\n").count();
    if rest.is_some() && levels.len() == wanted {
        return Some("13 and 10 end the header, and the second of them counts as a level");
    }
    if newlines == pairs && pairs > 0 && levels.len() - pairs == wanted {
        return Some("each byte 10 has become 13 and 10, as if it were the end of a line");
    }
    // A 10 is as likely as a 13, so this many may be gone. A file that was cut off
    // misses more, unless it has many a 10.
    if pairs == 0 && levels.len() < wanted && wanted - levels.len() <= 2 * newlines {
        return Some(
            "no byte 13 stands before a byte 10: such bytes may have been removed as ends of lines",
        );
    }
    None
}
