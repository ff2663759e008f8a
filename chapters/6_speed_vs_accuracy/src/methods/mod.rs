//! Floating point: each method rounds as it goes and hopes for the best.
//!
//! In what is said about errors, u = 2⁻⁵³ is the largest relative error of one operation, a = d·d,
//! M = oc·oc + r², and letters are those of [`bounds`](crate::bounds). What a method costs is
//! counted in √ and ÷, which take several times as long as + and ×.
//!
//! Both ends of the range are open, and a tangent is a hit. What a method answers where the
//! formula ends stands beside it; the page of all methods has it as a table, of which each
//! cell is tested. Where h², a·c or c underflows, t may be wrong; the certified methods and
//! `exact` are right there too.

mod compensated;
mod cross_q;
mod double_double;
mod error_free;
mod half_b;
mod half_b_q;
mod single;

pub use compensated::compensated;
pub use cross_q::cross_q;
pub use double_double::double_double;
pub use half_b::half_b;
pub use half_b_q::half_b_q;
pub use single::{half_b_f32, widened_half_b_q_f32};

pub(crate) use double_double::{DoubleDouble, DoubleQuadratic};
