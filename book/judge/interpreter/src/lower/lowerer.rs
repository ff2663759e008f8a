//! The state in which a body is lowered: names of variables, and slots of the frame.

use std::sync::Arc;

use syn::spanned::Spanned;

use crate::fault::{Fault, Span};
use crate::machine::{ClosureCode, Code};
use crate::names::{Names, Scope};
use crate::place::{Part, Place};
use crate::value::{Kind, kind};

pub(super) type Lowered<T = Code> = Result<T, Fault>;

/// The state in which a body is lowered.
pub(super) struct Lowerer<'n> {
    pub(super) names: &'n Names,
    pub(super) scope: &'n Scope,
    /// The number of the function.
    pub(super) number: usize,
    /// The name of the function if it is the reader's: then its values can be traced.
    pub(super) traced: Option<Arc<str>>,
    /// The variables in scope and their places, the innermost last.
    pub(super) variables: Vec<(String, Place)>,
    /// How many slots of the frame are taken. Each variable has one of its own.
    pub(super) slots: usize,
    /// The closures around the code, the innermost last: the first of their own slots, and the
    /// others that they use.
    pub(super) around: Vec<(usize, Vec<usize>)>,
    /// The closures that are lowered.
    pub(super) closures: Vec<ClosureCode>,
    /// The type that `return` gives.
    pub(super) result: Kind,
}

impl Lowerer<'_> {
    pub(super) fn at(&self, piece: &impl Spanned) -> Span {
        Span::of(self.scope.file, piece)
    }

    pub(super) fn unread<T>(&self, piece: &impl Spanned, words: &str) -> Lowered<T> {
        Err(Fault::unread(self.at(piece), words))
    }

    pub(super) fn refused<T>(
        &self,
        piece: &impl Spanned,
        message: impl Into<String>,
    ) -> Lowered<T> {
        Err(Fault::refused(self.at(piece), message))
    }

    /// Lowers something in a scope of its own.
    pub(super) fn scoped<T>(&mut self, lower: impl FnOnce(&mut Self) -> Lowered<T>) -> Lowered<T> {
        let count = self.variables.len();
        let lowered = lower(self);
        self.variables.truncate(count);
        lowered
    }

    /// Takes a slot of the frame.
    pub(super) fn slot(&mut self) -> usize {
        self.slots += 1;
        self.slots - 1
    }

    /// Declares a variable in a slot of its own.
    pub(super) fn declare(&mut self, name: &str, is_fixed: bool) -> usize {
        let slot = self.slot();
        self.name_place(name, Place::of(slot, is_fixed));
        slot
    }

    /// Declares a variable that is the name of a place.
    pub(super) fn name_place(&mut self, name: &str, place: Place) {
        self.variables.push((name.to_owned(), place));
    }

    /// Finds a variable, and notes that the closures around use it.
    pub(super) fn variable(&mut self, path: &syn::Path) -> Option<Place> {
        let name = path.get_ident()?;
        let (_, place) = self.variables.iter().rev().find(|it| name == &it.0)?;
        let indices = place.path.iter().filter_map(|part| match part {
            Part::Index(slot) => Some(*slot),
            _ => None,
        });
        for slot in indices.chain([place.slot]) {
            for (first, captured) in &mut self.around {
                if slot < *first && !captured.contains(&slot) {
                    captured.push(slot);
                }
            }
        }
        Some(place.clone())
    }

    /// Lowers an expression whose value must be of a type.
    pub(super) fn given(&mut self, expr: &syn::Expr, ty: Kind) -> Lowered {
        let at = self.at(expr);
        Ok(Self::checked(self.expr(expr)?, ty, at))
    }

    /// Adds a check of the type.
    pub(super) fn checked(code: Code, ty: Kind, at: Span) -> Code {
        if ty == kind::ANY || ty == kind::FLOAT && matches!(code, Code::Number(_)) {
            return code;
        }
        Code::act(move |m| {
            let mut value = code.run(m)?;
            m.admit(ty, &mut value, at)?;
            Ok(value)
        })
    }
}
