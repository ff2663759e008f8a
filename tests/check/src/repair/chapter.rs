//! Edits that put the chapter's expressions and statements, in the reader's letters, where the
//! reader has others.

use std::ops::Range;

use super::edit::{Edit, Proposal, Role, ranked, roots, words};
use super::functions::Function;
use super::letters::{Local, in_common_letters, locals};
use super::tree::{Tree, squeezed};

/// A reader's expression is compared with so many of the chapter's.
const COMPARED: usize = 3;
/// No expression here is deeper.
const DEEPEST: u8 = 12;

/// The edits by which the function comes nearer to the chapter's.
pub(super) fn edits(yours: &Function, right: &Function) -> Vec<Edit> {
    let (own, theirs) = in_common_letters(yours, right);
    let name = |at: &Range<usize>, new: &str| with_names_of(yours, &own, at, new);
    let mut edits = ranked(yours, expressions(&own, &theirs, &name));
    let mut others = ranked(yours, conditions(&own, &theirs));
    others.extend(ranked(yours, statements(&own, &theirs)));
    for edit in &mut others {
        make_mutable(&yours.body, edit);
    }
    edits.extend(others);
    edits
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

/// Expressions for those that are most like them.
fn expressions(
    own: &Tree,
    theirs: &Tree,
    name: &dyn Fn(&Range<usize>, &str) -> String,
) -> Vec<Proposal> {
    let theirs = roots(theirs);
    let mut proposals = Vec::new();
    for (role, yours) in roots(own) {
        let is_let = matches!(role, Role::Let(_));
        let score = |(other, right): &(Role, &Tree)| {
            let same_role = match is_let {
                true => 5.0,
                false => 0.6,
            };
            yours.likeness(right) + if *other == role { same_role } else { 0.0 }
        };
        let mut likest: Vec<_> = theirs.iter().map(|it| (score(it), it.1)).collect();
        likest.sort_by(|one, other| other.0.total_cmp(&one.0));
        if likest.first().is_none_or(|(_, right)| yours.is_same(right)) {
            continue;
        }
        let is_given = is_let && likest[0].0 > 5.0;
        likest.truncate(if is_given { 1 } else { COMPARED });
        for (n, (score, right)) in likest.into_iter().enumerate() {
            if n > 0 && score < 0.3 {
                break;
            }
            let unlike = (3.0 * (2.0 - score.min(2.0))) as u32 + n as u32;
            let mut found = Vec::new();
            differences(yours, right, 0, 0, &mut found);
            proposals.extend(found.into_iter().map(|(at, new, right_part)| {
                let new = name(&at, &new);
                match yours.with(&at, right_part).is_same(right) && !new.contains("if ") {
                    true => Proposal::new(at, new, unlike).whole(),
                    false => Proposal::new(at, new, unlike + 4),
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
        .filter(|(_, it)| it.likeness(right) > 0.5)
    {
        differences(own, right, depth + 4, yours.least(n), found);
    }
    for theirs in theirs.iter().filter(|it| it.likeness(yours) > 0.5) {
        differences(yours, theirs, depth + 4, least, found);
    }
}

/// Statements that only the chapter has, at every place, and without those that only the reader
/// has.
fn statements(own: &Tree, theirs: &Tree) -> Vec<Proposal> {
    let own = all_statements(own);
    let theirs = all_statements(theirs);
    let has = |all: &[Tree], it: &Tree| all.iter().any(|other| other.is_same(it));
    let mut proposals = Vec::new();
    let is_only_yours = |it: &&Tree| it.op == "□;" && !it.at.is_empty() && !has(&theirs, it);
    let only_yours: Vec<&Tree> = own.iter().filter(is_only_yours).collect();
    let is_missing = |it: &&Tree| {
        let is_whole = it.op.ends_with(';') || it.op.starts_with("if ");
        is_whole && !it.op.starts_with("let ") && !has(&own, it)
    };
    for statement in theirs.iter().filter(is_missing) {
        let text = statement.text();
        for place in own.iter().filter(|it| !it.at.is_empty()) {
            let (start, end) = (place.at.start, place.at.end);
            proposals.push(Proposal::new(start..start, format!("{text} "), 3).whole());
            if place.op == "□;" {
                proposals.push(Proposal::new(end..end, format!(" {text}"), 3).whole());
            }
        }
        let instead = only_yours.iter().map(|it| it.at.clone());
        proposals.extend(instead.map(|at| Proposal::new(at, text.clone(), 1).whole()));
    }
    let left_out = own
        .iter()
        .filter(|it| it.op == "□;" || it.op.starts_with("if "));
    let left_out = left_out.filter(|it| !it.at.is_empty() && !has(&theirs, it));
    proposals.extend(left_out.map(|it| Proposal::new(it.at.clone(), String::new(), 1)));
    proposals
}

/// The statements of all blocks. A field of a record that is made may be set later as well.
fn all_statements(body: &Tree) -> Vec<Tree> {
    let blocks = body.nodes().into_iter().filter(|it| it.is_block());
    let mut all = Vec::new();
    for statement in blocks.flat_map(|it| &it.parts) {
        all.push(statement.clone());
        let Some(record) = statement.parts.first().filter(|it| it.op.contains(" { ")) else {
            continue;
        };
        let name = statement
            .op
            .trim_start_matches("let ")
            .trim_start_matches("mut ");
        let name = name.split(' ').next().unwrap_or_default();
        let fields = record.parts.iter().filter(|it| it.op.ends_with(": □"));
        all.extend(fields.map(|field| {
            let place = format!("{name}.{}", field.op.trim_end_matches(": □"));
            let set = vec![Tree::new(&place, Vec::new()), field.parts[0].clone()];
            Tree::new("□;", vec![Tree::new("□ = □", set)])
        }));
    }
    all
}

/// Conditions that only the chapter has, beside those of the reader's and before blocks.
fn conditions(own: &Tree, theirs: &Tree) -> Vec<Proposal> {
    let all = |tree: &Tree| -> Vec<Tree> {
        let is_comparison = |it: &&Tree| matches!(it.sign(), Some("<" | ">" | "<=" | ">="));
        tree.nodes()
            .into_iter()
            .filter(is_comparison)
            .cloned()
            .collect()
    };
    let has = all(own);
    let mut proposals = Vec::new();
    for missing in all(theirs) {
        if has.iter().any(|it| it.is_same(&missing)) {
            continue;
        }
        let text = missing.text();
        for node in own.nodes() {
            if node.op.starts_with("if ") {
                let end = node.parts[0].at.end;
                let signs = ["&&", "||"].into_iter();
                let more = signs.map(|sign| format!(" {sign} {text}"));
                proposals.extend(more.map(|new| Proposal::new(end..end, new, 4)));
            }
            if node.is_block() {
                let start = node.at.start;
                let new = format!("if {text} ");
                proposals.push(Proposal::new(start..start, new, 5));
            }
        }
    }
    proposals
}

/// What is set once more has to be `mut`.
fn make_mutable(body: &Tree, edit: &mut Edit) {
    let new = edit.parts[0].1.trim();
    let Some((name, _)) = new.split_once(" = ") else {
        return;
    };
    let given = format!("let {} =", squeezed(name));
    let nodes = body.nodes().into_iter();
    let mut given = nodes.filter(|it| it.op.starts_with(&given));
    if let Some(place) = given.next() {
        let at = place.at.start + "let ".len();
        edit.parts.push((at..at, "mut ".to_owned()));
    }
}
