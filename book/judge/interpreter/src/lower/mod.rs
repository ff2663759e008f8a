//! Closure generation: turns each expression into a closure that runs it, with variables in slots
//! and names resolved. The type of its value is checked where the value meets a declared one.

mod calls;
mod closures;
mod declared;
mod expressions;
mod loops;
mod macros;
mod matches;
mod methods;
mod paths;
mod patterns;
mod places;
mod statements;
mod structs;

use std::sync::Arc;

use syn::spanned::Spanned;

use crate::machine::{
    CompiledFunction, CoveragePoint, Eval, ExprForm, ExprInfo, FunctionSource, Machine, Thunk,
};
use crate::names::collect::ItemBody;
use crate::names::{Names, Signature, TypeScope};
use crate::read::{at, at_expr, at_span};
use crate::refusal::{Refusal, Span};
use crate::types::{Ctor, Type};

/// The result of lowering a part of a text.
type Lowered<T = Expr> = Result<T, Refusal>;

/// An expression that was lowered, and what its text shows.
struct Expr {
    run: Thunk,
    spot: ExprInfo,
}

impl Expr {
    /// Makes an expression that runs `act`.
    fn new(at: Span, act: impl Fn(&mut Machine<'_>) -> Eval + Send + Sync + 'static) -> Self {
        Self::of(Thunk::new(act), at)
    }

    /// Makes an expression of a thunk.
    fn of(run: Thunk, at: Span) -> Self {
        let spot = at.into();
        Self { run, spot }
    }

    /// Sets the form of the expression.
    fn shown(self, form: ExprForm) -> Self {
        let at = self.spot.at;
        let spot = ExprInfo { at, form };
        Self { spot, ..self }
    }

    /// Sets the form of the expression, if `is_so`.
    fn shown_if(self, is_so: bool, form: ExprForm) -> Self {
        if is_so { self.shown(form) } else { self }
    }

    /// Marks the expression as one after which nothing runs, if `never_ends`.
    fn ending(self, never_ends: bool) -> Self {
        self.shown_if(never_ends, ExprForm::Never)
    }

    /// Returns true if nothing runs after the expression, as after `return`.
    fn never_ends(&self) -> bool {
        self.spot.form == ExprForm::Never
    }
}

/// Lowers a function or constant to one that can be run. `text` is that of its file. A function
/// without a body, as in a trait, becomes one that does nothing.
pub(crate) fn lower(
    names: &Names,
    text: &str,
    signature: &Signature,
    body: Option<ItemBody<'_>>,
) -> Lowered<CompiledFunction> {
    let Some(body) = body else {
        return Ok(CompiledFunction::default());
    };
    let module = signature.inside;
    let mut lowerer = Lowerer {
        names,
        text,
        name: &signature.name,
        file: names.modules[module].file,
        context: TypeScope {
            own: signature.of.clone(),
            ..TypeScope::of(module)
        },
        top: None,
        locals: Vec::new(),
        alternatives: None,
        slots: 0,
        slot_names: Vec::new(),
        loops: Vec::new(),
        result: signature.result.clone(),
        marks: Vec::new(),
    };
    let made = match body {
        ItemBody::Constant(value) => {
            let made = lowerer.given(value, &signature.result)?;
            lowerer.marked(made, lowerer.at(value))
        }
        ItemBody::Function(syntax, block) => lowerer.function(signature, syntax, block)?,
    };
    Ok(CompiledFunction {
        slots: lowerer.slots,
        names: lowerer.slot_names,
        body: made.run,
        marks: lowerer.marks,
        written: written(names, text, signature, body),
    })
}

/// Returns the function's name and text; `None` for a constant.
fn written(
    names: &Names,
    text: &str,
    own: &Signature,
    body: ItemBody<'_>,
) -> Option<FunctionSource> {
    let ItemBody::Function(syntax, block) = body else {
        return None;
    };
    let of = match own.of.as_ref().map(|it| it.0) {
        Some(Ctor::Own(kind)) => format!("{}::", names.structs[kind as usize].name),
        _ => String::new(),
    };
    let end = block.brace_token.span.close().byte_range().end;
    let text = text.get(syntax.fn_token.span.byte_range().start..end)?;
    Some(FunctionSource {
        name: of + &own.name,
        text: text.to_owned(),
    })
}

/// A variable in scope.
struct Variable {
    name: String,
    /// The place in the function's frame.
    slot: usize,
    is_mut: bool,
    /// True if nothing says the variable's type, which the compiler wants to know before it is
    /// used.
    is_open: bool,
}

/// The state while one function is lowered.
struct Lowerer<'n> {
    names: &'n Names,
    /// The text of the file, for operators.
    text: &'n str,
    /// The name of the function.
    name: &'n str,
    file: u32,
    context: TypeScope,
    /// The outermost block of the function, whose items are declared already.
    top: Option<*const syn::Block>,
    /// The variables in scope, the innermost last.
    locals: Vec<Variable>,
    /// Within a pattern with `|`, the count of variables before it: alternatives share the later
    /// ones.
    alternatives: Option<usize>,
    /// The count of slots in the frame so far.
    slots: usize,
    /// The variable's name of each slot.
    slot_names: Vec<String>,
    /// For each loop around, the innermost last: true if a `break` leaves it.
    loops: Vec<bool>,
    /// The declared result, of the function or of the closure that is being lowered.
    result: Type,
    /// All statements and expressions that note when they run.
    marks: Vec<Arc<CoveragePoint>>,
}

impl Lowerer<'_> {
    /// Lowers the parameters and the body of a function.
    fn function(
        &mut self,
        signature: &Signature,
        syntax: &syn::Signature,
        block: &syn::Block,
    ) -> Lowered {
        self.top = Some(block);
        // The arguments are in the first slots.
        self.slots = signature.parameters.len();
        let mut patterns = Vec::new();
        for (slot, input) in syntax.inputs.iter().enumerate() {
            match input {
                syn::FnArg::Receiver(it) => {
                    self.named("self", slot, it.mutability.is_some());
                }
                syn::FnArg::Typed(it) => match &*it.pat {
                    syn::Pat::Ident(name) if name.subpat.is_none() && name.by_ref.is_none() => {
                        let is_mut = name.mutability.is_some();
                        self.named(&name.ident.to_string(), slot, is_mut);
                    }
                    pattern => patterns.push((slot, self.irrefutable(pattern)?)),
                },
            }
        }
        let body = self.block_given(block, &signature.result)?;
        if patterns.is_empty() {
            return Ok(body);
        }
        Ok(Expr::new(body.spot.at, move |m| {
            for (slot, pattern) in &patterns {
                pattern.binds(m, &m.local(*slot))?;
            }
            body.run.eval(m)
        }))
    }

    fn at(&self, it: &syn::Expr) -> Span {
        at_expr(self.file, it)
    }

    fn at_any(&self, it: &impl Spanned) -> Span {
        at(self.file, it)
    }

    fn at_span(&self, it: proc_macro2::Span) -> Span {
        at_span(self.file, it)
    }

    fn fault<T>(&self, at: Span, message: &str, label: &str, help: &str) -> Lowered<T> {
        Err(Refusal::new(at, message, label, help))
    }

    fn refused<T>(&self, at: Span, message: impl Into<String>) -> Lowered<T> {
        Err(Refusal::new(at, message, "", ""))
    }

    fn unread<T>(&self, at: Span, what: &str) -> Lowered<T> {
        Err(Refusal::unread(at, what))
    }

    /// Returns the variable of that name in scope, the innermost if there are several.
    fn variable(&self, name: &str) -> Option<&Variable> {
        self.locals.iter().rev().find(|it| it.name == name)
    }

    /// Returns the variable that an expression names, if it is one name.
    fn variable_of(&self, it: &syn::Expr) -> Option<&Variable> {
        match it {
            syn::Expr::Path(it) => self.variable(&it.path.get_ident()?.to_string()),
            _ => None,
        }
    }

    /// Declares a variable in a new slot, and returns the slot.
    fn local(&mut self, name: &str, is_mut: bool) -> usize {
        let slot = self.slots;
        self.slots += 1;
        self.named(name, slot, is_mut);
        slot
    }

    /// Declares a variable in a given slot.
    fn named(&mut self, name: &str, slot: usize, is_mut: bool) {
        let slots = self.slot_names.len().max(slot + 1);
        self.slot_names.resize(slots, String::new());
        name.clone_into(&mut self.slot_names[slot]);
        self.locals.push(Variable {
            name: name.to_owned(),
            slot,
            is_mut,
            is_open: false,
        });
    }

    /// Lowers a part of the text at whose end its variables go out of scope.
    fn scoped<T>(&mut self, lower: impl FnOnce(&mut Self) -> Lowered<T>) -> Lowered<T> {
        let outside = self.locals.len();
        let lowered = lower(self);
        self.locals.truncate(outside);
        lowered
    }

    /// Makes an expression note when it runs.
    fn marked(&mut self, it: Expr, at: Span) -> Expr {
        let mark = self.mark(at);
        let Expr { run, spot } = it;
        let run = Thunk::new(move |m| {
            mark.notes_that_it_runs();
            run.eval(m)
        });
        Expr { run, spot }
    }

    /// Makes a coverage point for a span.
    fn mark(&mut self, at: Span) -> Arc<CoveragePoint> {
        let mark = Arc::new(CoveragePoint::at(at));
        self.marks.push(Arc::clone(&mark));
        mark
    }
}
