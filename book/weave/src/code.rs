//! Listings: items of the sources, found by their names.

use std::fs;
use std::ops::Range;
use std::path::Path;

use proc_macro2::{LineColumn, Span};
use syn::spanned::Spanned;
use syn::{ImplItem, Item, TraitItem};

use crate::controls;

/// What a page has listed so far, so that a listing can say what it stands beside: the
/// file, the lines, and what to look for there.
#[derive(Default)]
pub(crate) struct Listed(Vec<(String, Range<usize>, String)>);

impl Listed {
    /// `, below …` or `, above …`, if something else of the same file was listed before.
    fn beside(&self, file: &str, item: &Named) -> String {
        let of_file = || self.0.iter().filter(|(of, ..)| of == file);
        let before = of_file().filter(|(_, lines, _)| lines.end <= item.lines.start);
        let behind = of_file().filter(|(_, lines, _)| lines.start >= item.lines.end);
        let below = before.max_by_key(|(_, lines, _)| lines.end);
        let above = behind.min_by_key(|(_, lines, _)| lines.start);
        match (below, above) {
            (Some((_, _, name)), _) => format!(", below <b>{}</b>", escaped(name)),
            (None, Some((_, _, name))) => format!(", above <b>{}</b>", escaped(name)),
            (None, None) => String::new(),
        }
    }

    fn add(&mut self, file: &str, items: &[&Named]) {
        let entries = items.iter().filter(|item| !item.is_import).map(|item| {
            let name = item.called().to_owned();
            (file.to_owned(), item.lines.clone(), name)
        });
        self.0.extend(entries);
    }
}

/// The `items` of the source at `path` from the `folder`, or all of it, as Markdown.
///
/// The items are separated by commas. A function, type, trait or constant goes by its
/// name, an import by its line, an impl block by its header, a method by either of them,
/// `::` and its name. Doc comments and attributes belong to an item, and a method is
/// shown inside its block. Beside each line stands its value for the ray of the `figure`.
pub(crate) fn listing(
    folder: &Path,
    path: &str,
    items: &str,
    listed: &mut Listed,
    figure: Option<&str>,
) -> Result<String, String> {
    // The pages are in book/notes, so without `../../` it is as seen from the workspace.
    let file = path.trim_start_matches("../");
    let source =
        fs::read_to_string(folder.join(path)).map_err(|cause| format!("{file}: {cause}"))?;
    let (name, beside, listing) = match items {
        "" => (file.to_owned(), String::new(), source),
        items => {
            let named = named_items(&source).map_err(|cause| format!("{file}: {cause}"))?;
            let found: Result<Vec<&Named>, String> = names(items)
                .into_iter()
                .map(|name| find(&named, name))
                .collect();
            let found = found.map_err(|cause| format!("{file} {cause}"))?;
            let main = found
                .iter()
                .find(|item| !item.is_import)
                .unwrap_or(&found[0]);
            let beside = listed.beside(file, main);
            listed.add(file, &found);
            (main.names[0].clone(), beside, excerpt(&source, &found))
        }
    };
    // A heading with the names that are given here, so that the search leads from them to it;
    // but not in the outline of the page. Answers and tests belong to the section around them.
    let (tag, role) = match file.starts_with("tests/") {
        true => ("p", ""),
        false => ("h3", " role=\"presentation\""),
    };
    let whose = whose(file);
    let names = listing
        .lines()
        .filter_map(|line| given_name(line, !whose.is_empty()));
    let names = names.collect::<Vec<_>>().join(" ");
    let id: String = name
        .chars()
        .map(|it| if it.is_alphanumeric() { it } else { '-' })
        .collect();
    let values = figure.map_or(Ok(String::new()), |figure| values(figure, &listing))?;
    Ok(format!(
        "<div class=\"listing\"><{tag} class=\"source\"{role} id=\"listing-{id}\"><span class=\"file\">{file}</span>{whose}{beside}\
         <span hidden> {names}</span></{tag}>\n\n````rust\n{}\n````\n\n{values}</div>\n",
        listing.trim_end()
    ))
}

/// A line of values for each line of the code: what a name comes to that the figure tells, and
/// the result in the last line.
fn values(figure: &str, code: &str) -> Result<String, String> {
    let says = controls::says(figure)?;
    let lines: Vec<&str> = code.lines().map(str::trim).collect();
    let last = lines.iter().rposition(|line| !["", "}"].contains(line));
    let value = |(n, line): (usize, &str)| {
        let name = match line {
            _ if Some(n) == last => "result",
            "return None;" => "none",
            it if it.ends_with(';') => it.strip_prefix("let ")?.split(' ').next()?,
            _ => return None,
        };
        let (name, value) = says.iter().find(|(of, _)| *of == name)?;
        let told = controls::told(figure, name, value);
        Some(match *name {
            "none" | "result" => told,
            name => format!("<span class=\"of\">{name} = </span>{told}"),
        })
    };
    let rows = lines.iter().copied().enumerate();
    let rows: String = rows
        .map(|row| format!("<span>{}</span>", value(row).unwrap_or_default()))
        .collect();
    Ok(format!(
        "<div class=\"values\" role=\"group\" aria-label=\"For the ray of the figure\">{rows}</div>\n\n"
    ))
}

/// Where a reader types the listing of this file; or that it is there to be read.
fn whose(file: &str) -> String {
    let folders: Vec<&str> = file.splitn(3, '/').collect();
    match folders[..] {
        ["common", ..] | ["chapters", "0_build_test", _] => ", to be read".to_owned(),
        ["chapters", "6_speed_vs_accuracy", _] => String::new(),
        ["chapters", _, yours] => format!(", to be typed into <b>{yours}</b>"),
        _ => String::new(),
    }
}

/// The name of the item that begins in this line of code; in the lesson, which readers type
/// or read, also that of a field or a variable.
fn given_name(line: &str, is_lesson: bool) -> Option<&str> {
    let line = line.trim_start();
    let public = line.strip_prefix("pub ");
    let begins = |words: &[&str]| {
        let line = public.unwrap_or(line);
        words.iter().find_map(|it| line.strip_prefix(it))
    };
    let is_field = |it: &&str| {
        it.split_once(": ")
            .is_some_and(|(name, _)| !name.contains(' '))
    };
    let item = begins(&["const fn ", "fn ", "struct ", "trait ", "const ", "type "]);
    let inner = begins(&["let mut ", "let "]).or(public.filter(is_field));
    let name = item.or(inner.filter(|_| is_lesson))?;
    name.split(|it: char| !it.is_alphanumeric() && it != '_')
        .next()
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

/// The names in a list; a comma inside brackets belongs to a name.
fn names(list: &str) -> Vec<&str> {
    let mut depth = 0;
    let is_separator = |letter: char| {
        depth += i32::from("<[({".contains(letter)) - i32::from(">])}".contains(letter));
        letter == ',' && depth == 0
    };
    list.split(is_separator).map(str::trim).collect()
}

/// An item by its name or names, and the lines that it fills, from 0.
struct Named {
    names: Vec<String>,
    lines: Range<usize>,
    is_import: bool,
    /// The block that it is a method of, if it is one.
    block: Option<Block>,
}

/// The block around a method: its header, and the lines that the header fills.
#[derive(Clone, PartialEq)]
struct Block {
    header: String,
    lines: Range<usize>,
}

impl Named {
    /// What stands in the source to look for: of a method, the header of its block.
    fn called(&self) -> &str {
        let block = self.block.as_ref().map(|block| &block.header);
        block.unwrap_or(&self.names[0])
    }
}

fn find<'a>(items: &'a [Named], name: &str) -> Result<&'a Named, String> {
    let has_name = |item: &&Named| item.names.iter().any(|other| other == name);
    match items.iter().filter(has_name).collect::<Vec<_>>()[..] {
        [item] => Ok(item),
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

/// The items, with an empty line between them unless they stand together in the source;
/// methods of one block are in one block.
fn excerpt(source: &str, items: &[&Named]) -> String {
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
    let simple = |name: &syn::Ident| vec![entry(vec![name.to_string()], item.span(), None)];
    match item {
        Item::Const(item) => simple(&item.ident),
        Item::Enum(item) => simple(&item.ident),
        Item::Fn(item) => simple(&item.sig.ident),
        Item::Macro(item) => item.ident.as_ref().map_or(Vec::new(), simple),
        Item::Mod(item) => simple(&item.ident),
        Item::Static(item) => simple(&item.ident),
        Item::Struct(item) => simple(&item.ident),
        Item::Type(item) => simple(&item.ident),
        Item::Use(item) => {
            let line = source[item.span().byte_range()].trim_end_matches(';');
            vec![Named {
                is_import: true,
                ..entry(vec![line.to_owned()], item.span(), None)
            }]
        }
        Item::Trait(item) => {
            let name = item.ident.to_string();
            let block = Block {
                header: format!("trait {name}"),
                lines: lines(
                    item.trait_token.span.start(),
                    item.brace_token.span.open().end(),
                ),
            };
            let mut all = simple(&item.ident);
            all.extend(item.items.iter().filter_map(|inner| match inner {
                TraitItem::Fn(method) => Some(entry(
                    vec![format!("{name}::{}", method.sig.ident)],
                    method.span(),
                    Some(block.clone()),
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
fn named_impl(item: &syn::ItemImpl, source: &str) -> Vec<Named> {
    let [start, end] = [item.impl_token.span, item.brace_token.span.open()];
    let header = &source[start.byte_range().start..end.byte_range().start];
    let block = Block {
        header: header.split_whitespace().collect::<Vec<_>>().join(" "),
        lines: lines(start.start(), end.end()),
    };
    let mut all = vec![entry(vec![block.header.clone()], item.span(), None)];
    for inner in &item.items {
        if let ImplItem::Fn(method) = inner {
            let name = &method.sig.ident;
            let mut names = vec![format!("{}::{name}", block.header)];
            if item.trait_.is_none() {
                let owner = source[item.self_ty.span().byte_range()].to_owned();
                names.push(format!("{owner}::{name}"));
            }
            all.push(entry(names, method.span(), Some(block.clone())));
        }
    }
    all
}

fn entry(names: Vec<String>, span: Span, block: Option<Block>) -> Named {
    Named {
        names,
        lines: lines(span.start(), span.end()),
        is_import: false,
        block,
    }
}

/// From the line of one place to that of another, from 0.
fn lines(start: LineColumn, end: LineColumn) -> Range<usize> {
    start.line - 1..end.line
}
