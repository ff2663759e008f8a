//! Functions: those of a program with their trees, and the program with other texts for some.

use std::ops::Range;

use interpreter::nesting;
use syn::spanned::Spanned;
use syn::{Block, FnArg, ImplItem, Item, Signature, TraitItem};

use super::tree::{Reader, Tree, squeezed};

/// The names and texts of a program's files, the root first.
pub(super) type Files = Vec<(String, String)>;

/// A function with a body.
#[derive(Clone, Debug)]
pub(super) struct Function {
    /// Its name; a method's with the type that it belongs to.
    pub(super) name: String,
    /// Which of the files it stands in, and where.
    pub(super) file: usize,
    pub(super) at: Range<usize>,
    pub(super) text: String,
    pub(super) parameters: Vec<String>,
    pub(super) body: Tree,
}

impl Function {
    /// Its own name, without that of a type.
    pub(super) fn short_name(&self) -> &str {
        self.name.rsplit(':').next().unwrap_or(&self.name)
    }
}

/// All functions of the files.
pub(super) fn functions(files: &[(String, String)]) -> Vec<Function> {
    let files = files.iter().enumerate();
    files.flat_map(|(n, (_, text))| of_file(n, text)).collect()
}

fn of_file(file: usize, text: &str) -> Vec<Function> {
    let Ok(parsed) = nesting::parse_file(text) else {
        return Vec::new();
    };
    let read = |of: &str, signature: &Signature, body: &Block| {
        let start = signature.span().byte_range().start;
        let at = start..body.span().byte_range().end;
        let parameter = |it: &FnArg| match it {
            FnArg::Typed(it) => squeezed(&text[it.pat.span().byte_range()]),
            FnArg::Receiver(_) => "self".to_owned(),
        };
        Function {
            name: format!("{of}{}", signature.ident),
            file,
            text: text[at.clone()].to_owned(),
            at,
            parameters: signature.inputs.iter().map(parameter).collect(),
            body: Reader { text, start }.block(body),
        }
    };
    let mut all = Vec::new();
    for item in &parsed.items {
        match item {
            Item::Fn(it) => all.push(read("", &it.sig, &it.block)),
            Item::Impl(it) => {
                let of = format!("{}::", squeezed(&text[it.self_ty.span().byte_range()]));
                let methods = it.items.iter().filter_map(|it| match it {
                    ImplItem::Fn(it) => Some(read(&of, &it.sig, &it.block)),
                    _ => None,
                });
                all.extend(methods);
            }
            Item::Trait(it) => {
                let of = format!("{}::", it.ident);
                let methods = it.items.iter().filter_map(|it| match it {
                    TraitItem::Fn(it) => Some(read(&of, &it.sig, it.default.as_ref()?)),
                    _ => None,
                });
                all.extend(methods);
            }
            _ => {}
        }
    }
    all
}

/// The files with other texts for some functions.
pub(super) fn with(files: &Files, changes: &[(&Function, &str)]) -> Files {
    let mut files = files.clone();
    let mut changes = changes.to_vec();
    // What stands below a change keeps its place.
    changes.sort_by_key(|(function, _)| std::cmp::Reverse(function.at.start));
    for (function, text) in changes {
        files[function.file]
            .1
            .replace_range(function.at.clone(), text);
    }
    files
}
