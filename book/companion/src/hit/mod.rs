//! `hit`: rays and spheres under a microscope, by every method.

mod number;
mod one;
mod strain;
mod table;

use std::error::Error;
use std::path::PathBuf;

use clap::Args;
use clap::builder::TypedValueParser;
use common::rtweekend::*;
use speed_vs_accuracy::{Case, METHODS, Method};

pub(crate) use one::{ORDINARY, under_the_microscope};

use crate::chapter::named;
use number::{bound, finite, vector};

/// The words behind `cargo rtrace hit`.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Where the ray starts
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true, required_unless_present = "csv")]
    origin: Option<Vec3>,

    /// Where the ray points; t counts lengths of it
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true, required_unless_present = "csv")]
    direction: Option<Vec3>,

    /// The center of the sphere
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true, required_unless_present = "csv")]
    center: Option<Vec3>,

    /// The radius of the sphere
    #[arg(long, value_name = "R", value_parser = finite, allow_hyphen_values = true, required_unless_present = "csv")]
    radius: Option<f64>,

    /// A hit must have a greater t than this
    #[arg(long, value_name = "T", value_parser = bound, default_value = "0", allow_hyphen_values = true)]
    t_min: f64,

    /// A hit must have a lesser t than this
    #[arg(long, value_name = "T", value_parser = bound, default_value = "inf", allow_hyphen_values = true)]
    t_max: f64,

    /// Many rays and spheres, a row each, from a file with the columns ox, oy, oz, dx,
    /// dy, dz, cx, cy, cz and r, or from standard input if it is -; prints row,method,t
    #[arg(long, value_name = "FILE", conflicts_with_all = ["origin", "direction", "center", "radius"])]
    csv: Option<PathBuf>,

    /// Only this method [default: all]
    #[arg(long, value_name = "NAME", value_parser = method_parser())]
    method: Option<Method>,
}

/// Prints what the methods answer.
pub(crate) fn hit(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let range = (arguments.t_min, arguments.t_max);
    let methods = match &arguments.method {
        Some(method) => std::slice::from_ref(method),
        None => METHODS,
    };
    if let Some(path) = &arguments.csv {
        return table::print(path, methods, range);
    }
    let Arguments {
        origin: Some(origin),
        direction: Some(direction),
        center: Some(center),
        radius: Some(radius),
        ..
    } = *arguments
    else {
        unreachable!("they are required without a file");
    };
    let ray = Ray::new(origin, direction);
    let case = Case {
        center,
        radius,
        ray,
    };
    one::print(&case, methods, range)
}

fn method_parser() -> impl TypedValueParser<Value = Method> {
    named(METHODS.iter().map(|method| (method.name, *method)))
}
