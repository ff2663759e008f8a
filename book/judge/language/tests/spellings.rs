//! Equivalence: expressions of one meaning in ten languages have one normal form, others have not.

use language::{FunctionSize, Language, Pattern, Role, normal, statements};

fn value(text: &str, language: Language) -> language::Tree {
    let all = statements(text, language);
    let all: Vec<_> = all.into_iter().collect();
    assert!(!all.is_empty(), "{text} is not read");
    normal(&all[0].value)
}

/// A line of Rust, and the same in other languages.
const SAME: &[(&str, &[(Language, &str)])] = &[
    (
        "let oc = center - ray.origin;",
        &[
            (Language::Cpp, "vec3 oc = center - r.origin();"),
            (Language::Python, "oc = center - r.origin"),
            (Language::JavaScript, "const oc = sub(center, r.orig)"),
            (
                Language::JavaScript,
                "const oc = this.center.minus(ray.origin);",
            ),
            (Language::Java, "Vec3 oc = center.sub(r.origin());"),
            (
                Language::CSharp,
                "var oc = Vector3.Subtract(center, r.Origin);",
            ),
            (Language::Go, "oc := center.Sub(r.Origin)"),
            (Language::Kotlin, "val oc = center - r.origin"),
            (Language::Swift, "let oc = center - r.origin"),
            (Language::C, "vec3 oc = vec3_sub(center, r.orig);"),
        ],
    ),
    (
        "let h = ray.direction.dot(oc);",
        &[
            (Language::Cpp, "double h = dot(r.direction(), oc);"),
            (Language::Python, "h = np.dot(oc, r.dir)"),
            (Language::Go, "h := Dot(r.Direction, oc)"),
            (Language::Java, "double h = Vec3.dot(r.direction(), oc);"),
        ],
    ),
    (
        "let root = (-b - discriminant.sqrt()) / (2.0 * a);",
        &[
            (Language::Python, "t = (-b - math.sqrt(disc)) / (2 * a)"),
            (Language::Python, "t = 0.5 * (-b - disc ** 0.5) / a"),
            (Language::Cpp, "auto t = (-b - std::sqrt(disc)) / (2.0*a);"),
            (
                Language::JavaScript,
                "const t = -(b + Math.sqrt(disc)) / 2 / a;",
            ),
            (
                Language::Swift,
                "let t = (-b - disc.squareRoot()) / (2 * a)",
            ),
        ],
    ),
    (
        "let wrong = (-b - discriminant.sqrt()) / 2.0 * a;",
        &[(Language::Python, "t = (-b - math.sqrt(disc)) * 0.5 * a")],
    ),
    (
        "let color = 0.5 * (normal + Vec3::ONE);",
        &[
            (
                Language::Cpp,
                "auto c = 0.5*color(N.x()+1, N.y()+1, N.z()+1);",
            ),
            (
                Language::Python,
                "c = Vec3(0.5*n[0] + 0.5, 0.5*(n[1]+1), (n[2]+1)/2)",
            ),
            (
                Language::JavaScript,
                "let c = scale(add(n, vec3(1, 1, 1)), 0.5);",
            ),
            (Language::Go, "c := n.Add(Vec3{1, 1, 1}).Mul(0.5)"),
            (Language::Kotlin, "val c = (n + Vec3(1.0, 1.0, 1.0)) * 0.5"),
        ],
    ),
    (
        "let d = b * b - 4.0 * a * c;",
        &[
            (Language::Python, "d = b**2 - 4*a*c"),
            (Language::Cpp, "double d = b*b - 4*a*c;"),
            (
                Language::Java,
                "final double d = Math.pow(b, 2) - 4 * a * c;",
            ),
        ],
    ),
    (
        "let a = 0.5 * (unit_direction.y + 1.0);",
        &[
            (Language::Cpp, "auto a = 0.5*(unit_direction.y() + 1.0);"),
            (Language::Cpp, "auto a = 0.5*(unit_direction.e[1] + 1.0);"),
            (Language::CSharp, "double a = (unitDirection.Y + 1) / 2;"),
        ],
    ),
    (
        "let w = f64::from(image_width) / f64::from(image_height);",
        &[
            (Language::Python, "w = image_width / image_height"),
            (
                Language::Cpp,
                "int image_width = 400; int image_height = 225; w = double(image_width)/image_height;",
            ),
        ],
    ),
];

#[test]
fn what_means_the_same_is_the_same_in_each_language() {
    for (rust, others) in SAME {
        let right = statements(rust, Language::Rust);
        for (language, text) in *others {
            let pattern = Pattern::new(&right[0].value, [].into());
            let all = statements(text, *language);
            let last = all.last().unwrap_or_else(|| panic!("{text} is not read"));
            let found = normal(&last.value);
            assert!(
                pattern.find(&found).is_some(),
                "{text}\n{:?}\n{found:?}",
                pattern.tree()
            );
        }
    }
}

#[test]
fn what_does_not_mean_the_same_is_not_the_same() {
    for (one, other) in [
        ("center - r.origin", "r.origin - center"),
        ("(-b - sqrt(d)) / (2 * a)", "(-b - sqrt(d)) / 2 * a"),
        ("-b - sqrt(d) / a", "(-b - sqrt(d)) / a"),
        ("b * b - 4 * a * c", "b * b + 4 * a * c"),
        ("t > 0", "t < 0"),
        ("d < 0", "d <= 0"),
        ("w / h", "w // h"),
        (
            "vec3(n.x + 1, n.y + 1, n.z + 1)",
            "vec3(n.x + 1, n.z + 1, n.y + 1)",
        ),
        ("length(d)", "length_squared(d)"),
    ] {
        let [one, other] = [one, other].map(|it| value(it, Language::Python));
        assert!(!one.is_same(&other), "{one:?}\n{other:?}");
    }
}

#[test]
fn a_line_of_rust_is_printed_in_other_languages() {
    for (language, rust, printed) in [
        (
            Language::Cpp,
            "(-h - discriminant.sqrt()) / a",
            "(-h - sqrt(discriminant)) / a",
        ),
        (
            Language::Python,
            "oc = center - ray.origin",
            "oc = center - r.origin",
        ),
        (
            Language::Cpp,
            "let h = ray.direction.dot(oc);",
            "h = dot(r.direction(), oc);",
        ),
        (
            Language::Python,
            "t_min < t && t < t_max",
            "t_min < t and t < t_max",
        ),
        (Language::Cpp, "f64::from(i) / last", "double(i) / last"),
        (Language::Python, "f64::from(i / last)", "i // last"),
        (
            Language::Cpp,
            "0.5 * (record.normal + Vec3::ONE)",
            "0.5 * (rec.normal + vec3(1.0, 1.0, 1.0))",
        ),
        (
            Language::Cpp,
            "if discriminant < 0.0 {",
            "if (discriminant < 0.0) {",
        ),
    ] {
        assert_eq!(language.translate_line(rust), printed, "{rust}");
    }
}

#[test]
fn statements_are_read_with_what_they_are_there_for() {
    let text = "
function hit(center, radius, r) {
  const oc = sub(center, r.o)
  if (disc < 0) return null
  for (let k = 0; k < 3; k++) { world.add(sphere(vec3(0, 0, -1), 0.5)) }
  return { t: (h - Math.sqrt(disc)) / a, p: r.at(t) }
}
";
    let all = statements(text, Language::JavaScript);
    let roles: Vec<&Role> = all.iter().map(|it| &it.role).collect();
    let given = |name: &str| Role::ValueOf(name.to_owned());
    for role in [
        given("oc"),
        Role::Condition,
        Role::Result,
        given("t"),
        given("p"),
        Role::Effect,
    ] {
        assert!(roles.contains(&&role), "{role:?} is not in {roles:?}");
    }
}

#[test]
fn a_function_in_a_comment_is_none() {
    let text = "// pub fn hit() -> bool { true }\nfn sky() {} // fn none() {}";
    assert_eq!(
        language::function_sizes(text),
        [FunctionSize {
            name: "sky",
            tokens: 5
        }]
    );
}
