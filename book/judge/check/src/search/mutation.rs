//! Mutation operators: the single edits that people make when they type, at each expression of a
//! function. In the chapter they make mistakes, in a reader's program they undo some.

use std::cmp::Reverse;
use std::collections::HashSet;

use super::edit::RankedEdit;
use super::functions::RustFn;
use super::roots::roots;
use super::tree::{RustOp, RustTree};

/// Groups of words or signs that are mistaken for each other, each with the penalty for such an
/// edit.
const MISTAKEN: [(u32, &[&str]); 11] = [
    (7, &["+", "-"]),
    (9, &["*", "/"]),
    (9, &["+", "*"]),
    (7, &["<", ">", "<=", ">="]),
    (7, &["&&", "||"]),
    (7, &["x", "y", "z"]),
    (9, &["origin", "direction"]),
    (8, &["point", "normal"]),
    (7, &["length", "length_squared"]),
    (8, &["min", "max"]),
    (8, &["floor", "round", "ceil", "trunc"]),
];
/// The numbers that are tried in the place of another.
const NUMBERS: [f64; 11] = [0.0, 1.0, -1.0, 2.0, 3.0, 4.0, 0.1, 0.3, 0.5, 0.7, 1e-3];
/// The factors that are tried in the place of 255.999.
const LEVELS: [f64; 4] = [255.0, 255.5, 255.99, 256.0];
/// The most names in an expression that are swapped with each other.
const SWAPPED: usize = 8;

/// A tree that may replace another, and the penalty for it. Most penalties here are greater than
/// those of edits that bring one text nearer to another.
type Alternative = (RustTree, u32);

/// A mutation of a function: a node of its tree, and the tree that replaces it.
pub(super) struct Mutation<'t> {
    /// The node that is replaced.
    old: &'t RustTree,
    /// The least [level](RustOp::level) of an expression that needs no brackets in the place.
    least: u8,
    /// The tree that replaces the node.
    new: RustTree,
    /// The penalty for the mutation, added to the rank of its edit.
    penalty: u32,
}

/// Lists all mutations of a function. Those of one node follow one another.
pub(super) fn mutations(function: &RustFn) -> Vec<Mutation<'_>> {
    let mut names: Vec<String> = function.parameters.clone();
    names.extend(locals(&function.body));
    names.retain(|it| it != "self");
    names.sort();
    names.dedup();
    let roots = roots(&function.body).into_iter();
    let exchanged = roots.flat_map(|(_, root)| exchanged_names(root, &names));
    let mut all: Vec<Mutation> = exchanged.collect();
    all.extend(of_tree(&function.body, 0, &names));
    all.sort_by_key(|it| it.penalty);
    let mut seen = HashSet::new();
    all.retain(|it| {
        let node = std::ptr::from_ref(it.old);
        !it.new.is_same(it.old) && seen.insert((node, it.new.text()))
    });
    all.sort_by_key(|it| {
        let at = &it.old.at;
        (at.start, Reverse(at.end), std::ptr::from_ref(it.old))
    });
    all
}

/// Lists the names of the variables that a function declares, in their order.
fn locals(body: &RustTree) -> Vec<String> {
    let nodes = body.nodes().into_iter();
    let patterns = nodes.filter_map(|node| node.op.pattern());
    patterns.map(|it| it.name.clone()).collect()
}

impl Mutation<'_> {
    /// Returns the mutation as an edit of the function's text.
    pub(super) fn edit(&self, text: &str) -> RankedEdit {
        let new = self.new.within(self.least);
        RankedEdit::new(text, self.old.at.clone(), new, self.penalty)
    }
}

/// Writes a function that has all of its mutations, numbered from `first`. The function is read
/// once, and each mutation is run by its number (mutant schemata: Untch, Offutt and Harrold, 1993).
pub(super) fn schemata(function: &RustFn, mutations: &[Mutation], first: u32) -> String {
    let head = &function.text[..function.body.at.start];
    format!("{head}{}", written(&function.body, 0, mutations, first))
}

/// Writes a tree with its mutations, in brackets if it binds less firmly than `least`.
fn written(tree: &RustTree, least: u8, mutations: &[Mutation], first: u32) -> String {
    let text = tree.text_of(&|part, least| {
        let text = written(part, least, mutations, first);
        let is_last = std::ptr::eq(part, &tree.parts[tree.parts.len() - 1]);
        let is_statement = tree.op == RustOp::Block
            && !is_last
            && text.starts_with("mutants!")
            && !text.ends_with(';');
        if is_statement { text + ";" } else { text }
    });
    let is_own = |it: &Mutation| std::ptr::eq(it.old, tree);
    let Some(n) = mutations.iter().position(is_own) else {
        return if tree.op.level() < least {
            format!("({text})")
        } else {
            text
        };
    };
    let others = mutations[n..].iter().take_while(|it| is_own(it));
    let others = others.map(|it| match it.new.text() {
        nothing if nothing.is_empty() => ", ()".to_owned(),
        text => format!(", {text}"),
    });
    let (others, number) = (others.collect::<String>(), first + n as u32);
    match text
        .strip_suffix(';')
        .filter(|_| tree.op == RustOp::Statement)
    {
        Some(text) => format!("mutants!({number}, {text}{others});"),
        None => format!("mutants!({number}, {text}{others})"),
    }
}

/// Lists the mutations of a tree and of all trees inside of it, but for swapped names.
fn of_tree<'t>(tree: &'t RustTree, least: u8, names: &[String]) -> Vec<Mutation<'t>> {
    let mutation = |(new, penalty): Alternative| Mutation {
        old: tree,
        least,
        new,
        penalty,
    };
    // What is given a name as a condition has it in what stands beside.
    let is_named = |it: &RustTree| matches!(it.op, RustOp::Let(_, false));
    let is_bound = tree.op != RustOp::If && tree.parts.iter().any(is_named);
    let own = others(tree, names).into_iter().filter(|_| !is_bound);
    let mut all: Vec<Mutation> = own.map(mutation).collect();
    for (n, part) in tree.parts.iter().enumerate().skip(fixed(tree)) {
        all.extend(of_tree(part, tree.least(n), names));
    }
    if let Some(three) = components(tree) {
        all.extend(in_all(tree, three, names).into_iter().map(mutation));
    }
    all
}

/// Returns 1 if the first part of a tree is no value, as a function's name or the target of an
/// assignment, else 0.
fn fixed(tree: &RustTree) -> usize {
    let is_fixed = match &tree.op {
        RustOp::Call => true,
        RustOp::Sign(sign) => sign.ends_with('=') && !["<=", ">=", "==", "!="].contains(&&**sign),
        RustOp::Method(_) if tree.parts.len() > 1 => {
            let object = &tree.parts[0];
            let is_own = object.parts.iter().any(|it| it.name() == Some("self"));
            object.name().is_some() || is_own
        }
        RustOp::Other(texts) => texts[0].starts_with("&mut"),
        _ => false,
    };
    usize::from(is_fixed)
}

/// Lists the mutations of the first component, each made in all three components of `tree`.
fn in_all(tree: &RustTree, three: [&RustTree; 3], names: &[String]) -> Vec<Alternative> {
    let first = of_tree(three[0], 0, names).into_iter();
    let all = first.map(|it| {
        let first = three[0].with(&it.old.at, &it.new);
        let parts = three.iter().enumerate();
        let all = parts.fold(tree.clone(), |all, (n, part)| {
            all.with(&part.at, &on_axis(&first, n))
        });
        (all, it.penalty)
    });
    all.collect()
}

/// Finds three parts of a tree that differ in x, y and z only.
fn components(tree: &RustTree) -> Option<[&RustTree; 3]> {
    let three: [&RustTree; 3] = match (&tree.op, &tree.parts[..]) {
        (RustOp::Call, [_, x, y, z]) | (RustOp::Other(_), [x, y, z]) => [x, y, z],
        (RustOp::Sign(_), [sum, z]) if sum.op == tree.op => [&sum.parts[0], &sum.parts[1], z],
        _ => return None,
    };
    let is_like = |n: usize| on_axis(three[0], n).is_same(three[n]);
    (is_like(1) && is_like(2) && !three[0].is_same(three[1])).then_some(three)
}

/// Returns the tree with y, for axis 1, or z, for axis 2, in the place of each x.
fn on_axis(tree: &RustTree, axis: usize) -> RustTree {
    let letter = ["x", "y", "z"][axis].to_owned();
    tree.mapped(&|it| {
        let op = match &it.op {
            RustOp::Field(x) if x == "x" => RustOp::Field(letter.clone()),
            RustOp::Member(x) if x == "x" => RustOp::Member(letter.clone()),
            _ => return None,
        };
        let parts = it.parts.iter().map(|part| on_axis(part, axis)).collect();
        Some(RustTree {
            op,
            parts,
            ..it.clone()
        })
    })
}

/// Lists the trees that may replace a node.
fn others(tree: &RustTree, names: &[String]) -> Vec<Alternative> {
    let mut all = mistaken(tree);
    let first = tree.parts.first();
    match &tree.op {
        RustOp::Sign(sign) if "+-*/&&||".contains(&**sign) => all.extend(of_sign(tree, sign)),
        RustOp::Leaf(text) => all.extend(of_leaf(tree, text, names)),
        RustOp::Sign(sign) if ["<", ">", "<=", ">="].contains(&&**sign) => {
            all.push((RustTree::leaf("true"), 8));
        }
        RustOp::Prefix(sign) if sign != "&" => all.extend(first.map(|it| (it.clone(), 7))),
        RustOp::Field(name) => {
            all.push((negated(tree), 8));
            if name == "direction" {
                let unit = RustOp::Method("normalize".to_owned());
                all.push((RustTree::new(unit, vec![tree.clone()]), 9));
            }
        }
        RustOp::Method(name) if tree.parts.len() == 1 || name == "max" || name == "min" => {
            all.extend([(tree.parts[0].clone(), 8), (negated(tree), 8)]);
        }
        RustOp::Call if first.is_some_and(|it| it.name() == Some("Some")) => {
            all.push((RustTree::leaf("None"), 9));
        }
        RustOp::Call if tree.parts.len() == 2 => all.push((tree.parts[1].clone(), 8)),
        RustOp::If => all.extend(of_choice(tree)),
        RustOp::Statement => all.push((RustTree::leaf(""), 11)),
        _ => {}
    }
    all.extend(of_list(tree));
    all
}

/// Replaces a word or sign by each other one of its groups in [`MISTAKEN`].
fn mistaken(tree: &RustTree) -> Vec<Alternative> {
    let (RustOp::Sign(name) | RustOp::Method(name) | RustOp::Field(name)) = &tree.op else {
        return Vec::new();
    };
    let groups = MISTAKEN
        .iter()
        .filter(|(_, group)| group.contains(&&**name));
    let others = groups.flat_map(|(penalty, group)| group.iter().map(move |it| (it, *penalty)));
    let others = others
        .filter(|(it, _)| *it != name)
        .map(|(other, penalty)| {
            let op = match &tree.op {
                RustOp::Sign(_) => RustOp::Sign((*other).to_owned()),
                RustOp::Method(_) => RustOp::Method((*other).to_owned()),
                _ => RustOp::Field((*other).to_owned()),
            };
            (RustTree { op, ..tree.clone() }, penalty)
        });
    others.collect()
}

/// Mutates an operator: leaves a side out, swaps the sides, moves brackets or loses them, or
/// negates the whole.
fn of_sign(tree: &RustTree, sign: &str) -> Vec<Alternative> {
    let (one, other) = (&tree.parts[0], &tree.parts[1]);
    let mut all = vec![(one.clone(), 8), (other.clone(), 8)];
    let inner = [one, other].into_iter().filter(|it| it.op.sign().is_some());
    all.extend(inner.flat_map(|it| it.parts.iter().map(|part| (part.clone(), 9))));
    if let (RustOp::Sign(inner), [first, last]) = (&one.op, &one.parts[..]) {
        let new = RustTree::binary(inner, first, &RustTree::binary(sign, last, other));
        all.push((new, 7));
    }
    if let (RustOp::Sign(inner), [first, last]) = (&other.op, &other.parts[..]) {
        let new = RustTree::binary(inner, &RustTree::binary(sign, one, first), last);
        all.push((new, 7));
    }
    if let ([a, x], [b, y]) = (&one.parts[..], &other.parts[..])
        && one.op == other.op
        && "+-".contains(sign)
    {
        let [first, last] = [(a, y), (b, x)]
            .map(|(it, with)| RustTree::new(one.op.clone(), vec![it.clone(), with.clone()]));
        all.push((RustTree::binary(sign, &first, &last), 7));
    }
    if "-/".contains(sign) {
        all.push((RustTree::binary(sign, other, one), 7));
    }
    if !sign.contains(['&', '|']) {
        all.push((negated(tree), 9));
    }
    all
}

/// Mutates a number or a name: replaces it, negates it, or doubles or halves it.
fn of_leaf(tree: &RustTree, text: &str, names: &[String]) -> Vec<Alternative> {
    if text.contains('.')
        && let Ok(number) = text.parse::<f64>()
    {
        let near = [-1.0, 2.0, 0.5, 0.1, 10.0].map(|factor| factor * number);
        let all = match number {
            255.0.. => LEVELS.to_vec(),
            _ => {
                let steps = [number + 1.0, number - 1.0, number.trunc()];
                [&near[..], &steps, &NUMBERS].concat()
            }
        };
        let all = all.into_iter().filter(|it| *it != number);
        return all
            .map(|it| (RustTree::leaf(&format!("{:?}", it + 0.0)), 9))
            .collect();
    }
    if !names.iter().any(|it| it == text) {
        return Vec::new();
    }
    let others = names.iter().filter(|it| *it != text);
    let mut all: Vec<Alternative> = others.map(|it| (RustTree::leaf(it), 8)).collect();
    all.push((negated(tree), 8));
    let factors = ["2.0", "0.5"].map(RustTree::leaf);
    all.extend(factors.map(|it| (RustTree::binary("*", &it, tree), 10)));
    all
}

/// Mutates an `if`: exchanges its branches, or keeps one of them without the condition.
fn of_choice(tree: &RustTree) -> Vec<Alternative> {
    let (condition, branches) = (&tree.parts[0], &tree.parts[1..]);
    if matches!(condition.op, RustOp::Let(..)) {
        return Vec::new();
    }
    let mut all: Vec<Alternative> = branches.iter().map(|it| (it.clone(), 11)).collect();
    match branches {
        [then, other] => {
            let parts = [condition, other, then].map(RustTree::clone);
            all.push((RustTree::new(RustOp::If, parts.to_vec()), 8));
        }
        _ => all.push((RustTree::leaf(""), 11)),
    }
    all
}

/// Mutates arguments or a list: swaps two of them, or puts one in the place of another.
fn of_list(tree: &RustTree) -> Vec<Alternative> {
    let first = match &tree.op {
        RustOp::Method(name) if name == "dot" => 0,
        RustOp::Call | RustOp::Method(_) => 1,
        RustOp::Other(texts) if texts[0] == "[" || texts[0] == "(" => 0,
        _ => return Vec::new(),
    };
    let places = first..tree.parts.len();
    let pairs = places
        .clone()
        .flat_map(|n| places.clone().map(move |m| (n, m)));
    let pairs = pairs.filter(|(n, m)| n != m && !tree.parts[*n].is_same(&tree.parts[*m]));
    let all = pairs.flat_map(|(n, m)| {
        let [mut swapped, mut twice] = [tree.clone(), tree.clone()];
        swapped.parts.swap(n, m);
        twice.parts[n] = twice.parts[m].clone();
        [(swapped, 3), (twice, 9)]
            .into_iter()
            .skip(usize::from(n > m))
    });
    all.collect()
}

/// Lists the mutations that swap two names throughout an expression.
fn exchanged_names<'t>(root: &'t RustTree, names: &[String]) -> Vec<Mutation<'t>> {
    let nodes = root.nodes();
    let is_bound = nodes
        .iter()
        .any(|it| matches!(it.op, RustOp::Let(_, false)));
    let stands = |name: &&String| nodes.iter().any(|it| it.name() == Some(name));
    let here: Vec<&String> = names.iter().filter(stands).take(SWAPPED).collect();
    let pairs = (0..here.len()).flat_map(|n| (0..n).map(move |m| (n, m)));
    let pairs = pairs.filter(|_| !is_bound).map(|(n, m)| {
        let new = root.mapped(&|it| match it.name()? {
            name if name == here[n] => Some(RustTree::leaf(here[m])),
            name if name == here[m] => Some(RustTree::leaf(here[n])),
            _ => None,
        });
        Mutation {
            old: root,
            least: 0,
            new,
            penalty: 5,
        }
    });
    pairs.collect()
}

/// Returns the negative of a tree.
fn negated(tree: &RustTree) -> RustTree {
    RustTree::new(RustOp::Prefix("-".to_owned()), vec![tree.clone()])
}
