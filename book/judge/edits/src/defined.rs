//! A symbol table: what a program defines, for the names that an edit may put in.

use std::collections::{BTreeSet, HashMap, HashSet};

use syn::visit::{self, Visit};
use syn::{
    Expr, ExprRepeat, File, FnArg, Ident, ImplItemConst, ItemConst, ItemStatic, ItemStruct, Pat,
    Signature,
};

/// The structs, functions and constants of a program.
#[derive(Clone, Debug, Default)]
pub struct Defined {
    /// The fields of each struct, by its name; `0`, `1` … where they have no names.
    structs: HashMap<String, Vec<String>>,
    /// All functions and methods, of any type.
    pub(crate) functions: BTreeSet<Function>,
    /// The names of constants.
    pub(crate) constants: HashSet<String>,
    /// The words in the values of constants: what these call has to stay `const`.
    pub(crate) in_constants: HashSet<String>,
}

/// A function or method as it is called.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Function {
    pub(crate) name: String,
    pub(crate) is_method: bool,
    /// The names of the parameters but `self`; `_` for a pattern.
    pub(crate) parameters: Vec<String>,
}

impl Defined {
    /// Reads what the files of a program define.
    ///
    /// # Errors
    /// If a text is not Rust.
    pub fn by(texts: &[&str]) -> syn::Result<Self> {
        let files = texts.iter().map(|it| syn::parse_file(it));
        Ok(Self::in_files(&files.collect::<syn::Result<Vec<_>>>()?))
    }

    pub(crate) fn in_files(files: &[File]) -> Self {
        let mut defined = Self::default();
        files.iter().for_each(|it| defined.visit_file(it));
        defined
    }

    /// Lists the fields of a struct; none if there is no such struct.
    pub(crate) fn fields_of(&self, name: &str) -> &[String] {
        self.structs.get(name).map_or(&[], Vec::as_slice)
    }

    /// Lists the fields of all structs that have the field `name`.
    pub(crate) fn fields_beside<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a String> {
        let structs = self.structs.values();
        structs
            .filter(move |it| it.iter().any(|it| it == name))
            .flatten()
    }

    /// Lists the fields of all structs, each name once.
    pub(crate) fn fields(&self) -> BTreeSet<&String> {
        self.structs.values().flatten().collect()
    }

    /// Lists the names of the methods with so many arguments.
    pub(crate) fn methods(&self, arguments: usize) -> impl Iterator<Item = &str> {
        let methods = self.functions.iter();
        let methods = methods.filter(move |it| it.is_method && it.parameters.len() == arguments);
        methods.map(|it| &*it.name)
    }

    fn constant(&mut self, name: &Ident, value: &Expr) {
        self.constants.insert(name.to_string());
        Words(&mut self.in_constants).visit_expr(value);
    }
}

impl<'a> Visit<'a> for Defined {
    fn visit_item_struct(&mut self, it: &'a ItemStruct) {
        let fields = it.fields.iter().enumerate();
        let names = fields.map(|(n, it)| match &it.ident {
            Some(name) => name.to_string(),
            None => n.to_string(),
        });
        self.structs.insert(it.ident.to_string(), names.collect());
    }

    fn visit_signature(&mut self, it: &'a Signature) {
        let parameters = it.inputs.iter().filter_map(|it| match it {
            FnArg::Typed(it) => match &*it.pat {
                Pat::Ident(it) => Some(it.ident.to_string()),
                _ => Some("_".to_owned()),
            },
            FnArg::Receiver(_) => None,
        });
        self.functions.insert(Function {
            name: it.ident.to_string(),
            is_method: it.receiver().is_some(),
            parameters: parameters.collect(),
        });
    }

    fn visit_item_const(&mut self, it: &'a ItemConst) {
        self.constant(&it.ident, &it.expr);
    }

    fn visit_impl_item_const(&mut self, it: &'a ImplItemConst) {
        self.constant(&it.ident, &it.expr);
    }

    fn visit_item_static(&mut self, it: &'a ItemStatic) {
        Words(&mut self.in_constants).visit_expr(&it.expr);
    }

    fn visit_expr_repeat(&mut self, it: &'a ExprRepeat) {
        Words(&mut self.in_constants).visit_expr(&it.len);
        visit::visit_expr_repeat(self, it);
    }
}

/// Collects the words of an expression.
struct Words<'w>(&'w mut HashSet<String>);

impl<'a> Visit<'a> for Words<'_> {
    fn visit_ident(&mut self, it: &'a Ident) {
        self.0.insert(it.to_string());
    }
}
