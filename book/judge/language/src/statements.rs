//! Recursive descent with panic-mode recovery: the statements of a file, as far as they are read.
//!
//! A statement that is not understood is skipped up to the next place where one can begin.

use std::ops::Range;

use crate::Language;
use crate::parse::{Parser, is_keyword};
use crate::tokens::{Token, TokenKind};
use crate::tree::{Op, Tree};

/// The purpose of an expression in a [`Statement`]: the value of a name, a condition, a result, the
/// list of a loop, or an effect.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Role {
    /// The value that the variable, field or named argument of this name is given.
    ValueOf(String),
    /// The condition of an `if` or a loop.
    Condition,
    /// The value that a function returns.
    Result,
    /// The list or range that a loop goes over with a variable of this name.
    LoopOver(String),
    /// An expression that is evaluated only for its side effect, as in `world.add(ball);`, its
    /// value being discarded.
    Effect,
}

/// A statement of a program, reduced to one expression. A line with several expressions, as `x, y =
/// 1, 2`, makes several statements.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The purpose of the expression, with the name that it is given.
    pub role: Role,
    /// The expression, as it is written.
    pub value: Tree,
    /// The range of bytes of the statement in the source text; of a field or a named argument, that
    /// of its value.
    pub at: Range<usize>,
}

/// Parses a source text into statements, in their order; empty if it has none. Code that is not
/// understood is skipped, and comments, declarations of types and heads of functions are no
/// statements.
pub fn statements(text: &str, language: Language) -> Vec<Statement> {
    let mut all = Vec::new();
    let mut parser = Parser::new(text, language);
    while parser.next < parser.tokens.len() {
        parser.begin();
        let (start, first) = (parser.start(), parser.next);
        let read = statement(&mut parser).unwrap_or_default();
        let fields = std::mem::take(&mut parser.fields).into_iter();
        let at = start..parser.end();
        all.extend(read.into_iter().map(|(role, value)| Statement {
            at: at.clone(),
            role,
            value,
        }));
        all.extend(fields.map(|(name, value)| Statement {
            at: value.at.clone(),
            role: Role::ValueOf(name),
            value,
        }));
        parser.next = parser.next.max(first);
        skip(&mut parser, first);
    }
    all
}

/// Tokens behind which a statement may begin.
const BEGINNINGS: [&str; 7] = [";", "{", "}", ":", "=>", "else", "then"];

/// Moves on to the next token where a statement may begin, `first` being where the last one began.
fn skip(parser: &mut Parser, first: usize) {
    let is_behind = |parser: &Parser| {
        let last = parser.next.checked_sub(1).map(|n| parser.tokens[n].text);
        last.is_some_and(|it| BEGINNINGS.contains(&it))
    };
    if parser.next > first && (is_behind(parser) || begins(parser)) {
        return;
    }
    loop {
        parser.next += 1;
        if parser.next >= parser.tokens.len() || is_behind(parser) || begins(parser) {
            return;
        }
    }
}

/// Returns true if the next token can only be the first of a statement.
fn begins(parser: &Parser) -> bool {
    let is_word = matches!(
        parser.ahead(0),
        "return" | "if" | "elif" | "while" | "for" | "let"
    );
    let follows_bracket = parser.next > 0 && parser.tokens[parser.next - 1].text == ")";
    parser.is_on_a_new_line() || is_word || parser.is("}") || follows_bracket && parser.is_word(0)
}

/// The expressions of a statement, each with its purpose.
type Expressions = Vec<(Role, Tree)>;

/// Reads the statement that begins with the next token.
fn statement(parser: &mut Parser) -> Option<Expressions> {
    let is_result = parser.next > 0 && parser.tokens[parser.next - 1].text == "=>";
    match parser.ahead(0) {
        "return" => {
            parser.next += 1;
            if parser.is_on_a_new_line() {
                return None;
            }
            Some(vec![(Role::Result, parser.expression()?)])
        }
        "if" | "elif" | "while" | "guard" | "else" => conditions(parser),
        "for" => repeated(parser),
        "def" | "fn" | "func" | "fun" | "function" | "class" | "struct" | "impl" | "import"
        | "use" | "package" | "namespace" | "template" | "interface" | "trait" | "mod" | "enum"
        | "@" => None,
        "{" | "}" | ";" | ":" => None,
        _ => {
            let given = given(parser);
            if given.is_some() {
                return given;
            }
            let value = parser.expression()?;
            let is_end = parser.is("}") || parser.next == parser.tokens.len();
            let is_last = is_end && parser.language.returns_its_last();
            let role = if is_result || is_last {
                Role::Result
            } else if is_end || parser.is(";") || parser.is_on_a_new_line() {
                Role::Effect
            } else {
                return None;
            };
            Some(vec![(role, value)])
        }
    }
}

/// Reads the head of an `if`, `elif`, `else if` or `while`, also with a declaration first.
fn conditions(parser: &mut Parser) -> Option<Expressions> {
    let is_else = parser.eat("else");
    if is_else && !parser.is("if") {
        return None;
    }
    parser.next += 1;
    let condition = parser.condition()?;
    let mut all = vec![(Role::Condition, condition)];
    // Go and C++ give a name first; Swift has more conditions behind a comma.
    while parser.eat(";") || parser.language == Language::Swift && parser.eat(",") {
        all.push((Role::Condition, parser.condition()?));
    }
    if let [(role, first), _, ..] = &mut all[..]
        && first.op == Op::Operator("=")
    {
        *role = Role::ValueOf(first.parts[0].name().unwrap_or_default().to_owned());
        *first = first.parts[1].clone();
    }
    Some(all)
}

/// Reads the head of a `for`, over a list or with a counter.
fn repeated(parser: &mut Parser) -> Option<Expressions> {
    parser.next += 1;
    parser.eat("(");
    while matches!(
        parser.ahead(0),
        "const" | "auto" | "let" | "var" | "int" | "size_t"
    ) {
        parser.next += 1;
    }
    let is_each = parser.is_word(0) && matches!(parser.ahead(1), "in" | "of");
    if is_each {
        let name = parser.ahead(0).to_owned();
        parser.next += 2;
        parser.is_in_condition = true;
        let value = parser.expression();
        parser.is_in_condition = false;
        return Some(vec![(Role::LoopOver(name), value?)]);
    }
    let mut all = given(parser)?;
    parser.eat(";");
    all.push((Role::Condition, parser.expression()?));
    Some(all)
}

/// Reads an assignment or a declaration: `let t: f64 = …`, `auto t = …`, `t := …`, `sum += …`, or
/// C++'s `ray r(…)`.
fn given(parser: &mut Parser) -> Option<Expressions> {
    let first = parser.next;
    let end = target(parser)?;
    let names = names(parser, first, end);
    parser.next = end;
    let sign = parser.ahead(0);
    if matches!(sign, "(" | "{") {
        let close = if sign == "(" { ")" } else { "}" };
        let of = parser.tokens[end - 2].text;
        let given = parser.list(sign, close).filter(|_| parser.is(";"));
        let Some(given) = given else {
            parser.next = first;
            return None;
        };
        return Some(vec![(
            Role::ValueOf(names[0].clone()),
            Tree::call(of, given),
        )]);
    }
    parser.next += 1;
    let mut values = vec![parser.expression()?];
    while names.len() > 1 && parser.eat(",") {
        values.push(parser.expression()?);
    }
    let compound = ["+=", "-=", "*=", "/="].iter().position(|it| *it == sign);
    if let Some(n) = compound {
        let value = values.swap_remove(0);
        let name = Tree::name_of(&names[0]);
        let sum = Op::Operator(["+", "-", "*", "/"][n]);
        values = vec![Tree::new(sum, vec![name, value.clone()]).placed_at(value.at)];
    }
    let pairs = names.into_iter().zip(values);
    Some(
        pairs
            .map(|(name, value)| (Role::ValueOf(name), value))
            .collect(),
    )
}

/// Finds the token `=`, or the bracket of C++'s `ray r(…)`, in the statement that begins here.
fn target(parser: &Parser) -> Option<usize> {
    let mut depth = 0;
    for (n, token) in parser.tokens.iter().enumerate().skip(parser.next) {
        let is_new_line = token.is_first && n > parser.next && parser.language.ends_at_lines();
        match token.text {
            "=" | ":=" | "+=" | "-=" | "*=" | "/=" if depth == 0 => return Some(n),
            ";" | "}" | "return" | "=>" if depth == 0 => return None,
            _ if is_new_line && depth == 0 => return None,
            "(" | "{" if depth == 0 && is_made(parser, n) => return Some(n),
            "{" if depth == 0 => return None,
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
    }
    None
}

/// Returns true if a type and a new name stand before this bracket, as in C++'s `ray r(…)`.
fn is_made(parser: &Parser, bracket: usize) -> bool {
    let words = &parser.tokens[parser.next..bracket];
    let is_named = |it: &Token| it.kind == TokenKind::Word && !is_keyword(it.text);
    parser.language == Language::Cpp
        && words.len() > 1
        && words[words.len() - 2..].iter().all(is_named)
}

/// Finds the names that are assigned to, between the tokens `first` and `end`.
fn names(parser: &Parser, first: usize, end: usize) -> Vec<String> {
    let target = &parser.tokens[first..end];
    // What stands behind a colon is a type.
    let colon = target.iter().position(|it| it.text == ":");
    let target = &target[..colon.unwrap_or(target.len())];
    let parts = target.split(|it| it.text == ",");
    let is_word = |it: &&Token| it.kind == TokenKind::Word;
    let name = |part: &[Token]| {
        let indexed = part
            .iter()
            .position(|it| it.text == "[")
            .filter(|at| *at > 0);
        let part = &part[..indexed.unwrap_or(part.len())];
        part.iter()
            .rfind(is_word)
            .map_or(String::new(), |it| it.text.to_owned())
    };
    parts.map(name).collect()
}
