//! A lookup table for decimal numbers: 256 texts, made when the first one is needed.
//!
//! Formatting the three numbers of a pixel takes the book's program five times
//! as long as tracing its ray. There are only 256 of them: format each once,
//! then copy.

use std::array;
use std::sync::LazyLock;

use super::block::{BLOCK, Block};

/// Appends the first `count` pixels of `block` to `text`, each as a line `red green blue`.
pub(super) fn push_pixels(text: &mut Vec<u8>, block: &Block, count: usize) {
    let mut lines = [0; BLOCK * LONGEST_LINE + 4];
    let mut end = 0;
    let (spaced, last) = (&*SPACED, &*LAST);
    let mut push = |number: NumberText| {
        // Always four bytes, because copying fewer takes a decision. What is
        // too much is overwritten by the next number, or cut off below.
        lines[end..end + 4].copy_from_slice(&number.text);
        end += number.length;
    };
    let levels = block.red.iter().zip(&block.green).zip(&block.blue);
    for ((&red, &green), &blue) in levels.take(count) {
        push(spaced[usize::from(red)]);
        push(spaced[usize::from(green)]);
        push(last[usize::from(blue)]);
    }
    text.extend_from_slice(&lines[..end]);
}

const LONGEST_LINE: usize = "255 255 255\n".len();

/// The numbers 0 to 255, each with a space behind it.
static SPACED: LazyLock<[NumberText; 256]> = LazyLock::new(|| numbers(' '));

/// The numbers 0 to 255, each with an end of line behind it.
static LAST: LazyLock<[NumberText; 256]> = LazyLock::new(|| numbers('\n'));

/// A number as text with its separator: `length` bytes, filled up with zeros to four.
#[derive(Clone, Copy)]
struct NumberText {
    text: [u8; 4],
    length: usize,
}

fn numbers(separator: char) -> [NumberText; 256] {
    array::from_fn(|n| {
        let line = format!("{n}{separator}");
        let mut text = [0; 4];
        text[..line.len()].copy_from_slice(line.as_bytes());
        NumberText {
            text,
            length: line.len(),
        }
    })
}
