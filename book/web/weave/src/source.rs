//! Excerpts: items of a Rust source, found by their names in its syntax tree.

use std::ops::Range;

use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::{Ident, ImplItem, Item, TraitItem};

/// An item of a Rust source, with the names that find it.
///
/// A function, type, trait or constant goes by its name, an import by its line, an impl block by
/// its header, and a method by its block's header or owner, `::` and its name. Doc comments and
/// attributes belong to an item.
pub(crate) struct SourceItem {
    /// The names that find the item, at least one.
    pub(crate) names: Vec<String>,
    /// The lines that the item fills, counted from 0.
    pub(crate) lines: Range<usize>,
    /// True for a `use` declaration.
    pub(crate) is_import: bool,
    /// The block around the item if it is a method, else `None`.
    block: Option<OuterBlock>,
}

/// The trait or impl block around a method: its header, and the lines of the header, from 0.
#[derive(Clone, PartialEq)]
struct OuterBlock {
    header: String,
    lines: Range<usize>,
}

impl SourceItem {
    /// Makes an item that is no import and stands in no block.
    fn new(names: Vec<String>, span: Span) -> Self {
        Self {
            names,
            lines: lines(span, span),
            is_import: false,
            block: None,
        }
    }

    /// Returns the name by which a reader looks for the item: that of a method is its block's
    /// header.
    pub(crate) fn called(&self) -> &str {
        let block = self.block.as_ref().map(|block| &block.header);
        block.unwrap_or(&self.names[0])
    }
}

/// Returns the items of a source whose names, separated by commas, are in `list`.
///
/// # Errors
/// If the source is no Rust, or has none or several items of a name.
pub(crate) fn items(source: &str, list: &str) -> Result<Vec<SourceItem>, String> {
    let file = syn::parse_file(source)
        .map_err(|cause| format!(": line {}: {cause}", cause.span().start().line))?;
    let find = |name| {
        let all = file.items.iter().flat_map(|item| named(item, source));
        find(all.collect(), name).map_err(|cause| format!(" {cause}"))
    };
    names(list).into_iter().map(find).collect()
}

/// Splits a list of names; a comma inside brackets belongs to a name.
fn names(list: &str) -> Vec<&str> {
    let mut depth = 0;
    let is_separator = |letter: char| {
        depth += i32::from("<[({".contains(letter)) - i32::from(">])}".contains(letter));
        letter == ',' && depth == 0
    };
    list.split(is_separator).map(str::trim).collect()
}

/// Returns the only item with this name.
fn find(mut items: Vec<SourceItem>, name: &str) -> Result<SourceItem, String> {
    let all: Vec<String> = items.iter().map(|item| item.names[0].clone()).collect();
    items.retain(|item| item.names.iter().any(|other| other == name));
    match items.pop() {
        None => Err(format!("has no item `{name}`; it has {}", all.join(", "))),
        Some(item) if items.is_empty() => Ok(item),
        Some(_) => Err(format!(
            "has several items `{name}`: name an impl block by its header"
        )),
    }
}

/// Returns the text of the items, with an empty line between two that do not touch in the source.
/// Methods of one block share its header and its end.
pub(crate) fn excerpt(source: &str, items: &[SourceItem]) -> String {
    let source: Vec<&str> = source.lines().collect();
    let text = |lines: &Range<usize>| source[lines.clone()].join("\n") + "\n";
    let mut excerpt = String::new();
    let mut end = None;
    for together in items.chunk_by(|one, next| one.block.is_some() && one.block == next.block) {
        if end.is_some_and(|end| end != together[0].lines.start) {
            excerpt.push('\n');
        }
        let texts: Vec<String> = together.iter().map(|item| text(&item.lines)).collect();
        excerpt += &match &together[0].block {
            Some(block) => format!("{}{}}}\n", text(&block.lines), texts.join("\n")),
            None => texts.concat(),
        };
        end = together.last().map(|item| item.lines.end);
    }
    excerpt
}

/// Returns an item, and the methods inside of it.
fn named(item: &Item, source: &str) -> Vec<SourceItem> {
    let plain = |name: &Ident| vec![SourceItem::new(vec![name.to_string()], item.span())];
    match item {
        Item::Const(it) => plain(&it.ident),
        Item::Enum(it) => plain(&it.ident),
        Item::Fn(it) => plain(&it.sig.ident),
        Item::Mod(it) => plain(&it.ident),
        Item::Static(it) => plain(&it.ident),
        Item::Struct(it) => plain(&it.ident),
        Item::Type(it) => plain(&it.ident),
        Item::Use(_) => {
            let line = source[item.span().byte_range()].trim_end_matches(';');
            vec![SourceItem {
                is_import: true,
                ..SourceItem::new(vec![line.to_owned()], item.span())
            }]
        }
        Item::Trait(it) => {
            let methods = it.items.iter().filter_map(|inner| match inner {
                TraitItem::Fn(method) => Some((&method.sig.ident, method.span())),
                _ => None,
            });
            let block = block(source, it.trait_token.span, it.brace_token.span.open());
            let mut all = plain(&it.ident);
            all.extend(in_block(&block, Some(&it.ident.to_string()), methods));
            all
        }
        Item::Impl(it) => {
            let methods = it.items.iter().filter_map(|inner| match inner {
                ImplItem::Fn(method) => Some((&method.sig.ident, method.span())),
                _ => None,
            });
            let block = block(source, it.impl_token.span, it.brace_token.span.open());
            let owner = &source[it.self_ty.span().byte_range()];
            let owner = it.trait_.is_none().then_some(owner);
            let mut all = vec![SourceItem::new(vec![block.header.clone()], item.span())];
            all.extend(in_block(&block, owner, methods));
            all
        }
        _ => Vec::new(),
    }
}

/// Returns the header of a block, from its first word to its brace.
fn block(source: &str, start: Span, brace: Span) -> OuterBlock {
    let header = &source[start.byte_range().start..brace.byte_range().start];
    OuterBlock {
        header: header.split_whitespace().collect::<Vec<_>>().join(" "),
        lines: lines(start, brace),
    }
}

/// Returns methods of a block, named by its header and by its owner, if there is one.
fn in_block<'a>(
    block: &OuterBlock,
    owner: Option<&str>,
    methods: impl Iterator<Item = (&'a Ident, Span)>,
) -> impl Iterator<Item = SourceItem> {
    methods.map(move |(name, span)| {
        let by = [Some(&block.header[..]), owner].into_iter().flatten();
        SourceItem {
            block: Some(block.clone()),
            ..SourceItem::new(by.map(|it| format!("{it}::{name}")).collect(), span)
        }
    })
}

/// Returns the lines from the first one of `start` to the last one of `end`, counted from 0.
fn lines(start: Span, end: Span) -> Range<usize> {
    start.start().line - 1..end.end().line
}
