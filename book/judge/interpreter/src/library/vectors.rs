//! Vectors and rays, as glam and our prelude have them.

use std::rc::Rc;

use common::rtweekend::{Ray, Vec3, sky};

use super::{Native, library};
use crate::host::Eval;
use crate::value::{Data, Value};

fn plain(value: impl Into<Value>) -> Eval {
    Ok(value.into())
}

/// Functions of one vector or two that come to a vector, a number or a truth.
macro_rules! vectors {
    (
        { $($to_vec:ident)* } { $($to_vecs:ident)* } { $($to_f64:ident)* }
        { $($to_f64s:ident)* } { $($is:ident)* } { $($rest:tt)* } $($others:tt)*
    ) => {
        library! {
            VEC3 {
                $($to_vec self () => |_, a, _| plain(a[0].vec3().$to_vec());)*
                $($to_vecs self (Vec3) => |_, a, _| plain(a[0].vec3().$to_vecs(a[1].vec3()));)*
                $($to_f64 self () => |_, a, _| plain(a[0].vec3().$to_f64());)*
                $($to_f64s self (Vec3) => |_, a, _| plain(a[0].vec3().$to_f64s(a[1].vec3()));)*
                $($is self () => |_, a, _| Ok(a[0].vec3().$is().into());)*
                $($rest)*
            }
            $($others)*
        }
    };
}

pub(super) static TABLE: &[Native] = vectors! {
    { normalize normalize_or_zero abs signum floor ceil round fract recip exp }
    { cross min max reflect project_onto }
    { length length_squared length_recip element_sum min_element max_element }
    { dot distance distance_squared }
    { is_nan is_finite is_normalized }
    {
        new _ (F64, F64, F64) =>
            |_, a, _| plain(Vec3::new(a[0].float(), a[1].float(), a[2].float()));
        splat _ (F64) => |_, a, _| plain(Vec3::splat(a[0].float()));
        powf self (F64) => |_, a, _| plain(a[0].vec3().powf(a[1].float()));
        lerp self (Vec3, F64) => |_, a, _| plain(a[0].vec3().lerp(a[1].vec3(), a[2].float()));
        clamp self (Vec3, Vec3) =>
            |_, a, _| plain(a[0].vec3().max(a[1].vec3()).min(a[2].vec3()));
        to_array self () =>
            |_, a, _| Ok(Value::array(a[0].vec3().to_array().map(Value::from).to_vec()));
        from_array _ (Array) => |_, a, _| {
            let all = &a[0].list().all;
            plain(Vec3::new(all[0].float(), all[1].float(), all[2].float()))
        };
    }
    RAY {
        new _ (Vec3, Vec3) => |_, a, _| {
            Ok(Data::Ray(Rc::new(Ray::new(a[0].vec3(), a[1].vec3()))).into())
        };
        at self (F64) => |_, a, _| match &a[0].data {
            Data::Ray(ray) => plain(ray.at(a[1].float())),
            _ => unreachable!("types are checked"),
        };
    }
    NONE {
        sky _ (Ray) => |_, a, _| plain(sky(&a[0].ray()));
    }
};
