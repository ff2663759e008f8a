//! JSON: what a scene needs, for programs.

use std::path::Path;

use check::names;
use common::rtweekend::*;
use serde_json::{Value, json};
use speed_vs_accuracy::{Precision, Scene};

use super::text::profile;
use measure::needs::{Culprit, Found, Row};

/// One object.
pub(super) fn json(scene: &Scene, found: &[Found], folder: &Path, files: &[String]) -> String {
    let Camera {
        image_width,
        image_height,
        ..
    } = Camera::new(scene.width);
    let of_precision = |precision: Precision| {
        let found = found.iter().find(|found| found.precision == precision);
        (precision.name(), found.map(one_precision))
    };
    let [(double, in_double), (single, in_single)] = Precision::ALL.map(of_precision);
    let object = json!({
        "scene": scene.name,
        "spheres": scene.spheres.len(),
        "size": [image_width, image_height],
        "profile": profile(),
        double: in_double,
        // Null if it has no such numbers.
        single: in_single,
        "folder": names::spelled(folder),
        "files": files,
    });
    format!("{object:#}\n")
}

fn one_precision(found: &Found) -> Value {
    let name = |n: usize| found.rows[n].view.method.name;
    let failing = found.failing.as_ref();
    json!({
        "least": found.least.map(name),
        "ties": found.ties.iter().map(|&n| name(n)).collect::<Value>(),
        "fails": failing.map(|(n, culprit)| first_wrong(name(*n), culprit)),
        "methods": found.rows.iter().map(method).collect::<Value>(),
    })
}

fn method(row: &Row) -> Value {
    json!({
        "name": row.view.method.name,
        "wrong_pixels": row.view.wrong,
        "a_level_off": row.view.off_by_one,
        "worst_levels": row.view.levels,
        "worst_radii": row.view.radii,
        "least_ns": row.ns,
        "times_half_b": row.ratio,
    })
}

/// The first wrong pixel, and the question that is answered wrongly there.
fn first_wrong(method: &str, culprit: &Culprit) -> Value {
    let Culprit { case, colors, .. } = culprit;
    let [drawn, right] = colors;
    json!({
        "method": method,
        "pixel": culprit.pixel,
        "drawn": drawn,
        "right": right,
        "sphere": culprit.sphere + 1,
        "to_sun": culprit.is_to_sun,
        "origin": case.ray.origin.to_array(),
        "direction": case.ray.direction.to_array(),
        "center": case.center.to_array(),
        "radius": case.radius,
        "t_min": culprit.t_min,
    })
}
