//! Mutation operators, backwards: edits that undo what is often mistyped, at each expression of
//! a function.

use super::edit::{Edit, Proposal, ranked, roots};
use super::functions::Function;
use super::letters::locals;
use super::tree::{ATOM, Tree};

/// Each is less likely than an edit that brings the chapter nearer.
const UNLIKELY: u32 = 5;
/// What a function is given is often in the wrong order.
const EXCHANGED: u32 = 3;
/// Signs, comparisons and methods, each of which is mistaken for the others of its group.
const MISTAKEN: [&[&str]; 10] = [
    &["+", "-"],
    &["*", "/"],
    &["<", ">", "<=", ">="],
    &["&&", "||"],
    &["length", "length_squared"],
    &["min", "max"],
    &["first", "last"],
    &["any", "all"],
    &["x", "y", "z"],
    &["origin", "direction"],
];
/// Numbers that stand in many formulas, and factors that are forgotten.
const NUMBERS: [&str; 4] = ["0.0", "1.0", "0.5", "2.0"];
const FACTORS: [&str; 3] = ["0.5", "2.0", "4.0"];
/// Of so many names in an expression each is swapped with each other.
const SWAPPED: usize = 8;
const METHODS: [&str; 3] = ["normalize", "sqrt", "abs"];

/// The edits of a function, with the numbers of the chapter's if there is one.
pub(super) fn edits(yours: &Function, right: Option<&Function>) -> Vec<Edit> {
    let mut names: Vec<String> = yours.parameters.clone();
    names.extend(locals(&yours.body).iter().map(|it| it.name.to_owned()));
    let fields = yours
        .body
        .nodes()
        .into_iter()
        .chain(right.iter().flat_map(|it| it.body.nodes()));
    let fields = fields
        .map(Tree::text)
        .filter(|it| it.starts_with("self.") && !it.contains('('));
    names.extend(fields.filter(|it| it.matches('.').count() == 1));
    let mut numbers: Vec<String> = NUMBERS.map(str::to_owned).to_vec();
    let theirs = right.map_or(Vec::new(), |it| it.body.nodes());
    let theirs = theirs
        .iter()
        .filter(|it| is_number(it))
        .map(|it| it.op.clone());
    numbers.extend(theirs);
    for all in [&mut names, &mut numbers] {
        all.sort();
        all.dedup();
    }
    let mut known = Known {
        text: &yours.text,
        names,
        numbers,
        proposals: Vec::new(),
    };
    known.walk(&yours.body, 0);
    for (_, root) in roots(&yours.body) {
        known.swapped(root);
    }
    ranked(yours, known.proposals)
}

/// What can take the place of something else.
struct Known<'a> {
    text: &'a str,
    names: Vec<String>,
    numbers: Vec<String>,
    proposals: Vec<Proposal>,
}

impl Known<'_> {
    fn walk(&mut self, node: &Tree, least: u8) {
        self.mistaken(node, least);
        self.left_out(node, least);
        self.too_much(node, least);
        self.another(node);
        self.exchanged(node);
        for (n, part) in node.parts.iter().enumerate() {
            // A function is called by its name.
            if !(n == 0 && node.op.starts_with("□(")) {
                self.walk(part, node.least(n));
            }
        }
    }

    fn propose(&mut self, node: &Tree, new: String, penalty: u32) {
        let penalty = UNLIKELY + penalty;
        self.proposals
            .push(Proposal::new(node.at.clone(), new, penalty));
    }

    /// One sign, method or field for another of its group.
    fn mistaken(&mut self, node: &Tree, least: u8) {
        let Some(name) = node.sign().or(node.member()) else {
            return;
        };
        for group in MISTAKEN.iter().filter(|group| group.contains(&name)) {
            for other in group.iter().filter(|other| **other != name) {
                let op = node.op.replacen(name, other, 1);
                let new = Tree { op, ..node.clone() };
                self.propose(node, new.within(least), 2);
            }
        }
    }

    /// A sign, a factor, a method or a square that may have been forgotten.
    fn left_out(&mut self, node: &Tree, least: u8) {
        let is_name = self.names.contains(&node.text());
        let is_value = is_name
            || node.member().is_some()
            || node.op.starts_with("□(")
            || matches!(node.sign(), Some("+" | "-" | "*" | "/"));
        if is_value && node.op != "self" {
            let own = |parts| Tree::new("□ * □", parts);
            let leaf = |op: &str| Tree::new(op, Vec::new());
            let negated = Tree::new("-□", vec![node.clone()]);
            self.propose(node, negated.within(least), 3);
            for factor in FACTORS {
                let product = own(vec![leaf(factor), node.clone()]);
                self.propose(node, product.within(least), 3);
            }
            for method in METHODS {
                self.propose(node, format!("{}.{method}()", node.within(ATOM)), 4);
            }
            let square = own(vec![node.clone(), node.clone()]);
            self.propose(node, square.within(least), 4);
        }
        let is_condition = least == 0 && (is_name || node.sign().is_some_and(is_comparison));
        if is_condition {
            self.propose(node, Tree::new("!□", vec![node.clone()]).text(), 4);
        }
    }

    /// One of two operands, a sign or a method that may be too much, and a statement.
    fn too_much(&mut self, node: &Tree, least: u8) {
        let is_method = node.member().is_some() && node.op.ends_with(')');
        let is_negated = matches!(node.op.as_str(), "-□" | "!□");
        let is_operation = node.sign().is_some_and(|sign| sign != "=");
        if is_method || is_negated || is_operation {
            for (n, part) in node.parts.iter().enumerate() {
                self.propose(node, part.within(least), 2 + n as u32);
            }
        }
        if node.is_block() {
            for statement in node
                .parts
                .iter()
                .filter(|it| it.op == "□;" || it.op.starts_with("if "))
            {
                let size = statement.nodes().len() as u32;
                self.propose(statement, String::new(), size);
            }
        }
    }

    /// Two names, wherever they stand in an expression, the one for the other.
    fn swapped(&mut self, root: &Tree) {
        let stands = |name: &&String| root.nodes().iter().any(|it| it.op == **name);
        let here = self.names.iter().filter(stands).take(SWAPPED);
        let here: Vec<String> = here.cloned().collect();
        for (n, one) in here.iter().enumerate() {
            for other in &here[..n] {
                self.propose(root, renamed(root, [one, other]).text(), 0);
            }
        }
    }

    /// Two parts that follow each other, in the other order: of a difference, a quotient, a
    /// comparison or a list, what a function is given, and the statements of a block.
    fn exchanged(&mut self, node: &Tree) {
        let is_call = node.op.starts_with("□(");
        let is_sign = matches!(node.sign(), Some("-" | "/" | "<" | ">"));
        let is_ordered = is_call || is_sign || node.is_block() || node.op.starts_with(['(', '[']);
        let parts = &node.parts[usize::from(is_call)..];
        for pair in parts.windows(2).filter(|_| is_ordered) {
            let least = if is_sign { ATOM } else { 0 };
            let [one, other] = [&pair[0], &pair[1]].map(|it| it.within(least));
            let between = &self.text[pair[0].at.end..pair[1].at.start];
            let at = pair[0].at.start..pair[1].at.end;
            let new = format!("{other}{between}{one}");
            let penalty = if is_call { EXCHANGED } else { UNLIKELY };
            self.proposals.push(Proposal::new(at, new, penalty).whole());
        }
    }

    /// Another name or number.
    fn another(&mut self, node: &Tree) {
        let all = if is_number(node) {
            self.propose(node, format!("-{}", node.op), 3);
            self.numbers.clone()
        } else if self.names.contains(&node.text()) {
            self.names.clone()
        } else {
            return;
        };
        for other in all
            .into_iter()
            .filter(|it| *it != node.text() && it != "self")
        {
            self.propose(node, other, 3);
        }
    }
}

/// The tree with two names exchanged.
fn renamed(tree: &Tree, [one, other]: [&str; 2]) -> Tree {
    let op = match &*tree.op {
        op if op == one => other,
        op if op == other => one,
        op => op,
    };
    let parts = tree.parts.iter().map(|it| renamed(it, [one, other]));
    Tree {
        op: op.to_owned(),
        parts: parts.collect(),
        ..tree.clone()
    }
}

fn is_number(node: &Tree) -> bool {
    node.parts.is_empty()
        && node.op.contains('.')
        && node.op.starts_with(|c: char| c.is_ascii_digit())
}

fn is_comparison(sign: &str) -> bool {
    matches!(sign, "<" | ">" | "<=" | ">=")
}
