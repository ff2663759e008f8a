//! Token alignment: the reader's own lines beside those of the chapter.
//!
//! Two programs are compared as sequences of words and signs, so that spaces, comments,
//! and how a language declares a variable don't matter.

use std::ops::Range;

use slips::Words;

/// What a reader wrote, and the chapter as it should be.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    yours: Vec<File>,
    chapter: Vec<File>,
    /// Where the reader's functions are not the chapter's of the same names.
    unlike: Vec<Unlike>,
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

/// A place where what a reader wrote is not what the chapter has.
#[derive(Clone, Debug)]
pub struct Unlike {
    /// The reader's line; the one before, if a line is missing.
    pub yours: Line,
    /// What the chapter has there: nothing, if there is something too much.
    pub chapter: String,
    /// Whether the chapter has a line there that the reader has not.
    pub is_missing: bool,
    /// How many tokens more the chapter has there.
    more: isize,
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

#[derive(Clone, Debug)]
struct File {
    name: String,
    lines: Vec<String>,
    tokens: Vec<Token>,
}

#[derive(Clone, Debug)]
struct Token {
    text: String,
    /// The line, from 0.
    line: usize,
}

impl Sources {
    /// The files by their names and texts: the reader's, and those of the chapter if the
    /// reader types just these.
    pub fn new(yours: Vec<(String, String)>, chapter: Vec<(String, String)>) -> Self {
        let files = |files: Vec<(String, String)>| {
            let files = files.into_iter();
            files.map(|(name, text)| File::new(name, &text)).collect()
        };
        let mut sources = Self {
            yours: files(yours),
            chapter: files(chapter),
            unlike: Vec::new(),
        };
        sources.unlike = sources.pairs().flat_map(|pair| pair.unlike()).collect();
        sources
    }

    /// Whether they are those of the chapter and no other program.
    pub(crate) fn are_of_the_chapter(&self) -> bool {
        !self.chapter.is_empty()
    }

    /// Whether the prelude is the reader's own, too.
    pub(crate) fn have_a_prelude(&self) -> bool {
        self.yours.iter().any(|it| it.name == "src/rtweekend.rs")
    }

    /// Whether nothing is known of them.
    pub(crate) fn is_empty(&self) -> bool {
        self.yours.is_empty()
    }

    /// What they say of a slip: of a snippet in another one the longer counts.
    pub(crate) fn say(&self, words: &Words) -> Said {
        let longest = |snippets: &str| {
            let found = alternatives(snippets).filter(|it| self.find(it).is_some());
            found.map(|it| it.len()).max()
        };
        match (longest(&words.wrong), longest(&words.right)) {
            (None, None) => Said::Neither,
            // A line is wrong only in the place of one that could be found, and is no part of it.
            (Some(_), None) if !is_told_apart(words) => Said::Neither,
            (wrong, right) if wrong > right => Said::Wrong,
            _ => Said::Right,
        }
    }

    /// The reader's line that makes the slip, if it is found.
    pub(crate) fn line_of(&self, words: Words) -> Option<Line> {
        alternatives(&words.wrong).find_map(|it| self.find(&it))
    }

    fn find(&self, snippet: &[Token]) -> Option<Line> {
        self.yours.iter().find_map(|file| file.find(snippet))
    }

    /// The places where the reader's functions are not the chapter's of the same names; none
    /// where these are more than [`FEW`], since then they are written in other words.
    pub fn unlike(&self) -> &[Unlike] {
        match self.unlike.len() <= FEW {
            true => &self.unlike,
            false => &[],
        }
    }

    /// Whether all that the chapter has is there, line by line, right or wrong.
    pub(crate) fn is_written(&self) -> bool {
        let more: isize = self.unlike.iter().map(|it| it.more).sum();
        !self.chapter.is_empty() && more < STATEMENT
    }

    /// Functions that have the same name in files of the same name.
    fn pairs(&self) -> impl Iterator<Item = Pair<'_>> {
        self.chapter.iter().flat_map(move |chapter| {
            let yours = self.yours.iter().find(|it| it.name == chapter.name);
            yours.into_iter().flat_map(move |yours| {
                let own = yours.functions();
                let functions = chapter.functions().into_iter();
                functions.filter_map(move |(name, theirs)| {
                    let (_, own) = own.iter().find(|(own, _)| *own == name)?;
                    Some(Pair::new((yours, own), (chapter, theirs)))
                })
            })
        })
    }
}

/// So many tokens are a statement.
const STATEMENT: isize = 6;
/// Signs before and after a part of a formula.
const GOES_ON: [&str; 10] = ["+", "-", "*", "/", "<", ">", ".", "and", "&", "|"];

/// More differences than this are another way to write it.
const FEW: usize = 3;

/// Snippets of the catalogue: `one, or another`. One in which something is left out can't
/// be looked for.
fn alternatives(snippets: &str) -> impl Iterator<Item = Vec<Token>> {
    let whole = snippets.split(", or ").filter(|it| !it.contains('…'));
    whole.map(tokens).filter(|snippet| snippet.len() > 2)
}

/// Whether the right line can be looked for, and does not have the wrong one in it.
fn is_told_apart(words: &Words) -> bool {
    let joined = |text: &str| {
        let tokens = tokens(text).into_iter().map(|token| token.text);
        tokens.collect::<Vec<_>>().join(" ")
    };
    let is_searched = alternatives(&words.right).next().is_some();
    is_searched && !joined(&words.right).contains(&joined(&words.wrong))
}

impl File {
    fn new(name: String, text: &str) -> Self {
        Self {
            name,
            lines: text.lines().map(str::to_owned).collect(),
            tokens: tokens(text),
        }
    }

    /// The line on which these tokens begin.
    fn find(&self, part: &[Token]) -> Option<Line> {
        let same = |tokens: &[Token]| {
            tokens
                .iter()
                .zip(part)
                .all(|(one, other)| one.text == other.text)
        };
        // A part of a longer formula is another one.
        let goes_on = |n: Option<usize>| {
            let token = n.and_then(|n| self.tokens.get(n));
            token.is_some_and(|it| GOES_ON.contains(&it.text.as_str()))
        };
        let is_whole = |n: &usize| !goes_on(n.checked_sub(1)) && !goes_on(Some(n + part.len()));
        let places = self.tokens.windows(part.len()).enumerate();
        let mut found = places.filter(|(_, tokens)| same(tokens)).map(|(n, _)| n);
        let at = found.find(is_whole)?;
        Some(self.line(self.tokens[at].line))
    }

    fn line(&self, line: usize) -> Line {
        Line {
            file: self.name.clone(),
            number: line + 1,
            text: self.lines[line].trim().to_owned(),
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

/// A function of the reader's and the chapter's, aligned.
struct Pair<'a> {
    yours: &'a File,
    chapter: &'a File,
    own: &'a [Token],
    theirs: &'a [Token],
}

impl<'a> Pair<'a> {
    fn new(
        (yours, own): (&'a File, &'a [Token]),
        (chapter, theirs): (&'a File, &'a [Token]),
    ) -> Self {
        Self {
            yours,
            chapter,
            own,
            theirs,
        }
    }

    /// The differences, but for names that are others all the way.
    fn unlike(&self) -> Vec<Unlike> {
        let gaps = gaps(self.own, self.theirs);
        let renamed = |gap: &Gap| self.is_renamed(gap, &gaps);
        let mut unlike: Vec<Unlike> = Vec::new();
        for gap in gaps.iter().filter(|gap| !renamed(gap)) {
            let found = self.told(gap);
            match unlike.last_mut().filter(|last| last.yours == found.yours) {
                Some(last) if last.chapter == found.chapter => {
                    last.is_missing |= found.is_missing;
                    last.more += found.more;
                }
                _ => unlike.push(found),
            }
        }
        unlike
    }

    /// Whether one name stands for another one here, and wherever either of them is.
    fn is_renamed(&self, gap: &Gap, gaps: &[Gap]) -> bool {
        let name = |tokens: &'a [Token]| match tokens {
            [one] if one.text.starts_with(|c: char| c.is_alphabetic()) => Some(one.text.as_str()),
            _ => None,
        };
        let of = |gap: &Gap| {
            Some((
                name(&self.own[gap.own.clone()])?,
                name(&self.theirs[gap.theirs.clone()])?,
            ))
        };
        let Some((own, theirs)) = of(gap) else {
            return false;
        };
        let count =
            |tokens: &[Token], name: &str| tokens.iter().filter(|it| it.text == name).count();
        let times = gaps
            .iter()
            .filter(|gap| of(gap) == Some((own, theirs)))
            .count();
        count(self.own, own) == times && count(self.theirs, theirs) == times && times > 1
    }

    fn told(&self, gap: &Gap) -> Unlike {
        let line = |tokens: &[Token], at: usize| tokens[at.min(tokens.len() - 1)].line;
        let own = match gap.own.is_empty() {
            true => line(self.own, gap.own.start.saturating_sub(1)),
            false => line(self.own, gap.own.start),
        };
        let theirs = line(self.theirs, gap.theirs.start);
        let is_missing = whole_lines(self.theirs, &gap.theirs) > whole_lines(self.own, &gap.own);
        Unlike {
            yours: self.yours.line(own),
            chapter: self.chapter.line(theirs).text,
            is_missing,
            more: gap.theirs.len() as isize - gap.own.len() as isize,
        }
    }
}

/// How many lines have all their tokens in the stretch.
fn whole_lines(tokens: &[Token], stretch: &Range<usize>) -> usize {
    let is_whole = |part: &&[Token]| {
        let line = part[0].line;
        let first = tokens.partition_point(|token| token.line < line);
        let after = tokens.partition_point(|token| token.line <= line);
        stretch.start <= first && after <= stretch.end
    };
    let lines = tokens[stretch.clone()].chunk_by(|one, other| one.line == other.line);
    lines.filter(is_whole).count()
}

/// A stretch of tokens that is not the same in two sequences.
struct Gap {
    own: Range<usize>,
    theirs: Range<usize>,
}

/// Where two sequences differ, by their longest common subsequence.
fn gaps(own: &[Token], theirs: &[Token]) -> Vec<Gap> {
    let same = |n: usize, m: usize| own[n].text == theirs[m].text;
    let (rows, columns) = (own.len(), theirs.len());
    let mut longest = vec![vec![0_usize; columns + 1]; rows + 1];
    for n in (0..rows).rev() {
        for m in (0..columns).rev() {
            longest[n][m] = match same(n, m) {
                true => longest[n + 1][m + 1] + 1,
                false => longest[n + 1][m].max(longest[n][m + 1]),
            };
        }
    }
    let is_same = |n: usize, m: usize| n < rows && m < columns && same(n, m);
    let (mut n, mut m, mut gaps) = (0, 0, Vec::new());
    while n < rows || m < columns {
        let (from, to) = (n, m);
        while (n < rows || m < columns) && !is_same(n, m) {
            let skips_own = m == columns || n < rows && longest[n + 1][m] >= longest[n][m + 1];
            match skips_own {
                true => n += 1,
                false => m += 1,
            }
        }
        if (from, to) != (n, m) {
            gaps.push(Gap {
                own: from..n,
                theirs: to..m,
            });
        }
        (n, m) = (n + 1, m + 1);
    }
    gaps
}

/// The words, numbers and signs of a program, without comments and without what a language
/// needs and an idea does not: empty brackets, `let`, a zero after the point.
fn tokens(text: &str) -> Vec<Token> {
    let mut tokens: Vec<Token> = Vec::new();
    for (line, text) in text.lines().enumerate() {
        let code = text.split("//").next().unwrap_or_default();
        let code = code.split('#').next().unwrap_or_default();
        let code = code.replace("self.", "").replace("this->", "");
        let mut rest = code.trim_start();
        while let Some(first) = rest.chars().next() {
            let is_word = |c: char| c.is_alphanumeric() || c == '_';
            let is_number = |c: char| is_word(c) || c == '.';
            let length = match first {
                c if c.is_ascii_digit() => rest.find(|c| !is_number(c)),
                c if is_word(c) => rest.find(|c| !is_word(c)),
                c => Some(c.len_utf8()),
            };
            let (word, after) = rest.split_at(length.unwrap_or(rest.len()));
            rest = after.trim_start();
            let word = spelled(word);
            match (tokens.last().map(|it| it.text.as_str()), word) {
                (_, "let" | "mut" | "pub") => {}
                (Some("("), ")") => drop(tokens.pop()),
                _ => tokens.push(Token {
                    text: word.to_owned(),
                    line,
                }),
            }
        }
    }
    tokens
}

/// As it is written most often.
fn spelled(word: &str) -> &str {
    match word {
        "ray" => "r",
        "infinity" => "INFINITY",
        _ if word.starts_with(|c: char| c.is_ascii_digit()) => {
            let word = word.trim_end_matches("f64");
            match word.split_once('.') {
                Some((whole, part)) if part.chars().all(|c| c == '0') => whole,
                _ => word,
            }
        }
        _ => word,
    }
}
