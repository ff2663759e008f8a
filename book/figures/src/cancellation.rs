//! Catastrophic cancellation, digit by digit: what D and t of a ray are made of.

use speed_vs_accuracy::{Case, Method, exact_discriminant};

use crate::decimal::{PLACES, agreeing, exponent, places};
use crate::vocabulary::*;

/// What is computed for a ray, and what is right.
pub(crate) struct Numbers {
    /// h², rounded.
    pub(crate) h_squared: f64,
    /// a·c, rounded.
    pub(crate) ac: f64,
    /// D, as `half_b` has it.
    pub(crate) discriminant: f64,
    /// D, to within an ulp.
    pub(crate) exact_discriminant: f64,
    /// The root that `half_b` finds.
    pub(crate) t: Option<f64>,
    /// The root, rounded once.
    pub(crate) exact_t: Option<f64>,
}

impl Numbers {
    /// The numbers of a `case` with finite numbers, seen from outside.
    pub(crate) fn of(case: &Case) -> Self {
        let nearest = |method| case.put_to(method, 0.0, f64::INFINITY);
        let exact_discriminant = exact_discriminant(case.center, case.radius, &case.ray);
        Self {
            h_squared: case.h() * case.h(),
            ac: case.a() * case.c(),
            discriminant: case.discriminant(),
            exact_discriminant: exact_discriminant.expect("finite numbers"),
            t: nearest(&Method::HALF_B),
            exact_t: nearest(&Method::EXACT),
        }
    }

    /// In how many digits h² and a·c agree.
    pub(crate) fn agreeing(&self) -> usize {
        let [one, other] = self.aligned([self.h_squared, self.ac]);
        agreeing(&one, &other)
    }

    /// How many digits of t are right, if there is one and should be.
    pub(crate) fn right_digits(&self) -> Option<usize> {
        let (t, exact) = (self.t?, self.exact_t?);
        let first = exponent(t).max(exponent(exact));
        Some(agreeing(&places(t, first), &places(exact, first)))
    }

    /// How far off D is, in sizes of D; 0 if it is right.
    pub(crate) fn error(&self) -> f64 {
        let off = (self.discriminant - self.exact_discriminant).abs();
        match off {
            0.0 => 0.0,
            _ => off / self.exact_discriminant.abs(),
        }
    }

    /// Draws six rows: how D comes about and what it should be, then t and what it should
    /// be.
    pub(crate) fn draw(&self, svg: &mut Svg) {
        self.draw_discriminant(svg);
        let exponent_of = |t: Option<f64>| t.map_or(i32::MIN, exponent);
        let first = exponent_of(self.t).max(exponent_of(self.exact_t));
        let right = self.right_digits().unwrap_or(0);
        let judged = [(RIGHT, right), (WRONG, PLACES)];
        for (n, name, t, classes) in [
            (4, "*t*", self.t, &judged[..]),
            (5, "exactly", self.exact_t, &[("ink", PLACES)]),
        ] {
            let at = name_row(svg, n, name);
            match t {
                Some(t) => draw_number(svg, at, (t, first), classes),
                None => svg.label("ink", at, Start, "no hit"),
            }
        }
    }

    fn draw_discriminant(&self, svg: &mut Svg) {
        let struck = [("faint struck", self.agreeing()), ("ink", PLACES)];
        let [zeros, right, exact_zeros] = self.digits_of_discriminant();
        let judged = [("faint", zeros), (RIGHT, right), (WRONG, PLACES)];
        let judge = [("faint", exact_zeros), ("ink", PLACES)];
        for (n, name, x, classes) in [
            (0, "*h*²", self.h_squared, &struck[..]),
            (1, "*ac*", self.ac, &struck),
            (2, "*D*", self.discriminant, &judged),
            (3, "exactly", self.exact_discriminant, &judge),
        ] {
            let at = name_row(svg, n, name);
            draw_number(svg, at, (x, self.first()), classes);
        }
        for (n, value) in [(2, self.discriminant), (3, self.exact_discriminant)] {
            let beside = digits_of_row(n) + DVec2::new(206.0, 0.0);
            let words = format!("= {}", printed(value));
            svg.small_label("ink", beside, Start, &words);
        }
    }

    /// Before which place there are only zeros that D should have too, before which one its
    /// digits are right, and before which one there are only zeros in the exact D.
    fn digits_of_discriminant(&self) -> [usize; 3] {
        let [found, exact] = self.aligned([self.discriminant, self.exact_discriminant]);
        let shared = zeros(&found).min(zeros(&exact));
        let has_right_sign = self.discriminant * self.exact_discriminant > 0.0;
        let right = if has_right_sign {
            agreeing(&found, &exact)
        } else {
            shared
        };
        [shared, right, zeros(&exact)]
    }

    /// Digits one below the other, from the first place of the largest on.
    fn aligned<const N: usize>(&self, numbers: [f64; N]) -> [String; N] {
        numbers.map(|number| places(number, self.first()))
    }

    /// The exponent of that place. D has none before it, because c is positive here.
    fn first(&self) -> i32 {
        exponent(self.h_squared).max(exponent(self.ac))
    }
}

const RIGHT: &str = "certain vector";
const WRONG: &str = "wrong underlined";

/// A number from the place of 10 to the power `first` on; its digits are of these classes,
/// each up to some place.
fn draw_number(svg: &mut Svg, at: DVec2, (x, first): (f64, i32), classes: &[(&str, usize)]) {
    if x < 0.0 {
        svg.label("ink", at - DVec2::new(3.0, 0.0), End, "−");
    }
    let digits = places(x, first);
    let mut spans = Vec::new();
    let mut from = 0;
    for &(class, to) in classes {
        let to = to.max(from);
        spans.push((class, &digits[from..to]));
        from = to;
    }
    svg.digits(at, &spans);
    let beside = at + DVec2::new(160.0, 0.0);
    let words = format!("· 10{}", raised(first));
    svg.small_label("ink", beside, Start, &words);
}

/// Where the digits of the row `n` begin.
fn digits_of_row(n: u8) -> DVec2 {
    // Between D and t there is a gap.
    DVec2::new(84.0, 298.0 + 19.0 * f64::from(n) + 9.0 * f64::from(n / 4))
}

/// Names the row `n`; returns where its digits begin.
fn name_row(svg: &mut Svg, n: u8, name: &str) -> DVec2 {
    let at = digits_of_row(n);
    svg.label("ink", at - DVec2::new(19.0, 0.0), End, name);
    at
}

/// How many zeros come first.
fn zeros(digits: &str) -> usize {
    digits.bytes().take_while(|digit| *digit == b'0').count()
}
