//! The prelude of all figures: points and rays in a plane, axes, large pixels, labels, numbers as
//! text, and the parts of a live figure.

pub(crate) use common::rtweekend::*;
pub(crate) use glam::DVec2;

pub(crate) use crate::axis::{Axis, ticks};
pub(crate) use crate::figure::figure;
pub(crate) use crate::live::{DrawnFigure, Handle, Live, Movable, point};
pub(crate) use crate::number::{listed, power_of_ten, printed, sign, spoken, three_digits, triple};
pub(crate) use crate::parameters::{Parameter, parameters};
pub(crate) use crate::pixels::PixelGrid;
pub(crate) use crate::plane::{Plane, nearest, ray, roots, xy};
pub(crate) use crate::svg::Anchor::*;
pub(crate) use crate::svg::{Shift, Svg, spot};
