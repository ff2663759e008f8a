//! Functions of a program, each with its text and its tree.

use interpreter::{Program, SourceFile};

use super::parsed::Reader;
use super::tree::RustTree;

/// A function of a program in Rust, with its syntax tree.
#[derive(Clone, Debug)]
pub(super) struct RustFn {
    /// The name, for a method with its type: `Sphere::hit`.
    pub(super) name: String,
    /// The text, from `fn` to the last brace.
    pub(super) text: String,
    /// The names of the parameters, in their order; an empty name for a pattern.
    pub(super) parameters: Vec<String>,
    /// The block of the function; places in it are bytes of the text.
    pub(super) body: RustTree,
}

impl RustFn {
    /// Parses a function from its text, from `fn` to the last brace; `None` if it is not Rust.
    pub(super) fn read(name: &str, text: &str) -> Option<Self> {
        let item: syn::ImplItemFn = syn::parse_str(text).ok()?;
        let parameter = |it: &syn::FnArg| match it {
            syn::FnArg::Typed(it) => match &*it.pat {
                syn::Pat::Ident(it) => it.ident.to_string(),
                _ => String::new(),
            },
            syn::FnArg::Receiver(_) => "self".to_owned(),
        };
        Some(Self {
            name: name.to_owned(),
            text: text.to_owned(),
            parameters: item.sig.inputs.iter().map(parameter).collect(),
            body: Reader { text }.block(&item.block),
        })
    }

    /// Finds the function in a list of files: the index of its file, and the byte of that file's
    /// text at which it begins.
    pub(super) fn place(&self, files: &[SourceFile]) -> Option<(usize, usize)> {
        let mut places = files.iter().enumerate();
        places.find_map(|(n, file)| Some((n, file.text.find(&self.text)?)))
    }
}

/// Parses all functions of a program.
pub(super) fn functions(program: &Program) -> Vec<RustFn> {
    let all = program.functions();
    all.filter_map(|(name, text)| RustFn::read(name, text))
        .collect()
}
