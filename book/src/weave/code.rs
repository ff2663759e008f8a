//! Listings: items of the sources, found by their names.

use std::fs;
use std::ops::Range;
use std::path::Path;

use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::{ImplItem, Item, TraitItem};

/// The `items` of the source at `path`, or all of it, as Markdown.
///
/// The items are separated by commas. A function, type, trait or constant goes by
/// its name, an impl block by its header, a method by either of them, `::` and its
/// name. Doc comments and attributes belong to an item.
pub(super) fn listing(path: &Path, items: &str) -> Result<String, String> {
    let shown = shown(path);
    let source = fs::read_to_string(path).map_err(|cause| format!("{shown}: {cause}"))?;
    let listing = match items {
        "" => source,
        items => {
            let named = named_items(&source).map_err(|cause| format!("{shown}: {cause}"))?;
            let find = |name| find(&named, name).map(|lines| excerpt(&source, lines));
            let listings: Result<Vec<String>, String> =
                names(items).into_iter().map(find).collect();
            listings
                .map_err(|cause| format!("{shown} {cause}"))?
                .join("\n")
        }
    };
    Ok(format!(
        "<div class=\"listing\"><p class=\"source\">{shown}</p>\n\n````rust\n{}\n````\n\n</div>\n",
        listing.trim_end()
    ))
}

/// The path as seen from the workspace, if it is in there.
fn shown(path: &Path) -> String {
    let book = Path::new(env!("CARGO_MANIFEST_DIR"));
    let whole = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let workspace = book.parent().and_then(|path| path.canonicalize().ok());
    let inside = workspace.and_then(|workspace| whole.strip_prefix(workspace).ok());
    inside
        .unwrap_or(path)
        .display()
        .to_string()
        .replace('\\', "/")
}

/// The names in a list; a comma inside brackets belongs to a name.
fn names(list: &str) -> Vec<&str> {
    let mut depth = 0;
    let is_separator = |letter: char| {
        depth += i32::from("<[(".contains(letter)) - i32::from(">])".contains(letter));
        letter == ',' && depth == 0
    };
    list.split(is_separator).map(str::trim).collect()
}

/// An item by its name or names, and the lines that it fills, from 0.
struct Named {
    names: Vec<String>,
    lines: Range<usize>,
}

fn find(items: &[Named], name: &str) -> Result<Range<usize>, String> {
    let has_name = |item: &&Named| item.names.iter().any(|other| other == name);
    match items.iter().filter(has_name).collect::<Vec<_>>()[..] {
        [item] => Ok(item.lines.clone()),
        [] => {
            let all: Vec<&str> = items.iter().map(|item| item.names[0].as_str()).collect();
            Err(format!("has no item `{name}`; it has {}", all.join(", ")))
        }
        [first, second, ..] => Err(format!(
            "has several items `{name}`, in lines {} and {}: name an impl block by its header",
            1 + first.lines.start,
            1 + second.lines.start
        )),
    }
}

/// These lines, as far to the left as they go.
fn excerpt(source: &str, lines: Range<usize>) -> String {
    let lines: Vec<&str> = source.lines().skip(lines.start).take(lines.len()).collect();
    let indent = lines[0].len() - lines[0].trim_start().len();
    lines
        .into_iter()
        .flat_map(|line| [line.get(indent..).unwrap_or(""), "\n"])
        .collect()
}

fn named_items(source: &str) -> Result<Vec<Named>, String> {
    let file = syn::parse_file(source)
        .map_err(|cause| format!("line {}: {cause}", cause.span().start().line))?;
    Ok(file
        .items
        .iter()
        .flat_map(|item| named(item, source))
        .collect())
}

/// The item, and what can be named inside it.
fn named(item: &Item, source: &str) -> Vec<Named> {
    let simple = |name: &syn::Ident| vec![entry(vec![name.to_string()], item.span())];
    match item {
        Item::Const(item) => simple(&item.ident),
        Item::Enum(item) => simple(&item.ident),
        Item::Fn(item) => simple(&item.sig.ident),
        Item::Macro(item) => item.ident.as_ref().map_or(Vec::new(), simple),
        Item::Mod(item) => simple(&item.ident),
        Item::Static(item) => simple(&item.ident),
        Item::Struct(item) => simple(&item.ident),
        Item::Type(item) => simple(&item.ident),
        Item::Trait(item) => {
            let mut all = simple(&item.ident);
            all.extend(item.items.iter().filter_map(|inner| match inner {
                TraitItem::Fn(method) => Some(entry(
                    vec![format!("{}::{}", item.ident, method.sig.ident)],
                    method.span(),
                )),
                _ => None,
            }));
            all
        }
        Item::Impl(block) => named_impl(block, source),
        _ => Vec::new(),
    }
}

/// An impl block by its header, and its methods.
fn named_impl(block: &syn::ItemImpl, source: &str) -> Vec<Named> {
    let header =
        block.impl_token.span.byte_range().start..block.brace_token.span.open().byte_range().start;
    let header = source[header]
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    let mut all = vec![entry(vec![header.clone()], block.span())];
    for inner in &block.items {
        if let ImplItem::Fn(method) = inner {
            let name = &method.sig.ident;
            let mut names = vec![format!("{header}::{name}")];
            if block.trait_.is_none() {
                let owner = source[block.self_ty.span().byte_range()].to_owned();
                names.push(format!("{owner}::{name}"));
            }
            all.push(entry(names, method.span()));
        }
    }
    all
}

fn entry(names: Vec<String>, span: Span) -> Named {
    Named {
        names,
        lines: span.start().line - 1..span.end().line,
    }
}
