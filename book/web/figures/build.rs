//! Source instrumentation: copies of the chapters' own functions that note the value of each
//! `let`, so that a page can show it beside the line.

use std::path::Path;
use std::{env, fs};

use quote::{ToTokens, format_ident, quote};
use syn::{Expr, ImplItem, ImplItemFn, Item, Local, Pat, Stmt, parse_quote};

/// Each instrumented copy: the name of its module, the file that it is copied from, and the
/// function.
const COPIES: [[&str; 3]; 4] = [
    ["red_sphere", "2_red_sphere/src/lib.rs", "hit_sphere"],
    ["normals", "3_normals/src/lib.rs", "hit_sphere"],
    ["half_b_sphere", "4_half_b_sphere/src/lib.rs", "hit_sphere"],
    ["sphere", "5_hittable_list/src/sphere.rs", "hit"],
];

fn main() {
    // Asked for when this runs: the clone may have been moved since it was compiled.
    let here = env::var_os("CARGO_MANIFEST_DIR").expect("cargo names the package");
    let chapters = Path::new(&here).join("../../../chapters");
    let mut copies = String::new();
    for [module, file, name] in COPIES {
        let path = chapters.join(file);
        println!("cargo::rerun-if-changed={}", path.display());
        let source = fs::read_to_string(&path).expect("a source of a chapter");
        let parsed = syn::parse_file(&source).expect("the compiler reads it, too");
        let mut functions = parsed.items.into_iter().flat_map(functions);
        let function = functions.find(|it| it.sig.ident == name);
        let copy = traced(function.unwrap_or_else(|| panic!("{file} has no `{name}`")));
        let module = format_ident!("{module}");
        copies += &quote!(mod #module { use super::*; #copy }).to_string();
    }
    let folder = env::var_os("OUT_DIR").expect("cargo names a folder");
    fs::write(Path::new(&folder).join("traced.rs"), copies).expect("the folder takes it");
}

/// Returns a function of the file as a method, or all methods of an `impl` block.
fn functions(item: Item) -> Vec<ImplItemFn> {
    match item {
        Item::Fn(it) => vec![parse_quote!(#it)],
        Item::Impl(it) => it.items.into_iter().filter_map(method).collect(),
        _ => Vec::new(),
    }
}

/// Returns the method, if the item of an `impl` block is one.
fn method(item: ImplItem) -> Option<ImplItemFn> {
    match item {
        ImplItem::Fn(it) => Some(it),
        _ => None,
    }
}

/// Returns a copy of the function that appends to `notes`: the value of every `let` that is not
/// mutable, and an empty text behind every `if` that did not return. A constant `LINES` beside it
/// names these lines and, in the end, the `result`.
fn traced(mut function: ImplItemFn) -> impl ToTokens {
    let mut names = Vec::new();
    let mut body = Vec::new();
    for statement in &function.block.stmts {
        body.push(quote!(#statement));
        match statement {
            Stmt::Local(Local {
                pat: Pat::Ident(it),
                ..
            }) if it.mutability.is_none() => {
                names.push(it.ident.to_string());
                body.push(quote!(notes.push(#it.shown());));
            }
            // These chapters ask only whether to return early.
            Stmt::Expr(Expr::If(_), _) => {
                names.push("none".to_owned());
                body.push(quote!(notes.push(String::new());));
            }
            _ => {}
        }
    }
    function.vis = parse_quote!(pub(super));
    function
        .sig
        .inputs
        .push(parse_quote!(notes: &mut Vec<String>));
    function.block = parse_quote!({ #(#body)* });
    let function = match function.sig.receiver() {
        Some(_) => quote!(impl TracedSphere { #function }),
        None => quote!(#function),
    };
    quote!(pub(super) const LINES: &[&str] = &[#(#names,)* "result"]; #function)
}
