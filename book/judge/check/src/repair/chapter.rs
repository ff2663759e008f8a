//! Edits that put the chapter's expressions and statements, in the reader's letters, where the
//! reader has others.

use std::ops::Range;

use super::edit::{Edit, Proposal, Role, ranked, roots, words};
use super::functions::Function;
use super::letters::{Local, in_common_letters, locals, name_of};
use super::tree::Tree;

/// A reader's expression is compared with so many of the chapter's.
const COMPARED: usize = 3;
/// What is less like it, from 0 to 1 and by its role, is tried only as the first.
const UNLIKE: f64 = 0.3;
/// What the same role adds to a likeness; a name that is the same decides.
const SAME_ROLE: f64 = 0.6;
const SAME_NAME: f64 = 5.0;
/// A part of a difference has to have so much in common with the other side as a whole.
const HALF: f64 = 0.5;
/// A part is less likely than the whole by so much.
const PARTIAL: u32 = 4;
/// No expression here is deeper.
const DEEPEST: u8 = 12;

/// The edits by which the function comes nearer to the chapter's.
pub(super) fn edits(yours: &Function, right: &Function) -> Vec<Edit> {
    let (own, theirs) = in_common_letters(yours, right);
    let name = |at: &Range<usize>, new: &str| with_names_of(yours, &own, at, new);
    let mut proposals = expressions(&own, &roots(&theirs), false, &name);
    proposals.extend(statements(&own, &theirs));
    proposals.extend(numbers(&yours.body, &[&yours.body], &right.body));
    ranked(yours, proposals)
}

/// The edits by which a helper comes nearer to what the chapter's function has where the reader's
/// calls it: its expressions, in the names of the helper's parameters.
pub(super) fn edits_of_helper(helper: &Function, caller: &Function, right: &Function) -> Vec<Edit> {
    let numbers = numbers(&helper.body, &[&helper.body, &caller.body], &right.body);
    let (own, theirs) = in_common_letters(caller, right);
    let calls = own.nodes().into_iter().filter_map(|it| given(it, helper));
    let edits = calls.flat_map(|given| {
        let right = Function {
            parameters: helper.parameters.clone(),
            body: replaced(&theirs, &given),
            ..right.clone()
        };
        let (own, theirs) = in_common_letters(helper, &right);
        let mut all = roots(&theirs);
        let inner = theirs
            .nodes()
            .into_iter()
            .filter(|it| it.parts.len() > 1 && !it.is_block());
        all.extend(inner.map(|it| (Role::Part, it)));
        ranked(
            helper,
            expressions(&own, &all, true, &|_, new| new.to_owned()),
        )
    });
    edits.chain(ranked(helper, numbers)).collect()
}

/// Numbers of the chapter's that these functions of the reader's do not have, for those that the
/// chapter does not have.
fn numbers(own: &Tree, yours: &[&Tree], right: &Tree) -> Vec<Proposal> {
    let of = |tree: &'_ Tree| -> Vec<(Range<usize>, String)> {
        let nodes = tree.nodes().into_iter();
        let numbers = nodes.filter(|it| it.op.starts_with(|c: char| c.is_ascii_digit()));
        numbers.map(|it| (it.at.clone(), it.op.clone())).collect()
    };
    let yours: Vec<_> = yours.iter().flat_map(|it| of(it)).collect();
    let theirs = of(right);
    let is_missing =
        |new: &String, all: &[(Range<usize>, String)]| all.iter().all(|it| it.1 != *new);
    let missing = theirs.iter().filter(|it| is_missing(&it.1, &yours));
    let missing: Vec<&String> = missing.map(|it| &it.1).collect();
    let wrong = of(own).into_iter().filter(|it| is_missing(&it.1, &theirs));
    let pairs =
        wrong.flat_map(|(at, _)| missing.iter().map(move |new| (at.clone(), (*new).clone())));
    pairs.map(|(at, new)| Proposal::new(at, new, 0)).collect()
}

/// What the helper is given in a call of it, with the name of its parameter.
fn given<'a>(call: &'a Tree, helper: &'a Function) -> Option<Vec<(&'a Tree, &'a str)>> {
    let is_function =
        call.op.starts_with("□(") && call.parts[0].op.rsplit(':').next()? == helper.short_name();
    let is_method = call.op.contains('(') && call.member() == Some(helper.short_name());
    let arguments = match (is_function, is_method) {
        (true, _) => &call.parts[1..],
        (_, true) => &call.parts[..],
        _ => return None,
    };
    let names = helper
        .parameters
        .iter()
        .map(|it| it.trim_start_matches("mut "));
    Some(arguments.iter().zip(names).collect())
}

/// The tree with names for what has one.
fn replaced(tree: &Tree, names: &[(&Tree, &str)]) -> Tree {
    if let Some((_, name)) = names.iter().find(|(it, _)| it.is_same(tree)) {
        let leaf = Tree::new(name, Vec::new());
        return Tree {
            at: tree.at.clone(),
            ..leaf
        };
    }
    // A parameter is given no other value, so that no name is left for what it would be.
    let is_given = |it: &Tree| {
        let name = name_of(&it.op).map(|it| it.0);
        names.iter().any(|(_, given)| name == Some(given))
    };
    let bare = |it| match it {
        it if is_given(it) => it.parts.first().unwrap_or(it),
        it => it,
    };
    let parts = tree.parts.iter().map(|it| replaced(bare(it), names));
    Tree {
        parts: parts.collect(),
        ..tree.clone()
    }
}

/// The text with the names that only the reader has, where they stand already.
fn with_names_of(yours: &Function, own: &Tree, at: &Range<usize>, new: &str) -> String {
    let old = yours.text.get(at.clone()).unwrap_or_default();
    let kept = locals(own);
    let is_used = |local: &Local| {
        let is_written_out = kept.iter().all(|it| it.name != local.name);
        is_written_out && words(old).contains(&local.name)
    };
    let used = locals(&yours.body).into_iter().filter(is_used);
    used.fold(new.to_owned(), |new, local| {
        new.replace(&local.value.text(), local.name)
    })
}

/// Expressions for those that are most like them. One that the chapter has is right, unless it
/// may be a part of what is.
fn expressions(
    own: &Tree,
    theirs: &[(Role, &Tree)],
    are_parts: bool,
    name: &dyn Fn(&Range<usize>, &str) -> String,
) -> Vec<Proposal> {
    let mut proposals = Vec::new();
    for (role, yours) in roots(own) {
        let is_let = matches!(role, Role::Let(_));
        let score = |(other, right): &(Role, &Tree)| {
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
            proposals.extend(found.into_iter().map(|(at, new, right_part)| {
                let new = name(&at, &new);
                if yours.with(&at, right_part).is_same(right) && !new.contains("if ") {
                    Proposal::new(at, new, unlike).whole()
                } else {
                    Proposal::new(at, new, unlike + PARTIAL)
                }
            }));
        }
    }
    proposals
}

/// The places where two expressions differ, from the whole to the smallest, and what the other
/// has there.
fn differences<'a>(
    yours: &Tree,
    right: &'a Tree,
    depth: u8,
    least: u8,
    found: &mut Vec<(Range<usize>, String, &'a Tree)>,
) {
    if yours.is_same(right) {
        return;
    }
    if !yours.at.is_empty() && !yours.is_block() && !yours.op.starts_with("if ") {
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

/// Statements that only the chapter has, at every place, and without those that only the reader
/// has.
fn statements(own: &Tree, theirs: &Tree) -> Vec<Proposal> {
    let (own, theirs) = (all_statements(own), all_statements(theirs));
    let has = |all: &[&Tree], it: &Tree| all.iter().any(|other| other.is_same(it));
    let is_one = |it: &&&Tree| it.op == "□;" || it.op.starts_with("if ");
    let extra: Vec<_> = own
        .iter()
        .filter(is_one)
        .filter(|it| !has(&theirs, it))
        .collect();
    let mut proposals = Vec::new();
    // What the reader asks too is not missing, and nothing stands behind what is returned.
    let asks = |it: &Tree| {
        own.iter()
            .any(|own| own.op == it.op && own.parts[0].is_same(&it.parts[0]))
    };
    let is_missing = |it: &&&Tree| {
        let is_asked = it.op.starts_with("if ") && asks(it);
        !has(&own, it) && !is_asked && !it.text().starts_with("return")
    };
    for missing in theirs.iter().filter(is_one).filter(is_missing) {
        let text = missing.text();
        let mut put = |at, new, penalty| proposals.push(Proposal::new(at, new, penalty).whole());
        for place in &own {
            let (start, end) = (place.at.start, place.at.end);
            put(start..start, format!("{text}\n"), 3);
            if place.op == "□;" {
                put(end..end, format!("\n{text}"), 3);
            }
        }
        for it in extra.iter().filter(|it| it.op == "□;") {
            put(it.at.clone(), text.clone(), 1);
        }
    }
    let left_out = extra.iter().map(|it| it.at.clone());
    proposals.extend(left_out.map(|at| Proposal::new(at, String::new(), 1)));
    proposals
}

/// The statements of all blocks.
fn all_statements(body: &Tree) -> Vec<&Tree> {
    let blocks = body.nodes().into_iter().filter(|it| it.is_block());
    blocks.flat_map(|it| &it.parts).collect()
}
