//! Calls of functions by their paths, and of values that are functions.

use common::rtweekend::Vec3;

use super::paths::Callee;
use super::{Lowered, Lowerer};
use crate::library;
use crate::names::names;
use crate::node::{Arguments, Node};
use crate::refusal::{At, Refusal};
use crate::types::{Owners, Type};

impl Lowerer<'_> {
    pub(super) fn call(&mut self, it: &syn::ExprCall) -> Lowered {
        let at = At {
            end: self.at_span(it.paren_token.span.close()).end,
            ..self.at(&it.func)
        };
        let syn::Expr::Path(function) = &*it.func else {
            return self.call_value(it, at);
        };
        let path = names(&function.path);
        if let [name] = path.as_slice()
            && self.variable(name).is_some()
        {
            return self.call_value(it, at);
        }
        if let Some("Some" | "Ok") = path.last().map(String::as_str) {
            self.counted(1, &it.args, at)?;
            return Ok(Node::Some(Box::new(self.expr(&it.args[0])?)));
        }
        let at_path = self.at_any(&function.path);
        let (owner, name) = self.owner(&path, at_path)?;
        match self.callee(owner.as_ref(), &name, &path, at_path, "function")? {
            Callee::Own(own) if self.names.functions[own].is_constant => {
                self.refused(at, "expected function, found a constant")
            }
            Callee::Own(own) => {
                let wanted = self.names.functions[own].parameters.clone();
                let arguments = self.arguments(&wanted, &it.args, at)?;
                Ok(Node::Call(own, arguments))
            }
            Callee::Default(ty) => {
                self.counted(0, &it.args, at)?;
                self.default_of(&ty, at)
            }
            Callee::Struct(kind) => self.tuple_struct(kind, it, at),
            Callee::Native(native) => self.call_native(native, it, at),
            Callee::OfTrait => {
                let given: Vec<&syn::Expr> = it.args.iter().collect();
                let Some((receiver, rest)) = given.split_first() else {
                    return Err(Refusal::miscounted(false, 1, 0, at));
                };
                self.method(receiver, &name, rest, (at_path, at))
            }
        }
    }

    fn tuple_struct(&mut self, kind: u32, it: &syn::ExprCall, at: At) -> Lowered {
        let fields = self.names.kinds[kind as usize].fields.iter();
        let wanted: Vec<Type> = fields.map(|it| it.ty.clone()).collect();
        self.counted(wanted.len(), &it.args, at)?;
        let given = it.args.iter().zip(&wanted).enumerate();
        let nodes = given.map(|(n, (value, ty))| Ok((n, self.given(value, ty)?)));
        Ok(Node::New(kind, nodes.collect::<Lowered<_>>()?, None))
    }

    fn call_native(&mut self, native: usize, it: &syn::ExprCall, at: At) -> Lowered {
        let listed = library::native(native);
        let count = listed.takes.len() + usize::from(listed.on.is_some());
        let wanted = vec![Type::UNKNOWN; count];
        let arguments = self.arguments(&wanted, &it.args, at)?;
        // A vector of numbers is made once.
        let number = |it: &Node| match it {
            Node::Float(it) => Some(*it),
            _ => None,
        };
        let numbers: Option<Vec<f64>> = arguments.nodes.iter().map(number).collect();
        Ok(match numbers.as_deref() {
            Some(&[x, y, z]) if listed.owners == Owners::VEC3 && listed.name == "new" => {
                Node::Vec3(Vec3::new(x, y, z))
            }
            _ => Node::Native(native, arguments),
        })
    }

    fn call_value(&mut self, it: &syn::ExprCall, at: At) -> Lowered {
        let function = self.expr(&it.func)?;
        if self.is_open(&it.func) {
            return self.needs_a_type(self.at(&it.func));
        }
        let wanted = vec![Type::UNKNOWN; it.args.len()];
        let arguments = self.arguments(&wanted, &it.args, at)?;
        Ok(Node::Apply(Box::new(function), arguments))
    }

    /// The arguments of a call as what is declared.
    pub(super) fn arguments<'s, G>(
        &mut self,
        wanted: &[Type],
        given: G,
        at: At,
    ) -> Lowered<Arguments>
    where
        G: IntoIterator<Item = &'s syn::Expr>,
    {
        let given: Vec<&syn::Expr> = given.into_iter().collect();
        if given.len() != wanted.len() {
            return Err(Refusal::miscounted(false, wanted.len(), given.len(), at));
        }
        let nodes = given.iter().zip(wanted);
        let nodes = nodes.map(|(value, ty)| self.argument(value, ty));
        Ok(Arguments {
            nodes: nodes.collect::<Lowered<_>>()?,
            places: given.iter().map(|it| self.at(it)).collect(),
            at,
        })
    }

    fn counted<T>(
        &self,
        wanted: usize,
        given: &syn::punctuated::Punctuated<T, syn::Token![,]>,
        at: At,
    ) -> Lowered<()> {
        if given.len() == wanted {
            Ok(())
        } else {
            Err(Refusal::miscounted(false, wanted, given.len(), at))
        }
    }
}
