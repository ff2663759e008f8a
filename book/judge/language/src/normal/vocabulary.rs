//! Synonyms: the names that functions, fields and constants have in other programs.

/// Types of whole numbers.
pub(crate) const WHOLE: &str =
    "int i32 u32 i64 u64 usize u8 size_t Int long unsigned short uint8 byte int64 uint";

/// Types of real numbers, and functions that only turn a number into a real one.
pub(crate) const REAL: &str = "double float f64 f32 float64 float32 Double Float real Number";

/// Each function, method or field by its canonical name, with its other canonical names.
const FUNCTIONS: [(&str, &str); 23] = [
    (
        "unit",
        "unitvector unit normalize normalized normalise normalised unitize",
    ),
    ("length", "length len norm mag magnitude hypot"),
    (
        "lengthsquared",
        "lengthsquared squaredlength lengthsq lensq length2 len2 normsquared lensquared norm2 \
         magsq magnitudesquared squarednorm",
    ),
    ("dot", "dot dotproduct inner vdot dotp"),
    ("abs", "abs fabs"),
    ("sqrt", "sqrt squareroot"),
    ("+", "add plus vadd added"),
    ("-", "sub minus subtract vsub subtracted difference"),
    (
        "*",
        "scale mul times multiply vmul muls scaled vscale multiplied mulscalar smul",
    ),
    ("/", "div divide divided vdiv divs divscalar"),
    (
        "neg",
        "neg negate negated negative unaryminus vneg opposite",
    ),
    (
        "vec",
        "vec3 vec vector vector3 point3 point color colour v3 vec3d dvec3 float3 double3 rgb \
         array p3 col v vec3f newvec3 makevec3 color3 mkvec v3new",
    ),
    ("origin", "origin orig o org getorigin"),
    ("direction", "direction dir d getdirection"),
    ("at", "at pointat pointatparameter along position"),
    ("x", "x getx r red"),
    ("y", "y gety g green"),
    ("z", "z getz b blue"),
    ("point", "point p pos"),
    ("normal", "normal n"),
    (
        "sphere",
        "sphere makeshared makeunique newsphere makesphere",
    ),
    ("ray", "ray newray makeray"),
    ("frontface", "frontface front isfrontface"),
];

/// The functions in [`FUNCTIONS`] that are fields elsewhere, and so have one argument.
const FIELDS: &str = "origin direction x y z point normal frontface";

/// Functions of one argument that return it unchanged, as far as these chapters care.
const IDENTITIES: &str = "some unwrap clone copy value get makeoptional optional todouble tofloat \
                          expect borrow asref ok tolist sharedptr";

/// Functions that drop the digits behind the point.
const ROUNDING_DOWN: &str = "int floor trunc toint truncate uint8 byte floori rounddown";

/// Names of the infinite number.
const INFINITY: &str = "infinity inf positiveinfinity infinite hugeval maxvalue dblmax inff";

/// Returns true if the word is one of those of a list with blanks between them.
pub(crate) fn is_in(list: &str, word: &str) -> bool {
    list.split(' ').any(|it| it == word)
}

/// Returns true if a function of one argument with this canonical name returns the argument.
pub(super) fn is_identity(name: &str) -> bool {
    is_in(IDENTITIES, name)
}

/// Returns true if a function with this canonical name drops the digits behind the point.
pub(super) fn rounds_down(name: &str) -> bool {
    is_in(ROUNDING_DOWN, name) || is_in(WHOLE, name)
}

/// Returns true if this canonical name means the infinite number.
pub(super) fn is_infinity(name: &str) -> bool {
    is_in(INFINITY, name)
}

/// Returns an identifier in lower case and without `_`, so that `unit_vector` and `unitVector` both
/// become `unitvector`. An identifier of one letter stays as it is.
pub fn canonical(name: &str) -> String {
    if name.len() < 2 {
        return name.to_owned();
    }
    name.chars()
        .filter(|c| *c != '_')
        .flat_map(char::to_lowercase)
        .collect()
}

/// Returns the name in [`FUNCTIONS`] of a function with so many arguments, its object counted
/// too, or its canonical name if there is none. A type's name before it, as in C's `vec3_dot`, is
/// dropped.
pub(crate) fn function(name: &str, arguments: usize) -> String {
    let name = match name.len() {
        1 => name.to_lowercase(),
        _ => canonical(name),
    };
    let short = ["vec3", "vector3", "vec", "v3", "v"].iter();
    let short = short.filter_map(|it| name.strip_prefix(it));
    let mut names = [name.as_str()].into_iter().chain(short);
    let found = names.find_map(|name| known(name, arguments));
    found.map_or(name.clone(), str::to_owned)
}

/// Finds a function in [`FUNCTIONS`] by one of its names and the number of its arguments.
fn known(name: &str, arguments: usize) -> Option<&'static str> {
    let is_it = |(of, names): &&(&str, &str)| {
        let fits = match *of {
            "vec" => arguments == 3 || arguments == 1 && name != "point" && name != "v",
            of => !is_in(FIELDS, of) || arguments == 1,
        };
        fits && is_in(names, name)
    };
    FUNCTIONS.iter().find(is_it).map(|(of, _)| *of)
}
