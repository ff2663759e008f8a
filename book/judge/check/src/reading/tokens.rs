//! A tokenizer for the text of PPM files: words, comments and line ends.

use super::cause::Cause;

/// An iterator over the words of a PPM file that stand between white space. A `#` and the rest of
/// its line are a comment.
///
/// A comment may follow a number at once, as in `400#width`, and ends it, as netpbm's own tools
/// have it. A `#` that follows anything else belongs to the word, so that a message shows all of
/// `1.#IND`, which Windows prints for NaN.
#[derive(Clone)]
pub(super) struct PpmTokens<'a> {
    /// The bytes of the file.
    bytes: &'a [u8],
    /// The index of the first byte that is not yet read.
    at: usize,
}

/// A word of a PPM file.
#[derive(Clone, Copy)]
pub(super) struct PpmToken<'a> {
    /// The bytes of the word, at least one.
    pub(super) word: &'a [u8],
    /// The index of its first byte in the file.
    start: usize,
}

impl<'a> PpmTokens<'a> {
    /// Begins behind the two letters that name the format, `P3` or `P6`.
    pub(super) fn after_magic(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 2 }
    }

    /// Returns the index of the first byte behind the header of a P6 file: the one after the single
    /// byte of white space that ends the last word. As netpbm has it, a comment that follows the
    /// word at once comes before that byte, which is then the end of the comment's line. May lie
    /// beyond the end of the file.
    pub(super) fn body(&self) -> usize {
        self.at + self.comment() + 1
    }

    /// Returns the length in bytes of the comment that begins at the next byte, without the end of
    /// its line; 0 if none does.
    fn comment(&self) -> usize {
        let rest = &self.bytes[self.at..];
        let is_end = |byte: &u8| b"\r\n".contains(byte);
        match rest {
            [b'#', ..] => rest.iter().position(is_end).unwrap_or(rest.len()),
            _ => 0,
        }
    }
}

impl<'a> Iterator for PpmTokens<'a> {
    type Item = PpmToken<'a>;

    fn next(&mut self) -> Option<PpmToken<'a>> {
        loop {
            let byte = *self.bytes.get(self.at)?;
            if byte == b'#' {
                self.at += self.comment();
            } else if is_space(byte) {
                self.at += 1;
            } else {
                break;
            }
        }
        let start = self.at;
        let rest = &self.bytes[start..];
        let length = rest.iter().position(|&byte| is_space(byte));
        let token = PpmToken {
            word: &rest[..length.unwrap_or(rest.len())],
            start,
        };
        let token = token.before_comment().unwrap_or(token);
        self.at += token.word.len();
        Some(token)
    }
}

impl PpmToken<'_> {
    /// Returns the part before a `#` of this word, if that part is a number.
    fn before_comment(self) -> Option<Self> {
        let end = self.word.iter().position(|&byte| byte == b'#')?;
        let word = &self.word[..end];
        let token = Self { word, ..self };
        token.number().map(|_| token)
    }

    /// Parses the word as a whole number with an optional sign; `None` if it is none. A number
    /// beyond 64 bits becomes ±(2⁶³ − 1).
    pub(super) fn number(&self) -> Option<i64> {
        let (sign, digits) = match self.word {
            [b'-', digits @ ..] => (-1, digits),
            [b'+', digits @ ..] | digits => (1, digits),
        };
        let is_number = !digits.is_empty() && digits.iter().all(u8::is_ascii_digit);
        let add = |number: i64, digit: &u8| {
            let digit = i64::from(digit - b'0');
            number.saturating_mul(10).saturating_add(digit)
        };
        is_number.then(|| sign * digits.iter().fold(0, add))
    }

    /// Returns the word as a message can show it: its first 24 characters, with `·` for a control
    /// character, and `…` behind them if the word has more bytes.
    pub(super) fn shown(&self) -> String {
        const LONGEST: usize = 24;
        let shown: String = String::from_utf8_lossy(&self.word[..self.word.len().min(4 * LONGEST)])
            .chars()
            .map(|letter| if letter.is_control() { '·' } else { letter })
            .take(LONGEST)
            .collect();
        if self.word.len() > LONGEST {
            shown + "…"
        } else {
            shown
        }
    }

    /// Names the line, counted from 1, and the byte, counted from 0, at which the word begins in
    /// the file of these `bytes`.
    pub(super) fn place(&self, bytes: &[u8]) -> String {
        // The old Macintosh ended a line with 13 alone, Windows does with 13 and 10.
        let is_end = |at: &usize| match bytes[*at] {
            b'\r' => bytes.get(at + 1) != Some(&b'\n'),
            byte => byte == b'\n',
        };
        let lines = (0..self.start).filter(is_end).count() + 1;
        format!("line {lines}, byte {}", self.start)
    }

    /// Names what is wrong with a word that follows the last pixel.
    pub(super) fn stray(&self, bytes: &[u8]) -> Cause {
        if matches!(self.word, b"P3" | b"P6") {
            return self.cause(bytes);
        }
        let (word, place) = (self.shown(), self.place(bytes));
        Cause::new(
            "stray-output",
            format!("{place}: after the last pixel stands {word:?}"),
            NO_TEXT,
        )
    }

    /// Names what is wrong with a word where a number should be, which is no number.
    pub(super) fn cause(&self, bytes: &[u8]) -> Cause {
        let text = String::from_utf8_lossy(self.word);
        let fault = FAULTS.iter().find(|(is_it, ..)| is_it(&text));
        let (_, name, problem, fix) = *fault.expect("the last fault is that of any word");
        let (word, place) = (self.shown(), self.place(bytes));
        Cause::new(name, format!("{place}: {word:?} {problem}"), fix)
    }
}

/// A test of a word that is no number, and the name, the problem and the fix of its fault.
type WordFault = (fn(&str) -> bool, &'static str, &'static str, &'static str);

/// The faults of words that are no numbers; the first whose test a word passes is its fault.
const FAULTS: [WordFault; 10] = [
    (
        |word| word.contains('\u{1b}'),
        "text-in-body",
        "has terminal colors in it",
        NO_TEXT,
    ),
    (
        is_not_a_number,
        "not-a-number",
        "is what a division by zero, or the square root of a negative number, prints",
        "Convert to int before printing, and look for 0 / 0: a direction of length zero, or a width of 1 without a guard.",
    ),
    (
        |word| word.parse::<f64>().is_ok(),
        "fractions",
        "is not a whole number",
        "Print integers alone, as sizes and as levels: int(255.999 * r).",
    ),
    (
        |word| word.contains("\\n"),
        "line-endings",
        "has the two characters \\ and n in it instead of a new line",
        "Write \"\\n\" between double quotes, in the language's own way.",
    ),
    (
        |word| word.contains('\u{a0}'),
        "separators",
        "has a no-break space in it, which looks like a space",
        "Type ordinary spaces between the numbers, in the header too.",
    ),
    (
        |word| word.contains([',', ';', '(', '[', '{']),
        "separators",
        "has more than digits in it",
        "Separate the numbers by spaces and new lines alone, without commas or brackets.",
    ),
    (
        |word| matches!(word, "P3" | "P6"),
        "second-picture",
        "begins a second picture",
        "Write into a new file: >> appends to what is there, > replaces it.",
    ),
    (
        |word| word.contains(|letter: char| !letter.is_ascii() || letter < ' '),
        "binary-in-text",
        "is not text",
        "P3 is followed by numbers as text: does something else print to standard output, as \"press any key\" in another language? Print the numbers as text, with spaces between them.",
    ),
    (
        |word| word.starts_with(|letter: char| letter.is_ascii_digit()) && word.ends_with('n'),
        "text-in-body",
        "stands among the numbers",
        "A line ends with \\n: is the backslash missing?",
    ),
    (
        |_| true,
        "text-in-body",
        "stands among the numbers",
        NO_TEXT,
    ),
];

/// Returns true if C or C++ prints a NaN or an infinity as this word.
fn is_not_a_number(word: &str) -> bool {
    let word = word.trim_start_matches(['-', '+']).to_ascii_lowercase();
    ["nan", "inf", "1.#"].iter().any(|it| word.starts_with(it))
}

/// The fix for text among the numbers.
const NO_TEXT: &str = "Only the picture goes to standard output. Send progress and messages to standard error: std::clog, eprintln!, sys.stderr.";

/// Returns true for a byte that is white space in a PPM file.
fn is_space(byte: u8) -> bool {
    // The vertical tab and the form feed are white space to a PPM as well.
    matches!(byte, b' ' | b'\t'..=b'\r')
}
