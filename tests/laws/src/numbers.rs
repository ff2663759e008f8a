//! Numbers as Rust writes them, or a person, and shorter ones near them for shrinking.

use common::rtweekend::Vec3;

/// A number as Rust has it, which has words for three of them.
pub(crate) fn code(x: f64) -> String {
    if x.is_nan() {
        "f64::NAN".to_owned()
    } else if x == f64::INFINITY {
        "f64::INFINITY".to_owned()
    } else if x == f64::NEG_INFINITY {
        "f64::NEG_INFINITY".to_owned()
    } else {
        format!("{x:?}")
    }
}

/// A vector as a person writes it, who knows no -0.
pub(crate) fn in_words(v: Vec3) -> String {
    let v = v + Vec3::ZERO;
    format!("({}, {}, {})", v.x, v.y, v.z)
}

/// A color as a person writes it, finer than the levels of a picture.
pub(crate) fn color_in_words(color: Vec3) -> String {
    format!("({:.4}, {:.4}, {:.4})", color.x, color.y, color.z)
}

/// Numbers that take fewer digits to write than `number`, near it or not.
pub(crate) fn simpler(number: f64) -> Vec<f64> {
    let digits = |x: f64| format!("{:e}", x.abs()).len();
    let size = if number == 0.0 {
        0.0
    } else {
        number.abs().log10().floor()
    };
    let rounded = (0..=3).map(|keep| {
        let unit = 10f64.powf(size - f64::from(keep));
        (number / unit).round() * unit
    });
    [0.0, 1.0, -1.0, number.round()]
        .into_iter()
        .chain(rounded)
        .filter(|simpler| {
            simpler.is_finite()
                && (digits(*simpler), simpler.abs()) < (digits(number), number.abs())
        })
        .collect()
}
