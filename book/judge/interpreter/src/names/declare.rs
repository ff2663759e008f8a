//! Declaration pass: which names the items of the trees declare, before any type is read.

use super::{Entry, Meaning, Module, Resolved, Signature, StructDef, TraitDef, module_key};
use crate::names::collect::{Collector, is_public, is_test};
use crate::refusal::Refusal;
use crate::types::{Ctor, Type};

impl<'a> Collector<'a> {
    /// Adds a module and declares its items; returns its number.
    pub(super) fn module(
        &mut self,
        module: Module,
        items: impl IntoIterator<Item = &'a syn::Item>,
    ) -> usize {
        self.names.modules.push(module);
        let own = self.names.modules.len() - 1;
        for item in items {
            if !is_test(item) {
                self.items.push((own, item));
                let declared = self.declare(own, item);
                self.faults.extend(declared.err());
            }
        }
        own
    }

    /// Declares the names of an item.
    fn declare(&mut self, module: usize, item: &'a syn::Item) -> Resolved {
        let (name, visibility, named) = match item {
            syn::Item::Struct(it) => {
                self.no_generics(module, &it.generics)?;
                let named = self.kind(module, it);
                (&it.ident, &it.vis, named)
            }
            syn::Item::Trait(it) => {
                self.no_generics(module, &it.generics)?;
                let named = Meaning::Trait(self.names.traits.len());
                self.names.traits.push(TraitDef {
                    name: it.ident.to_string(),
                    ..TraitDef::default()
                });
                (&it.ident, &it.vis, named)
            }
            syn::Item::Fn(it) => {
                self.block(module, &it.block);
                (&it.sig.ident, &it.vis, self.function())
            }
            syn::Item::Const(it) => (&it.ident, &it.vis, self.function()),
            syn::Item::Static(it) if matches!(it.mutability, syn::StaticMutability::None) => {
                (&it.ident, &it.vis, self.function())
            }
            syn::Item::Mod(it) => (&it.ident, &it.vis, self.submodule(module, it)?),
            syn::Item::Type(it) => (&it.ident, &it.vis, Meaning::Type(Type::UNKNOWN)),
            syn::Item::Use(it) => return self.import(module, &it.vis, Vec::new(), &it.tree),
            syn::Item::Impl(it) => {
                for item in &it.items {
                    if let syn::ImplItem::Fn(it) = item {
                        self.block(module, &it.block);
                    }
                }
                return Ok(());
            }
            syn::Item::Enum(it) => return Err(self.unread(module, &it.ident, "enums")),
            _ => return Err(self.unread(module, item, "this kind of item")),
        };
        self.name(module, name, visibility, named)
    }

    /// Declares the items in a function's body, which forms a module then that sees all names
    /// around it.
    fn block(&mut self, module: usize, block: &'a syn::Block) {
        let items = block.stmts.iter().filter_map(|it| match it {
            syn::Stmt::Item(it) => Some(it),
            _ => None,
        });
        let items: Vec<&syn::Item> = items.collect();
        if !items.is_empty() {
            let own = Module {
                file: self.names.modules[module].file,
                parent: module,
                is_block: true,
                ..Module::default()
            };
            let own = self.module(own, items);
            self.blocks.push((block, own));
        }
    }

    /// Declares a name in a module; refuses one that is declared already.
    fn name(
        &mut self,
        module: usize,
        name: &syn::Ident,
        visibility: &syn::Visibility,
        named: Meaning,
    ) -> Resolved {
        let entry = Entry {
            named,
            is_public: is_public(visibility),
        };
        let key = match entry.named {
            Meaning::Module(_) => module_key(&name.to_string()),
            _ => name.to_string(),
        };
        match self.names.modules[module].names.insert(key, entry) {
            None => Ok(()),
            Some(_) => {
                let message = format!("the name `{name}` is defined multiple times");
                Err(Refusal::new(self.at(module, name), message, "", ""))
            }
        }
    }

    /// Numbers a function whose signature is resolved later.
    pub(super) fn function(&mut self) -> Meaning {
        self.names.functions.push(Signature::default());
        self.bodies.push(None);
        Meaning::Function(self.names.functions.len() - 1)
    }

    /// Adds the module of a `mod`, in braces or in its file.
    fn submodule(&mut self, module: usize, it: &'a syn::ItemMod) -> Resolved<Meaning> {
        let name = it.ident.to_string();
        let mut own = Module {
            file: self.names.modules[module].file,
            parent: module,
            name: name.clone(),
            ..Module::default()
        };
        if let Some((_, items)) = &it.content {
            return Ok(Meaning::Module(self.module(own, items)));
        }
        let is_it = |(file, _): &(String, syn::File)| {
            let path = file.trim_end_matches("/mod.rs").trim_end_matches(".rs");
            path.rsplit('/').next() == Some(&name)
        };
        let Some(file) = self.files.iter().position(is_it) else {
            let message = format!("file not found for module `{name}`");
            return Err(Refusal::new(self.at(module, &it.ident), message, "", ""));
        };
        own.file = file as u32;
        let files = self.files;
        Ok(Meaning::Module(self.module(own, &files[file].1.items)))
    }

    /// Numbers a struct whose fields are resolved later.
    fn kind(&mut self, module: usize, it: &syn::ItemStruct) -> Meaning {
        let mut derives = Vec::new();
        for derive in it.attrs.iter().filter(|it| it.path().is_ident("derive")) {
            let _ = derive.parse_nested_meta(|meta| {
                derives.extend(meta.path.segments.last().map(|it| it.ident.to_string()));
                Ok(())
            });
        }
        self.names.structs.push(StructDef {
            name: it.ident.to_string(),
            module,
            fields: Vec::new(),
            derives,
            is_tuple: !matches!(it.fields, syn::Fields::Named(_)),
            at: self.at(module, &it.ident),
            default: None,
        });
        let kind = self.names.structs.len() - 1;
        Meaning::Type(Ctor::Own(kind as u32).into())
    }

    /// Declares the names of a `use`.
    fn import(
        &mut self,
        module: usize,
        visibility: &syn::Visibility,
        mut path: Vec<String>,
        tree: &syn::UseTree,
    ) -> Resolved {
        let (own, name) = match tree {
            syn::UseTree::Path(it) => {
                path.push(it.ident.to_string());
                return self.import(module, visibility, path, &it.tree);
            }
            syn::UseTree::Group(it) => {
                let mut trees = it.items.iter();
                return trees.try_for_each(|it| self.import(module, visibility, path.clone(), it));
            }
            syn::UseTree::Glob(_) => (None, None),
            syn::UseTree::Name(it) => (Some(&it.ident), Some(it.ident.clone())),
            syn::UseTree::Rename(it) => (Some(&it.ident), Some(it.rename.clone())),
        };
        let at = self.at(module, tree);
        let name = match (own, path.last()) {
            // `use std::fmt::{self, …}`.
            (Some(own), Some(last)) if own == "self" => {
                let is_plain = name.as_ref() == Some(own);
                let last = syn::Ident::new(last, own.span());
                name.map(|it| if is_plain { last } else { it })
            }
            _ => {
                path.extend(own.map(ToString::to_string));
                name
            }
        };
        self.imports.push((module, path.clone(), at));
        match name {
            Some(name) if name == "_" => Ok(()),
            Some(name) => self.name(module, &name, visibility, Meaning::Import(path)),
            None => {
                let is_public = is_public(visibility);
                self.names.modules[module].globs.push((path, is_public));
                Ok(())
            }
        }
    }
}
