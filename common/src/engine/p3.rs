//! A lookup table for decimal numbers: 256 texts, made when the program is compiled.
//!
//! Formatting the three numbers of a pixel takes the book's program five times
//! as long as tracing its ray. There are only 256 of them: format each once,
//! then copy.

use super::block::{BLOCK, Block};

/// Appends a line for each of the first `count` pixels of `block`.
pub(super) fn push_pixels(text: &mut Vec<u8>, block: &Block, count: usize) {
    let mut lines = [0; BLOCK * LONGEST_LINE + 4];
    let mut end = 0;
    let mut push = |number: Number| {
        // Always four bytes, because copying fewer takes a decision. What is
        // too much is overwritten by the next number, or cut off below.
        lines[end..end + 4].copy_from_slice(&number.text);
        end += number.length;
    };
    let levels = block.red.iter().zip(&block.green).zip(&block.blue);
    for ((&red, &green), &blue) in levels.take(count) {
        push(SPACED[usize::from(red)]);
        push(SPACED[usize::from(green)]);
        push(LAST[usize::from(blue)]);
    }
    text.extend_from_slice(&lines[..end]);
}

const LONGEST_LINE: usize = "255 255 255\n".len();

/// The numbers 0 to 255, each with the space that follows it.
static SPACED: [Number; 256] = numbers(b' ');

/// The numbers 0 to 255, each with the end of the line.
static LAST: [Number; 256] = numbers(b'\n');

/// A number as text with a separator: `length` bytes, filled up to four.
#[derive(Clone, Copy)]
struct Number {
    text: [u8; 4],
    length: usize,
}

const fn numbers(separator: u8) -> [Number; 256] {
    let mut numbers = [Number {
        text: [separator; 4],
        length: 0,
    }; 256];
    let mut n = 0;
    while n < 256 {
        let digits = [n / 100, n / 10 % 10, n % 10];
        let mut k = if n < 10 {
            2
        } else if n < 100 {
            1
        } else {
            0
        };
        while k < 3 {
            numbers[n].text[numbers[n].length] = b'0' + digits[k] as u8;
            numbers[n].length += 1;
            k += 1;
        }
        numbers[n].length += 1;
        n += 1;
    }
    numbers
}
