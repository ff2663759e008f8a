//! Method lookup: a name on a type, then on what the type leads to, until one is found.

use syn::spanned::Spanned;

use super::{Checked, Checker, Typed};
use crate::items::{Named, Shape, Signature, names, similar};
use crate::node::{Node, Pattern, Step, Target};
use crate::prelude::{self, NATIVES};
use crate::run::{Closure, Value};
use crate::types::{Head, Int, Type};

/// What is called.
#[derive(Clone, Copy)]
enum Callee {
    Own(usize),
    /// By the trait of the receiver.
    Dynamic(usize),
    Native(usize),
}

impl<'a> Checker<'a> {
    /// A name that is a value: a variable, a constant, a function, a variant.
    pub(super) fn path(&mut self, it: &syn::ExprPath) -> Checked {
        let path = names(&it.path);
        if let [name] = path.as_slice()
            && let Some(found) = self.variable(name)
        {
            return Ok(found);
        }
        if path == ["None"] {
            let of = self.types.any();
            return Ok(Typed::new(Node::None, Type::one(Head::Option, of)));
        }
        if let Some((kind, variant)) = self.variant(&it.path)
            && self.items.kinds[kind].variants[variant].shape == Shape::Unit
        {
            let node = Node::New(kind, variant, Vec::new(), None);
            return Ok(Typed::new(node, Type::plain(Head::Own(kind))));
        }
        let (owner, name) = self.owner(&path, &it.path)?;
        if let Some(owner) = &owner
            && let Some((value, ty)) = prelude::constant(owner, &name)
        {
            return Ok(Typed::new(constant(&value), ty));
        }
        if owner.is_none()
            && let Some(Named::Number(number)) = self.items.found(self.context.file, &path)
        {
            return Ok(Typed::new(Node::Float(number), Type::plain(Head::F64)));
        }
        let Some(callee) = self.function_named(owner.as_ref(), &name, &path) else {
            return Err(self.no_such_value(&it.path, owner.as_ref(), &name, "value"));
        };
        let (signature, _) = self.instance(callee, owner.as_ref());
        if signature.is_constant {
            let Callee::Own(function) = callee else {
                unreachable!("constants of the library are found before");
            };
            return Ok(Typed::new(
                Node::Call(function, Vec::new()),
                signature.result,
            ));
        }
        let ty = Type::function(signature.parameters, signature.result);
        let node = match callee {
            Callee::Own(function) => Node::Function(function),
            Callee::Native(native) => Node::NativeFunction(native, self.at(it)),
            Callee::Dynamic(_) => return self.unknown(it, "methods of traits as values"),
        };
        Ok(Typed::new(node, ty))
    }

    fn no_such_value(
        &self,
        path: &syn::Path,
        owner: Option<&Type>,
        name: &str,
        what: &str,
    ) -> crate::Fault {
        if let Some(owner) = owner {
            let message = format!(
                "no function or associated item named `{name}` found for `{}`",
                self.name(owner)
            );
            return crate::Fault::at(Some(self.place(path)), &message, "", "");
        }
        let locals = self.locals.iter().map(|it| it.name.as_str());
        match similar(name, locals) {
            Some(near) if what == "value" => {
                let message = format!("cannot find value `{name}` in this scope");
                let help = format!("there is a variable with a similar name: `{near}`");
                crate::Fault::at(
                    Some(self.place(path)),
                    &message,
                    "not found in this scope",
                    &help,
                )
            }
            _ => self
                .items
                .not_found(self.context.file, self.place(path), what, name),
        }
    }

    /// The type before the last `::`, if a type is there, and what comes after.
    fn owner(&mut self, path: &[String], at: &syn::Path) -> Checked<(Option<Type>, String)> {
        let Some((name, before)) = path.split_last().filter(|(_, before)| !before.is_empty())
        else {
            return Ok((None, path[0].clone()));
        };
        let owner = match (before, &self.context.own) {
            ([own], Some(ty)) if own == "Self" => Some(ty.clone()),
            _ => match self.items.found(self.context.file, before) {
                Some(Named::Type(ty)) => Some(ty),
                Some(Named::Generic(generic)) => {
                    let of = self.types.any();
                    Some(Type::one(crate::items::generic(generic), of))
                }
                Some(Named::Trait(found)) => Some(Type::plain(Head::Dyn(found))),
                _ => None,
            },
        };
        if owner.is_none() && before == ["Default"] {
            return Ok((Some(self.types.any()), name.clone()));
        }
        if owner.is_none() && self.items.found(self.context.file, path).is_none() {
            let message = format!("cannot find `{}` here", before.join("::"));
            return self.fault(
                at,
                &message,
                "use of unresolved module or unlinked crate",
                "",
            );
        }
        Ok((owner, name.clone()))
    }

    fn function_named(&self, owner: Option<&Type>, name: &str, path: &[String]) -> Option<Callee> {
        match owner {
            None => match self.items.found(self.context.file, path)? {
                Named::Function(function) => Some(Callee::Own(function)),
                Named::Library(name) => prelude::native("", name).map(Callee::Native),
                _ => None,
            },
            Some(owner) => self.method_of(owner, name),
        }
    }

    /// The function of that name that the type has.
    fn method_of(&self, ty: &Type, name: &str) -> Option<Callee> {
        match ty.head() {
            Some(Head::Own(kind)) => {
                if let Some(own) = self.items.method_or_default(kind, name) {
                    return Some(Callee::Own(own));
                }
                let derives = |it: &str| self.items.kinds[kind].derives.iter().any(|own| own == it);
                (name == "clone" && derives("Clone"))
                    .then(|| prelude::native("any", name))
                    .flatten()
                    .map(Callee::Native)
            }
            Some(Head::Dyn(of)) => self
                .items
                .method_of(&self.items.traits[of], name)
                .map(Callee::Dynamic),
            _ => {
                let mut owners = prelude::owners(ty).iter();
                owners
                    .find_map(|owner| prelude::native(owner, name))
                    .map(Callee::Native)
            }
        }
    }

    /// The signature of what is called on that type, with fresh types for its parameters.
    fn instance(&mut self, callee: Callee, owner: Option<&Type>) -> (Signature, Type) {
        match callee {
            Callee::Own(function) | Callee::Dynamic(function) => {
                let signature = self.items.functions[function].clone();
                let own = signature.of.clone().unwrap_or_else(Type::unit);
                (signature, own)
            }
            Callee::Native(native) => {
                let signature = NATIVES[native].signature.clone();
                let own = owner.cloned().unwrap_or_else(Type::unit);
                let own = match self.types.known(&own) {
                    it @ Type::Var(_) if self.types.is_integer(&it) || self.types.is_float(&it) => {
                        it
                    }
                    it => it,
                };
                let of = match own.head() {
                    Some(_) if matches!(&own, Type::Of(_, of) if !of.is_empty()) => own.inner(),
                    _ => self.types.any(),
                };
                let with = [of, self.types.any(), own.clone()];
                let parameters = signature
                    .parameters
                    .iter()
                    .map(|it| it.with(&with))
                    .collect();
                let result = signature.result.with(&with);
                (
                    Signature {
                        parameters,
                        result,
                        ..signature
                    },
                    own,
                )
            }
        }
    }

    pub(super) fn call(&mut self, it: &syn::ExprCall) -> Checked {
        let syn::Expr::Path(function) = &*it.func else {
            let function = self.expr(&it.func, None)?;
            return self.call_value(function, it);
        };
        let path = names(&function.path);
        if let [name] = path.as_slice()
            && let Some(found) = self.variable(name)
        {
            return self.call_value(found, it);
        }
        if path.last().is_some_and(|it| it == "Some") && (path.len() == 1 || path[0] == "Option") {
            let of = self.types.any();
            let arguments = self.arguments(std::slice::from_ref(&of), &it.args, it, 0)?;
            let [argument] = <[Node; 1]>::try_from(arguments).expect("they were counted");
            return Ok(Typed::new(
                Node::Some(Box::new(argument)),
                Type::one(Head::Option, of),
            ));
        }
        if let Some((kind, variant)) = self.variant(&function.path)
            && self.items.kinds[kind].variants[variant].shape == Shape::Tuple
        {
            let fields = &self.items.kinds[kind].variants[variant].fields;
            let types: Vec<Type> = fields.iter().map(|it| it.ty.clone()).collect();
            let nodes = self.arguments(&types, &it.args, it, 0)?;
            let node = Node::New(kind, variant, nodes.into_iter().enumerate().collect(), None);
            return Ok(Typed::new(node, Type::plain(Head::Own(kind))));
        }
        let (owner, name) = self.owner(&path, &function.path)?;
        if let Some(made) = self.conversion(owner.as_ref(), &name, it)? {
            return Ok(made);
        }
        let Some(callee) = self.function_named(owner.as_ref(), &name, &path) else {
            return Err(self.no_such_value(&function.path, owner.as_ref(), &name, "function"));
        };
        let (signature, own) = self.instance(callee, owner.as_ref());
        if signature.is_constant {
            return self.fault(it, "expected function, found a constant", "", "");
        }
        // `f64::sqrt(x)` and `Hittable::hit(&sphere, …)`: a method by its full name.
        if signature.has_self && matches!(callee, Callee::Native(_) | Callee::Dynamic(_)) {
            let Some(receiver) = it.args.first() else {
                return self.fault(
                    it,
                    "this method takes `self`, but no argument was supplied",
                    "",
                    "",
                );
            };
            let receiver_typed = self.expr(receiver, Some(&own))?;
            let rest = it.args.iter().skip(1).collect();
            return self.method(receiver_typed, receiver, &name, rest, it, it);
        }
        let arguments = self.arguments(&signature.parameters, &it.args, it, 0)?;
        Ok(self.made(callee, arguments, signature.result, it))
    }

    /// What is made of other types: `f64::from(…)`, and what is there by default.
    fn conversion(
        &mut self,
        owner: Option<&Type>,
        name: &str,
        it: &syn::ExprCall,
    ) -> Checked<Option<Typed>> {
        let Some(owner) = owner else {
            return Ok(None);
        };
        let is_number = matches!(owner.head(), Some(Head::F64 | Head::F32 | Head::Int(_)));
        if name == "from" && is_number && it.args.len() == 1 {
            let from = self.expr(&it.args[0], None)?;
            return self.converted(from, &owner.clone(), it).map(Some);
        }
        let is_written = matches!(owner.head(), Some(Head::Own(kind)) if self.items.method(kind, "default", None).is_some());
        if name == "default" && it.args.is_empty() && !is_written {
            let has_none = match owner.head() {
                Some(Head::Own(kind)) => !self.items.kinds[kind]
                    .derives
                    .iter()
                    .any(|it| it == "Default"),
                Some(Head::Ray | Head::Camera | Head::Picture | Head::Dyn(_)) => true,
                _ => false,
            };
            if has_none {
                let message = format!(
                    "no function or associated item named `default` found for `{}`",
                    self.name(owner)
                );
                return self.fault(
                    it,
                    &message,
                    "",
                    "`#[derive(Default)]` above the struct gives one",
                );
            }
            let kept = self.keep(owner);
            return Ok(Some(Typed::new(Node::Default(kept), owner.clone())));
        }
        Ok(None)
    }

    /// A number as a type that has room for all of its type.
    fn converted(&mut self, from: Typed, to: &Type, at: &impl Spanned) -> Checked {
        let (ty, wanted) = (self.types.known(&from.ty), self.types.known(to));
        let fits = match (ty.head(), wanted.head()) {
            (None, Some(Head::F64 | Head::F32))
                if self.types.is_integer(&ty) || self.types.is_float(&ty) =>
            {
                // A literal takes the type that fits.
                self.types.is_integer(&ty) || self.types.unify(&ty, &wanted)
            }
            (None, _) => self.types.is_integer(&ty),
            (Some(Head::Int(int)), Some(Head::F64)) => int.most < 1 << 32,
            (Some(Head::Int(int)), Some(Head::F32)) => int.most < 1 << 16,
            (Some(Head::F32), Some(Head::F64)) | (Some(Head::Bool), Some(Head::Int(_))) => true,
            (Some(Head::Int(int)), Some(Head::Int(wanted))) => {
                wanted.fits(int.least)
                    && wanted.fits(int.most)
                    && (!int.name.ends_with("size") || int == wanted)
            }
            (Some(one), Some(other)) => one == other,
            _ => false,
        };
        if !fits {
            let [one, other] = [&wanted, &ty].map(|it| self.name(it));
            let message = format!("the trait bound `{one}: From<{other}>` is not satisfied");
            return self.fault(at, &message, "", &format!("`… as {one}`"));
        }
        let kept = self.keep(&wanted);
        Ok(Typed::new(Node::Cast(Box::new(from.node), kept), wanted))
    }

    fn call_value(&mut self, function: Typed, it: &syn::ExprCall) -> Checked {
        let function = self.stripped(&function);
        let Type::Of(Head::Fn, types) = function.ty else {
            let message = format!("expected function, found `{}`", self.name(&function.ty));
            return self.fault(&it.func, &message, "", "");
        };
        let (result, parameters) = types.split_last().expect("a function has a result");
        let arguments = self.arguments(parameters, &it.args, it, 0)?;
        Ok(Typed::new(
            Node::CallValue(Box::new(function.node), arguments),
            result.clone(),
        ))
    }

    /// The arguments as their parameters want them. Of a method the first has been seen.
    fn arguments<'s>(
        &mut self,
        parameters: &[Type],
        given: impl IntoIterator<Item = &'s syn::Expr>,
        at: &impl Spanned,
        seen: usize,
    ) -> Checked<Vec<Node>> {
        let given: Vec<&syn::Expr> = given.into_iter().collect();
        let (wanted, count) = (parameters.len() - seen, given.len());
        if wanted != count {
            let what = if seen > 0 { "method" } else { "function" };
            let several = |n: usize| if n == 1 { "argument" } else { "arguments" };
            let was = if count == 1 { "was" } else { "were" };
            let message = format!(
                "this {what} takes {wanted} {} but {count} {} {was} supplied",
                several(wanted),
                several(count)
            );
            return self.fault(at, &message, "", "");
        }
        let each = given.into_iter().zip(&parameters[seen..]);
        each.map(|(value, ty)| self.given(value, ty)).collect()
    }

    fn made(
        &mut self,
        callee: Callee,
        arguments: Vec<Node>,
        result: Type,
        at: &impl Spanned,
    ) -> Typed {
        let kept = self.keep(&result);
        let node = match callee {
            Callee::Own(function) => Node::Call(function, arguments),
            Callee::Dynamic(function) => Node::Dispatch(
                function,
                self.items.functions[function].name.clone(),
                arguments,
            ),
            Callee::Native(native) => Node::Native(native, arguments, kept, self.at(at)),
        };
        Typed::new(node, result)
    }

    pub(super) fn method_call(&mut self, it: &syn::ExprMethodCall) -> Checked {
        let receiver = self.expr(&it.receiver, None)?;
        let made = self.method(
            receiver,
            &it.receiver,
            &it.method.to_string(),
            it.args.iter().collect(),
            &it.method,
            it,
        )?;
        // `.sum::<f64>()` and `.collect::<Vec<_>>()` say what comes out.
        if let Some(written) = &it.turbofish
            && let Some(syn::GenericArgument::Type(ty)) = written.args.first()
        {
            let ty = self.ty(ty)?;
            if !self.types.unify(&made.ty, &ty) {
                return self.unknown(written, &format!("`{}` of that type", it.method));
            }
        }
        Ok(made)
    }

    /// A method by its name, on the receiver or on what that leads to.
    fn method(
        &mut self,
        receiver: Typed,
        receiver_at: &syn::Expr,
        name: &str,
        arguments: Vec<&syn::Expr>,
        at: &impl Spanned,
        whole: &impl Spanned,
    ) -> Checked {
        let mut on = receiver.clone();
        on.ty = self.types.known(&on.ty);
        let mut reached = on.ty.clone();
        if name == "into" && arguments.is_empty() {
            return self.unknown(at, "`into`: say what it becomes, as in `f64::from(…)`");
        }
        let callee = loop {
            on.ty = self.types.known(&on.ty);
            if let Some(callee) = self.method_of(&self.number(&on.ty), name) {
                break callee;
            }
            match on.ty.head() {
                Some(Head::Ref | Head::RefMut | Head::Box) => {
                    reached = on.ty.clone();
                    on = self.dereferenced(on);
                }
                _ => return Err(self.no_method(&receiver.ty, &on.ty, name, at)),
            }
        };
        if self.types.known(&on.ty).head().is_none()
            && self.types.is_float(&on.ty)
            && matches!(callee, Callee::Native(_))
        {
            let is_literal = matches!(
                receiver_at,
                syn::Expr::Lit(_) | syn::Expr::Paren(_) | syn::Expr::Unary(_)
            );
            if is_literal {
                let message =
                    format!("can't call method `{name}` on ambiguous numeric type `{{float}}`");
                return self.fault(at, &message, "", "say which: `2.0_f64`");
            }
            self.types.unify(&on.ty, &Type::plain(Head::F64));
            on.ty = Type::plain(Head::F64);
        }
        // What is borrowed gives references.
        let is_borrowed = matches!(reached.head(), Some(Head::Ref | Head::RefMut));
        let callee = match callee {
            Callee::Native(_) if name == "into_iter" && is_borrowed => prelude::native(
                if on.ty.is(Head::Option) {
                    "Option"
                } else {
                    "list"
                },
                "iter",
            )
            .map_or(callee, Callee::Native),
            callee => callee,
        };
        let own = self.iterator_of(&on.ty, callee);
        let (signature, _) = self.instance(callee, Some(&own));
        let Some(wanted) = signature.parameters.first().filter(|_| signature.has_self) else {
            let message = format!(
                "no method named `{name}` found for `{}` in the current scope",
                self.name(&on.ty)
            );
            return self.fault(
                at,
                &message,
                "this is an associated function, not a method",
                &format!("`{}::{name}(…)`", self.name(&on.ty)),
            );
        };
        let node = match self.types.known(wanted).head() {
            Some(Head::RefMut) => {
                if is_borrowed && reached.is(Head::RefMut) && on.target.is_none() {
                    on.node.clone()
                } else {
                    let target = self.mutable(on.clone(), receiver_at)?;
                    Node::Address(Box::new(target))
                }
            }
            Some(Head::Ref) => on.node.clone(),
            _ => {
                // Of an iterator of references that is asked for their values.
                let fits = self.types.unify(wanted, &own);
                if !fits {
                    return Err(self.no_method(&receiver.ty, &on.ty, name, at));
                }
                on.node.clone()
            }
        };
        let rest = self.arguments(&signature.parameters, arguments, whole, 1)?;
        let arguments = [vec![node], rest].concat();
        let mut result = signature.result;
        if matches!(name, "sum" | "product") && self.types.known(&result).is(Head::Ref) {
            result = self.types.known(&result).inner();
        }
        if name == "map"
            && let Some(Head::Array(length)) = on.ty.head()
        {
            result = Type::one(Head::Array(length), result.inner());
        }
        Ok(self.made(callee, arguments, result, at))
    }

    /// A range or a list as the iterator of which it has the methods.
    fn iterator_of(&self, ty: &Type, callee: Callee) -> Type {
        match (callee, ty.head()) {
            (Callee::Native(native), Some(Head::Range)) if NATIVES[native].owner == "Iterator" => {
                Type::one(Head::Iterator, ty.inner())
            }
            _ => ty.clone(),
        }
    }

    /// The type whose methods a number has, of which not all is known.
    fn number(&self, ty: &Type) -> Type {
        match ty {
            Type::Var(_) if self.types.is_float(ty) => Type::plain(Head::F64),
            Type::Var(_) if self.types.is_integer(ty) => Int::plain("i32"),
            ty => ty.clone(),
        }
    }

    fn no_method(
        &self,
        receiver: &Type,
        last: &Type,
        name: &str,
        at: &impl Spanned,
    ) -> crate::Fault {
        let known: Vec<&str> = match last.head() {
            Some(Head::Own(kind)) => {
                let own = self
                    .items
                    .functions
                    .iter()
                    .filter(|it| it.of.as_ref().is_some_and(|of| of.is(Head::Own(kind))));
                own.map(|it| it.name.as_str()).collect()
            }
            _ => {
                let owners = prelude::owners(&self.number(last));
                let own = NATIVES.iter().filter(|it| owners.contains(&it.owner));
                own.map(|it| it.signature.name.as_str()).collect()
            }
        };
        let help =
            similar(name, known.into_iter()).map_or(String::new(), |it| format!("there is `{it}`"));
        let message = match self.types.known(receiver) {
            Type::Var(_) if !self.types.is_float(receiver) && !self.types.is_integer(receiver) => {
                "type annotations needed".to_owned()
            }
            _ => format!(
                "no method named `{name}` found for `{}` in the current scope",
                self.name(receiver)
            ),
        };
        let is_field = self.fields_of(last).iter().any(|it| it.0 == name);
        let is_native = !matches!(last.head(), Some(Head::Own(_) | Head::Dyn(_)));
        let help = match (is_native, help.is_empty()) {
            _ if is_field => format!("`{name}` is a field: without `()`"),
            (true, true) => "if Rust has it, this page does not know it; cargo does".to_owned(),
            _ => help,
        };
        crate::Fault::at(Some(self.place(at)), &message, "", &help)
    }

    pub(super) fn closure(&mut self, it: &syn::ExprClosure, expected: Option<&Type>) -> Checked {
        let expected = expected.map(|it| self.types.known(it));
        let wanted: Vec<Type> = match expected {
            Some(Type::Of(Head::Fn, types)) if types.len() == it.inputs.len() + 1 => types,
            Some(Type::Of(Head::Fn, types)) => {
                let message = format!(
                    "closure is expected to take {} arguments, but it takes {}",
                    types.len() - 1,
                    it.inputs.len()
                );
                return self.fault(it, &message, "", "");
            }
            _ => (0..=it.inputs.len()).map(|_| self.types.any()).collect(),
        };
        let outside = self.locals.len();
        let mut parameters: Vec<Pattern> = Vec::new();
        for (input, ty) in it.inputs.iter().zip(&wanted) {
            let pattern = match input {
                syn::Pat::Type(typed) => {
                    let written = self.ty(&typed.ty)?;
                    if !self.types.unify(ty, &written) {
                        let (message, label) = self.mismatch(ty, &written);
                        return self.fault(&typed.ty, message, &label, "");
                    }
                    self.pattern(&typed.pat, ty, false)?
                }
                input => self.pattern(input, ty, false)?,
            };
            parameters.push(pattern);
        }
        let result = wanted.last().expect("a function has a result").clone();
        if let syn::ReturnType::Type(_, ty) = &it.output {
            let written = self.ty(ty)?;
            self.types.unify(&result, &written);
        }
        let outer = std::mem::replace(&mut self.result, result.clone());
        let ways = std::mem::take(&mut self.ways);
        let body = self.given(&it.body, &result);
        self.result = outer;
        self.ways = ways;
        let body = body?;
        self.leave(outside);
        self.code.closures.push(Closure {
            parameters,
            body,
            slots: 0,
        });
        let node = Node::Closure(self.code.closures.len() - 1, it.capture.is_some());
        Ok(Typed::new(node, Type::Of(Head::Fn, wanted)))
    }

    pub(super) fn field(&mut self, it: &syn::ExprField) -> Checked {
        let base = self.expr(&it.base, None)?;
        let on = self.stripped(&base);
        let name = match &it.member {
            syn::Member::Named(name) => name.to_string(),
            syn::Member::Unnamed(n) => n.index.to_string(),
        };
        if let Some(Head::Own(kind)) = on.ty.head() {
            let own = &self.items.kinds[kind];
            let mut fields = own.variants.iter().flat_map(|it| &it.fields);
            let is_hidden =
                own.file != self.context.file && fields.any(|it| it.name == name && !it.is_public);
            if is_hidden {
                let message = format!("field `{name}` of struct `{}` is private", own.name);
                let help = "`pub` before it shows it to other files";
                return self.fault(&it.member, &message, "private field", help);
            }
        }
        let known = self.fields_of(&on.ty);
        let Some((n, (_, ty))) = known.iter().enumerate().find(|(_, (own, _))| *own == name) else {
            let is_method = self.method_of(&self.number(&on.ty), &name).is_some();
            let near = similar(&name, known.iter().map(|it| it.0));
            let help = match (is_method, near) {
                (true, _) => format!("`{name}` is a method: `.{name}(…)`"),
                (_, Some(near)) => format!("there is `{near}`"),
                _ => known
                    .iter()
                    .map(|it| format!("`{}`", it.0))
                    .collect::<Vec<_>>()
                    .join(", "),
            };
            let message = format!("no field `{name}` on type `{}`", self.name(&base.ty));
            return self.fault(&it.member, &message, "unknown field", &help);
        };
        let target = on.target.map(|mut target: Target| {
            target.steps.push(Step::Field(n));
            target
        });
        Ok(Typed {
            node: Node::Field(Box::new(on.node), n),
            ty: ty.clone(),
            target,
            fixed: on.fixed,
        })
    }

    /// The names and the types of what a value has, if it has no variants.
    pub(super) fn fields_of(&self, ty: &Type) -> Vec<(&'a str, Type)> {
        let all = |names: &[&'a str], ty: Type| -> Vec<(&'a str, Type)> {
            names.iter().map(|it| (*it, ty.clone())).collect()
        };
        let [float, vector] = [Head::F64, Head::Vec3].map(Type::plain);
        match ty {
            Type::Of(Head::Own(kind), _) if !self.items.kinds[*kind].is_enum => {
                let fields = self.items.kinds[*kind].variants[0].fields.iter();
                fields.map(|it| (it.name.as_str(), it.ty.clone())).collect()
            }
            Type::Of(Head::Vec3, _) => all(&["x", "y", "z"], float),
            Type::Of(Head::Ray, _) => all(&["origin", "direction"], vector),
            Type::Of(Head::Camera, _) => {
                let sizes = all(&["image_width", "image_height"], Int::plain("u32"));
                let vectors = ["center", "pixel00", "pixel_delta_u", "pixel_delta_v"];
                [sizes, all(&vectors, vector)].concat()
            }
            Type::Of(Head::Tuple, types) => {
                const NUMBERS: [&str; 8] = ["0", "1", "2", "3", "4", "5", "6", "7"];
                NUMBERS.into_iter().zip(types.iter().cloned()).collect()
            }
            _ => Vec::new(),
        }
    }

    pub(super) fn index(&mut self, it: &syn::ExprIndex) -> Checked {
        let base = self.expr(&it.expr, None)?;
        let on = self.stripped(&base);
        let of = match on.ty.head() {
            Some(Head::Vec | Head::Slice | Head::Array(_)) => on.ty.inner(),
            Some(Head::Vec3) => Type::plain(Head::F64),
            _ => {
                let message = format!(
                    "cannot index into a value of type `{}`",
                    self.name(&base.ty)
                );
                return self.fault(it, &message, "", "");
            }
        };
        let usize = Int::plain("usize");
        let index = self.expr(&it.index, Some(&usize))?;
        if self.types.known(&index.ty).is(Head::Range) {
            return self.unknown(&it.index, "slices by a range");
        }
        if !self.types.unify(&index.ty, &usize) {
            let message = format!(
                "the type `[{}]` cannot be indexed by `{}`",
                self.name(&of),
                self.name(&index.ty)
            );
            return self.fault(&it.index, &message, "an index is a `usize`", "");
        }
        let at = self.at(it);
        let target = on.target.map(|mut target| {
            target
                .steps
                .push(Step::Index(index.node.clone(), at.clone()));
            target
        });
        Ok(Typed {
            node: Node::Index(Box::new(on.node), Box::new(index.node), at),
            ty: of,
            target,
            fixed: on.fixed,
        })
    }

    pub(super) fn cast(&mut self, it: &syn::ExprCast) -> Checked {
        let from = self.expr(&it.expr, None)?;
        let to = self.ty(&it.ty)?;
        let ty = self.types.known(&from.ty);
        let is_number = |it: &Type| matches!(it.head(), Some(Head::Int(_) | Head::F64 | Head::F32));
        let is_free = self.types.is_integer(&ty) || self.types.is_float(&ty);
        let fits = match to.head() {
            _ if !is_number(&to) => ty == to,
            Some(Head::Int(_)) if ty.is(Head::Bool) => true,
            _ => is_number(&ty) || is_free,
        };
        if !fits {
            let message = format!(
                "non-primitive cast: `{}` as `{}`",
                self.name(&ty),
                self.name(&to)
            );
            return self.fault(it, &message, "", "");
        }
        // A literal is at once what it is cast to.
        if self.types.is_integer(&ty)
            && matches!(to.head(), Some(Head::Int(_)))
            && matches!(ty, Type::Var(_))
        {
            self.types.unify(&ty, &to);
        }
        let kept = self.keep(&to);
        Ok(Typed::new(Node::Cast(Box::new(from.node), kept), to))
    }
}

fn constant(value: &Value) -> Node {
    match value {
        Value::Vec3(it) => Node::Vec3(*it),
        Value::Float(it) => Node::Float(*it),
        Value::Int(it) => Node::Int(*it),
        Value::Ordering(it) => Node::Ordering(*it),
        _ => Node::Unit,
    }
}
