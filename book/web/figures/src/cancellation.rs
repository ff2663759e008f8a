//! Catastrophic cancellation, digit by digit: what D and t of a ray are made of.

use speed_vs_accuracy::{Case, Method, exact_discriminant};

use crate::decimal::{PLACES, agreeing, exponent, places};
use crate::prelude::*;

/// Two numbers whose difference is D, as a method rounds them.
#[derive(Clone, Copy)]
pub(crate) struct Terms {
    /// What a reader calls them.
    pub(crate) names: [&'static str; 2],
    values: [f64; 2],
}

impl Terms {
    /// Computes h² and a·c, as `half_b` and `half_b_q` do.
    pub(crate) fn of_half_b(case: &Case) -> Self {
        Self {
            names: ["*h*²", "*ac*"],
            values: [case.h() * case.h(), case.a() * case.c()],
        }
    }

    /// Computes a·r² and a·l² = |d × oc|², as `cross_q` does.
    pub(crate) fn of_cross_q(case: &Case) -> Self {
        let oc = case.center - case.ray.origin;
        let across = case.ray.direction.cross(oc);
        Self {
            names: ["*ar*²", "*al*²"],
            values: [
                case.a() * (case.radius * case.radius),
                across.length_squared(),
            ],
        }
    }

    /// Counts the leading digits that the two have in common.
    pub(crate) fn agreeing(&self) -> usize {
        let [one, other] = self.values.map(|it| places(it, self.first()));
        agreeing(&one, &other)
    }

    /// Computes D from the two.
    pub(crate) fn difference(&self) -> f64 {
        self.values[0] - self.values[1]
    }

    /// Returns the power of ten of the first digit that is drawn: that of the larger one. Neither
    /// is negative, so D is not larger.
    fn first(&self) -> i32 {
        let [one, other] = self.values.map(exponent);
        one.max(other)
    }
}

/// How a method comes to D.
pub(crate) enum Discriminant {
    /// As the difference of two numbers.
    Difference(Terms),
    /// With all its digits, as these words tell.
    Whole(&'static str),
}

/// The numbers that a method computes for a ray, beside the exact ones: how cancellation in the
/// discriminant D takes digits away.
pub(crate) struct Numbers {
    /// D, as the method computes it.
    pub(crate) discriminant: Discriminant,
    /// D, correct to an ulp.
    pub(crate) exact_discriminant: f64,
    /// The root that the method finds, or `None` for a miss.
    pub(crate) t: Option<f64>,
    /// The true root, rounded once, or `None` for a miss.
    pub(crate) exact_t: Option<f64>,
}

impl Numbers {
    /// Computes the numbers for a `case`, whose ray has to start outside of the sphere, by a
    /// `method` and its way to D.
    pub(crate) fn of(case: &Case, method: Method, discriminant: Discriminant) -> Self {
        let nearest = |method| case.put_to(method, 0.0, f64::INFINITY);
        let exact_discriminant = exact_discriminant(case.center, case.radius, &case.ray);
        Self {
            discriminant,
            exact_discriminant: exact_discriminant.expect("finite numbers"),
            t: nearest(&method),
            exact_t: nearest(&Method::EXACT),
        }
    }

    /// Counts the leading digits of t that are right; returns `None` unless the method and the
    /// exact answer both are hits.
    pub(crate) fn right_digits(&self) -> Option<usize> {
        let (t, exact) = (self.t?, self.exact_t?);
        let first = exponent(t).max(exponent(exact));
        Some(agreeing(&places(t, first), &places(exact, first)))
    }

    /// Draws six rows of digits: the two terms, D, the exact D, t and the exact t.
    pub(crate) fn draw(&self, svg: &mut Svg) {
        let x = self.exact_discriminant;
        let (name, first) = match &self.discriminant {
            Discriminant::Difference(terms) => {
                self.draw_difference(svg, terms);
                ("exactly", terms.first())
            }
            Discriminant::Whole(words) => {
                svg.small_label("ink", spot(200.0, 317.0), Middle, words);
                ("*D* exactly", exponent(x))
            }
        };
        let [_, _, zeros] = self.digits_of_discriminant(x, first);
        let y = 355.0;
        let exact = DigitRow { y, name, x, first };
        exact.draw(svg, &[("faint", zeros), ("ink", PLACES)]);
        exact.draw_value(svg);
        self.draw_roots(svg);
    }

    /// Draws the two terms, the digits in which they agree struck out, and D.
    fn draw_difference(&self, svg: &mut Svg, terms: &Terms) {
        let first = terms.first();
        let row = |y, name, x| DigitRow { y, name, x, first };
        let struck = [("faint struck", terms.agreeing()), ("ink", PLACES)];
        row(298.0, terms.names[0], terms.values[0]).draw(svg, &struck);
        row(317.0, terms.names[1], terms.values[1]).draw(svg, &struck);
        let discriminant = terms.difference();
        let [zeros, right, _] = self.digits_of_discriminant(discriminant, first);
        let found = row(336.0, "*D*", discriminant);
        found.draw(svg, &[("faint", zeros), (RIGHT, right), (WRONG, PLACES)]);
        found.draw_value(svg);
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

    /// Returns three lengths in the digits of a `discriminant`, from the place of ten to the power
    /// `first` on: of the zeros that should be there, of these with the right digits behind them,
    /// and of all zeros of the exact D.
    fn digits_of_discriminant(&self, discriminant: f64, first: i32) -> [usize; 3] {
        let both = [discriminant, self.exact_discriminant];
        let [found, exact] = both.map(|it| places(it, first));
        let shared = zeros(&found).min(zeros(&exact));
        let has_right_sign = discriminant * self.exact_discriminant > 0.0;
        let right = if has_right_sign {
            agreeing(&found, &exact)
        } else {
            shared
        };
        [shared, right, zeros(&exact)]
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

    /// Writes the number, rounded, behind its digits.
    fn draw_value(&self, svg: &mut Svg) {
        let words = format!("= {}", printed(self.x));
        svg.small_label("ink", spot(290.0, self.y), Start, &words);
    }
}

/// Counts the leading zeros of these digits.
fn zeros(digits: &str) -> usize {
    digits.bytes().take_while(|digit| *digit == b'0').count()
}
