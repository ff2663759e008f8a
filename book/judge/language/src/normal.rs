//! Term rewriting: the normal form, in which expressions that mean the same are the same but for
//! the order of their parts.
//!
//! Differences and negatives are sums and products with numbers, quotients are products with
//! [`Op::Over`], a comparison is a sum that is below zero, a cast is nothing, and what is done in
//! all three components is done with the vector.

use crate::parse::{REAL, WHOLE};
use crate::tree::{Op, Tree};

/// What a function, a method or a field is called here, and elsewhere: without capitals and `_`.
const FUNCTIONS: [(&str, &[&str]); 23] = [
    (
        "unit",
        &[
            "unitvector",
            "unit",
            "normalize",
            "normalized",
            "normalise",
            "normalised",
            "unitize",
        ],
    ),
    (
        "length",
        &["length", "len", "norm", "mag", "magnitude", "hypot"],
    ),
    (
        "lengthsquared",
        &[
            "lengthsquared",
            "squaredlength",
            "lengthsq",
            "lensq",
            "length2",
            "len2",
            "normsquared",
            "lensquared",
            "norm2",
            "magsq",
            "magnitudesquared",
            "squarednorm",
        ],
    ),
    ("dot", &["dot", "dotproduct", "inner", "vdot", "dotp"]),
    ("abs", &["abs", "fabs"]),
    ("sqrt", &["sqrt", "squareroot"]),
    ("+", &["add", "plus", "vadd", "added"]),
    (
        "-",
        &[
            "sub",
            "minus",
            "subtract",
            "vsub",
            "subtracted",
            "difference",
        ],
    ),
    (
        "*",
        &[
            "scale",
            "mul",
            "times",
            "multiply",
            "vmul",
            "muls",
            "scaled",
            "vscale",
            "multiplied",
            "mulscalar",
            "smul",
        ],
    ),
    (
        "/",
        &["div", "divide", "divided", "vdiv", "divs", "divscalar"],
    ),
    (
        "neg",
        &[
            "neg",
            "negate",
            "negated",
            "negative",
            "unaryminus",
            "vneg",
            "opposite",
        ],
    ),
    (
        "vec",
        &[
            "vec3", "vec", "vector", "vector3", "point3", "point", "color", "colour", "v3",
            "vec3d", "dvec3", "float3", "double3", "rgb", "array", "p3", "col", "v", "vec3f",
            "newvec3", "makevec3", "color3", "mkvec", "v3new",
        ],
    ),
    ("origin", &["origin", "orig", "o", "org", "getorigin"]),
    ("direction", &["direction", "dir", "d", "getdirection"]),
    (
        "at",
        &["at", "pointat", "pointatparameter", "along", "position"],
    ),
    ("x", &["x", "getx", "r", "red"]),
    ("y", &["y", "gety", "g", "green"]),
    ("z", &["z", "getz", "b", "blue"]),
    ("point", &["point", "p", "pos"]),
    ("normal", &["normal", "n"]),
    (
        "sphere",
        &[
            "sphere",
            "makeshared",
            "makeunique",
            "newsphere",
            "makesphere",
        ],
    ),
    ("ray", &["ray", "newray", "makeray"]),
    ("frontface", &["frontface", "front", "isfrontface"]),
];
/// Functions that say nothing of a value.
const NOTHING: [&str; 16] = [
    "some",
    "unwrap",
    "clone",
    "copy",
    "value",
    "get",
    "makeoptional",
    "optional",
    "todouble",
    "tofloat",
    "expect",
    "borrow",
    "asref",
    "ok",
    "tolist",
    "sharedptr",
];
/// Functions that cut a number off.
const CUT: [&str; 9] = [
    "int",
    "floor",
    "trunc",
    "toint",
    "truncate",
    "uint8",
    "byte",
    "floori",
    "rounddown",
];
const INFINITY: [&str; 8] = [
    "infinity",
    "inf",
    "positiveinfinity",
    "infinite",
    "hugeval",
    "maxvalue",
    "dblmax",
    "inff",
];

/// Returns a name without capitals and `_`; one of a single letter as it is.
pub fn canonical(name: &str) -> String {
    if name.len() < 2 {
        return name.to_owned();
    }
    name.chars()
        .filter(|c| *c != '_')
        .flat_map(char::to_lowercase)
        .collect()
}

/// How far an expression is rewritten.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    /// With signs for functions, fields for functions that return them, and without casts. Its
    /// numbers are computed in the order in which they were.
    Plain,
    /// As what is the same in mathematics.
    Normal,
}

/// Brings an expression into its normal form. Each node stands where it stood.
pub fn normal(tree: &Tree) -> Tree {
    rewritten(tree, Form::Normal)
}

/// Spells an expression with signs for functions, fields for functions that return them, and
/// without casts. Its numbers are computed in the order in which they were.
pub fn plain(tree: &Tree) -> Tree {
    rewritten(tree, Form::Plain)
}

impl Form {
    /// Makes a tree of a sign and its parts.
    fn signed(self, sign: &'static str, parts: Vec<Tree>) -> Tree {
        if self == Self::Normal || matches!(sign, "//" | "|" | "=") {
            return of_sign(sign, parts);
        }
        let op = match sign {
            "neg" => Op::Minus,
            "!" => Op::Not,
            "?" => Op::Choice,
            "vec" => Op::Call(sign.to_owned()),
            _ => Op::Sign(sign),
        };
        Tree::new(op, parts)
    }
}

fn rewritten(tree: &Tree, form: Form) -> Tree {
    let parts: Vec<Tree> = tree.parts.iter().map(|it| rewritten(it, form)).collect();
    of_parts(&tree.op, parts, form).at(tree.at.clone())
}

fn of_parts(op: &Op, mut parts: Vec<Tree>, form: Form) -> Tree {
    match op {
        Op::Name(name) => of_name(name),
        Op::Minus => form.signed("neg", parts),
        Op::Not => form.signed("!", parts),
        Op::Choice => form.signed("?", parts),
        Op::Sign(sign) => form.signed(sign, parts),
        Op::Call(name) => of_call(name, parts, form),
        Op::List if parts.len() == 3 => form.signed("vec", parts),
        Op::Index => match parts[1].value() {
            Some(axis @ (0.0 | 1.0 | 2.0)) => {
                let of = parts.swap_remove(0);
                let of = match (&of.op, &of.parts[..]) {
                    (Op::Call(name), [of]) if name == "e" => of.clone(),
                    (Op::Name(name), _) if name == "e" => name_of("self").at(of.at),
                    _ => of,
                };
                Tree::call(AXES[axis as usize], vec![of])
            }
            _ => Tree::new(Op::Index, parts),
        },
        _ => Tree::new(op.clone(), parts),
    }
}

const AXES: [&str; 3] = ["x", "y", "z"];

fn of_name(name: &str) -> Tree {
    let name = canonical(name);
    match &*name {
        it if INFINITY.contains(&it) => name_of("infinity"),
        "none" | "null" | "nullptr" | "nil" | "nullopt" => name_of("none"),
        "zero" => vector(0.0),
        "one" => vector(1.0),
        "raytmin" => name_of("tmin"),
        "raytmax" => name_of("tmax"),
        _ => name_of(&name),
    }
}

fn name_of(name: &str) -> Tree {
    Tree::new(Op::Name(name.to_owned()), Vec::new())
}

/// Makes the normal form of a sign between parts that are in it.
fn of_sign(sign: &'static str, mut parts: Vec<Tree>) -> Tree {
    let compared = |less: &'static str, parts: Vec<Tree>| below_zero(less, sum(with_minus(parts)));
    match sign {
        "neg" => scaled(-1.0, parts.swap_remove(0)),
        "!" => negated(parts.swap_remove(0)),
        "?" => of_choice(parts),
        "vec" => of_components(parts),
        "+" => sum(parts),
        "-" => sum(with_minus(parts)),
        "*" => product(parts),
        "/" => {
            let divisor = over(parts.remove(1));
            product(vec![parts.remove(0), divisor])
        }
        "<" => compared("<", parts),
        "<=" => compared("<=", parts),
        ">" => compared("<", parts.into_iter().rev().collect()),
        ">=" => compared("<=", parts.into_iter().rev().collect()),
        "!=" => negated(Tree::new(Op::Sign("=="), parts)),
        "&&" | "||" => flat(sign, parts),
        "//" => match (parts[0].value(), parts[1].value()) {
            (Some(one), Some(other)) if other != 0.0 => Tree::number((one / other).floor()),
            _ => Tree::call("//", parts),
        },
        // JavaScript cuts off so.
        "|" if parts[1].value() == Some(0.0) => Tree::call("int", vec![parts.swap_remove(0)]),
        "=" => parts.swap_remove(1),
        _ => Tree::new(Op::Sign(sign), parts),
    }
}

fn with_minus(mut parts: Vec<Tree>) -> Vec<Tree> {
    let last = parts.pop().map(|it| scaled(-1.0, it));
    parts.extend(last);
    parts
}

/// Joins sides that are themselves joined by the sign.
fn flat(sign: &'static str, parts: Vec<Tree>) -> Tree {
    let op = Op::Sign(sign);
    let parts = parts.into_iter().flat_map(|it| match it.op == op {
        true => it.parts,
        false => vec![it],
    });
    Tree::new(Op::Sign(sign), parts.collect())
}

/// `sum < 0` or `sum <= 0`.
fn below_zero(less: &'static str, sum: Tree) -> Tree {
    Tree::new(Op::Sign(less), vec![sum])
}

fn negated(tree: Tree) -> Tree {
    let all = |parts: Vec<Tree>| parts.into_iter().map(negated).collect();
    match (&tree.op, &tree.parts[..]) {
        (Op::Not, [of]) => of.clone(),
        (Op::Sign("<"), [sum]) => below_zero("<=", scaled(-1.0, sum.clone())),
        (Op::Sign("<="), [sum]) => below_zero("<", scaled(-1.0, sum.clone())),
        (Op::Sign("&&"), _) => flat("||", all(tree.parts)),
        (Op::Sign("||"), _) => flat("&&", all(tree.parts)),
        _ => Tree::new(Op::Not, vec![tree]),
    }
}

/// Asks only whether something is below zero, or is.
fn of_choice(parts: Vec<Tree>) -> Tree {
    let swapped = |condition: Tree| {
        Tree::new(
            Op::Choice,
            vec![condition, parts[2].clone(), parts[1].clone()],
        )
    };
    match &parts[0].op {
        Op::Not | Op::Sign("<=") => swapped(negated(parts[0].clone())),
        _ => Tree::new(Op::Choice, parts),
    }
}

/// Multiplies by a number, inside of a sum and of a vector.
fn scaled(factor: f64, tree: Tree) -> Tree {
    let each = |tree: Tree| {
        let parts = tree.parts.into_iter().map(|it| scaled(factor, it));
        Tree {
            parts: parts.collect(),
            ..Tree::new(tree.op, Vec::new())
        }
        .at(tree.at)
    };
    match &tree.op {
        _ if factor == 1.0 => tree,
        Op::Number(value, _) => Tree::number(factor * value).at(tree.at),
        Op::Sign("+") => each(tree),
        Op::Call(name) if name == "vec" => each(tree),
        _ => {
            let at = tree.at.clone();
            product(vec![Tree::number(factor), tree]).at(at)
        }
    }
}

fn sum(parts: Vec<Tree>) -> Tree {
    let (mut terms, mut number): (Vec<Tree>, Option<Tree>) = (Vec::new(), None);
    let flat = parts.into_iter().flat_map(|it| match it.op {
        Op::Sign("+") => it.parts,
        _ => vec![it],
    });
    for term in flat {
        match (term.value(), &number) {
            (Some(value), Some(before)) => {
                number = before
                    .value()
                    .map(|it| Tree::number(it + value).at(term.at));
            }
            (Some(_), None) => number = Some(term),
            _ => terms.push(term),
        }
    }
    terms.extend(number.filter(|it| it.value() != Some(0.0)));
    match terms.len() {
        0 => Tree::number(0.0),
        1 => terms.swap_remove(0),
        _ => Tree::new(Op::Sign("+"), terms),
    }
}

/// A product: its number comes first, if it has one that could not be brought into a sum.
fn product(parts: Vec<Tree>) -> Tree {
    let flat = parts.into_iter().flat_map(|it| match it.op {
        Op::Sign("*") => it.parts,
        _ => vec![it],
    });
    let (numbers, mut factors): (Vec<Tree>, Vec<Tree>) = flat.partition(|it| it.value().is_some());
    let number: f64 = numbers.iter().filter_map(Tree::value).product();
    if factors.is_empty() || number == 0.0 {
        return Tree::number(number);
    }
    let takes = |it: &Tree| it.op == Op::Sign("+") || it.is_call("vec");
    let mut sums = (0..factors.len()).filter(|n| takes(&factors[*n]));
    let only = sums.next().filter(|_| sums.next().is_none());
    match only {
        Some(n) => factors[n] = scaled(number, factors[n].clone()),
        None if number != 1.0 && factors.len() == 1 && factors[0].op == Op::Sign("*") => {}
        None if number != 1.0 => factors.insert(0, Tree::number(number)),
        None => {}
    }
    match factors.len() {
        1 => factors.swap_remove(0),
        _ => Tree::new(Op::Sign("*"), factors),
    }
}

fn over(tree: Tree) -> Tree {
    match (&tree.op, &tree.parts[..]) {
        (Op::Number(value, _), _) => Tree::number(1.0 / value),
        (Op::Over, [of]) => of.clone(),
        (Op::Sign("*"), parts) => product(parts.iter().cloned().map(over).collect()),
        _ => Tree::new(Op::Over, vec![tree]),
    }
}

fn of_call(name: &str, mut parts: Vec<Tree>, form: Form) -> Tree {
    let is_cast = REAL.contains(&name) && parts.len() == 1;
    let name = function(name, parts.len());
    match (&*name, parts.len()) {
        (it, 1) if is_cast || NOTHING.contains(&it) => return parts.swap_remove(0),
        (it, 1) if CUT.contains(&it) || WHOLE.contains(&it) => return Tree::call("int", parts),
        ("+" | "-" | "*" | "/", 2) if !parts[1].is_call("sphere") => {
            let signs = ["+", "-", "*", "/"].into_iter();
            let sign = signs.into_iter().find(|it| *it == name).unwrap_or("+");
            return form.signed(sign, parts);
        }
        ("neg", 1) => return form.signed("neg", parts),
        ("square" | "sqr" | "sq", 1) => {
            return form.signed("*", vec![parts[0].clone(), parts.swap_remove(0)]);
        }
        ("pow" | "powi" | "powf", 2) => match parts[1].value() {
            Some(2.0) => return form.signed("*", vec![parts[0].clone(), parts.swap_remove(0)]),
            Some(0.5) => return Tree::call("sqrt", vec![parts.swap_remove(0)]),
            _ => {}
        },
        ("dot", 2) if parts[0].is_same(&parts[1]) => {
            return Tree::call("lengthsquared", vec![parts.swap_remove(0)]);
        }
        ("vec", 3) => return form.signed("vec", parts),
        ("vec" | "splat", 1) => match parts[0].value() {
            Some(value) => return vector(value),
            None => return parts.swap_remove(0),
        },
        ("zero", 0 | 1) => return vector(0.0),
        ("one", 0 | 1) => return vector(1.0),
        ("infinity", _) => return of_name("infinity"),
        ("min", 1) if is_range(&parts[0]) => return of_name("tmin"),
        ("max", 1) if is_range(&parts[0]) => return of_name("tmax"),
        ("surrounds", 2) => {
            let at = parts[1].clone();
            let low = form.signed("<", vec![of_name("tmin"), at.clone()]);
            return form.signed("&&", vec![low, form.signed("<", vec![at, of_name("tmax")])]);
        }
        _ => {}
    }
    // A range is its two ends; a record that is filled is what is returned elsewhere.
    let mut parts: Vec<Tree> = parts
        .into_iter()
        .flat_map(|it| {
            if it.is_call("interval") {
                it.parts
            } else {
                vec![it]
            }
        })
        .collect();
    let is_record = |it: &Tree| {
        matches!(
            it.name(),
            Some("rec" | "temprec" | "record" | "temp" | "hitrecord")
        )
    };
    if parts.len() > 2 && parts.last().is_some_and(is_record) {
        parts.pop();
    }
    Tree::call(&name, parts)
}

fn is_range(tree: &Tree) -> bool {
    matches!(tree.name(), Some("rayt" | "interval" | "range"))
}

/// Returns what a function of so many parts is called here. Where a language has no methods, the
/// type's name stands before it.
pub(crate) fn function(name: &str, parts: usize) -> String {
    let name = match name.len() {
        1 => name.to_lowercase(),
        _ => canonical(name),
    };
    let short = ["vec3", "vector3", "vec", "v3", "v"].iter();
    let short = short.filter_map(|it| name.strip_prefix(it));
    let mut names = [name.as_str()].into_iter().chain(short);
    let found = names.find_map(|name| known(name, parts));
    found.map_or(name.clone(), str::to_owned)
}

fn known(name: &str, parts: usize) -> Option<&'static str> {
    const FIELDS: [&str; 8] = [
        "origin",
        "direction",
        "x",
        "y",
        "z",
        "point",
        "normal",
        "frontface",
    ];
    let is_it = |(of, names): &&(&str, &[&str])| {
        let fits = match *of {
            "vec" => parts == 3 || parts == 1 && name != "point" && name != "v",
            of if FIELDS.contains(&of) => parts == 1,
            _ => true,
        };
        fits && names.contains(&name)
    };
    FUNCTIONS.iter().find(is_it).map(|(of, _)| *of)
}

fn vector(value: f64) -> Tree {
    Tree::call("vec", vec![Tree::number(value); 3])
}

/// A vector of three parts. If these are one but for x, y and z, it is that of the vectors.
fn of_components(parts: Vec<Tree>) -> Tree {
    let whole = (0..3)
        .map(|n| without_axis(&parts[n], AXES[n]))
        .collect::<Option<Vec<_>>>();
    match whole {
        Some(whole) if whole[0].is_same(&whole[1]) && whole[1].is_same(&whole[2]) => {
            whole[0].clone()
        }
        _ => Tree::call("vec", parts),
    }
}

/// Returns the expression of whole vectors of which this is one component.
fn without_axis(tree: &Tree, axis: &str) -> Option<Tree> {
    if tree.is_call(axis) && tree.parts.len() == 1 {
        return Some(tree.parts[0].clone());
    }
    let inside = |tree: &Tree| {
        tree.nodes()
            .iter()
            .any(|it| AXES.iter().any(|axis| it.is_call(axis)))
    };
    if !inside(tree) {
        return None;
    }
    let each = |it: &Tree| match (it.value(), without_axis(it, axis)) {
        (_, Some(whole)) => Some(whole),
        (Some(value), None) if tree.op == Op::Sign("+") => Some(vector(value)),
        _ if tree.op == Op::Sign("*") && !inside(it) => Some(it.clone()),
        _ => None,
    };
    let is_linear = matches!(tree.op, Op::Sign("+" | "*"));
    let parts = is_linear.then(|| tree.parts.iter().map(each).collect::<Option<Vec<_>>>())??;
    Some(Tree {
        parts,
        ..tree.clone()
    })
}
