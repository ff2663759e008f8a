//! Confusion sets: the words, signs and numbers that people take for one another, each with the
//! rank of such an edit.

/// Operators, each with those that are typed in its place.
const OPERATORS: [(&str, &[(&str, u32)]); 16] = [
    ("+", &[("-", 1), ("*", 5)]),
    ("-", &[("+", 1), ("*", 7)]),
    ("*", &[("/", 2), ("+", 4), ("-", 7)]),
    ("/", &[("*", 2)]),
    ("<", &[(">", 1), ("<=", 3), (">=", 3)]),
    (">", &[("<", 1), (">=", 3), ("<=", 3)]),
    ("<=", &[(">=", 1), ("<", 3), (">", 3)]),
    (">=", &[("<=", 1), (">", 3), ("<", 3)]),
    ("==", &[("!=", 2)]),
    ("!=", &[("==", 2)]),
    ("&&", &[("||", 1)]),
    ("||", &[("&&", 1)]),
    ("+=", &[("-=", 2), ("=", 5), ("*=", 5)]),
    ("-=", &[("+=", 2), ("=", 5)]),
    ("*=", &[("/=", 3), ("+=", 4), ("=", 5)]),
    ("/=", &[("*=", 3)]),
];

/// Names of fields and methods. Those of the first three groups are the axes of a vector.
const WORDS: [(u32, &[&str]); 14] = [
    (3, &["x", "y", "z"]),
    (3, &["r", "g", "b"]),
    (3, &["0", "1", "2"]),
    (3, &["u", "v"]),
    (3, &["origin", "direction"]),
    (4, &["point", "normal"]),
    (3, &["length", "length_squared"]),
    (3, &["norm", "norm_squared"]),
    (3, &["min", "max"]),
    (3, &["min_by", "max_by"]),
    (4, &["floor", "round", "ceil", "trunc"]),
    (4, &["sin", "cos", "tan"]),
    (4, &["next", "last"]),
    (5, &["any", "all"]),
];

/// Methods without arguments that are forgotten.
pub(crate) const FORGOTTEN: [(&str, u32); 5] = [
    ("sqrt", 4),
    ("normalize", 4),
    ("length", 6),
    ("length_squared", 6),
    ("abs", 6),
];

/// Factors that are forgotten.
pub(crate) const FACTORS: [&str; 3] = ["2.0", "0.5", "4.0"];

/// Values that stand for a missing bound.
pub(crate) const BOUNDS: [&str; 2] = ["f64::INFINITY", "f32::INFINITY"];

/// Numbers that are typed in the place of another.
const NUMBERS: [f64; 11] = [0.0, 1.0, 0.5, 2.0, 4.0, -1.0, 3.0, 0.1, 0.3, 0.7, 1e-3];

/// Numbers that are typed in the place of another from 255 on: factors of a color.
const LEVELS: [f64; 5] = [255.0, 255.5, 255.99, 255.999, 256.0];

/// Whole numbers that are typed in the place of another.
const WHOLE_NUMBERS: [i64; 5] = [0, 1, 2, 255, 256];

/// Returns the operators that are typed in the place of `operator`.
pub(crate) fn operators(operator: &str) -> &'static [(&'static str, u32)] {
    let found = OPERATORS.iter().find(|it| it.0 == operator);
    found.map_or(&[], |it| it.1)
}

/// Returns the names that are typed in the place of a field or method.
pub(crate) fn words(word: &str) -> impl Iterator<Item = (&'static str, u32)> {
    let groups = WORDS.iter().filter(move |it| it.1.contains(&word));
    groups.flat_map(|(rank, group)| group.iter().map(move |it| (*it, *rank)))
}

/// Returns the name of an axis that stands for `word` on another `axis`, from 0: `y` for `x` on
/// axis 1. `None` if the word is no first axis.
pub(crate) fn on_axis(word: &str, axis: usize) -> Option<&'static str> {
    let group = WORDS[..3].iter().find(|it| it.1[0] == word);
    group.map(|it| it.1[axis])
}

/// Returns the numbers that are typed in the place of `number`, which is not negative.
pub(crate) fn numbers(number: f64) -> impl Iterator<Item = (f64, u32)> {
    let near = [
        -number,
        2.0 * number,
        number / 2.0,
        number + 1.0,
        number - 1.0,
    ];
    let far = [
        10.0 * number,
        number / 10.0,
        number.trunc(),
        number + 0.5,
        number - 0.5,
    ];
    let usual = if number < 255.0 {
        &NUMBERS[..]
    } else {
        &LEVELS
    };
    let others = far.into_iter().chain(usual.iter().copied());
    let all = near
        .map(|it| (it, 4))
        .into_iter()
        .chain(others.map(|it| (it, 5)));
    // A zero has no sign.
    all.filter(move |it| it.0 != number)
        .map(|it| (it.0 + 0.0, it.1))
}

/// Returns the whole numbers that are typed in the place of `number`.
pub(crate) fn whole_numbers(number: i64) -> impl Iterator<Item = i64> {
    let near = [
        number.saturating_add(1),
        number - 1,
        number.saturating_mul(2),
    ];
    near.into_iter()
        .chain(WHOLE_NUMBERS)
        .filter(move |it| *it != number)
}

/// Returns how firmly an operator binds its sides: 0 for an assignment, 5 for `*`.
pub(crate) fn level(operator: &str) -> u32 {
    match operator {
        "*" | "/" | "%" => 5,
        "+" | "-" => 4,
        "<" | ">" | "<=" | ">=" | "==" | "!=" => 3,
        "&&" => 2,
        "||" => 1,
        _ => 0,
    }
}
