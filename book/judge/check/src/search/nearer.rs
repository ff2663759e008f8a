//! Tree differencing: edits that put the chapter's expressions and statements, with the reader's
//! names, where the reader has others.

use std::ops::Range;

use super::edit::{RankedEdit, words};
use super::functions::RustFn;
use super::renaming::{LocalName, in_common_names, locals};
use super::roots::{RootRole, roots};
use super::tree::{RustOp, RustTree};

/// The number of the chapter's expressions, most alike first, that are tried in the place of one.
const COMPARED: usize = 3;
/// An expression that scores less, by likeness and role, is tried only if no other is more alike.
const UNLIKE: f64 = 0.3;
/// The score for the same role, added to a likeness from 0 to 1.
const SAME_ROLE: f64 = 0.6;
/// The score for the value of a variable of the same name, which outweighs all else.
const SAME_NAME: f64 = 5.0;
/// The least likeness of a part to the whole of the other expression, so that both are compared.
const HALF: f64 = 0.5;
/// The penalty for an edit after which two expressions still differ.
const PARTIAL: u32 = 4;
/// The greatest depth at which expressions are compared.
const DEEPEST: u8 = 12;

/// Lists the edits that bring a reader's function nearer to the chapter's: expressions, and
/// statements that are missing or too many.
pub(super) fn edits(yours: &RustFn, right: &RustFn) -> Vec<RankedEdit> {
    let (own, theirs) = in_common_names(yours, right);
    let name = |at: &Range<usize>, new: &str| with_names_of(yours, &own, at, new);
    let mut edits = expressions(&yours.text, &own, &roots(&theirs), false, &name);
    edits.extend(statements(&yours.text, &own, &theirs));
    edits
}

/// Lists the edits that bring a helper nearer to what the chapter's function has where the reader's
/// calls the helper: the expressions there, in the names of the helper's parameters.
pub(super) fn edits_of_helper(helper: &RustFn, caller: &RustFn, right: &RustFn) -> Vec<RankedEdit> {
    let (own, theirs) = in_common_names(caller, right);
    let calls = own.nodes().into_iter().filter_map(|it| given(it, helper));
    let edits = calls.flat_map(|given| {
        let right = RustFn {
            parameters: helper.parameters.clone(),
            body: replaced(&theirs, &given),
            ..right.clone()
        };
        let (own, theirs) = in_common_names(helper, &right);
        let mut all = roots(&theirs);
        let nodes = theirs.nodes().into_iter();
        let inner = nodes.filter(|it| it.parts.len() > 1 && it.op != RustOp::Block);
        all.extend(inner.map(|it| (RootRole::Part, it)));
        expressions(&helper.text, &own, &all, true, &|_, new| new.to_owned())
    });
    edits.collect()
}

/// Pairs the arguments in a call with the names of the helper's parameters; `None` if the tree is
/// no call of the helper.
fn given<'a>(call: &'a RustTree, helper: &'a RustFn) -> Option<Vec<(&'a RustTree, &'a str)>> {
    let arguments = match &call.op {
        RustOp::Call if call.parts[0].name()?.rsplit(':').next()? == helper.short_name() => {
            &call.parts[1..]
        }
        RustOp::Method(name) if name == helper.short_name() => &call.parts[..],
        _ => return None,
    };
    let names = helper.parameters.iter().map(String::as_str);
    Some(arguments.iter().zip(names).collect())
}

/// Returns the tree with the names of parameters for the arguments.
fn replaced(tree: &RustTree, names: &[(&RustTree, &str)]) -> RustTree {
    tree.mapped(&|it| {
        if let Some((_, name)) = names.iter().find(|(given, _)| given.is_same(it)) {
            return Some(RustTree {
                at: it.at.clone(),
                ..RustTree::leaf(name)
            });
        }
        // A parameter is given no other value, so that no name is left for what it would be.
        let given = it.op.pattern()?;
        let is_given = names.iter().any(|(_, name)| *name == given.name);
        is_given.then(|| replaced(&it.parts[0], names))
    })
}

/// Returns new code for a place of the reader's function, in which a variable of the reader again
/// replaces its value, if the value was written out and the old code of the place has the name.
fn with_names_of(yours: &RustFn, own: &RustTree, at: &Range<usize>, new: &str) -> String {
    let old = yours.text.get(at.clone()).unwrap_or_default();
    let kept = locals(own);
    let is_used = |local: &LocalName| {
        let is_written_out = kept.iter().all(|it| it.name != local.name);
        is_written_out && words(old).contains(&local.name)
    };
    let used = locals(&yours.body).into_iter().filter(is_used);
    used.fold(new.to_owned(), |new, local| {
        new.replace(&local.value.text(), local.name)
    })
}

/// Lists the edits that replace expressions of the reader's tree by the most similar ones of the
/// chapter, or parts by parts. An expression that the chapter has, too, is left as it is; with
/// `are_parts`, the most similar others are tried for it. `name` rewrites new code for its place.
fn expressions(
    text: &str,
    own: &RustTree,
    theirs: &[(RootRole, &RustTree)],
    are_parts: bool,
    name: &dyn Fn(&Range<usize>, &str) -> String,
) -> Vec<RankedEdit> {
    let mut edits = Vec::new();
    for (role, yours) in roots(own) {
        let is_let = matches!(role, RootRole::Let(_));
        let score = |(other, right): &(RootRole, &RustTree)| {
            let same_role = if is_let { SAME_NAME } else { SAME_ROLE };
            yours.likeness(right)
                + if are_parts || *other == role {
                    same_role
                } else {
                    0.0
                }
        };
        let mut likest: Vec<_> = theirs.iter().map(|it| (score(it), it.1)).collect();
        likest.sort_by(|one, other| other.0.total_cmp(&one.0));
        if are_parts {
            likest.retain(|(_, right)| !yours.is_same(right));
        }
        if likest.first().is_none_or(|(_, right)| yours.is_same(right)) {
            continue;
        }
        let is_given = is_let && likest[0].0 > SAME_NAME;
        let many = if are_parts { 2 * COMPARED } else { COMPARED };
        likest.truncate(if is_given { 1 } else { many });
        for (n, (score, right)) in likest.into_iter().enumerate() {
            if n > 0 && score < UNLIKE {
                break;
            }
            let unlike = (3.0 * (2.0 - score.min(2.0))) as u32 + n as u32;
            let mut found = Vec::new();
            differences(yours, right, 0, 0, &mut found);
            edits.extend(found.into_iter().map(|(at, new, right_part)| {
                let new = name(&at, &new);
                if yours.with(&at, right_part).is_same(right) && !new.contains("if ") {
                    RankedEdit::whole(text, at, new, unlike)
                } else {
                    RankedEdit::new(text, at, new, unlike + PARTIAL)
                }
            }));
        }
    }
    edits
}

/// Adds to `found` the places where two expressions differ, from the whole to the smallest part:
/// the bytes of the reader's text, the chapter's code, and its tree.
fn differences<'a>(
    yours: &RustTree,
    right: &'a RustTree,
    depth: u8,
    least: u8,
    found: &mut Vec<(Range<usize>, String, &'a RustTree)>,
) {
    if yours.is_same(right) {
        return;
    }
    if !yours.at.is_empty() && !matches!(yours.op, RustOp::Block | RustOp::If) {
        found.push((yours.at.clone(), right.within(least), right));
    }
    if depth > DEEPEST {
        return;
    }
    let (own, theirs) = (&yours.parts, &right.parts);
    if own.len() == theirs.len() && !own.is_empty() {
        for (n, (own, theirs)) in own.iter().zip(theirs).enumerate() {
            differences(own, theirs, depth + 1, yours.least(n), found);
        }
        // One of two is the same, and stands on the other side.
        if let ([first, second], [other, last]) = (&own[..], &theirs[..])
            && first.is_same(last)
        {
            differences(second, other, depth + 1, yours.least(1), found);
        }
        return;
    }
    for (n, own) in own
        .iter()
        .enumerate()
        .filter(|(_, it)| it.likeness(right) > HALF)
    {
        differences(own, right, depth + 4, yours.least(n), found);
    }
}

/// Lists the edits that add a statement which only the chapter has, at any place, and those that
/// replace by it, or remove, a statement which only the reader has.
fn statements(text: &str, own: &RustTree, theirs: &RustTree) -> Vec<RankedEdit> {
    let (own, theirs) = (all_statements(own), all_statements(theirs));
    let has = |all: &[&RustTree], it: &RustTree| all.iter().any(|other| other.is_same(it));
    let is_one = |it: &&&RustTree| matches!(it.op, RustOp::Statement | RustOp::If);
    let extra = own.iter().filter(is_one).filter(|it| !has(&theirs, it));
    let extra: Vec<&&RustTree> = extra.collect();
    let mut edits = Vec::new();
    // What the reader asks too is not missing, and nothing stands behind what is returned.
    let asks = |it: &RustTree| {
        let mut own = own.iter().filter(|own| own.op == it.op);
        own.any(|own| own.parts[0].is_same(&it.parts[0]))
    };
    let is_missing = |it: &&&RustTree| {
        let is_asked = it.op == RustOp::If && asks(it);
        !has(&own, it) && !is_asked && it.parts[0].op != RustOp::Return
    };
    for missing in theirs.iter().filter(is_one).filter(is_missing) {
        let new = missing.text();
        let mut put = |at, new, penalty| edits.push(RankedEdit::whole(text, at, new, penalty));
        for place in &own {
            let (start, end) = (place.at.start, place.at.end);
            put(start..start, format!("{new}\n"), 3);
            if place.op == RustOp::Statement {
                put(end..end, format!("\n{new}"), 3);
            }
        }
        for it in extra.iter().filter(|it| it.op == RustOp::Statement) {
            put(it.at.clone(), new.clone(), 1);
        }
    }
    let left_out = extra.iter().map(|it| it.at.clone());
    edits.extend(left_out.map(|at| RankedEdit::new(text, at, String::new(), 1)));
    edits
}

/// Lists the statements of a function's body and of all blocks inside of it.
fn all_statements(body: &RustTree) -> Vec<&RustTree> {
    let blocks = body.nodes().into_iter().filter(|it| it.op == RustOp::Block);
    blocks.flat_map(|it| &it.parts).collect()
}
