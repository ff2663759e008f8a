//! Witnesses: the pixels of the book's picture at which t is farthest off, and how far
//! off the rule "the error over the slope" says that it will be.

use figures::records::Worst;
use figures::table::Table;
use laws::oracle::Exact;
use speed_vs_accuracy::{Case, Method};

use crate::population;

/// Where `cargo bench -p measure --bench accuracy` found the largest error of each.
const PIXELS: [(&str, Method, [u32; 2]); 4] = [
    ("ball", Method::HALF_B, [1435, 1472]),
    ("ball", Method::HALF_B_Q, [1435, 1472]),
    ("ground", Method::HALF_B_Q, [3236, 1240]),
    ("ground", Method::CROSS_Q, [2923, 1217]),
];

/// The error at each of these pixels, and what the rule says.
pub fn table() -> Table<Worst> {
    let rows = PIXELS.map(|(sphere, method, [column, row])| {
        let case = population::pixel(sphere, column, row);
        let exact = Exact::of(&case);
        let root = exact.nearer_root().expect("the pixel shows the sphere");
        let t = case.put_to(&method, 0.0, f64::INFINITY).expect("a hit");
        let sqrt_d = (exact.discriminant_margin() * case.a() * case.m()).sqrt();
        let ulp = root.rounded().next_up() - root.rounded();
        Worst {
            sphere: sphere.to_owned(),
            method: method.name.to_owned(),
            column,
            row,
            sqrt_d,
            ulps: root.error_in_ulps(t),
            rule_ulps: error_over_slope(&case, sqrt_d) / ulp,
        }
    });
    rows.to_vec().into()
}

/// u·M / 2√D.
fn error_over_slope(case: &Case, sqrt_d: f64) -> f64 {
    0.5 * f64::EPSILON * case.m() / (2.0 * sqrt_d)
}
