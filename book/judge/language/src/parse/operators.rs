//! Precedence climbing (Richards, 1979), with the operators of all languages in one table.

use super::Parser;
use crate::Language;
use crate::tree::{Op, Tree};

/// The operators between two operands: spelling, precedence (a higher one binds more firmly), and
/// the one spelling that a tree has for it.
const BINARY: [(&str, u8, &str); 37] = [
    ("=", 1, "="),
    (":=", 1, "="),
    ("??", 2, "??"),
    ("?:", 2, "??"),
    ("||", 3, "||"),
    ("or", 3, "||"),
    ("&&", 4, "&&"),
    ("and", 4, "&&"),
    ("|", 5, "|"),
    ("^", 5, "^"),
    ("&", 5, "&"),
    ("==", 6, "=="),
    ("===", 6, "=="),
    ("is", 6, "=="),
    ("!=", 6, "!="),
    ("!==", 6, "!="),
    ("<", 6, "<"),
    (">", 6, ">"),
    ("<=", 6, "<="),
    (">=", 6, ">="),
    ("in", 6, "in"),
    ("<<", 7, "<<"),
    (">>", 7, ">>"),
    ("..", 8, ".."),
    ("..=", 8, "..="),
    ("..<", 8, ".."),
    ("...", 8, "..="),
    ("until", 8, ".."),
    ("downTo", 8, "downTo"),
    ("to", 8, "to"),
    ("step", 8, "step"),
    ("+", 9, "+"),
    ("-", 9, "-"),
    ("*", 10, "*"),
    ("/", 10, "/"),
    ("//", 10, "//"),
    ("%", 10, "%"),
];
/// The precedence of a choice, `c ? a : b` or `a if c else b`.
const CHOICE: u8 = 2;
/// The lowest precedence of an operator that the condition of Python's choice may have.
const SIDE: u8 = 3;
/// The precedence of comparisons.
const COMPARED: u8 = 6;
/// The precedence of an operator before its operand.
const PREFIX: u8 = 11;
/// Expressions nested deeper are not read, so that no text exhausts the stack.
const DEEPEST: usize = 60;

impl Parser<'_> {
    /// Reads an expression whose operators have at least this precedence.
    pub(super) fn binary(&mut self, least: u8) -> Option<Tree> {
        let start = self.start();
        let mut left = self.prefix()?;
        loop {
            let sign = self.ahead(0);
            if self.is_on_a_new_line() && !["&&", "||", "?", ".."].contains(&sign) {
                return Some(left);
            }
            if least <= CHOICE && self.begins_choice() {
                left = self.choice(left)?.placed_at(start..self.end());
                continue;
            }
            let negated = usize::from(sign == "is" && self.ahead(1) == "not");
            let row = BINARY.iter().find(|(text, ..)| *text == sign);
            let Some(&(_, level, name)) = row.filter(|(_, level, _)| *level >= least) else {
                return Some(left);
            };
            // A brace may end what the sign would go on.
            if matches!(self.ahead(1), ")" | "]" | "}" | "," | ";" | "{") && level == COMPARED {
                return Some(left);
            }
            self.next += 1 + negated;
            // An assignment is read from the right, all other operators from the left.
            let right = self.binary(if level == 1 { level } else { level + 1 })?;
            left = self.signed(name, left, right).placed_at(start..self.end());
        }
    }

    /// Makes the tree of an operator between two operands.
    fn signed(&self, name: &'static str, left: Tree, right: Tree) -> Tree {
        let is_compared = |it: &Tree| matches!(it.op, Op::Operator("<" | ">" | "<=" | ">="));
        if is_compared(&left) && matches!(name, "<" | ">" | "<=" | ">=") {
            // Python: `a < b < c`.
            let middle = left.parts[1].clone();
            let last = Tree::new(Op::Operator(name), vec![middle, right]);
            return Tree::new(Op::Operator("&&"), vec![left, last]);
        }
        let is_whole = name == "/" && self.is_whole(&left) && self.is_whole(&right);
        let name = if is_whole { "//" } else { name };
        Tree::new(Op::Operator(name), vec![left, right])
    }

    /// Returns true if the `?` or `if` of a choice comes next.
    fn begins_choice(&self) -> bool {
        match self.language {
            Language::Python => self.is("if"),
            Language::Rust | Language::Kotlin => false,
            _ => self.is("?"),
        }
    }

    /// Reads the rest of a choice behind its first operand.
    fn choice(&mut self, left: Tree) -> Option<Tree> {
        self.next += 1;
        if self.language == Language::Python {
            let condition = self.binary(SIDE)?;
            self.expect("else")?;
            let other = self.binary(CHOICE)?;
            return Some(Tree::new(Op::Choice, vec![condition, left, other]));
        }
        let then = self.binary(CHOICE)?;
        self.expect(":")?;
        let other = self.binary(CHOICE)?;
        Some(Tree::new(Op::Choice, vec![left, then, other]))
    }

    /// Reads a value and the operators before it, unless it is nested too deep.
    pub(super) fn prefix(&mut self) -> Option<Tree> {
        self.depth += 1;
        let tree = if self.depth > DEEPEST {
            None
        } else {
            self.prefixed()
        };
        self.depth -= 1;
        tree
    }

    /// Reads a value and the operators before it, and a power behind it.
    fn prefixed(&mut self) -> Option<Tree> {
        let start = self.start();
        let tree = match self.ahead(0) {
            "-" => {
                self.next += 1;
                let part = self.binary(PREFIX)?;
                Tree::new(Op::Negative, vec![part])
            }
            "!" => {
                self.next += 1;
                let part = self.binary(PREFIX)?;
                Tree::new(Op::Not, vec![part])
            }
            "not" => {
                self.next += 1;
                let part = self.binary(COMPARED)?;
                Tree::new(Op::Not, vec![part])
            }
            "+" | "&" | "*" | "new" | "await" | "move" | "mut" | "ref" | "inout" | "&&" | "try" => {
                self.next += 1;
                self.binary(PREFIX)?
            }
            "if" => self.either()?,
            "|" | "||" => self.closure()?,
            _ => self.postfix()?,
        };
        let tree = if self.is("**") {
            self.next += 1;
            let power = self.binary(PREFIX)?;
            match tree.op {
                // Python: `-b ** 2`.
                Op::Negative => {
                    let base = tree.parts.into_iter().next()?;
                    Tree::new(Op::Negative, vec![Tree::call("pow", vec![base, power])])
                }
                _ => Tree::call("pow", vec![tree, power]),
            }
        } else {
            tree
        };
        Some(tree.placed_at(start..self.end()))
    }

    /// Reads `if condition { value } else { value }`, with braces or without.
    fn either(&mut self) -> Option<Tree> {
        self.expect("if")?;
        let condition = self.condition()?;
        let then = self.branch()?;
        self.expect("else")?;
        let other = self.branch()?;
        Some(Tree::new(Op::Choice, vec![condition, then, other]))
    }

    /// Reads one branch of a choice, in braces or without.
    fn branch(&mut self) -> Option<Tree> {
        if !self.eat("{") {
            return self.expression();
        }
        let value = self.expression()?;
        self.expect("}")?;
        Some(value)
    }

    /// Reads a condition, in brackets where the language wants them.
    pub(crate) fn condition(&mut self) -> Option<Tree> {
        if self.language.has_conditions_in_brackets() && self.eat("(") {
            self.brackets += 1;
            let condition = self.expression()?;
            self.brackets -= 1;
            self.expect(")")?;
            return Some(condition);
        }
        let outer = std::mem::replace(&mut self.is_in_condition, true);
        let condition = self.expression();
        self.is_in_condition = outer;
        condition
    }

    /// Reads `|x| value` as a call of `lambda` with the value.
    fn closure(&mut self) -> Option<Tree> {
        if !self.eat("||") {
            self.next += 1;
            while !self.is("|") && self.next < self.tokens.len() {
                self.next += 1;
            }
            self.next += 1;
        }
        let value = self.expression()?;
        Some(Tree::call("lambda", vec![value]))
    }
}
