//! Macros: those that stop, those that ask, and those that make text.

use syn::parse::Parser;
use syn::punctuated::Punctuated;

use super::{Lowered, Lowerer, Typed};
use crate::node::{At, Node};
use crate::read::Refusal;
use crate::types::{Head, Type};

impl Lowerer<'_> {
    pub(super) fn macro_call(&mut self, it: &syn::Macro) -> Lowered {
        let at = self.at_any(&it.path);
        let parser = Punctuated::<syn::Expr, syn::Token![,]>::parse_terminated;
        let arguments: Vec<syn::Expr> = match parser.parse2(it.tokens.clone()) {
            Ok(arguments) => arguments.into_iter().collect(),
            Err(error) => return self.refused(at, error.to_string()),
        };
        let never = |said: &str| Ok(Typed::new(Node::Panic(said.to_owned(), at), Head::Never));
        let name = it.path.segments.last().expect("a path has a name");
        match name.ident.to_string().as_str() {
            "todo" | "unimplemented" => never("not yet implemented"),
            "unreachable" => never("internal error: entered unreachable code"),
            "panic" => never("the program panics here"),
            "assert" | "debug_assert" => {
                let Some(condition) = arguments.first() else {
                    return self.refused(at, "requires a boolean expression as 1st argument");
                };
                let condition = self.given(condition, &Head::Bool.into())?;
                let panic = Node::Panic("assertion failed".to_owned(), at);
                let node = Node::If(Box::new([condition, Node::Unit, panic]));
                Ok(Typed::new(node, Type::UNIT))
            }
            "vec" => {
                let (nodes, of) = self.listed(&arguments)?;
                Ok(Typed::new(Node::Many(nodes), Type::of(Head::Vec, of)))
            }
            "format" => Ok(Typed::new(self.formatted(&arguments, "", at)?, Head::Str)),
            // Nothing shows what is printed beside the picture.
            "println" | "eprintln" | "print" | "eprint" => {
                let text = self.formatted(&arguments, "", at)?;
                Ok(Typed::new(Node::Block(vec![text], false), Type::UNIT))
            }
            "mutants" => self.mutants(&arguments, at),
            "write" => self.written(&arguments, "", at),
            "writeln" => self.written(&arguments, "\n", at),
            name => Err(Refusal::unknown(at, &format!("`{name}!`"))),
        }
    }

    /// An expression and the mutants that may run in its place, behind the number of the first. One
    /// that is refused is lost, and no other with it.
    fn mutants(&mut self, arguments: &[syn::Expr], at: At) -> Lowered {
        let [number, right, others @ ..] = arguments else {
            return self.refused(at, "requires a number and an expression");
        };
        let Node::Int(first, _) = self.expr(number)?.node else {
            return self.refused(at, "requires a number");
        };
        let right = self.expr(right)?;
        let mut nodes = vec![right.node];
        for other in others {
            let (locals, loops) = (self.locals.len(), self.loops.clone());
            let lowered = match right.ty.0 {
                Head::Never => self.expr(other).map(|it| it.node),
                _ => self.given(other, &right.ty),
            };
            self.locals.truncate(locals);
            self.loops = loops;
            nodes.push(lowered.unwrap_or(Node::Panic("no program".to_owned(), at)));
        }
        Ok(Typed::new(
            Node::Mutants(first as u32, nodes.into()),
            right.ty,
        ))
    }

    /// What is added to a text.
    fn written(&mut self, arguments: &[syn::Expr], end: &str, at: At) -> Lowered {
        let Some((to, rest)) = arguments.split_first() else {
            return self.refused(at, "requires at least a format string argument");
        };
        let typed = self.expr(to)?;
        let place = match typed.ty.0 {
            Head::RefMut | Head::Unknown => typed.node,
            _ => Node::Address(Box::new(self.mutable(typed, to)?)),
        };
        let text = self.formatted(rest, end, at)?;
        let written = self.native("str", "push_str", vec![place, text], at);
        let ty = Type::of(Head::Option, Type::UNIT);
        Ok(Typed::new(Node::Some(Box::new(written)), ty))
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
            nodes.push(value?.node);
            pieces.push(plain(before));
            rest = after;
        }
        pieces.push(plain(rest));
        match unnamed.next() {
            Some(_) => self.refused(at, "argument never used"),
            None => Ok(Node::Format(pieces, nodes)),
        }
    }

    fn inline(&mut self, name: &str, at: At) -> Lowered {
        if name.starts_with(|it: char| it.is_ascii_digit()) {
            return Err(Refusal::unknown(at, &format!("`{{{name}}}` in a text")));
        }
        let message = format!("cannot find value `{name}` in this scope");
        let missing = Refusal::new(at, &message, "not found in this scope", "");
        self.variable(name).ok_or(missing)
    }
}

/// What is before the first bracket, in it, and after it.
fn bracket(text: &str) -> Option<(&str, &str, &str)> {
    let (before, after) = text.split_once('{')?;
    let (inside, after) = after.split_once('}')?;
    Some((before, inside, after))
}
