//! A map of difficulty: how far off each method is, by how far away a ray starts, and how near to
//! the rim of the sphere it passes or to the surface it starts.

use figures::records::MapCell;
use figures::table::Table;
use figures::{MAPPED, Spot};
use laws::oracle::ExactCase;
use rayon::prelude::*;
use speed_vs_accuracy::{Case, Method, Precision, Random, above, aimed};

use crate::accuracy::ulps_off;

/// The number of rays of each spot.
const RAYS: usize = 1000;

/// Asks each method of [`MAPPED`] about a thousand rays, chosen by `seed`, of each [`Spot`] of the
/// map of its precision. Returns a row for each spot and method.
pub fn table(seed: u64) -> Table<MapCell> {
    let spots = Precision::ALL.map(|precision| Spot::all(precision).map(move |it| (precision, it)));
    let spots: Vec<(Precision, Spot)> = spots.into_iter().flatten().collect();
    let cells = spots.into_par_iter().flat_map_iter(|(precision, spot)| {
        let cases = cases(spot, precision, seed);
        let methods = MAPPED.iter().filter(move |it| it.precision() == precision);
        methods.map(move |method| cell(spot, method, &cases))
    });
    cells.collect::<Vec<_>>().into()
}

/// Makes the rays of a spot, in numbers that `precision` can hold.
fn cases(spot: Spot, precision: Precision, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    let mut case = || match spot {
        Spot::Above(n) => above(&mut random, 1.0, tenth(n)),
        Spot::Inside(n) => above(&mut random, 1.0, -tenth(n)),
        Spot::Away(k, n) => {
            let miss_by = 1.0 + random.sign() * tenth(n);
            aimed(&mut random, 1.0 + 1.0 / tenth(k), miss_by)
        }
    };
    (0..RAYS).map(|_| case().rounded(precision)).collect()
}

/// Computes 10⁻ⁿ.
fn tenth(n: i32) -> f64 {
    1.0 / (0..n).fold(1.0, |power, _| 10.0 * power)
}

fn cell(spot: Spot, method: &Method, cases: &[Case]) -> MapCell {
    let (mut wrong, mut off) = (0, 0.0);
    for case in cases {
        let exact = ExactCase::of(&laws::Case::new(case.center, case.radius, case.ray));
        let root = exact.nearest_root_in(0.0, f64::INFINITY);
        match (case.put_to(method, 0.0, f64::INFINITY), root) {
            (Some(t), Some(root)) => {
                let right = root.rounded();
                let ulp = (right.next_up() - right) * method.precision().epsilon() / f64::EPSILON;
                let error = ulps_off(root, method.precision(), t) * ulp;
                off = f64::max(
                    off,
                    match spot {
                        Spot::Away(..) => error * case.a().sqrt() / case.radius,
                        _ => error / right,
                    },
                );
            }
            (None, None) => {}
            _ => wrong += 1,
        }
    }
    MapCell {
        column: spot.column(),
        row: spot.row(),
        precision: method.precision(),
        method: method.name.to_owned(),
        wrong,
        off,
    }
}
