//! Whatever a file holds, it is read, or refused with the right reason.

use check::reading::{Cause, Reading, read};
use common::rtweekend::*;
use difference::png;
use slips::{Chapter, ChapterCode};

#[test]
fn text_bytes_and_png_of_a_picture_are_read_as_the_same_picture() {
    let picture = Chapter::HittableList.picture(40);
    let expected = Reading::of(&picture);
    assert_eq!(read(&p3(&picture)), Ok(expected.clone()));
    assert_eq!(read(&p6(&picture)), Ok(expected.clone()));
    assert_eq!(read(&png::encode(&picture)), Ok(expected.clone()));
    assert_eq!(expected.picture(), picture);
}

#[test]
fn white_space_and_comments_are_free() {
    let one_line = b"P3 # by hand\n2 1 255 1 2 3 4 5 6";
    let many_lines = b"P3\r\n#size\r\n2\r\n1\r\n255\r\n1\r\n2\t3\r\n\r\n4 5 +6\r\n\r\n";
    let old_mac = b"P3\r2 1\r255\r1 2 3\r4 5 6\r";
    for text in [&one_line[..], many_lines, old_mac] {
        let reading = read(text).expect("a picture");
        assert_eq!(reading.pixels, [[1, 2, 3], [4, 5, 6]]);
    }
}

/// `pnmtoplainpnm` of netpbm reads the same bytes so.
#[test]
fn a_comment_behind_a_number_ends_it() {
    for text in [
        &b"P3#\n1#width\n1#height\n255#maximum\n97#red\n98#green\r99#blue"[..],
        b"P6\n1#width\n1#height\n255\nabc",
        b"P6 1 1 255#its newline is the white space\nabc",
        b"P6 1 1 255#\rabc",
    ] {
        let shown = String::from_utf8_lossy(text);
        let reading = read(text).unwrap_or_else(|cause| panic!("{shown}: {cause}"));
        assert_eq!(reading.pixels, [[97, 98, 99]], "{shown}");
    }
    let after_space = read(b"P6 1 1 255 #bc").expect("a # is a level as well");
    assert_eq!(after_space.pixels, [[35, 98, 99]]);
    for (text, expected) in [
        (&b"P3\n1 1\n255\n1.#IND 0 0\n"[..], "not-a-number"),
        (b"P3\n1 1\n255\n-1.#QNAN0 0 0\n", "not-a-number"),
        (b"P3\n1 1\n255\nx#y\n0 0\n", "text-in-body"),
        (b"P6 1 1 255#", "too-few-bytes"),
        (b"P6 1 1 255#abc", "too-few-bytes"),
    ] {
        assert_eq!(cause(text), expected, "{}", String::from_utf8_lossy(text));
    }
}

#[test]
fn bytes_that_were_taken_for_text_are_told_from_a_file_cut_off() {
    let picture = Chapter::BuildTest.picture(256);
    let bytes = p6(&picture);
    let header = bytes.len() - picture.rgb().len();
    let body_alone = [&bytes[..header], &with_crlf(&bytes[header..])].concat();
    let header_alone = [&with_crlf(&bytes[..header])[..], &bytes[header..]].concat();
    let removed = bytes
        .iter()
        .copied()
        .filter(|&byte| byte != b'\r')
        .collect();
    for (changed, words) in [
        (with_crlf(&bytes), "has become 13 and 10"),
        (body_alone, "has become 13 and 10"),
        (header_alone, "end the header"),
        (removed, "may have been removed"),
    ] {
        let refused = read(&changed).expect_err("it is not what was written");
        assert_eq!(refused.name, "line-endings");
        assert!(refused.problem.contains(words), "{refused}");
        assert!(refused.fix.contains("_setmode"), "{refused}");
    }
    let cut_off = &bytes[..bytes.len() - 1000];
    assert_eq!(cause(cut_off), "too-few-bytes");
    let text = p3(&picture);
    for text in [with_crlf(&text), with_crlf(&with_crlf(&text))] {
        assert_eq!(read(&text), Ok(Reading::of(&picture)), "text stays text");
    }
}

#[test]
fn lines_are_counted_whatever_ends_them() {
    for end in ["\n", "\r\n", "\r"] {
        let text = format!("P3{end}1 1{end}255{end}{end}0 0 x{end}");
        let refused = read(text.as_bytes()).expect_err("x is no number");
        assert!(refused.problem.starts_with("line 5, "), "{refused}");
    }
}

#[test]
fn numbers_that_are_no_levels_are_kept_and_found() {
    let reading = read(
        b"P3\n2 2\n255\n0 0 255 256 -107 511 0 0 0 1 99999999999999999999 -99999999999999999999",
    )
    .expect("its numbers are numbers");
    let invalid = reading.invalid_levels().expect("two pixels");
    assert_eq!(invalid.count, 2);
    assert_eq!(invalid.first, [1, 0]);
    assert_eq!(invalid.pixel, [256, -107, 511]);
    assert_eq!((invalid.lowest, invalid.highest), (i16::MIN, i16::MAX));
    assert_eq!(reading.picture().rgb()[3..6], [255, 0, 255]);
}

#[test]
fn a_png_is_read_with_its_transparent_pixels_on_black_if_most_are_opaque() {
    use image::{DynamicImage, ImageFormat};
    let encoded = |image: DynamicImage| {
        let mut bytes = std::io::Cursor::new(Vec::new());
        image
            .write_to(&mut bytes, ImageFormat::Png)
            .expect("memory takes it");
        bytes.into_inner()
    };
    let rgba = |alpha| image::RgbaImage::from_pixel(1, 1, image::Rgba([1, 2, 3, alpha]));
    let gray = image::GrayImage::from_pixel(1, 1, image::Luma([7]));
    assert_eq!(
        read(&encoded(gray.into())).expect("gray").pixels,
        [[7, 7, 7]]
    );
    assert_eq!(
        read(&encoded(rgba(255).into())).expect("opaque").pixels,
        [[1, 2, 3]]
    );
    assert_eq!(cause(&encoded(rgba(254).into())), "png-kind");
    let mut window = image::RgbaImage::from_pixel(2, 2, image::Rgba([9, 9, 9, 255]));
    window.put_pixel(0, 0, image::Rgba([200, 100, 50, 51]));
    let read = read(&encoded(window.into())).expect("most are opaque");
    assert_eq!(read.pixels[..2], [[40, 20, 10], [9, 9, 9]]);
    assert_eq!(read.flaw.expect("it is told").name, "png-kind");
}

#[test]
fn text_that_a_shell_has_put_into_another_encoding_is_read() {
    let encoded = |text: &str| {
        let marked = format!("\u{feff}{text}");
        let little = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big = |text: &str| text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        let wide: [Vec<u8>; 4] = [little(&marked), big(&marked), little(text), big(text)];
        let wide = wide.map(|bytes| (bytes, "utf-16"));
        wide.into_iter()
            .chain([(marked.into_bytes(), "byte-order-mark")])
    };
    for (bytes, name) in encoded("P3\r\n1 1 # grün ☀\r\n255\r\n1 2 3\r\n") {
        let reading = read(&bytes).expect("it is text");
        let flaw = reading.flaw.expect("it is told");
        assert_eq!((reading.pixels, flaw.name), (vec![[1, 2, 3]], name));
        assert!(flaw.fix.contains("PowerShell"), "{flaw}");
    }
    for (bytes, _) in encoded("P3\n1 1\n255\n1 2\n") {
        assert_eq!(cause(&bytes), "too-few-numbers");
    }
    for (bytes, name) in encoded("P6\n1 1\n255\nabc") {
        assert_eq!(cause(&bytes), name, "a shell may have changed levels");
    }
}

/// Files that are no pictures, each with the name of its cause.
const CAUSES: [(&[u8], &str); 48] = [
    (b"", "empty"),
    (b" \r\n\t", "empty"),
    (
        b"Scanlines remaining: 224\nP3\n1 1\n255\n0 0 0\n",
        "not-a-picture",
    ),
    (b"\xff\xd8\xff\xe0 JFIF", "other-format"),
    (b"P2\n1 1\n255\n0\n", "other-format"),
    (b"\x1f\x8b\x08\0", "other-format"),
    (b"data:image/png;base64,iVBORw0KGgo=", "other-format"),
    (
        b"\0\0\x02\0\0\0\0\0\0\0\0\0\x10\0\x09\0\x18\x20",
        "other-format",
    ),
    (b"\x01\x02\x03\x04", "not-a-picture"),
    (b"P\0\0\x003\0\0\0\n\0\0\0", "other-format"),
    (b"\0\0\xfe\xff\0\0\0P\0\0\x003", "other-format"),
    (b"\nP3\n1 1\n255\n0 0 0\n", "header"),
    (b"p3\n1 1\n255\n0 0 0\n", "header"),
    (b"P31 1 255 0 0 0", "header"),
    (b"P3", "header"),
    (b"P3\n1 1\n", "header"),
    (b"1 1\n255\n0 0 0\n", "missing-header"),
    (b"P3\n2 1\n1 2 3 4 5 6\n", "missing-header-number"),
    (b"P3\n2 255\n1 2 3 4 5 6\n", "missing-header-number"),
    (b"P3\n255 2 1\n1 2 3 4 5 6\n", "swapped-header-numbers"),
    (b"P3\n2 255 1\n1 2 3 4 5 6\n", "swapped-header-numbers"),
    (b"P3\n1 1\n65535\n0 0 0\n", "wrong-maximum"),
    (b"P3\n1 1\n1\n0 0 0\n", "wrong-maximum"),
    (b"P3\n1 0\n255\n", "no-pixels"),
    (b"P3\n1 1\n255\n", "no-pixels"),
    (b"P3\n-1 1\n255\n0 0 0\n", "negative-size"),
    (b"P3\n1000000 1000000\n255\n0 0 0\n", "absurd-size"),
    (
        b"P6\n4294967296 4294967296\n255\n\x80\x80\x80",
        "absurd-size",
    ),
    (b"P3\n99999999999999999999 1\n255\n0 0 0\n", "absurd-size"),
    (b"P3\n2 1\n255\n0 0 0\n", "too-few-numbers"),
    (b"P3\n1 1\n255\n0 0 0 0 0 0\n", "too-many-numbers"),
    (b"P3\n1 1\n255\n0 0 0\nDone.\n", "stray-output"),
    (b"P3\n1 1\n255\n0 0 0\n1.0\n", "stray-output"),
    (b"P3\n2 1\n255\n0 0 0 0 0 0 7\n", "stray-output"),
    (b"P3\n1 1\n255\nScanlines 1\n0 0 0\n", "text-in-body"),
    (b"P3\n1 1\n255\n\x1b[2K 0 0 0\n", "text-in-body"),
    (b"P3\n1 1\n255\n0.5 0.7 1.0\n", "fractions"),
    (b"P3\n1 1\n255\n-nan 0 0\n", "not-a-number"),
    (b"P3\n1 1\n255\n1,2,3\n", "separators"),
    (b"P3\n1 1\n255\n1 2 3\\n\n", "line-endings"),
    (
        b"P3\n1 1\n255\n0 0 0\nP3\n1 1\n255\n0 0 0\n",
        "second-picture",
    ),
    (b"P3\n1 1\n255\n\xff\xfe\xfd", "binary-in-text"),
    (b"P6\n1 1\n255\n255 255 255\n", "p6-over-text"),
    (
        b"P6\n2 2\n255\n1 1 1\n1 1 1\n1 1 1\n1 1 1\n",
        "p6-over-text",
    ),
    (b"P6\n1 1\n255\n\x80\x81", "too-few-bytes"),
    (b"P6\n1 1\n255\n\x80\x81\x82\n", "too-many-bytes"),
    (b"P6\n1 1\n255\n\x80\x81\r\n", "line-endings"),
    (b"P6\n1 1\n255\n\xef\xbf\xbd\x80", "text-conversion"),
];

#[test]
fn every_other_cause_has_its_name() {
    let swollen_png = with_crlf(&png::encode(&Chapter::Gradient.picture(16)));
    let swollen: (&[u8], &str) = (&swollen_png, "line-endings");
    let bytes = read(b"\x01\x02\x03\x04").expect_err("bytes");
    assert!(bytes.problem.contains("the bytes 01 02 03 04"), "{bytes}");
    for (bytes, expected) in CAUSES.into_iter().chain([swollen]) {
        let shown = String::from_utf8_lossy(bytes);
        assert_eq!(cause(bytes), expected, "{shown:?}");
    }
    let refused = read(b"P3\n99999999999999999999 1\n255\n0 0 0\n").expect_err("too large");
    assert!(
        refused.problem.contains("99999999999999999999 × 1"),
        "{refused}"
    );
}

#[test]
fn a_png_that_ends_too_early_or_is_broken_is_refused() {
    let png = png::encode(&Chapter::HittableList.picture(40));
    for length in [8, 20, 33, 40, png.len() / 2, png.len() - 13] {
        assert_eq!(
            cause(&png[..length]),
            "truncated-png",
            "after {length} bytes"
        );
    }
    let mut broken = png.clone();
    // In the sum over the header.
    broken[29] ^= 1;
    assert_eq!(cause(&broken), "broken-png");
}

#[test]
fn a_png_that_promises_too_much_is_refused_before_memory_is_taken() {
    let mut png = png::encode(&Chapter::Gradient.picture(16));
    // Width and height, and the sum over the header that vouches for them.
    png[16..24].copy_from_slice(&[0x7f, 0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff]);
    let sum = crc(&png[12..29]);
    png[29..33].copy_from_slice(&sum.to_be_bytes());
    assert_eq!(cause(&png), "absurd-size");
}

#[test]
fn a_wrong_count_says_what_it_looks_like() {
    let text = |count: usize| format!("P3\n4 3\n255\n{}", "9 ".repeat(count));
    for (count, hint) in [
        (12, "one number a pixel"),
        (24, "2 rows"),
        (12 * 4, "4 rows"),
        (27, "3 columns"),
        (60, "<="),
        (35, "multiple of three"),
        (39, "3 more numbers follow"),
        (37, "1 more number follows"),
        (3, "1 pixel:"),
        (51, "17 pixels:"),
    ] {
        let refused = read(text(count).as_bytes()).expect_err("36 are wanted");
        assert!(refused.fix.contains(hint), "{count}: {refused}");
        assert!(refused.problem.contains(&count.to_string()), "{refused}");
    }
}

#[test]
fn text_in_the_body_is_shown_where_it_stands_and_harmless() {
    let refused = read(b"P3\n1 1\n255\nLoading\x07\x1b]0;evil 0 0\n").expect_err("text");
    assert!(refused.problem.starts_with("line 4, byte 11"), "{refused}");
    assert!(
        !refused.to_string().contains(['\x07', '\x1b']),
        "{refused:?}"
    );
    let long = format!("P3\n1 1\n255\n{}", "x".repeat(100_000));
    assert!(read(long.as_bytes()).expect_err("text").problem.len() < 200);
}

/// Computes the checksum at the end of each chunk of a PNG.
pub(crate) fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |sum, &byte| {
        (0..8).fold(sum ^ u32::from(byte), |sum, _| {
            (sum >> 1) ^ (0xedb8_8320 * (sum & 1))
        })
    })
}

/// Puts a carriage return before each new line.
fn with_crlf(bytes: &[u8]) -> Vec<u8> {
    let lines: Vec<&[u8]> = bytes.split(|&byte| byte == b'\n').collect();
    lines.join(&b"\r\n"[..])
}

fn cause(bytes: &[u8]) -> &'static str {
    match read(bytes) {
        Err(Cause { name, .. }) => name,
        Ok(_) => "none: it is a picture",
    }
}

pub(crate) fn p6(picture: &Picture) -> Vec<u8> {
    let header = format!("P6\n{} {}\n255\n", picture.width(), picture.height());
    [header.as_bytes(), picture.rgb()].concat()
}

/// Returns the P3 text of a picture.
fn p3(picture: &Picture) -> Vec<u8> {
    let mut text = Vec::new();
    picture.write_p3(&mut text).expect("memory takes it");
    text
}
