//! Pictures that a text paints by a function, or prints as a P3 file.

use std::rc::Rc;

use common::rtweekend::{Camera, Picture};

use super::library;
use crate::machine::Eval;
use crate::machine::value::{Brush, Data, Value};
use crate::types::{Ctor, Int, Type};

const U32: Ctor = Ctor::Int(Int::U32);

/// Makes a picture, `size` pixels wide and high, whose pixels are colored when they are asked for.
fn painted(size: (u32, u32), brush: Brush) -> Eval {
    Ok(Data::Picture(Rc::new((size, Rc::new(brush)))).into())
}

/// Returns a width as a `u32`.
fn size(value: &Value) -> u32 {
    value.int().clamp(0, u32::MAX.into()) as u32
}

library! { table:
    [Ctor::Picture] {
        paint _ (U32, U32, Type::function(2)) => |m, a, at| {
            painted((size(&a[0]), size(&a[1])), Brush::Pixel(m.kept(&a[2]), at))
        };
    }
    [Ctor::Never] {
        render _ (U32, Type::function(1)) => |m, a, at| {
            let camera = Camera::new(size(&a[0]).max(1));
            let size = (camera.image_width, camera.image_height);
            painted(size, Brush::Ray(camera, m.kept(&a[1]), at))
        };
    }
}

/// Parses a text that was printed as a P3 file with the greatest level 255; `None` if it is none.
pub(crate) fn printed(text: &str) -> Option<Picture> {
    let mut words = text
        .strip_prefix("P3")?
        .split_whitespace()
        .map(str::parse::<u32>);
    let [width, height, most] = [(); 3].map(|()| words.next().and_then(Result::ok));
    let levels = words.map(|it| u8::try_from(it.ok()?).ok());
    most.filter(|&it| it == 255)?;
    Picture::from_rgb(width?, height?, levels.collect::<Option<_>>()?)
}
