//! Macros: those that stop, those that ask, and those that make text.

use syn::parse::Parser;
use syn::punctuated::Punctuated;

use super::{Lowered, Lowerer};
use crate::library;
use crate::node::{Arguments, Node};
use crate::refusal::{At, Refusal};
use crate::types::{Owners, Type};

impl Lowerer<'_> {
    pub(super) fn macro_call(&mut self, it: &syn::Macro) -> Lowered {
        let at = self.at_any(&it.path);
        let parser = Punctuated::<syn::Expr, syn::Token![,]>::parse_terminated;
        let is_repeated = repeated(&it.tokens).is_some();
        let arguments: Vec<syn::Expr> = match parser.parse2(it.tokens.clone()) {
            Ok(arguments) => arguments.into_iter().collect(),
            Err(_) if is_repeated => Vec::new(),
            Err(error) => return self.refused(at, error.to_string()),
        };
        let never = |said: &str| Ok(Node::Panic(said.to_owned(), at));
        let name = it.path.segments.last().expect("a path has a name");
        match name.ident.to_string().as_str() {
            "todo" | "unimplemented" => never("not yet implemented"),
            "unreachable" => never("internal error: entered unreachable code"),
            "panic" => never("the program panics here"),
            "assert" | "debug_assert" => {
                let Some(condition) = arguments.first() else {
                    return self.refused(at, "requires a boolean expression as 1st argument");
                };
                let condition = self.given(condition, &Type::BOOL)?;
                let panic = Node::Panic("assertion failed".to_owned(), at);
                Ok(Node::If(Box::new([condition, Node::Unit, panic])))
            }
            "vec" => match repeated(&it.tokens) {
                Some(it) => {
                    let nodes = [self.expr(&it.expr)?, self.expr(&it.len)?];
                    Ok(Node::Repeat(Box::new(nodes), false, at))
                }
                None => self.listed(&arguments, &Type::UNKNOWN, false, at),
            },
            "format" => self.formatted(&arguments, "", at),
            "dbg" if arguments.len() == 1 => self.expr(&arguments[0]),
            // Nothing shows what is printed beside the picture.
            "println" | "eprintln" | "print" | "eprint" => {
                let text = self.formatted(&arguments, "", at)?;
                Ok(Node::Block(vec![text], false))
            }
            "mutants" => self.mutants(&arguments, at),
            "write" => self.written(&arguments, "", at),
            "writeln" => self.written(&arguments, "\n", at),
            name => self.unread(at, &format!("`{name}!`")),
        }
    }

    /// An expression and the mutants that may run in its place, behind the number of the first. One
    /// that is refused is lost, and no other with it.
    fn mutants(&mut self, arguments: &[syn::Expr], at: At) -> Lowered {
        let [number, all @ ..] = arguments else {
            return self.refused(at, "requires a number and an expression");
        };
        let Node::Int(first, _) = self.expr(number)? else {
            return self.refused(at, "requires a number");
        };
        let mut nodes = Vec::new();
        for one in all {
            let (locals, loops) = (self.locals.len(), self.loops.clone());
            let lowered = self.expr(one);
            self.locals.truncate(locals);
            self.loops = loops;
            nodes.push(match lowered {
                Err(refusal) if nodes.is_empty() => return Err(refusal),
                lowered => lowered.unwrap_or(Node::Panic("no program".to_owned(), at)),
            });
        }
        Ok(Node::Mutants(first as u32, nodes.into()))
    }

    /// What is added to a text.
    fn written(&mut self, arguments: &[syn::Expr], end: &str, at: At) -> Lowered {
        let Some((to, rest)) = arguments.split_first() else {
            return self.refused(at, "requires at least a format string argument");
        };
        let place = match self.place(to)? {
            Some(place) => Node::Address(Box::new(self.mutable(place))),
            None => self.expr(to)?,
        };
        let text = self.formatted(rest, end, at)?;
        let native = library::function(Owners::STR, "push_str").expect("it is listed");
        let nodes = [place, Node::Lend(Box::new(text))].into();
        let places = [at; 2].into();
        let arguments = Arguments { nodes, places, at };
        Ok(Node::Some(Box::new(Node::Native(native, arguments))))
    }

    /// A text with values in its brackets: `{}` and `{name}`. How they are to look,
    /// after a colon, is passed over.
    fn formatted(&mut self, arguments: &[syn::Expr], end: &str, at: At) -> Lowered<Node> {
        let (text, values) = match arguments.split_first() {
            None => (String::new(), arguments),
            Some((syn::Expr::Lit(it), values)) => match &it.lit {
                syn::Lit::Str(text) => (text.value(), values),
                _ => return self.refused(at, "format argument must be a string literal"),
            },
            Some(_) => return self.refused(at, "format argument must be a string literal"),
        };
        // Two brackets stand for one.
        let text = text.replace("{{", "\u{1}").replace("}}", "\u{2}") + end;
        let plain = |text: &str| text.replace('\u{1}', "{").replace('\u{2}', "}");
        let (mut pieces, mut nodes) = (Vec::new(), Vec::new());
        let mut unnamed = values.iter();
        let mut rest = text.as_str();
        while let Some((before, inside, after)) = bracket(rest) {
            let name = inside.split(':').next().unwrap_or_default();
            let value = match name {
                "" => unnamed.next().map(|it| self.expr(it)),
                name => Some(self.inline(name, at)),
            };
            let Some(value) = value else {
                return self.refused(at, "this text has more brackets than there are arguments");
            };
            nodes.push(value?);
            pieces.push(plain(before));
            rest = after;
        }
        pieces.push(plain(rest));
        match unnamed.next() {
            Some(_) => self.refused(at, "argument never used"),
            None => Ok(Node::Format(pieces, nodes, at)),
        }
    }

    fn inline(&mut self, name: &str, at: At) -> Lowered {
        if name.starts_with(|it: char| it.is_ascii_digit()) {
            return self.unread(at, &format!("`{{{name}}}` in a text"));
        }
        let message = format!("cannot find value `{name}` in this scope");
        let missing = Refusal::new(at, message, "not found in this scope", "");
        let local = self.variable(name).map(|it| Node::Local(it.slot));
        local.ok_or(missing)
    }
}

/// The `value; count` of a list.
fn repeated(tokens: &proc_macro2::TokenStream) -> Option<syn::ExprRepeat> {
    let tokens = tokens.clone();
    let group = proc_macro2::Group::new(proc_macro2::Delimiter::Bracket, tokens);
    syn::parse2(proc_macro2::TokenTree::from(group).into()).ok()
}

/// What is before the first bracket, in it, and after it.
fn bracket(text: &str) -> Option<(&str, &str, &str)> {
    let (before, after) = text.split_once('{')?;
    let (inside, after) = after.split_once('}')?;
    Some((before, inside, after))
}
