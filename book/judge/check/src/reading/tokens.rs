//! A tokenizer for PPM: words, comments and line ends.

use super::cause::Cause;

/// Words between white space, each with its place in the file. What follows a
/// `#` up to the end of the line is a comment.
///
/// A comment may stand right behind a number, as in `400#width`, and ends it, as
/// netpbm's own tools have it. Behind anything else, a `#` belongs to the word: of
/// `1.#IND`, which Windows prints for NaN, a message shows all.
#[derive(Clone)]
pub(super) struct Tokens<'a> {
    bytes: &'a [u8],
    at: usize,
}

/// A word of the text.
#[derive(Clone, Copy)]
pub(super) struct Token<'a> {
    pub(super) word: &'a [u8],
    start: usize,
}

impl<'a> Tokens<'a> {
    /// The words after the two letters that say which format it is.
    pub(super) fn after_magic(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 2 }
    }

    /// Where bytes begin that are no words: after the one byte of white space that
    /// ends the last word. As netpbm has it, a comment right behind the word comes
    /// before that byte, which is then the end of its line.
    pub(super) fn body(&self) -> usize {
        self.at + self.comment() + 1
    }

    /// How long the comment is that begins here, without the end of the line; 0 if
    /// none does.
    fn comment(&self) -> usize {
        let rest = &self.bytes[self.at..];
        let is_end = |byte: &u8| b"\r\n".contains(byte);
        match rest {
            [b'#', ..] => rest.iter().position(is_end).unwrap_or(rest.len()),
            _ => 0,
        }
    }
}

impl<'a> Iterator for Tokens<'a> {
    type Item = Token<'a>;

    fn next(&mut self) -> Option<Token<'a>> {
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
        let token = Token {
            word: &rest[..length.unwrap_or(rest.len())],
            start,
        };
        let token = token.before_comment().unwrap_or(token);
        self.at += token.word.len();
        Some(token)
    }
}

impl Token<'_> {
    /// The number that stands before a comment in this word, if one does.
    fn before_comment(self) -> Option<Self> {
        let end = self.word.iter().position(|&byte| byte == b'#')?;
        let word = &self.word[..end];
        let token = Self { word, ..self };
        token.number().map(|_| token)
    }

    /// Returns the number that the word is; one beyond 64 bits is the largest, since
    /// no size and no level is that large.
    pub(super) fn number(&self) -> Option<i64> {
        let (negative, digits) = match self.word {
            [b'-', digits @ ..] => (true, digits),
            [b'+', digits @ ..] => (false, digits),
            digits => (false, digits),
        };
        if digits.is_empty() {
            return None;
        }
        let mut number: i64 = 0;
        for digit in digits {
            if !digit.is_ascii_digit() {
                return None;
            }
            let digit = i64::from(digit - b'0');
            number = number.saturating_mul(10).saturating_add(digit);
        }
        Some(if negative { -number } else { number })
    }

    /// The word as a message can show it: short and harmless.
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

    /// Where the word is, for a message.
    pub(super) fn place(&self, bytes: &[u8]) -> String {
        // The old Macintosh ended a line with 13 alone, Windows does with 13 and 10.
        let is_end = |at: &usize| match bytes[*at] {
            b'\r' => bytes.get(at + 1) != Some(&b'\n'),
            byte => byte == b'\n',
        };
        let lines = (0..self.start).filter(is_end).count() + 1;
        format!("line {lines}, byte {}", self.start)
    }

    /// Returns what is wrong with a word after the last pixel, whatever it is.
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

    /// Why the word is no number, though one should be there.
    pub(super) fn cause(&self, bytes: &[u8]) -> Cause {
        let problem = |what: &str| {
            let (word, place) = (self.shown(), self.place(bytes));
            format!("{place}: {word:?} {what}")
        };
        let text = String::from_utf8_lossy(self.word);
        let lower = text.trim_start_matches(['-', '+']).to_ascii_lowercase();
        if self.word.contains(&0x1b) {
            Cause::new(
                "text-in-body",
                problem("has terminal colors in it"),
                NO_TEXT,
            )
        } else if ["nan", "inf", "1.#"]
            .iter()
            .any(|odd| lower.starts_with(odd))
        {
            Cause::new(
                "not-a-number",
                problem(
                    "is what a division by zero, or the square root of a negative number, prints",
                ),
                "Convert to int before printing, and look for 0 / 0: a direction of length zero, or a width of 1 without a guard.",
            )
        } else if text.parse::<f64>().is_ok() {
            Cause::new(
                "fractions",
                problem("is not a whole number"),
                "Print integers alone, as sizes and as levels: int(255.999 * r).",
            )
        } else if text.contains("\\n") {
            Cause::new(
                "line-endings",
                problem("has the two characters \\ and n in it instead of a new line"),
                "Write \"\\n\" between double quotes, in the language's own way.",
            )
        } else if text.contains('\u{a0}') {
            Cause::new(
                "separators",
                problem("has a no-break space in it, which looks like a space"),
                "Type ordinary spaces between the numbers, in the header too.",
            )
        } else if text.contains([',', ';', '(', '[', '{']) {
            Cause::new(
                "separators",
                problem("has more than digits in it"),
                "Separate the numbers by spaces and new lines alone, without commas or brackets.",
            )
        } else if self.word == b"P3" || self.word == b"P6" {
            Cause::new(
                "second-picture",
                problem("begins a second picture"),
                "Write into a new file: >> appends to what is there, > replaces it.",
            )
        } else if self
            .word
            .iter()
            .any(|byte| !byte.is_ascii() || *byte < b' ')
        {
            Cause::new(
                "binary-in-text",
                problem("is not text"),
                "P3 is followed by numbers as text: does something else print to standard output, as \"press any key\" in another language? Print the numbers as text, with spaces between them.",
            )
        } else if let [b'0'..=b'9', .., b'n'] = self.word[..] {
            Cause::new(
                "text-in-body",
                problem("stands among the numbers"),
                "A line ends with \\n: is the backslash missing?",
            )
        } else {
            Cause::new("text-in-body", problem("stands among the numbers"), NO_TEXT)
        }
    }
}

const NO_TEXT: &str = "Only the picture goes to standard output. Send progress and messages to standard error: std::clog, eprintln!, sys.stderr.";

fn is_space(byte: u8) -> bool {
    // The vertical tab and the form feed are white space to a PPM as well.
    matches!(byte, b' ' | b'\t'..=b'\r')
}
