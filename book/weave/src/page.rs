//! One page: where its formulas and directives are, and what becomes of them.

use std::collections::HashSet;
use std::env;
use std::ops::Range;
use std::path::{Path, PathBuf};

use mdbook_markdown::pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use crate::code::Listed;
use crate::directive::{self, Woven};
use crate::maths::Maths;

/// A page as it was written.
pub(crate) struct Page<'a> {
    path: PathBuf,
    text: &'a str,
}

/// A piece of a page and what becomes of it, or why nothing does.
type Piece = (Range<usize>, Result<Woven, String>);

impl<'a> Page<'a> {
    /// The page at `path`, with `text` in it.
    pub(crate) fn new(path: PathBuf, text: &'a str) -> Self {
        Self { path, text }
    }

    /// The folder that paths in the page start from.
    pub(crate) fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(&self.path)
    }

    /// The page as mdBook understands it, or each cause why there is none.
    pub(crate) fn weave(&self, maths: &mut Maths) -> Result<String, Vec<String>> {
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
        match problems.is_empty() {
            true => Ok(woven),
            false => Err(problems),
        }
    }

    /// File and line of the byte `at`, as seen from the folder that the reader is in.
    fn place(&self, at: usize) -> String {
        let line = 1 + self.text[..at].matches('\n').count();
        let here = env::current_dir().unwrap_or_default();
        let path = self.path.strip_prefix(here).unwrap_or(&self.path);
        format!("{}:{line}", path.display())
    }

    /// The formulas, and the ranges in which braces mean what they are.
    fn formulas(&self, maths: &mut Maths) -> (Vec<Piece>, Vec<Range<usize>>) {
        let mut pieces = Vec::new();
        let mut opaque: Vec<Range<usize>> = Vec::new();
        let mut in_table = false;
        // In a heading or a link there is no room for another link.
        let mut linked = 0;
        let mut met = HashSet::new();
        for (event, range) in parser(self.text).into_offset_iter() {
            match event {
                Event::InlineMath(formula) if in_table => {
                    pieces.push((range.clone(), maths.in_table(&formula).map(Woven::Inline)));
                }
                Event::InlineMath(formula) => {
                    let end = self.end_of_punctuation(range.end);
                    let met = (linked == 0).then_some(&mut met);
                    let woven = maths.inline(&formula, &self.text[range.end..end], met);
                    pieces.push((range.start..end, woven.map(Woven::Inline)));
                }
                Event::DisplayMath(formula) => {
                    let equation = maths.equation(&formula, || self.place(range.start));
                    pieces.push((range.clone(), equation.map(Woven::Block)));
                }
                Event::Start(Tag::CodeBlock(_)) | Event::Code(_) => {}
                Event::Start(Tag::Heading { .. } | Tag::Link { .. }) => {
                    linked += 1;
                    continue;
                }
                Event::End(TagEnd::Heading(_) | TagEnd::Link) => {
                    linked -= 1;
                    continue;
                }
                Event::Start(Tag::TableCell) => {
                    in_table = true;
                    continue;
                }
                Event::End(TagEnd::TableCell) => {
                    in_table = false;
                    continue;
                }
                Event::Text(_) if opaque.last().is_none_or(|code| code.end <= range.start) => {
                    pieces.extend(self.stray_dollar(range));
                    continue;
                }
                _ => continue,
            }
            opaque.push(range);
        }
        (pieces, opaque)
    }

    /// Where the punctuation ends that begins at the byte `at`.
    fn end_of_punctuation(&self, at: usize) -> usize {
        let rest = &self.text[at..];
        self.text.len()
            - rest
                .trim_start_matches(['.', ',', ';', ':', '!', '?', ')'])
                .len()
    }

    /// A formula that does not end is mere text to the parser.
    fn stray_dollar(&self, text: Range<usize>) -> Option<Piece> {
        let at = text.start + self.text[text.clone()].find('$')?;
        let cause = r"this $ belongs to no formula: close it, or write \$".to_owned();
        let is_escaped = self.text[..at].ends_with('\\');
        (!is_escaped).then_some((at..at, Err(cause)))
    }

    fn directives(&self, opaque: &[Range<usize>]) -> Vec<Piece> {
        let mut pieces = Vec::new();
        let mut listed = Listed::default();
        let mut from = 0;
        while let Some(start) = self.text[from..].find("{{").map(|at| from + at) {
            if let Some(range) = opaque.iter().find(|range| range.contains(&start)) {
                from = range.end;
                continue;
            }
            let line_end = self.text[start..]
                .find('\n')
                .map_or(self.text.len(), |at| start + at);
            let Some(end) = self.text[start..line_end].find("}}") else {
                let cause = "a directive ends with }} on the same line".to_owned();
                pieces.push((start..line_end, Err(cause)));
                from = line_end;
                continue;
            };
            let range = start..start + end + 2;
            let text = &self.text[start + 2..start + end];
            let woven = directive::resolve(text, self.folder(), &mut listed);
            pieces.push((range.clone(), self.alone_if_block(&range, woven)));
            from = range.end;
        }
        pieces
    }

    /// What needs lines of its own must be written on a line of its own.
    fn alone_if_block(
        &self,
        range: &Range<usize>,
        woven: Result<Woven, String>,
    ) -> Result<Woven, String> {
        let before = self.text[..range.start].rsplit('\n').next().unwrap_or("");
        let after = self.text[range.end..].split('\n').next().unwrap_or("");
        let alone = after.trim().is_empty() && before.trim_matches([' ', '>']).is_empty();
        match woven {
            Ok(Woven::Block(_)) if !alone => {
                Err("this directive needs a line of its own".to_owned())
            }
            woven => woven,
        }
    }

    /// `text` between empty lines, each indented or quoted as the line at `start` is.
    fn block(&self, start: usize, text: &str) -> String {
        let line = self.text[..start].rsplit('\n').next().unwrap_or("");
        let prefix = &line[..line.len() - line.trim_start_matches([' ', '>']).len()];
        let lines: String = text.lines().flat_map(|line| [prefix, line, "\n"]).collect();
        format!("\n{prefix}\n{lines}{prefix}\n{prefix}")
    }
}

/// The parser with mdBook's options (see `mdbook_markdown::new_cmark_parser`), and
/// with formulas.
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
