//! A Pratt parser for the Rust that our chapters are written in, and no more.

/// A function: its name, and a slot for each of its variables.
#[derive(Debug)]
pub(super) struct Function {
    pub(super) slots: usize,
    pub(super) body: Node,
}

/// A part of a program, with variables by their slots.
#[derive(Debug)]
pub(super) enum Node {
    Number(f64),
    /// A name that is no variable: a constant.
    Name(String),
    Variable(usize),
    Set(usize, Box<Node>),
    SetField(usize, Member, Box<Node>),
    Field(Box<Node>, Member),
    Negated(Box<Node>),
    Not(Box<Node>),
    Binary(Sign, Box<Node>, Box<Node>),
    Call(Callee, Vec<Node>),
    /// A method, the slot of what it is called on if that is a variable, and what it is.
    Method(Member, Box<Node>, Vec<Node>),
    /// The first of some that a closure says yes to.
    Find(Box<Node>, usize, Box<Node>),
    Several(Vec<Node>),
    Record(Vec<(Member, Node)>),
    Camera(Vec<(Member, Node)>),
    If(Vec<Node>, Box<Node>, Option<Box<Node>>),
    /// `let Some(x) = …`, as a condition.
    Matches(usize, Box<Node>),
    For(usize, Box<Node>),
    Return(Box<Node>),
    Try(Box<Node>),
    Block(Vec<Node>),
}

/// Words of the language as values, each by the name that it has in a text.
macro_rules! words {
    ($(#[$about:meta])* $kind:ident { $($name:ident = $text:literal,)* }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(super) enum $kind {
            $($name,)*
        }

        impl $kind {
            fn of(text: &str) -> Option<Self> {
                match text {
                    $($text => Some(Self::$name),)*
                    _ => None,
                }
            }
        }
    };
}

words! {
    /// An operator between two values.
    Sign {
        Plus = "+", Minus = "-", Times = "*", Over = "/", Less = "<", Greater = ">",
        AtMost = "<=", AtLeast = ">=", And = "&&", Or = "||",
    }
}

words! {
    /// A field or a method.
    Member {
        Origin = "origin", Direction = "direction", X = "x", Y = "y", Z = "z",
        Center = "center", Radius = "radius", T = "t", Point = "point", Normal = "normal",
        FrontFace = "front_face", Objects = "objects", Sqrt = "sqrt", Abs = "abs",
        Normalize = "normalize", Length = "length", LengthSquared = "length_squared",
        Dot = "dot", At = "at", IntoIter = "into_iter", Hit = "hit",
        SetFaceNormal = "set_face_normal", ImageWidth = "image_width",
        ImageHeight = "image_height", Pixel00 = "pixel00", PixelDeltaU = "pixel_delta_u",
        PixelDeltaV = "pixel_delta_v",
    }
}

words! {
    /// A function that is called by its name.
    Callee {
        Some = "Some", Sky = "sky", Point = "Point3::new", Color = "Color::new",
        Vector = "Vec3::new", HitSphere = "hit_sphere", Default = "HitRecord::default",
        From = "f64::from", Ray = "Ray::new",
    }
}

/// The tokens of a source without its comments.
fn tokens(text: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if first.is_ascii_digit() {
            let is_range = rest.find("..").unwrap_or(rest.len());
            let end = rest.find(|c: char| !is_word(c) && c != '.');
            end.unwrap_or(rest.len()).min(is_range)
        } else if is_word(first) {
            rest.find(|c| !is_word(c)).unwrap_or(rest.len())
        } else {
            let signs = ["&&", "||", "<=", ">=", "==", "->", "::", ".."];
            let two = signs.iter().find(|sign| rest.starts_with(**sign));
            two.map_or(first.len_utf8(), |sign| sign.len())
        };
        if !first.is_whitespace() && !rest.starts_with("//") {
            tokens.push(&rest[..length]);
        }
        at += length;
    }
    tokens
}

/// The function that the text is; `None` if it is none that could be run.
pub(super) fn function(text: &str) -> Option<Function> {
    let tokens = tokens(text);
    let mut parser = Parser {
        tokens: &tokens,
        at: 0,
        scope: Vec::new(),
        slots: 0,
    };
    parser.parameters()?;
    let body = parser.block()?;
    Some(Function {
        slots: parser.slots,
        body,
    })
}

struct Parser<'a> {
    tokens: &'a [&'a str],
    at: usize,
    /// The names in reach, each with its slot.
    scope: Vec<(&'a str, usize)>,
    slots: usize,
}

impl<'a> Parser<'a> {
    fn peek(&self) -> &'a str {
        self.tokens.get(self.at).copied().unwrap_or_default()
    }

    fn next(&mut self) -> Option<&'a str> {
        let token = *self.tokens.get(self.at)?;
        self.at += 1;
        Some(token)
    }

    fn takes(&mut self, text: &str) -> bool {
        let is_it = self.peek() == text;
        self.at += usize::from(is_it);
        is_it
    }

    fn expect(&mut self, text: &str) -> Option<()> {
        self.takes(text).then_some(())
    }

    fn declare(&mut self, name: &'a str) -> usize {
        self.scope.push((name, self.slots));
        self.slots += 1;
        self.slots - 1
    }

    /// From `fn` to the body: each parameter gets a slot, `self` the first.
    fn parameters(&mut self) -> Option<()> {
        self.expect("fn")?;
        self.next()?;
        self.expect("(")?;
        while !self.takes(")") {
            while self.takes("&") || self.takes("mut") {}
            let name = self.next()?;
            self.declare(name);
            while !matches!(self.peek(), "," | ")" | "") {
                self.next();
            }
            self.takes(",");
        }
        while self.peek() != "{" {
            self.next()?;
        }
        Some(())
    }

    fn block(&mut self) -> Option<Node> {
        self.expect("{")?;
        let outside = self.scope.len();
        let mut nodes = Vec::new();
        while !self.takes("}") {
            nodes.push(self.statement()?);
        }
        self.scope.truncate(outside);
        Some(Node::Block(nodes))
    }

    fn statement(&mut self) -> Option<Node> {
        if self.takes("let") {
            self.takes("mut");
            let name = self.next()?;
            self.expect("=")?;
            let value = self.expression()?;
            self.expect(";")?;
            return Some(Node::Set(self.declare(name), Box::new(value)));
        }
        if self.takes("return") {
            let value = self.expression()?;
            self.takes(";");
            return Some(Node::Return(Box::new(value)));
        }
        if self.takes("for") {
            let outside = self.scope.len();
            let name = self.next()?;
            let slot = self.declare(name);
            while self.peek() != "{" {
                self.next()?;
            }
            let body = self.block()?;
            self.scope.truncate(outside);
            return Some(Node::For(slot, Box::new(body)));
        }
        if self.takes("debug_assert") {
            while self.next()? != ";" {}
            return Some(Node::Block(Vec::new()));
        }
        let value = self.expression()?;
        let node = match self.takes("=") {
            true => self.assignment(value)?,
            false => value,
        };
        self.takes(";");
        Some(node)
    }

    fn assignment(&mut self, place: Node) -> Option<Node> {
        let value = Box::new(self.expression()?);
        match place {
            Node::Variable(slot) => Some(Node::Set(slot, value)),
            Node::Field(of, field) => match *of {
                Node::Variable(slot) => Some(Node::SetField(slot, field, value)),
                _ => None,
            },
            _ => None,
        }
    }

    fn expression(&mut self) -> Option<Node> {
        self.binary(0, true)
    }

    /// Operators that bind at least as tightly as this.
    fn binary(&mut self, least: usize, may_be_struct: bool) -> Option<Node> {
        const LEVELS: [&[&str]; 5] = [
            &["||"],
            &["&&"],
            &["<", ">", "<=", ">=", "=="],
            &["+", "-"],
            &["*", "/"],
        ];
        let Some(operators) = LEVELS.get(least) else {
            return self.unary(may_be_struct);
        };
        let mut left = self.binary(least + 1, may_be_struct)?;
        while operators.contains(&self.peek()) {
            let operator = Sign::of(self.next()?)?;
            let right = self.binary(least + 1, may_be_struct)?;
            left = Node::Binary(operator, Box::new(left), Box::new(right));
        }
        Some(left)
    }

    fn unary(&mut self, may_be_struct: bool) -> Option<Node> {
        if self.takes("-") {
            return Some(Node::Negated(Box::new(self.unary(may_be_struct)?)));
        }
        if self.takes("!") {
            return Some(Node::Not(Box::new(self.unary(may_be_struct)?)));
        }
        while self.takes("&") || self.takes("mut") {}
        let mut node = self.primary(may_be_struct)?;
        loop {
            if self.takes("?") {
                node = Node::Try(Box::new(node));
            } else if self.takes(".") {
                node = self.member(node)?;
            } else {
                return Some(node);
            }
        }
    }

    /// A field or a method.
    fn member(&mut self, of: Node) -> Option<Node> {
        let name = self.next()?;
        if !self.takes("(") {
            return Some(Node::Field(Box::new(of), Member::of(name)?));
        }
        if name == "find" {
            self.expect("|")?;
            self.takes("&");
            let variable = self.next()?;
            let slot = self.declare(variable);
            self.expect("|")?;
            let condition = self.expression()?;
            self.scope.pop();
            self.expect(")")?;
            return Some(Node::Find(Box::new(of), slot, Box::new(condition)));
        }
        Some(Node::Method(
            Member::of(name)?,
            Box::new(of),
            self.several(")")?,
        ))
    }

    fn several(&mut self, end: &str) -> Option<Vec<Node>> {
        let mut nodes = Vec::new();
        while !self.takes(end) {
            nodes.push(self.expression()?);
            if !self.takes(",") {
                self.expect(end)?;
                break;
            }
        }
        Some(nodes)
    }

    fn primary(&mut self, may_be_struct: bool) -> Option<Node> {
        let text = self.next()?;
        match text {
            "(" => {
                let mut nodes = self.several(")")?;
                match nodes.len() {
                    1 => nodes.pop(),
                    // A vector in the words of no language.
                    3 => Some(Node::Call(Callee::Vector, nodes)),
                    _ => None,
                }
            }
            "[" => Some(Node::Several(self.several("]")?)),
            "if" => self.condition(),
            _ if text.starts_with(|c: char| c.is_ascii_digit()) => {
                text.parse().ok().map(Node::Number)
            }
            _ if text.starts_with(|c: char| c.is_alphabetic() || c == '_') => {
                self.named(text, may_be_struct)
            }
            _ => None,
        }
    }

    fn named(&mut self, first: &'a str, may_be_struct: bool) -> Option<Node> {
        let mut name = first.to_owned();
        while self.takes("::") {
            name = format!("{name}::{}", self.next()?);
        }
        if self.takes("(") {
            let mut given = self.several(")")?;
            return match Callee::of(&name) {
                Some(callee) => Some(Node::Call(callee, given)),
                // A method is a function elsewhere.
                None => {
                    let method = Member::of(&name)?;
                    (!given.is_empty()).then(|| {
                        let of = Box::new(given.remove(0));
                        Node::Method(method, of, given)
                    })
                }
            };
        }
        if matches!(first, "HitRecord" | "Self") && may_be_struct && self.takes("{") {
            let fields = self.fields()?;
            return Some(match first {
                "Self" => Node::Camera(fields),
                _ => Node::Record(fields),
            });
        }
        let known = self.scope.iter().rev().find(|(known, _)| *known == name);
        Some(match known {
            Some((_, slot)) => Node::Variable(*slot),
            None => Node::Name(name),
        })
    }

    fn fields(&mut self) -> Option<Vec<(Member, Node)>> {
        let mut fields = Vec::new();
        while !self.takes("}") {
            if self.takes("..") {
                self.expression()?;
                continue;
            }
            let name = self.next()?;
            let value = match self.takes(":") {
                true => self.expression()?,
                false => self.named(name, false)?,
            };
            fields.push((Member::of(name)?, value));
            self.takes(",");
        }
        Some(fields)
    }

    fn condition(&mut self) -> Option<Node> {
        let outside = self.scope.len();
        let mut all = Vec::new();
        loop {
            all.push(match self.takes("let") {
                true => {
                    self.expect("Some")?;
                    self.expect("(")?;
                    let name = self.next()?;
                    self.expect(")")?;
                    self.expect("=")?;
                    let value = self.binary(2, false)?;
                    Node::Matches(self.declare(name), Box::new(value))
                }
                false => self.binary(2, false)?,
            });
            if !self.takes("&&") {
                break;
            }
        }
        let then = Box::new(self.block()?);
        self.scope.truncate(outside);
        let other = match self.takes("else") {
            true if self.takes("if") => Some(Box::new(self.condition()?)),
            true => Some(Box::new(self.block()?)),
            false => None,
        };
        Some(Node::If(all, then, other))
    }
}
