//! Lexical normalization: the words, numbers and signs of a program, the same for three
//! languages and for the ways in which one thing is written.

/// A word, a number or a sign.
#[derive(Clone, Debug)]
pub(super) struct Token {
    pub(super) text: String,
    /// The line, from 0.
    pub(super) line: usize,
}

impl Token {
    /// One that no program has in this place.
    pub(super) fn new(text: &str, line: usize) -> Self {
        Self {
            text: text.to_owned(),
            line,
        }
    }
}

/// Without comments, and without what a language needs and an idea does not: `let`, empty
/// brackets, a zero after the point. A method is a function of what it is called on.
pub(super) fn tokens(text: &str) -> Vec<Token> {
    let words = text
        .lines()
        .enumerate()
        .flat_map(|(n, line)| words(n, line));
    let mut rest = words.collect::<Vec<_>>().into_iter().peekable();
    let mut tokens = Vec::new();
    while let Some(token) = rest.next() {
        let next = rest.peek().map_or("", |it| it.text.as_str());
        match (token.text.as_str(), next) {
            ("let" | "mut" | "pub" | "auto" | "const" | "double" | "static" | "inline", _) => {}
            (")", _) if ends_with(&tokens, &["("]) => {
                tokens.pop();
            }
            ("::", _) => {
                rest.next_if(|it| it.text == "new");
            }
            ("]", _) if is_component(&tokens) => component(&mut tokens),
            ("2", _) if ends_with(&tokens, &["*", "*"]) => {
                tokens.pop();
                let start = operand(&tokens[..tokens.len() - 1]);
                tokens.extend_from_within(start..tokens.len() - 1);
            }
            (_, "(") if ends_with(&tokens, &["."]) && is_function(&token.text) => {
                rest.next();
                let is_empty = rest.next_if(|it| it.text == ")").is_some();
                call(&mut tokens, token, is_empty);
            }
            (")", _) => {
                // A record that is filled is what is returned elsewhere.
                if ends_with(&tokens, &[",", "rec"]) {
                    tokens.truncate(tokens.len() - 2);
                }
                tokens.push(token);
                for shorter in [operated, interval, reciprocal, ones, bracketed] {
                    if ends_with(&tokens, &[")"]) {
                        shorter(&mut tokens);
                    }
                }
            }
            _ => tokens.push(token),
        }
    }
    // Three numbers in brackets are a vector, whatever it is called.
    tokens.retain(|it| it.text != "Vec3");
    tokens
}

/// The words of a line as they are written most often.
fn words(line: usize, text: &str) -> Vec<Token> {
    let code = text.split("//").next().unwrap_or_default();
    let code = code.split('#').next().unwrap_or_default();
    let mut code = code
        .replace("make_shared<sphere>", "sphere")
        .replace("->", ".");
    // Nobody adds one to a color but to a normal that is taken for one.
    for sign in ["* Color::ONE", "= Color::ONE", "Color::ONE *"] {
        code = code.replace(sign, &sign.replace("ONE", "new(1.0, 1.0, 1.0)"));
    }
    for prefix in ["this->", "std::", "math.", "f64::from", "f64::"] {
        code = code.replace(prefix, "");
    }
    let words = lexed(&code, &["::"]);
    let word = |n: usize| words.get(n).copied().unwrap_or_default();
    // A vector's own letters have a name before them elsewhere.
    let is_own = |n: usize| {
        (word(n), word(n + 1)) == ("self", ".") && !matches!(word(n + 2), "x" | "y" | "z" | "e")
    };
    let is_read = |n: &usize| !is_own(*n) && !n.checked_sub(1).is_some_and(is_own);
    let read = (0..words.len()).filter(is_read);
    read.map(|n| Token::new(spelled(word(n), word(n + 1)), line))
        .collect()
}

/// The words, numbers and signs of a text. A sign is one letter, or one of these.
pub(crate) fn lexed<'a>(text: &'a str, signs: &[&str]) -> Vec<&'a str> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut words = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let sign = signs.iter().find(|it| rest.starts_with(**it));
        let length = match first {
            c if c.is_ascii_digit() => rest.find(|c| !is_word(c) && c != '.'),
            c if is_word(c) => rest.find(|c| !is_word(c)),
            c => Some(sign.map_or(c.len_utf8(), |it| it.len())),
        };
        let (word, after) = rest.split_at(length.unwrap_or(rest.len()));
        words.push(word);
        rest = after.trim_start();
    }
    words
}

/// As it is written most often, before `next`.
fn spelled<'a>(word: &'a str, next: &str) -> &'a str {
    match word {
        "ray" => "r",
        "infinity" | "inf" => "INFINITY",
        "camera_center" => "center",
        "orig" => "origin",
        "dir" => "direction",
        "unit_vector" | "normalized" | "unit" => "normalize",
        "fabs" => "abs",
        "Sphere" => "sphere",
        "temp_rec" | "temp" => "rec",
        "ray_tmin" | "tmin" => "t_min",
        "ray_tmax" | "tmax" => "t_max",
        "disc" => "discriminant",
        "root" | "sqrt_d" => "sqrtd",
        "vec3" | "Color" | "color" | "Point3" | "point3" if matches!(next, "(" | "::") => "Vec3",
        _ if word.starts_with(|c: char| c.is_ascii_digit()) => {
            let word = word.trim_end_matches("f64");
            match word.split_once('.') {
                Some((whole, part)) if part.chars().all(|c| c == '0') => whole,
                _ => word,
            }
        }
        _ => word,
    }
}

fn ends_with(tokens: &[Token], end: &[&str]) -> bool {
    let start = tokens.len().checked_sub(end.len());
    start.is_some_and(|start| {
        tokens[start..]
            .iter()
            .zip(end)
            .all(|(it, end)| it.text == *end)
    })
}

/// A method that is a function elsewhere.
fn is_function(name: &str) -> bool {
    let functions = [
        "dot",
        "normalize",
        "length",
        "length_squared",
        "sqrt",
        "abs",
    ];
    functions.contains(&name)
}

/// `object.` and the name of a method become `name(object`, and what follows its brackets.
fn call(tokens: &mut Vec<Token>, name: Token, is_empty: bool) {
    tokens.pop();
    let line = name.line;
    let start = operand(tokens);
    tokens.splice(start..start, [name, Token::new("(", line)]);
    tokens.push(Token::new(if is_empty { ")" } else { "," }, line));
}

/// Where the operand begins that the tokens end with: a path, or brackets.
fn operand(tokens: &[Token]) -> usize {
    let mut start = tokens.len();
    loop {
        start = match start.checked_sub(1).map(|n| tokens[n].text.as_str()) {
            Some(")") => opening(&tokens[..start]),
            Some(text) if is_name(text) => start - 1,
            _ => return start,
        };
        let before = start.checked_sub(1).map_or("", |n| tokens[n].text.as_str());
        match before {
            "." => start -= 1,
            // A function that is called.
            _ if is_name(before) && tokens[start].text == "(" => {}
            _ => return start,
        }
    }
}

/// Where the bracket was opened that the tokens end with.
fn opening(tokens: &[Token]) -> usize {
    let mut depth = 0;
    let open = tokens.iter().rposition(|token| {
        depth += i32::from(token.text == ")") - i32::from(token.text == "(");
        depth == 0
    });
    open.unwrap_or(0)
}

pub(super) fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_alphabetic() || c == '_')
        && !matches!(text, "return" | "if" | "and" | "or" | "not")
}

/// Whether `[0]`, `[1]` or `[2]` is about to end.
fn is_component(tokens: &[Token]) -> bool {
    let is_number = tokens
        .last()
        .is_some_and(|it| matches!(&*it.text, "0" | "1" | "2"));
    is_number
        && tokens.len() > 2
        && tokens[tokens.len() - 2].text == "["
        && is_name(&tokens[tokens.len() - 3].text)
}

/// `v[0]` and `v.e[0]` become `v.x`, and so on.
fn component(tokens: &mut Vec<Token>) {
    let Some(number) = tokens.pop() else { return };
    tokens.pop();
    if ends_with(tokens, &[".", "e"]) {
        tokens.truncate(tokens.len() - 2);
    }
    if ends_with(tokens, &["e"]) {
        tokens.pop();
        tokens.push(Token::new("self", number.line));
    }
    let letter = ["x", "y", "z"][number.text.parse::<usize>().unwrap_or(0)];
    tokens.extend([".", letter].map(|sign| Token::new(sign, number.line)));
}

/// `sub(a, b)` becomes `(a - b)`.
fn operated(tokens: &mut Vec<Token>) {
    let (open, close) = (opening(tokens), tokens.len() - 1);
    let text = |n: Option<usize>| n.map_or("", |n| tokens[n].text.as_str());
    let sign = match text(open.checked_sub(1)) {
        "add" => "+",
        "sub" => "-",
        "scale" => "*",
        _ => return,
    };
    let is_named = matches!(text(open.checked_sub(2)), "fn" | "def" | ".");
    let second = operand(&tokens[..close]);
    if !is_named && text(second.checked_sub(1)) == "," {
        tokens[second - 1] = Token::new(sign, tokens[second].line);
        tokens.remove(open - 1);
    }
}

/// `interval(low, high)` becomes `low, high`.
fn interval(tokens: &mut Vec<Token>) {
    let open = opening(tokens);
    if open > 0 && matches!(&*tokens[open - 1].text, "interval" | "Interval") {
        tokens.pop();
        tokens.drain(open - 1..=open);
    }
}

/// Brackets around a single word that is no argument go.
fn bracketed(tokens: &mut Vec<Token>) {
    let (open, end) = (opening(tokens), tokens.len());
    let is_called = open
        .checked_sub(1)
        .is_some_and(|n| is_name(&tokens[n].text));
    if open + 3 == end && !is_called && tokens[open].text == "(" {
        tokens.pop();
        tokens.remove(open);
    }
}

/// `* (1 / s)` becomes `/ s`.
fn reciprocal(tokens: &mut Vec<Token>) {
    let open = opening(tokens);
    let is = |n: usize, text: &str| tokens.get(n).is_some_and(|it| it.text == text);
    let is_reciprocal = open > 0 && is(open - 1, "*") && is(open + 1, "1") && is(open + 2, "/");
    if is_reciprocal && operand(&tokens[..tokens.len() - 1]) == open + 3 {
        tokens.pop();
        tokens.drain(open - 1..=open + 1);
    }
}

/// `Vec3(n.x + 1, n.y + 1, n.z + 1)` becomes `(n + Vec3 ONE)`.
fn ones(tokens: &mut Vec<Token>) {
    let open = opening(tokens);
    let inside = tokens.get(open + 1..tokens.len() - 1).unwrap_or_default();
    let parts: Vec<&[Token]> = inside.split(|it| it.text == ",").collect();
    let names: Vec<Option<String>> = parts
        .iter()
        .zip(["x", "y", "z"])
        .map(|(part, letter)| {
            let name = part.len().checked_sub(4)?;
            let name = ends_with(part, &[".", letter, "+", "1"]).then(|| &part[..name])?;
            Some(
                name.iter()
                    .map(|it| it.text.as_str())
                    .collect::<Vec<_>>()
                    .join(" "),
            )
        })
        .collect();
    let is_vector = open > 0 && tokens[open - 1].text == "Vec3" && parts.len() == 3;
    let are_same = names.iter().all(|name| name.is_some() && *name == names[0]);
    if is_vector && are_same {
        let line = tokens[open].line;
        let mut sum = tokens[open..open + parts[0].len() - 3].to_vec();
        let rest = ["+", "Vec3", "ONE", ")"];
        sum.extend(rest.map(|text| Token::new(text, line)));
        tokens.splice(open - 1.., sum);
    }
}
