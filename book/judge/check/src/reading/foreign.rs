//! File signatures: recognizes files that are neither PPM nor PNG by their first bytes.

use super::cause::Cause;

/// The fix for a text that a shell has put into another encoding.
const REDIRECT: &str = "PowerShell before 7.4 does this to what > writes. Let the program write the file itself, or type: cmd /c \"program > picture.ppm\"";

/// Takes back what a shell does to the text of a program: returns the text as it was printed, and
/// names the encoding, UTF-16 or a byte-order mark. `None` for bytes in neither.
pub(super) fn before_a_shell(bytes: &[u8]) -> Option<(Vec<u8>, Cause)> {
    let (text, name, problem) = match bytes {
        [0xff, 0xfe, 0, 0, ..] | [b'P', 0, 0, ..] => return None,
        [0xff, 0xfe, words @ ..] | words @ [b'P', 0, ..] => {
            let text = narrow(words, u16::from_le_bytes);
            (text, "utf-16", "is text in UTF-16")
        }
        [0xfe, 0xff, words @ ..] | words @ [0, b'P', ..] => {
            let text = narrow(words, u16::from_be_bytes);
            (text, "utf-16", "is text in UTF-16")
        }
        [0xef, 0xbb, 0xbf, text @ ..] => {
            let problem = "begins with a byte-order mark (EF BB BF)";
            (text.to_vec(), "byte-order-mark", problem)
        }
        _ => return None,
    };
    let problem = format!("the file {problem}, so viewers don't show it");
    Some((text, Cause::new(name, problem, REDIRECT)))
}

/// Decodes UTF-16 into a byte a letter, with `?` for letters beyond a byte, which no picture has.
/// `unit` joins two bytes in their order.
fn narrow(words: &[u8], unit: fn([u8; 2]) -> u16) -> Vec<u8> {
    let (words, _) = words.as_chunks();
    let letter = |&word: &[u8; 2]| u8::try_from(unit(word)).unwrap_or(b'?');
    words.iter().map(letter).collect()
}

/// The first bytes and the names of formats that are recognized, and not read.
const FORMATS: [(&[u8], &str); 14] = [
    (b"\xff\xd8\xff", "JPEG, which changes colors"),
    (b"GIF8", "GIF, which has no more than 256 colors"),
    (b"BM", "BMP"),
    (b"RIFF", "WebP"),
    (b"II*\0", "TIFF"),
    (b"MM\0*", "TIFF"),
    (b"%PDF", "PDF"),
    (b"qoif", "QOI"),
    (b"PF", "PFM"),
    (b"\x1f\x8b", "a file that gzip has packed"),
    (b"\xff\xfe\0\0", "text in UTF-32"),
    (b"\0\0\xfe\xff", "text in UTF-32"),
    (b"P\0\0\0", "text in UTF-32"),
    (b"\0\0\0P", "text in UTF-32"),
];

/// A test of the bytes behind the white space at the beginning of a file, and the name, the problem
/// and the fix of a fault.
type FileFault = (fn(&[u8]) -> bool, &'static str, &'static str, &'static str);

/// Usual beginnings of files that are no pictures.
const FAULTS: [FileFault; 5] = [
    (
        |text| text.is_empty(),
        "empty",
        "the content is empty",
        "Did the program stop with an error, or print to standard error? The picture goes to standard output.",
    ),
    (
        |text| text.starts_with(b"P3") || text.starts_with(b"P6"),
        "header",
        "white space stands before the first letter",
        "The file begins with its P at once.",
    ),
    (
        |text| text.starts_with(b"p3") || text.starts_with(b"p6"),
        "header",
        "the first letter is a small p",
        "Write P3, with a capital P.",
    ),
    (
        |text| text.starts_with(b"data:image/"),
        "other-format",
        "this is a data URL: the picture stands behind its comma, in base64",
        "Decode what stands behind the comma, such as with base64 -d, or save the picture as a file.",
    ),
    (
        |text| text[0].is_ascii_digit() || text[0] == b'-',
        "missing-header",
        "the file begins with a number: its first line is missing",
        "First comes P3, then width and height, and then 255, on a line each; below them the pixels.",
    ),
];

/// Names what keeps bytes from being a picture that begin neither with P3 or P6 nor as a PNG does.
pub(super) fn cause(bytes: &[u8]) -> Cause {
    let format = FORMATS.iter().find(|(magic, _)| bytes.starts_with(magic));
    let format = format.map(|it| it.1).or(is_tga(bytes).then_some("TGA"));
    if let Some(format) = format {
        return Cause::new(
            "other-format",
            format!("this is {format}"),
            "Save it as PPM (P3 or P6) or PNG.",
        );
    }
    if let [b'P', kind @ (b'1' | b'2' | b'4' | b'5' | b'7'), ..] = bytes {
        return Cause::new(
            "other-format",
            format!(
                "P{} is another kind of picture than P3 and P6",
                char::from(*kind)
            ),
            "Write P3 in the first line and three numbers a pixel, or P6 and three bytes a pixel.",
        );
    }
    let text = bytes.trim_ascii_start();
    if let Some(&(_, name, problem, fix)) = FAULTS.iter().find(|(is_it, ..)| is_it(text)) {
        return Cause::new(name, problem, fix);
    }
    let line: String = String::from_utf8_lossy(&text[..text.len().min(160)])
        .chars()
        .take_while(|letter| !letter.is_control())
        .take(40)
        .collect();
    let first = match &*line {
        "" => {
            let bytes = bytes.iter().take(4).map(|byte| format!("{byte:02x}"));
            format!("with the bytes {}", bytes.collect::<Vec<_>>().join(" "))
        }
        line => format!("with {line:?}"),
    };
    Cause::new(
        "not-a-picture",
        format!(
            "the first line begins {first}, and a picture begins with P3, P6 or the mark of a PNG"
        ),
        "Send only the picture to standard output, the header first. Messages go to standard error.",
    )
}

/// Returns true for the header of a TGA file, which has no mark: no or one color map, a type of
/// image, and 8 to 32 bits a pixel.
fn is_tga(bytes: &[u8]) -> bool {
    let Some(&[_, map, kind, .., bits, _]) = bytes.first_chunk::<18>() else {
        return false;
    };
    map <= 1 && matches!(kind, 1..=3 | 9..=11) && matches!(bits, 8 | 16 | 24 | 32)
}
