//! Vectors and rays, as glam and our prelude have them.

use std::rc::Rc;

use common::rtweekend::{Ray, Vec3, sky};

use super::library;
use crate::machine::value::{Data, Value};
use crate::types::Ctor::{F64, Vec3 as Vector};
use crate::types::{Ctor, Type};

/// Defines the functions of vectors and rays: those of one vector or two by their names alone, as
/// glam has them, and then the rest.
macro_rules! vectors {
    ({ $($one:ident)* } { $($two:ident)* } $($rest:tt)*) => {
        library! { table:
            [Ctor::Vec3] {
                $($one self () => |_, a, _| Ok(a[0].vec3().$one().into());)*
                $($two self (Vector) => |_, a, _| Ok(a[0].vec3().$two(a[1].vec3()).into());)*
                $($rest)*
            }
            [Ctor::Ray] {
                new _ (Vector, Vector) => |_, a, _| {
                    Ok(Data::Ray(Rc::new(Ray::new(a[0].vec3(), a[1].vec3()))).into())
                };
                at self (F64) => |_, a, _| Ok(a[0].ray().at(a[1].float()).into());
            }
            [Ctor::Never] {
                sky _ (Type::of(Ctor::Ref, Ctor::Ray.into())) =>
                    |_, a, _| Ok(sky(&a[0].ray()).into());
            }
        }
    };
}

vectors! {
    {
        normalize normalize_or_zero abs signum floor ceil round fract recip exp
        length length_squared length_recip element_sum min_element max_element
        is_nan is_finite is_normalized
    }
    { cross min max reflect project_onto dot distance distance_squared }
    new _ (F64, F64, F64) =>
        |_, a, _| Ok(Vec3::new(a[0].float(), a[1].float(), a[2].float()).into());
    splat _ (F64) => |_, a, _| Ok(Vec3::splat(a[0].float()).into());
    powf self (F64) => |_, a, _| Ok(a[0].vec3().powf(a[1].float()).into());
    lerp self (Vector, F64) =>
        |_, a, _| Ok(a[0].vec3().lerp(a[1].vec3(), a[2].float()).into());
    clamp self (Vector, Vector) =>
        |_, a, _| Ok(a[0].vec3().max(a[1].vec3()).min(a[2].vec3()).into());
    to_array self () =>
        |_, a, _| Ok(Value::array(a[0].vec3().to_array().map(Value::from).to_vec()));
    from_array _ (Type::of(Ctor::Array(3), F64.into())) => |_, a, _| {
        let all = &a[0].list().all;
        Ok(Vec3::new(all[0].float(), all[1].float(), all[2].float()).into())
    };
}
