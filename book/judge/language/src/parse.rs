//! Precedence climbing (Richards, 1979): expressions, with the signs of all languages in one table.

use std::collections::HashSet;

use crate::Language;
use crate::tokens::{Kind, Token, tokens};
use crate::tree::{Op, Tree};

/// Signs between two parts: how firmly each binds, and what it is called here.
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
/// So firmly a choice binds, one of two sides, what is compared, and a sign before its part.
const CHOICE: u8 = 2;
const SIDE: u8 = 3;
const COMPARED: u8 = 6;
const PREFIX: u8 = 11;
/// A text that is nested deeper is none of these chapters.
const DEEPEST: usize = 60;
/// Names before `.` or `::` that say only where a function lives.
const SPACES: [&str; 10] = [
    "std",
    "math",
    "Math",
    "MathF",
    "np",
    "numpy",
    "self",
    "this",
    "glm",
    "rtweekend",
];
/// Types of numbers: those of whole ones, and all that a number is turned into without a word.
pub(crate) const WHOLE: [&str; 16] = [
    "int", "i32", "u32", "i64", "u64", "usize", "u8", "size_t", "Int", "long", "unsigned", "short",
    "uint8", "byte", "int64", "uint",
];
pub(crate) const REAL: [&str; 10] = [
    "double", "float", "f64", "f32", "float64", "float32", "Double", "Float", "real", "Number",
];

/// A reader of tokens.
pub(crate) struct Parser<'a> {
    pub(crate) tokens: Vec<Token<'a>>,
    pub(crate) next: usize,
    pub(crate) language: Language,
    /// The names of whole numbers, if these are divided as such.
    whole: HashSet<&'a str>,
    /// True if a brace begins a block, and no value.
    pub(crate) is_in_condition: bool,
    /// What the fields of new records are given.
    pub(crate) fields: Vec<(String, Tree)>,
    /// How many brackets are open, and how deep the expression is.
    brackets: usize,
    depth: usize,
}

impl<'a> Parser<'a> {
    pub(crate) fn new(text: &'a str, language: Language) -> Self {
        let tokens = tokens(text, language);
        let whole = match language.divides_whole_numbers() {
            true => whole_numbers(&tokens),
            false => HashSet::new(),
        };
        Self {
            tokens,
            next: 0,
            language,
            whole,
            is_in_condition: false,
            fields: Vec::new(),
            brackets: 0,
            depth: 0,
        }
    }

    /// Returns the text of the `n`th token from here, or nothing.
    pub(crate) fn ahead(&self, n: usize) -> &'a str {
        self.tokens.get(self.next + n).map_or("", |it| it.text)
    }

    pub(crate) fn is(&self, text: &str) -> bool {
        self.ahead(0) == text
    }

    /// Takes a token, if it is this one.
    pub(crate) fn eat(&mut self, text: &str) -> bool {
        let is_it = self.is(text);
        self.next += usize::from(is_it);
        is_it
    }

    fn expect(&mut self, text: &str) -> Option<()> {
        self.eat(text).then_some(())
    }

    fn is_kind(&self, n: usize, kind: Kind) -> bool {
        let token = self.tokens.get(self.next + n);
        token.is_some_and(|it| it.kind == kind)
    }

    pub(crate) fn is_word(&self, n: usize) -> bool {
        self.is_kind(n, Kind::Word)
    }

    /// Where the next token begins, and where the last one ends.
    pub(crate) fn start(&self) -> usize {
        self.tokens.get(self.next).map_or(0, |it| it.at)
    }

    pub(crate) fn end(&self) -> usize {
        let last = self.next.checked_sub(1).and_then(|n| self.tokens.get(n));
        last.map_or(0, |it| it.at + it.text.len())
    }

    /// Returns true if the next token is on a line that may be another statement.
    pub(crate) fn is_on_a_new_line(&self) -> bool {
        let token = self.tokens.get(self.next);
        self.language.ends_at_lines() && self.brackets == 0 && token.is_none_or(|it| it.is_first)
    }

    /// Begins a new statement, whatever became of the last one.
    pub(crate) fn begin(&mut self) {
        (self.brackets, self.depth, self.is_in_condition) = (0, 0, false);
    }

    /// Reads an expression, as far as it goes.
    pub(crate) fn expression(&mut self) -> Option<Tree> {
        self.binary(1)
    }

    fn binary(&mut self, least: u8) -> Option<Tree> {
        let start = self.start();
        let mut left = self.prefix()?;
        loop {
            let sign = self.ahead(0);
            if self.is_on_a_new_line() && !["&&", "||", "?", ".."].contains(&sign) {
                return Some(left);
            }
            if least <= CHOICE && self.begins_choice() {
                left = self.choice(left)?.at(start..self.end());
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
            // What is given a value stands on the left, all else is read from the left.
            let right = self.binary(if level == 1 { level } else { level + 1 })?;
            left = self.signed(name, left, right).at(start..self.end());
        }
    }

    /// Makes a tree of a sign between two parts.
    fn signed(&self, name: &'static str, left: Tree, right: Tree) -> Tree {
        let is_compared = |it: &Tree| matches!(it.op, Op::Sign("<" | ">" | "<=" | ">="));
        if is_compared(&left) && matches!(name, "<" | ">" | "<=" | ">=") {
            // Python: `a < b < c`.
            let middle = left.parts[1].clone();
            let last = Tree::new(Op::Sign(name), vec![middle, right]);
            return Tree::new(Op::Sign("&&"), vec![left, last]);
        }
        let is_whole = name == "/" && self.is_whole(&left) && self.is_whole(&right);
        let name = if is_whole { "//" } else { name };
        Tree::new(Op::Sign(name), vec![left, right])
    }

    /// Returns true if the language takes the value for a whole number.
    fn is_whole(&self, tree: &Tree) -> bool {
        match &tree.op {
            Op::Number(_, is_whole) => self.language.divides_whole_numbers() && *is_whole,
            Op::Name(name) => self.whole.contains(name.as_str()),
            Op::Call(name) => match &tree.parts[..] {
                [of] if of.name().is_some() && self.whole.contains(name.as_str()) => true,
                _ => WHOLE.contains(&name.as_str()),
            },
            Op::Minus => self.is_whole(&tree.parts[0]),
            Op::Sign("+" | "-" | "*" | "//" | "%") => tree.parts.iter().all(|it| self.is_whole(it)),
            _ => false,
        }
    }

    fn begins_choice(&self) -> bool {
        match self.language {
            Language::Python => self.is("if"),
            Language::Rust | Language::Kotlin => false,
            _ => self.is("?"),
        }
    }

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

    fn prefix(&mut self) -> Option<Tree> {
        self.depth += 1;
        let tree = if self.depth > DEEPEST {
            None
        } else {
            self.prefixed()
        };
        self.depth -= 1;
        tree
    }

    fn prefixed(&mut self) -> Option<Tree> {
        let start = self.start();
        let tree = match self.ahead(0) {
            "-" => {
                self.next += 1;
                let part = self.binary(PREFIX)?;
                Tree::new(Op::Minus, vec![part])
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
                Op::Minus => {
                    let base = tree.parts.into_iter().next()?;
                    Tree::new(Op::Minus, vec![Tree::call("pow", vec![base, power])])
                }
                _ => Tree::call("pow", vec![tree, power]),
            }
        } else {
            tree
        };
        Some(tree.at(start..self.end()))
    }

    /// Reads `if condition { value } else { value }`, also without braces.
    fn either(&mut self) -> Option<Tree> {
        self.expect("if")?;
        let condition = self.condition()?;
        let then = self.branch()?;
        self.expect("else")?;
        let other = self.branch()?;
        Some(Tree::new(Op::Choice, vec![condition, then, other]))
    }

    fn branch(&mut self) -> Option<Tree> {
        if !self.eat("{") {
            return self.expression();
        }
        let value = self.expression()?;
        self.expect("}")?;
        Some(value)
    }

    /// Reads a condition: what is in brackets where the language wants them.
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

    /// Reads `|x| value`.
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

    fn postfix(&mut self) -> Option<Tree> {
        let start = self.start();
        let mut tree = self.atom()?;
        loop {
            if self.is_on_a_new_line() && !self.is(".") && !self.is("?.") {
                return Some(tree);
            }
            match self.ahead(0) {
                "." | "->" | "?." | "::" => {
                    self.next += 1;
                    self.eat("::");
                    tree = self.member(tree)?;
                }
                "(" => {
                    let given = self.list("(", ")")?;
                    tree = called(tree, given)?;
                }
                "[" => {
                    let given = self.list("[", "]")?;
                    tree = Tree::new(Op::Index, [vec![tree], given].concat());
                }
                "?" | "!" | "!!" if self.ends_here() => self.next += 1,
                "as" => {
                    self.next += 1;
                    self.eat("?");
                    let name = self.ahead(0);
                    self.next += 1;
                    tree = Tree::call(name, vec![tree]);
                }
                "<" if self.type_arguments().is_some() => self.next += self.type_arguments()?,
                "{" if self.begins_record(&tree) => {
                    let given = self.list("{", "}")?;
                    tree = called(tree, given)?;
                }
                _ => return Some(tree),
            }
            tree = tree.at(start..self.end());
        }
    }

    /// Returns true if a sign behind a value belongs to it, and is no choice.
    fn ends_here(&self) -> bool {
        let is_rust_or_later = matches!(
            self.language,
            Language::Rust
                | Language::Kotlin
                | Language::Swift
                | Language::JavaScript
                | Language::CSharp
        );
        let goes_on =
            self.is_word(1) || self.is_kind(1, Kind::Number) || matches!(self.ahead(1), "(" | "-");
        is_rust_or_later && (self.language == Language::Rust || !goes_on)
    }

    fn begins_record(&self, tree: &Tree) -> bool {
        use Language::{C, CSharp, Cpp, Go, Rust};
        let is_type = tree.parts.is_empty() && tree.at.end == self.end() && tree.name().is_some();
        is_type && !self.is_in_condition && matches!(self.language, Rust | Cpp | C | Go | CSharp)
    }

    /// Counts the tokens of `<T, U>` before what is called with them.
    fn type_arguments(&self) -> Option<usize> {
        let mut depth = 0;
        for n in 0..if self.is("<") { 16 } else { 0 } {
            match self.ahead(n) {
                "<" => depth += 1,
                ">" => depth -= 1,
                ">>" => depth -= 2,
                "," | "::" | "*" | "&" | "." => {}
                _ if self.is_word(n) => {}
                _ => return None,
            }
            if depth == 0 {
                return matches!(self.ahead(n + 1), "(" | "::" | "{").then_some(n + 1);
            }
        }
        None
    }

    /// Reads what stands behind a dot or colons.
    fn member(&mut self, of: Tree) -> Option<Tree> {
        if self.type_arguments().is_some() {
            self.next += self.type_arguments()?;
            return Some(of);
        }
        let name = self.ahead(0);
        self.next += 1;
        let is_space = of
            .name()
            .is_some_and(|it| SPACES.contains(&it) || REAL.contains(&it));
        let is_own = matches!(name, "x" | "y" | "z" | "e");
        if name == "new" || name == "from" || name == "init" {
            return Some(of);
        }
        let is_of_self = matches!(of.name(), Some("self" | "this"));
        if is_space && !(is_of_self && is_own) {
            return Some(
                Tree::new(Op::Name(name.to_owned()), Vec::new())
                    .at(self.end() - name.len()..self.end()),
            );
        }
        // A constant or a function of a type.
        let is_type = of
            .name()
            .is_some_and(|it| it.starts_with(char::is_uppercase) && it.len() > 1);
        if is_type && (name.starts_with(char::is_uppercase) || self.is("(")) {
            return Some(Tree::new(Op::Name(name.to_owned()), Vec::new()));
        }
        Some(Tree::call(name, vec![of]))
    }

    /// Reads what stands in brackets, between commas.
    pub(crate) fn list(&mut self, open: &str, close: &str) -> Option<Vec<Tree>> {
        self.expect(open)?;
        self.brackets += 1;
        let is_in_condition = std::mem::take(&mut self.is_in_condition);
        let mut all = Vec::new();
        while !self.is(close) {
            // A name before a colon, or after a point: of an argument or of a field.
            let is_named =
                self.is_word(0) && (self.ahead(1) == ":" || self.ahead(1) == "=" && open == "(");
            let field = is_named.then(|| self.ahead(0).to_owned());
            self.next += if is_named { 2 } else { 0 };
            if !is_named && (self.is("..") || self.is("...")) {
                self.next += 1;
            }
            let value = self.expression()?;
            if let Some(field) = field {
                self.fields.push((field, value.clone()));
            }
            all.push(value);
            if !self.eat(",") && !self.is(close) {
                return None;
            }
        }
        self.next += 1;
        self.brackets -= 1;
        self.is_in_condition = is_in_condition;
        Some(all)
    }

    fn atom(&mut self) -> Option<Tree> {
        let start = self.start();
        let token = *self.tokens.get(self.next)?;
        let tree = match (token.kind, token.text) {
            (Kind::Number, text) => {
                self.next += 1;
                Tree::new(number(text)?, Vec::new())
            }
            (Kind::Text, text) => {
                self.next += 1;
                Tree::new(Op::Text(text.to_owned()), Vec::new())
            }
            (_, "(") => self.in_brackets()?,
            (_, "[") => Tree::new(Op::List, self.list("[", "]")?),
            (_, "{") if !self.is_in_condition => Tree::new(Op::List, self.list("{", "}")?),
            (_, "let") => self.bound()?,
            (_, "lambda") => {
                while !self.is(":") && self.next < self.tokens.len() {
                    self.next += 1;
                }
                self.next += 1;
                let value = self.expression()?;
                Tree::call("lambda", vec![value])
            }
            (Kind::Word, text) if !is_keyword(text) => {
                self.next += 1;
                if self.eat("=>") {
                    let value = self.expression()?;
                    Tree::call("lambda", vec![value])
                } else {
                    Tree::new(Op::Name(text.to_owned()), Vec::new())
                }
            }
            _ => return None,
        };
        Some(tree.at(start..self.end()))
    }

    /// Reads `let pattern = value` as a part of a condition.
    fn bound(&mut self) -> Option<Tree> {
        let mut name = "";
        while !self.is("=") {
            if self.is_word(0) {
                name = self.ahead(0);
            }
            self.next += 1;
            self.tokens.get(self.next)?;
        }
        self.next += 1;
        let value = self.binary(5)?;
        self.fields.push((name.to_owned(), value.clone()));
        Some(value)
    }

    /// Reads a value in brackets, a tuple, a cast, or a function of one expression.
    fn in_brackets(&mut self) -> Option<Tree> {
        if let Some(end) = self.closing()
            && self.ahead(end + 1) == "=>"
        {
            self.next += end + 2;
            let value = self.expression()?;
            return Some(Tree::call("lambda", vec![value]));
        }
        let start = self.start();
        let cast = self.ahead(1);
        if (WHOLE.contains(&cast) || REAL.contains(&cast)) && self.ahead(2) == ")" {
            self.next += 3;
            let value = self.prefix()?;
            return Some(Tree::call(cast, vec![value]));
        }
        let mut all = self.list("(", ")")?;
        match all.len() {
            // The brackets are a part of its place.
            1 => Some(all.pop()?.at(start..self.end())),
            _ => Some(Tree::new(Op::List, all)),
        }
    }

    /// Counts the tokens from a bracket to the one that closes it.
    fn closing(&self) -> Option<usize> {
        let mut depth = 0;
        let rest = self.tokens[self.next..].iter();
        rest.take(40).position(|it| {
            depth += i32::from(it.text == "(") - i32::from(it.text == ")");
            depth == 0
        })
    }
}

/// Makes a call of what stands before the brackets.
fn called(of: Tree, given: Vec<Tree>) -> Option<Tree> {
    match of.op {
        Op::Name(name) => {
            // A cast of a quotient divides whole numbers.
            let is_real = REAL.contains(&name.as_str());
            let given = match &given[..] {
                [one] if is_real && one.op == Op::Sign("/") && !has_cast(one) => {
                    vec![Tree {
                        op: Op::Sign("//"),
                        ..one.clone()
                    }]
                }
                _ => given,
            };
            Some(Tree::call(&name, given))
        }
        // A method: its object is the first part.
        Op::Call(name) => Some(Tree::call(&name, [of.parts, given].concat())),
        _ => None,
    }
}

/// Returns true if a part of a quotient is turned into another number.
fn has_cast(tree: &Tree) -> bool {
    let nodes = tree.nodes().into_iter();
    let mut all = nodes.map(|it| &it.op);
    all.any(|op| match op {
        Op::Call(name) => REAL.contains(&name.as_str()),
        Op::Number(_, is_whole) => !is_whole,
        _ => false,
    })
}

fn number(text: &str) -> Option<Op> {
    let digits: String = text.chars().filter(|c| *c != '_').collect();
    let is_suffix = |c: char| c.is_ascii_alphabetic() && !"eE".contains(c);
    let digits = match digits.find(is_suffix) {
        Some(end) => &digits[..end],
        None => &digits,
    };
    let is_real = text.contains(['.', 'f']) || digits.contains(['e', 'E']);
    Some(Op::Number(digits.parse().ok()?, !is_real))
}

/// Finds the names that are declared as whole numbers: by a type before or behind them, or by a
/// whole number that they are given.
fn whole_numbers<'a>(tokens: &[Token<'a>]) -> HashSet<&'a str> {
    let is_type = |it: &Token| WHOLE.contains(&it.text);
    let is_name = |it: &Token| it.kind == Kind::Word && !is_keyword(it.text);
    let is_whole = |it: &Token| {
        it.kind == Kind::Number && matches!(number(it.text), Some(Op::Number(_, true)))
    };
    let names = tokens.windows(4).filter_map(|four| match four {
        [of, name, ..] if is_type(of) && is_name(name) && !is_type(name) => Some(name.text),
        [name, colon, of, _] if colon.text == ":" && is_type(of) => Some(name.text),
        [name, of, ..] if is_name(name) && is_type(of) && !is_type(name) => Some(name.text),
        [name, sign, value, end]
            if matches!(sign.text, "=" | ":=")
                && is_whole(value)
                && (end.text == ";" || end.is_first) =>
        {
            Some(name.text)
        }
        _ => None,
    });
    // Where it is given a real number elsewhere, it is none.
    let reals: HashSet<&str> = tokens
        .windows(2)
        .filter(|two| REAL.contains(&two[0].text) && is_name(&two[1]))
        .map(|two| two[1].text)
        .collect();
    names.filter(|it| !reals.contains(it)).collect()
}

/// Returns true if the word begins a statement or joins two, and names nothing.
pub(crate) fn is_keyword(word: &str) -> bool {
    const WORDS: [&str; 19] = [
        "return", "if", "else", "for", "while", "and", "or", "not", "in", "is", "let", "var",
        "const", "auto", "do", "switch", "match", "when", "elif",
    ];
    WORDS.contains(&word)
}
