//! Source instrumentation: copies of the chapters' own functions that note the value of each
//! `let`, so that a page can show it beside the line.

use std::path::Path;
use std::{env, fs};

use syn::spanned::Spanned;
use syn::{Block, Expr, ImplItem, Item, Pat, Signature, Stmt};

/// The module of each copy, the file of its chapter, and the function.
const COPIES: [[&str; 3]; 4] = [
    ["red_sphere", "2_red_sphere/src/lib.rs", "hit_sphere"],
    ["normals", "3_normals/src/lib.rs", "hit_sphere"],
    ["half_b_sphere", "4_half_b_sphere/src/lib.rs", "hit_sphere"],
    ["sphere", "5_hittable_list/src/sphere.rs", "hit"],
];

fn main() {
    // Asked for when this runs: the clone may have been moved since it was compiled.
    let here = env::var_os("CARGO_MANIFEST_DIR").expect("cargo names the package");
    let chapters = Path::new(&here).join("../../chapters");
    let mut copies = String::new();
    for [module, file, name] in COPIES {
        let path = chapters.join(file);
        println!("cargo::rerun-if-changed={}", path.display());
        let source = fs::read_to_string(&path).expect("a source of a chapter");
        let parsed = syn::parse_file(&source).expect("the compiler reads it, too");
        let (signature, body) =
            function(&parsed, name).unwrap_or_else(|| panic!("{} has no `{name}`", path.display()));
        let copy = traced(&source, signature, body);
        copies += &format!("mod {module} {{\nuse super::*;\n{copy}\n}}\n");
    }
    let folder = env::var_os("OUT_DIR").expect("cargo names a folder");
    fs::write(Path::new(&folder).join("traced.rs"), copies).expect("the folder takes it");
}

/// The function of that name, or the method.
fn function<'a>(file: &'a syn::File, name: &str) -> Option<(&'a Signature, &'a Block)> {
    let of_item = |item: &'a Item| match item {
        Item::Fn(it) => vec![(&it.sig, &*it.block)],
        Item::Impl(it) => it.items.iter().filter_map(method).collect(),
        _ => Vec::new(),
    };
    let mut functions = file.items.iter().flat_map(of_item);
    functions.find(|(signature, _)| signature.ident == name)
}

fn method(item: &ImplItem) -> Option<(&Signature, &Block)> {
    match item {
        ImplItem::Fn(it) => Some((&it.sig, &it.block)),
        _ => None,
    }
}

/// The names of its lines, in order, and the function with a note behind each of them.
fn traced(source: &str, signature: &Signature, body: &Block) -> String {
    let text = |it: &dyn Spanned| &source[it.span().byte_range()];
    let mut names = String::new();
    let mut copy = String::new();
    for statement in &body.stmts {
        copy += text(statement);
        if let Some(name) = given_name(statement) {
            names += &format!("\"{name}\", ");
            copy += &format!(" trace.note(\"{name}\", &{name});");
        } else if returns(statement) {
            names += "\"none\", ";
        }
        copy.push('\n');
    }
    let inputs = signature.inputs.iter().map(|input| text(input));
    let inputs: Vec<&str> = inputs.chain(["trace: &mut Trace"]).collect();
    let (name, inputs, output) = (&signature.ident, inputs.join(", "), text(&signature.output));
    let function = format!("pub(super) fn {name}({inputs}) {output} {{\n{copy}}}");
    let function = match signature.receiver() {
        Some(_) => format!("impl Sphere {{\n{function}\n}}"),
        None => function,
    };
    format!("pub(super) const LINES: &[&str] = &[{names}\"result\"];\n\n{function}")
}

/// The name that a `let` gives, unless its value changes later.
fn given_name(statement: &Stmt) -> Option<String> {
    match statement {
        Stmt::Local(local) => match &local.pat {
            Pat::Ident(it) if it.mutability.is_none() => Some(it.ident.to_string()),
            _ => None,
        },
        _ => None,
    }
}

/// Whether it returns early.
fn returns(statement: &Stmt) -> bool {
    let is_return = |it: &Stmt| matches!(it, Stmt::Expr(Expr::Return(_), _));
    match statement {
        Stmt::Expr(Expr::If(it), _) => it.then_branch.stmts.iter().any(is_return),
        _ => false,
    }
}
