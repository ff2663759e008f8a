//! Pictures: what is painted or printed.

use std::rc::Rc;

use common::rtweekend::{Camera, Picture};

use super::{Native, library};
use crate::host::Eval;
use crate::value::{Brush, Data, Value};

/// A picture whose pixels are colored when they are asked for.
fn painted(size: (u32, u32), brush: Brush) -> Eval {
    Ok(Data::Picture(Rc::new((size, Rc::new(brush)))).into())
}

fn size(value: &Value) -> u32 {
    value.int().clamp(0, u32::MAX.into()) as u32
}

pub(super) static TABLE: &[Native] = library! {
    PICTURE {
        paint _ (U32, U32, Fn(2)) => |host, a, at| {
            painted((size(&a[0]), size(&a[1])), Brush::Pixel(host.kept(&a[2]), at))
        };
    }
    NONE {
        render _ (U32, Fn(1)) => |host, a, at| {
            let camera = Camera::new(size(&a[0]).max(1));
            let size = (camera.image_width, camera.image_height);
            painted(size, Brush::Ray(camera, host.kept(&a[1]), at))
        };
    }
};

/// The picture that a text has printed as a P3 file.
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
