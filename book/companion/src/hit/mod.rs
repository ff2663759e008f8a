//! `hit`: rays and spheres under a microscope, by every method.

mod number;
mod one;
mod strain;

use std::error::Error;

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
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    origin: Vec3,

    /// Where the ray points; t counts lengths of it
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    direction: Vec3,

    /// The center of the sphere
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    center: Vec3,

    /// The radius of the sphere
    #[arg(long, value_name = "R", value_parser = finite, allow_hyphen_values = true)]
    radius: f64,

    /// A hit must have a greater t than this
    #[arg(long, value_name = "T", value_parser = bound, default_value = "0", allow_hyphen_values = true)]
    t_min: f64,

    /// A hit must have a lesser t than this
    #[arg(long, value_name = "T", value_parser = bound, default_value = "inf", allow_hyphen_values = true)]
    t_max: f64,

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
    let ray = Ray::new(arguments.origin, arguments.direction);
    let case = Case::new(arguments.center, arguments.radius, ray);
    one::print(&case, methods, range)
}

fn method_parser() -> impl TypedValueParser<Value = Method> {
    named(METHODS.iter().map(|method| (method.name, *method)))
}
