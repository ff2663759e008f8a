//! `match`: arms that are tried one after the other, and what none of them matches.

use super::patterns::{Coverage, Matcher};
use super::{Expr, Lowered, Lowerer};
use crate::machine::Thunk;
use crate::types::Type;

/// An arm of a `match`, ready to be run.
struct Arm {
    pattern: Matcher,
    guard: Option<Thunk>,
    body: Thunk,
}

impl Lowerer<'_> {
    /// Lowers `match`, whose arms should come to type `ty`.
    pub(super) fn matching(&mut self, it: &syn::ExprMatch, ty: &Type) -> Lowered {
        let of = self.expr(&it.expr)?.run;
        let (mut arms, mut is_left) = (Vec::new(), !it.arms.is_empty());
        for arm in &it.arms {
            let (arm, never_ends) = self.arm(arm, ty)?;
            is_left &= never_ends;
            arms.push(arm);
        }
        let shapes = arms.iter();
        let shapes = shapes.map(|it| (&it.pattern.shape, it.guard.is_none()));
        if let Some(missing) = missing(&shapes.collect::<Vec<_>>()) {
            let message = format!("non-exhaustive patterns: `{missing}` not covered");
            return self.refused(self.at(&it.expr), message);
        }
        let at = self.at_any(&it.match_token);
        let made = Expr::new(at, move |m| {
            let value = of.eval(m)?;
            for arm in &arms {
                let guard = arm.guard.as_ref();
                if arm.pattern.binds(m, &value)?
                    && guard.map_or(Ok(true), |it| Ok(it.eval(m)?.truth()))?
                {
                    return arm.body.eval(m);
                }
            }
            m.wrong(at, "non-exhaustive patterns: no arm matches this value", "")
        });
        Ok(made.ending(is_left))
    }

    /// Lowers an arm of a `match`. The boolean is true if the arm's body never ends.
    fn arm(&mut self, arm: &syn::Arm, ty: &Type) -> Lowered<(Arm, bool)> {
        let (pattern, guard) = match &arm.pat {
            syn::Pat::Guard(it) => (&*it.pat, Some(&it.guard)),
            pattern => (pattern, None),
        };
        let (pattern, guard, mut body) = self.scoped(|own| {
            let pattern = own.pattern(pattern, false)?;
            let guard = guard.map(|it| own.given(it, &Type::BOOL)).transpose()?;
            Ok((pattern, guard.map(|it| it.run), own.given(&arm.body, ty)?))
        })?;
        let never_ends = body.never_ends();
        if !matches!(*arm.body, syn::Expr::Block(_)) {
            body = self.marked(body, self.at(&arm.body));
        }
        let body = body.run;
        let arm = Arm {
            pattern,
            guard,
            body,
        };
        Ok((arm, never_ends))
    }
}

/// Returns a pattern that no arm covers; `None` if all is covered, or if only running can tell.
/// Options, booleans and numbers are judged. Each arm comes with true if it has no guard.
fn missing(arms: &[(&Coverage, bool)]) -> Option<&'static str> {
    fn flat<'s>(shape: &'s Coverage, is_sure: bool, all: &mut Vec<(&'s Coverage, bool)>) {
        match shape {
            Coverage::Or(ways) => ways.iter().for_each(|it| flat(it, is_sure, all)),
            shape => all.push((shape, is_sure)),
        }
    }
    let mut all = Vec::new();
    for &(shape, is_sure) in arms {
        flat(shape, is_sure, &mut all);
    }
    let has = |wanted: Coverage| all.iter().any(|it| *it.0 == wanted);
    let sure = |wanted: &Coverage| all.iter().any(|it| it.1 && it.0 == wanted);
    let ways = if sure(&Coverage::Any) || all.is_empty() {
        return None;
    } else if has(Coverage::Bool(true)) || has(Coverage::Bool(false)) {
        [
            (Coverage::Bool(true), "true"),
            (Coverage::Bool(false), "false"),
        ]
    } else if has(Coverage::None) || has(Coverage::Some) {
        [(Coverage::None, "None"), (Coverage::Some, "Some(_)")]
    } else {
        let is_number = |it: &(&Coverage, bool)| *it.0 == Coverage::Number;
        return all.iter().all(is_number).then_some("_");
    };
    ways.into_iter().find(|it| !sure(&it.0)).map(|it| it.1)
}
