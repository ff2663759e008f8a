//! Catastrophic cancellation, digit by digit: what D and t of a ray are made of.

use speed_vs_accuracy::{Case, Method, exact_discriminant};

use crate::decimal::{PLACES, agreeing, exponent, places};
use crate::prelude::*;

/// The numbers that `half_b` computes for a ray, beside the exact ones: how cancellation in the
/// discriminant D = h² − a·c takes digits away.
pub(crate) struct Numbers {
    /// h², rounded.
    h_squared: f64,
    /// a·c, rounded.
    ac: f64,
    /// D as `half_b` computes it.
    pub(crate) discriminant: f64,
    /// D, correct to an ulp.
    pub(crate) exact_discriminant: f64,
    /// The root that `half_b` finds, or `None` for a miss.
    pub(crate) t: Option<f64>,
    /// The true root, rounded once, or `None` for a miss.
    pub(crate) exact_t: Option<f64>,
}

impl Numbers {
    /// Computes the numbers for a `case`, whose ray has to start outside of the sphere.
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

    /// Counts the leading digits that h² and a·c have in common.
    pub(crate) fn agreeing(&self) -> usize {
        let [one, other] = [self.h_squared, self.ac].map(|it| places(it, self.first()));
        agreeing(&one, &other)
    }

    /// Counts the leading digits of t that are right; returns `None` unless `half_b` and the exact
    /// answer both are hits.
    pub(crate) fn right_digits(&self) -> Option<usize> {
        let (t, exact) = (self.t?, self.exact_t?);
        let first = exponent(t).max(exponent(exact));
        Some(agreeing(&places(t, first), &places(exact, first)))
    }

    /// Returns the error of D, relative to the exact D.
    pub(crate) fn error(&self) -> f64 {
        ((self.discriminant - self.exact_discriminant) / self.exact_discriminant).abs()
    }

    /// Draws six rows of digits: h², a·c, D, the exact D, t and the exact t.
    pub(crate) fn draw(&self, svg: &mut Svg) {
        let first = self.first();
        let row = |y, name, x| DigitRow { y, name, x, first };
        let struck = [("faint struck", self.agreeing()), ("ink", PLACES)];
        row(298.0, "*h*²", self.h_squared).draw(svg, &struck);
        row(317.0, "*ac*", self.ac).draw(svg, &struck);
        let [zeros, right, exact_zeros] = self.digits_of_discriminant();
        let found = row(336.0, "*D*", self.discriminant);
        found.draw(svg, &[("faint", zeros), (RIGHT, right), (WRONG, PLACES)]);
        let exact = row(355.0, "exactly", self.exact_discriminant);
        exact.draw(svg, &[("faint", exact_zeros), ("ink", PLACES)]);
        for DigitRow { y, x, .. } in [found, exact] {
            let words = format!("= {}", printed(x));
            svg.small_label("ink", spot(290.0, y), Start, &words);
        }
        self.draw_roots(svg);
    }

    fn draw_roots(&self, svg: &mut Svg) {
        let roots = [self.t, self.exact_t];
        let first = roots.into_iter().flatten().map(exponent).max();
        let right = self.right_digits().unwrap_or(0);
        let judged = [(RIGHT, right), (WRONG, PLACES)];
        let rows = [
            (383.0, "*t*", &judged[..]),
            (402.0, "exactly", &[("ink", PLACES)]),
        ];
        for ((y, name, classes), t) in rows.into_iter().zip(roots) {
            match (t, first) {
                (Some(x), Some(first)) => DigitRow { y, name, x, first }.draw(svg, classes),
                _ => {
                    svg.label("ink", spot(65.0, y), End, name);
                    svg.label("ink", spot(84.0, y), Start, "no hit");
                }
            }
        }
    }

    /// Returns three lengths in the digits of D: of the zeros that should be there, of these with
    /// the right digits behind them, and of all zeros of the exact D.
    fn digits_of_discriminant(&self) -> [usize; 3] {
        let both = [self.discriminant, self.exact_discriminant];
        let [found, exact] = both.map(|it| places(it, self.first()));
        let shared = zeros(&found).min(zeros(&exact));
        let has_right_sign = self.discriminant * self.exact_discriminant > 0.0;
        let right = if has_right_sign {
            agreeing(&found, &exact)
        } else {
            shared
        };
        [shared, right, zeros(&exact)]
    }

    /// Returns the power of ten of the first digit that is drawn: that of the larger one of h² and
    /// a·c. D is less than h², because c is positive here.
    fn first(&self) -> i32 {
        exponent(self.h_squared).max(exponent(self.ac))
    }
}

const RIGHT: &str = "certain vector";
const WRONG: &str = "wrong underlined";

/// A row of digits: a number's name and its digits, from the place of ten to the power `first` on.
#[derive(Clone, Copy)]
struct DigitRow {
    y: f64,
    name: &'static str,
    x: f64,
    first: i32,
}

impl DigitRow {
    /// Draws the digits in stretches: each class holds from the end of the last one up to its
    /// digit.
    fn draw(&self, svg: &mut Svg, classes: &[(&str, usize)]) {
        let at = spot(84.0, self.y);
        svg.label("ink", at.right(-19.0), End, self.name);
        if self.x < 0.0 {
            svg.label("ink", at.right(-3.0), End, "−");
        }
        let mut digits = places(self.x, self.first);
        digits.insert(1, '.');
        let mut from = 0;
        let stretches = classes.iter().map(|&(class, to)| {
            // The point follows the first digit.
            let to = if to == 0 { 0 } else { to + 1 }.max(from);
            let start = std::mem::replace(&mut from, to);
            (class, &digits[start..to])
        });
        svg.digits(at, &stretches.collect::<Vec<_>>());
        let words = format!("· {}", power_of_ten(self.first));
        svg.small_label("ink", at.right(160.0), Start, &words);
    }
}

/// Counts the leading zeros of these digits.
fn zeros(digits: &str) -> usize {
    digits.bytes().take_while(|digit| *digit == b'0').count()
}
