//! One page: finds its formulas and directives, and replaces them.

use std::collections::HashSet;
use std::env;
use std::ops::Range;
use std::path::{Path, PathBuf};

use mdbook_markdown::pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use crate::code::Listed;
use crate::directive::{self, Woven};
use crate::maths::Maths;

/// A page as its author wrote it, in Markdown with directives and formulas.
pub(crate) struct Page<'a> {
    path: PathBuf,
    text: &'a str,
}

/// A range of bytes in a page, and the text for its place or the reason why there is none.
type Piece = (Range<usize>, Result<Woven, String>);

impl<'a> Page<'a> {
    /// Makes a page of its path and its text.
    pub(crate) fn new(path: PathBuf, text: &'a str) -> Self {
        Self { path, text }
    }

    /// Returns the folder from which paths in the page start.
    pub(crate) fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(&self.path)
    }

    /// Replaces the page's directives and formulas; returns Markdown for mdBook.
    ///
    /// # Errors
    /// All problems of the page, each with its file and line.
    pub(crate) fn weave(&self, maths: &Maths) -> Result<String, Vec<String>> {
        let (mut pieces, opaque) = self.formulas(maths);
        pieces.extend(self.directives(&opaque));
        pieces.sort_by_key(|(range, _)| range.start);

        let mut woven = String::new();
        let mut problems = Vec::new();
        let mut done = 0;
        for (range, piece) in pieces {
            woven += &self.text[done..range.start];
            match piece {
                Ok(Woven::Inline(text)) => woven += &text,
                Ok(Woven::Block(text)) => woven += &self.block(range.start, &text),
                Err(cause) => problems.push(format!("{}: {cause}", self.place(range.start))),
            }
            done = range.end;
        }
        woven += &self.text[done..];
        if problems.is_empty() {
            Ok(woven)
        } else {
            Err(problems)
        }
    }

    /// Returns the file and the line of the byte `at`, seen from the current folder.
    fn place(&self, at: usize) -> String {
        let line = 1 + self.text[..at].matches('\n').count();
        let here = env::current_dir().unwrap_or_default();
        let path = self.path.strip_prefix(here).unwrap_or(&self.path);
        format!("{}:{line}", path.display())
    }

    /// Returns the formulas, and the ranges (code and formulas) in which braces are no directive.
    fn formulas(&self, maths: &Maths) -> (Vec<Piece>, Vec<Range<usize>>) {
        let mut pieces = Vec::new();
        let mut opaque: Vec<Range<usize>> = Vec::new();
        // In a heading, a link, or a table there is no room for another link.
        let mut full = 0;
        let mut met = HashSet::new();
        for (event, range) in parser(self.text).into_offset_iter() {
            match event {
                Event::InlineMath(formula) => {
                    let end = self.end_of_punctuation(range.end);
                    let met = (full == 0).then_some(&mut met);
                    let woven = maths.inline(&formula, &self.text[range.end..end], met);
                    pieces.push((range.start..end, woven.map(Woven::Inline)));
                    opaque.push(range);
                }
                Event::DisplayMath(formula) => {
                    let equation = maths.equation(&formula);
                    pieces.push((range.clone(), equation.map(Woven::Block)));
                    opaque.push(range);
                }
                Event::Start(Tag::CodeBlock(_)) | Event::Code(_) => opaque.push(range),
                Event::Start(Tag::Heading { .. } | Tag::Link { .. } | Tag::Table(_)) => full += 1,
                Event::End(TagEnd::Heading(_) | TagEnd::Link | TagEnd::Table) => full -= 1,
                Event::Text(_) if opaque.last().is_none_or(|code| code.end <= range.start) => {
                    pieces.extend(self.stray_dollar(range));
                }
                _ => {}
            }
        }
        (pieces, opaque)
    }

    /// Returns the end of the punctuation that begins at the byte `at`.
    fn end_of_punctuation(&self, at: usize) -> usize {
        let rest = &self.text[at..];
        self.text.len()
            - rest
                .trim_start_matches(['.', ',', ';', ':', '!', '?', ')'])
                .len()
    }

    /// Finds a dollar sign in `text` that begins no formula: to the parser, a formula without an
    /// end is mere text.
    fn stray_dollar(&self, text: Range<usize>) -> Option<Piece> {
        let at = text.start + self.text[text.clone()].find('$')?;
        let cause = r"this $ belongs to no formula: close it, or write \$".to_owned();
        let is_escaped = self.text[..at].ends_with('\\');
        (!is_escaped).then_some((at..at, Err(cause)))
    }

    /// Returns the directives outside of the ranges `opaque`.
    fn directives(&self, opaque: &[Range<usize>]) -> Vec<Piece> {
        let mut pieces = Vec::new();
        let mut listed = Listed::default();
        let mut from = 0;
        while let Some(start) = self.text[from..].find("{{").map(|at| from + at) {
            if let Some(range) = opaque.iter().find(|range| range.contains(&start)) {
                from = range.end;
                continue;
            }
            let line = self.text[start..].lines().next().unwrap_or("");
            let (length, woven) = match line.find("}}") {
                Some(end) => {
                    let woven = directive::resolve(&line[2..end], self.folder(), &mut listed);
                    (end + 2, woven)
                }
                None => {
                    let cause = "a directive ends with }} on the same line";
                    (line.len(), Err(cause.to_owned()))
                }
            };
            from = start + length;
            pieces.push((start..from, woven));
        }
        pieces
    }

    /// Puts `text` between empty lines, each line indented or quoted as the line at `start` is.
    fn block(&self, start: usize, text: &str) -> String {
        let line = self.text[..start].rsplit('\n').next().unwrap_or("");
        let prefix = &line[..line.len() - line.trim_start_matches([' ', '>']).len()];
        let lines: String = text.lines().flat_map(|line| [prefix, line, "\n"]).collect();
        format!("\n{prefix}\n{lines}{prefix}\n{prefix}")
    }
}

/// Makes a parser with mdBook's options (see `mdbook_markdown::new_cmark_parser`), and with
/// formulas.
fn parser(text: &str) -> Parser<'_> {
    let options = Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_SMART_PUNCTUATION
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH;
    Parser::new_ext(text, options)
}
