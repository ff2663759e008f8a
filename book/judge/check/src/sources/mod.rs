//! Token alignment: the reader's own lines beside those of the chapter.
//!
//! Two programs are compared as sequences of words and signs, so that spaces, comments,
//! and how a language declares a variable don't matter.

mod tokens;

use slips::{Chapter, Words};

pub(crate) use tokens::lexed;
use tokens::{Token, is_name, tokens};

/// What a reader wrote, and the chapter as it should be.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    yours: Vec<File>,
    chapter: Vec<File>,
}

/// A line that somebody typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The file, as seen from the folder of the program.
    pub file: String,
    /// Its number, from 1.
    pub number: usize,
    /// What it says.
    pub text: String,
}

/// What a reader's files say of a slip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Said {
    /// The wrong line is there.
    Wrong,
    /// The line is right.
    Right,
    /// Neither is found.
    Neither,
}

/// What is looked for in a file.
struct Snippet {
    tokens: Vec<Token>,
    /// Whether it is what some name is given, or what is returned.
    is_value: bool,
}

#[derive(Clone, Debug)]
struct File {
    name: String,
    text: String,
    tokens: Vec<Token>,
}

impl Sources {
    /// The files by their names and texts: the reader's, and those of the chapter if the
    /// reader types just these.
    pub fn new(yours: Vec<(String, String)>, chapter: Vec<(String, String)>) -> Self {
        let files = |files: Vec<(String, String)>| {
            let files = files.into_iter();
            files.map(|(name, text)| File::new(name, text)).collect()
        };
        Self {
            yours: files(yours),
            chapter: files(chapter),
        }
    }

    /// The files of a reader who types the chapter, beside its own.
    pub fn of_chapter(yours: Vec<(String, String)>, chapter: Chapter) -> Self {
        let owned = |&(name, text): &(&str, &str)| (name.to_owned(), text.to_owned());
        Self::new(yours, chapter.files().iter().map(owned).collect())
    }

    /// Whether they are those of the chapter and no other program.
    pub(crate) fn are_of_the_chapter(&self) -> bool {
        !self.chapter.is_empty()
    }

    /// Those in Rust but for the program's own, the root first.
    pub(crate) fn in_rust(&self) -> Vec<(String, String)> {
        let is_read = |it: &&File| it.name.ends_with(".rs") && !it.name.ends_with("main.rs");
        let files = self.yours.iter().filter(is_read);
        let mut files: Vec<_> = files.map(|it| (it.name.clone(), it.text.clone())).collect();
        files.sort_by_key(|(name, _)| !name.ends_with("lib.rs"));
        files
    }

    /// All of them, by their names and texts.
    pub(crate) fn files(&self) -> Vec<(String, String)> {
        let files = self.yours.iter();
        files.map(|it| (it.name.clone(), it.text.clone())).collect()
    }

    /// Whether nothing is known of them.
    pub(crate) fn is_empty(&self) -> bool {
        self.yours.is_empty()
    }

    /// What they say of a slip: of a snippet in another one the longer counts.
    pub(crate) fn say(&self, words: &Words) -> Said {
        // A cast, for example, is no token.
        let same = |one: &[Token], other: &[Token]| {
            let text = |it: &Token| it.text.clone();
            one.iter().map(text).eq(other.iter().map(text))
        };
        if same(&tokens(&words.wrong), &tokens(&words.right)) {
            return Said::Neither;
        }
        // By another name the wrong line of one formula is the right one of another.
        let longest = |snippets: &str, free: &[&str]| {
            let snippets = self.snippets(snippets).into_iter();
            let found = snippets.filter(|it| self.find(it, free).is_some());
            found.map(|it| it.tokens.len()).max()
        };
        match (
            longest(&words.wrong, &[]),
            longest(&words.right, &VARIABLES),
        ) {
            (None, None) => Said::Neither,
            // A line is wrong only in the place of one that could be found, and is no part of it.
            (Some(_), None) if !self.is_told_apart(words) => Said::Neither,
            (wrong, right) if wrong > right => Said::Wrong,
            _ => Said::Right,
        }
    }

    /// The reader's line that makes the slip, if it is found.
    pub(crate) fn line_of(&self, words: Words) -> Option<Line> {
        self.snippets(&words.wrong)
            .iter()
            .find_map(|it| self.find(it, &[]))
    }

    /// What can be looked for: each alternative as it is, and without the name that it gives.
    fn snippets(&self, alternatives: &str) -> Vec<Snippet> {
        let whole = alternatives.split(", or ").filter(|it| !it.contains('…'));
        let whole = whole.map(|it| self.without_colors(it));
        let with_values = whole.flat_map(|tokens| {
            let value = value(&tokens).to_vec();
            let is_shorter = VALUE < value.len() && value.len() < tokens.len();
            let value = is_shorter.then_some(Snippet {
                tokens: value,
                is_value: true,
            });
            let is_value = false;
            [Some(Snippet { tokens, is_value }), value]
        });
        with_values
            .flatten()
            .filter(|it| it.tokens.len() > 2)
            .collect()
    }

    /// The tokens with the two colors of the sky in their places, if they have no names.
    fn without_colors(&self, snippet: &str) -> Vec<Token> {
        let mut snippet = snippet.to_owned();
        for (name, color) in COLORS {
            if !self.has(name) {
                snippet = snippet.replace(name, color);
            }
        }
        tokens(&snippet)
    }

    /// Whether the word is in one of the files.
    fn has(&self, word: &str) -> bool {
        let mut tokens = self.yours.iter().flat_map(|file| &file.tokens);
        tokens.any(|token| token.text == word)
    }

    /// Where the snippet is, with the variables by other names where a program has these.
    fn find(&self, snippet: &Snippet, variables: &[&str]) -> Option<Line> {
        let is_free =
            |name: &str| PARAMETERS.contains(&name) || variables.contains(&name) && !self.has(name);
        let mut free: Vec<&str> = snippet.tokens.iter().map(|it| it.text.as_str()).collect();
        free.retain(|name| is_free(name));
        self.yours.iter().find_map(|file| file.find(snippet, &free))
    }

    /// Whether the right line can be looked for, and does not have the wrong one in it.
    fn is_told_apart(&self, words: &Words) -> bool {
        let joined = |text: &str| {
            let tokens = tokens(text).into_iter().map(|token| token.text);
            tokens.collect::<Vec<_>>().join(" ")
        };
        let is_searched = !self.snippets(&words.right).is_empty();
        // Where nothing is said of it, it is a whole line of the chapter.
        let is_line = words.why.is_empty();
        is_searched && (is_line || !joined(&words.right).contains(&joined(&words.wrong)))
    }

    /// Whether the chapter's functions are as long as there, right or wrong, but for less than a
    /// statement. What stands in functions of the reader's own counts with them.
    pub(crate) fn is_written(&self) -> bool {
        let [chapter, yours] = [&self.chapter, &self.yours].map(|files| {
            let files = files.iter();
            files.map(File::functions).collect::<Vec<_>>()
        });
        let is_of_chapter = |name: &str| chapter.iter().flatten().any(|(it, _)| *it == name);
        // A prelude has none of the chapter's functions, and `start` gives a sky.
        let counts = |functions: &&Vec<(&str, &[Token])>| {
            functions
                .iter()
                .any(|(name, _)| *name != "new" && is_of_chapter(name))
        };
        let yours = yours.iter().filter(counts).flatten();
        let yours = yours.filter(|(name, _)| *name != "sky");
        let [theirs, own] = [
            chapter
                .iter()
                .flatten()
                .map(|(_, it)| it.len())
                .sum::<usize>(),
            yours.map(|(_, it)| it.len()).sum(),
        ];
        self.are_of_the_chapter() && own + STATEMENT > theirs
    }
}

/// So many tokens are a statement.
const STATEMENT: usize = 6;
/// Signs before and after a part of a formula.
const GOES_ON: [&str; 10] = ["+", "-", "*", "/", "<", ">", ".", "and", "&", "|"];

/// A value of so few tokens may stand anywhere.
const VALUE: usize = 4;
/// The colors of the sky, where they have no names.
const COLORS: [(&str, &str); 2] = [("white", "Color(1, 1, 1)"), ("blue", "Color(0.5, 0.7, 1)")];
/// Words of a snippet that stand for any other one, always or where a program has other names.
const PARAMETERS: [&str; 2] = ["u", "v"];
const VARIABLES: [&str; 6] = ["a", "b", "h", "c", "oc", "unit_direction"];

/// What is returned, or given to a name.
fn value(snippet: &[Token]) -> &[Token] {
    let is = |n: usize, text: &str| snippet.get(n).is_some_and(|it| it.text == text);
    let end = snippet.len();
    match snippet.iter().position(|it| it.text == "=") {
        Some(at) if is_name(&snippet[0].text) && at < 5 && !is(at + 1, "=") => &snippet[at + 1..],
        _ if is(0, "return") => &snippet[1..],
        _ if is(0, "Some") && is(1, "(") && is(end - 1, ")") => &snippet[2..end - 1],
        _ => snippet,
    }
}

impl File {
    fn new(name: String, text: String) -> Self {
        // Some editors begin a file with a byte order mark.
        let text = text.trim_start_matches('\u{feff}').to_owned();
        let tokens = tokens(&with_brackets(&name, &text));
        Self { name, text, tokens }
    }

    /// The line on which these tokens begin, with other names for the free ones.
    fn find(&self, snippet: &Snippet, free: &[&str]) -> Option<Line> {
        let part = &snippet.tokens[..];
        // A part of a longer formula is another one.
        let goes_on = |n: Option<usize>| {
            let token = n.and_then(|n| self.tokens.get(n));
            token.is_some_and(|it| GOES_ON.contains(&it.text.as_str()))
        };
        // A value is given to a name, or returned.
        let is_given = |n: usize| {
            let before = n.checked_sub(1).map(|n| self.tokens[n].text.as_str());
            matches!(before, Some("=" | "return" | ";" | "{" | "}"))
        };
        let is_whole = |n: &usize| {
            let is_alone = !goes_on(n.checked_sub(1)) && !goes_on(Some(n + part.len()));
            is_alone && (!snippet.is_value || is_given(*n))
        };
        let places = self.tokens.windows(part.len()).enumerate();
        let mut found = places.filter(|(_, tokens)| is_same(part, tokens, free));
        let (at, _) = found.find(|(n, _)| is_whole(n))?;
        Some(self.line(self.tokens[at].line))
    }

    fn line(&self, line: usize) -> Line {
        Line {
            file: self.name.clone(),
            number: line + 1,
            text: self
                .text
                .lines()
                .nth(line)
                .unwrap_or_default()
                .trim()
                .to_owned(),
        }
    }

    /// Each function of Rust with a body, by its name, from there to the closing brace.
    fn functions(&self) -> Vec<(&str, &[Token])> {
        let is_fn = |n: &usize| self.tokens[*n].text == "fn";
        let starts = (0..self.tokens.len()).filter(is_fn);
        let function = |start: usize| {
            let name = &self.tokens.get(start + 1)?.text;
            let mut depth = 0;
            for (n, token) in self.tokens.iter().enumerate().skip(start) {
                match token.text.as_str() {
                    ";" if depth == 0 => return None,
                    "{" => depth += 1,
                    "}" if depth == 1 => return Some((name.as_str(), &self.tokens[start..=n])),
                    "}" => depth -= 1,
                    _ => {}
                }
            }
            None
        };
        starts.filter_map(function).collect()
    }
}

/// What C++ makes in braces as it is made in brackets, line for line.
pub(crate) fn with_brackets(name: &str, text: &str) -> String {
    if name.ends_with(".py") || name.ends_with(".rs") {
        return text.to_owned();
    }
    let mut open = Vec::new();
    let mut before = String::new();
    for letter in text.chars() {
        let is_value = || {
            let ends_with = |c: char| c.is_alphanumeric() || ",(={".contains(c);
            let last = before.trim_end();
            before.ends_with(ends_with)
                || last.ends_with([',', '(', '='])
                || last.ends_with("return")
        };
        let letter = match letter {
            '{' => {
                open.push(is_value());
                if is_value() { '(' } else { letter }
            }
            '}' if open.pop() == Some(true) => ')',
            _ => letter,
        };
        before.push(letter);
    }
    before
}

/// Whether the tokens are the same, but for names that stand for the free ones.
fn is_same(part: &[Token], tokens: &[Token], free: &[&str]) -> bool {
    let mut names: Vec<(&str, &str)> = Vec::new();
    part.iter().zip(tokens).all(|(part, token)| {
        let (part, token) = (part.text.as_str(), token.text.as_str());
        if !free.contains(&part) {
            return part == token && names.iter().all(|(_, own)| *own != token);
        }
        match names
            .iter()
            .find(|(name, own)| *name == part || *own == token)
        {
            Some(known) => *known == (part, token),
            None => {
                names.push((part, token));
                is_name(token)
            }
        }
    })
}
