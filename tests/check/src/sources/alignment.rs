//! Sequence alignment: a reader's function beside the chapter's, by the longest common
//! subsequence of their tokens.

use std::ops::Range;

use super::tokens::{Token, is_name};
use super::{File, Unlike};

/// A function of the reader's and the chapter's, aligned.
pub(super) struct Pair<'a> {
    yours: &'a File,
    chapter: &'a File,
    own: Vec<Token>,
    theirs: Vec<Token>,
}

impl<'a> Pair<'a> {
    pub(super) fn new(
        (yours, own): (&'a File, &'a [Token]),
        (chapter, theirs): (&'a File, &'a [Token]),
    ) -> Self {
        let mut own = essential(own);
        let mut theirs = essential(theirs);
        // What has a name in one of them only is as well without it.
        inline(&mut own, &theirs);
        inline(&mut theirs, &own);
        Self {
            yours,
            chapter,
            own,
            theirs,
        }
    }

    /// The differences, but for names that are others all the way.
    pub(super) fn unlike(&self) -> Vec<Unlike> {
        let gaps = gaps(&self.own, &self.theirs);
        let renamed = |gap: &Gap| self.is_renamed(gap, &gaps);
        let mut unlike: Vec<Unlike> = Vec::new();
        for gap in gaps.iter().filter(|gap| !renamed(gap)) {
            let found = self.told(gap);
            match unlike.last_mut().filter(|last| last.yours == found.yours) {
                Some(last) if last.chapter == found.chapter => {
                    last.is_missing |= found.is_missing;
                }
                _ => unlike.push(found),
            }
        }
        unlike
    }

    /// Whether one name stands for another one here, and wherever either of them is.
    fn is_renamed(&self, gap: &Gap, gaps: &[Gap]) -> bool {
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
        count(&self.own, own) == times && count(&self.theirs, theirs) == times && times > 1
    }

    fn told(&self, gap: &Gap) -> Unlike {
        let line = |tokens: &[Token], at: usize| tokens[at.min(tokens.len() - 1)].line;
        let before = usize::from(gap.own.is_empty());
        let own = line(&self.own, gap.own.start.saturating_sub(before));
        let theirs = line(&self.theirs, gap.theirs.start);
        let is_missing = whole_lines(&self.theirs, &gap.theirs) > whole_lines(&self.own, &gap.own);
        Unlike {
            yours: self.yours.line(own),
            chapter: self.chapter.line(theirs).text,
            is_missing,
        }
    }
}

/// The only word.
fn name(tokens: &[Token]) -> Option<&str> {
    match tokens {
        [one] if is_name(&one.text) => Some(&one.text),
        _ => None,
    }
}

/// Without what makes blocks: a value is returned in several ways, and conditions stand
/// after each other or in each other.
fn essential(tokens: &[Token]) -> Vec<Token> {
    let mut essential: Vec<Token> = Vec::new();
    for token in tokens {
        match (
            essential.last().map(|it| it.text.as_str()),
            token.text.as_str(),
        ) {
            (_, "return" | "else" | "{" | "}" | ";") => {}
            (Some("&"), "&") => {
                essential.pop();
                essential.push(Token::new("if", token.line));
            }
            _ => essential.push(token.clone()),
        }
    }
    essential
}

/// Puts what a name is given in its place, where the other function does not have the name.
fn inline(tokens: &mut Vec<Token>, other: &[Token]) {
    let mut at = 1;
    while at + 1 < tokens.len() {
        let name = tokens[at - 1].text.clone();
        let is_given = tokens[at].text == "="
            && tokens[at + 1].text != "="
            && is_name(&name)
            && !other.iter().any(|it| it.text == name)
            && (at < 2 || !matches!(tokens[at - 2].text.as_str(), "." | "(" | ","));
        let end = at + 1 + value(&tokens[at + 1..]);
        if !is_given || end == at + 1 {
            at += 1;
            continue;
        }
        let given: Vec<Token> = tokens[at + 1..end].to_vec();
        tokens.drain(at - 1..end);
        let mut n = 0;
        while n < tokens.len() {
            if tokens[n].text == name && (n == 0 || tokens[n - 1].text != ".") {
                tokens.splice(n..=n, given.iter().cloned());
                n += given.len();
            } else {
                n += 1;
            }
        }
    }
}

/// How many tokens the value has that they begin with, if that is a number, a path or a call.
fn value(tokens: &[Token]) -> usize {
    let text = |n: usize| tokens.get(n).map_or("", |it| it.text.as_str());
    // A vector begins with its brackets.
    let mut end = usize::from(text(0) != "(");
    loop {
        end = match text(end) {
            "." => end + 2,
            "(" => {
                let mut depth = 0;
                let close = tokens[end..].iter().position(|it| {
                    depth += i32::from(it.text == "(") - i32::from(it.text == ")");
                    depth == 0
                });
                match close {
                    Some(close) => end + close + 1,
                    None => return 0,
                }
            }
            // The value goes on: what it is part of is no single one.
            "+" | "-" | "*" | "/" | "<" | ">" | "?" | "[" => return 0,
            _ => break,
        };
    }
    let first = text(0);
    let is_value = is_name(first) || first.starts_with(|c: char| c.is_ascii_digit() || c == '(');
    if is_value { end.min(tokens.len()) } else { 0 }
}

/// How many lines have all their tokens in the stretch.
fn whole_lines(tokens: &[Token], stretch: &Range<usize>) -> usize {
    let count = |tokens: &[Token], line: usize| tokens.iter().filter(|it| it.line == line).count();
    let inside = &tokens[stretch.clone()];
    let lines = inside.chunk_by(|one, other| one.line == other.line);
    lines
        .filter(|part| count(inside, part[0].line) == count(tokens, part[0].line))
        .count()
}

/// A stretch of tokens that is not the same in two sequences.
struct Gap {
    own: Range<usize>,
    theirs: Range<usize>,
}

/// How many tokens two sequences have in common, in the same order.
pub(super) fn common(own: &[Token], theirs: &[Token]) -> usize {
    longest(own, theirs)[0][0]
}

/// The length of the longest common subsequence from each place on.
fn longest(own: &[Token], theirs: &[Token]) -> Vec<Vec<usize>> {
    let mut longest = vec![vec![0; theirs.len() + 1]; own.len() + 1];
    for n in (0..own.len()).rev() {
        for m in (0..theirs.len()).rev() {
            longest[n][m] = if own[n].text == theirs[m].text {
                longest[n + 1][m + 1] + 1
            } else {
                longest[n + 1][m].max(longest[n][m + 1])
            };
        }
    }
    longest
}

/// Where two sequences differ, by their longest common subsequence.
fn gaps(own: &[Token], theirs: &[Token]) -> Vec<Gap> {
    let (rows, columns) = (own.len(), theirs.len());
    let longest = longest(own, theirs);
    let is_same = |n: usize, m: usize| n < rows && m < columns && own[n].text == theirs[m].text;
    let (mut n, mut m, mut gaps) = (0, 0, Vec::new());
    while n < rows || m < columns {
        let (from, to) = (n, m);
        while (n < rows || m < columns) && !is_same(n, m) {
            let skips_own = m == columns || n < rows && longest[n + 1][m] >= longest[n][m + 1];
            if skips_own {
                n += 1;
            } else {
                m += 1;
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
