//! Texts: what is written, of which only the picture is looked at.

use std::rc::Rc;

use super::{Native, library};
use crate::value::{Data, Value};

pub(super) static TABLE: &[Native] = library! {
    STR {
        new _ () => |_, _, _| Ok(Value::str(""));
        with_capacity _ (Usize) => |_, _, _| Ok(Value::str(""));
        from _ (Str) => |_, a, _| Ok(a[0].clone().owned());
        to_string self () => |_, a, _| Ok(a[0].clone().owned());
        to_owned self () => |_, a, _| Ok(a[0].clone().owned());
        as_str self () => |_, a, _| Ok(a[0].clone().owned().lent());
        len self () => |_, a, _| Ok(Value::usize(a[0].text().len()));
        is_empty self () => |_, a, _| Ok(a[0].text().is_empty().into());
        push_str mut (Str) => |host, a, at| {
            let more = a[1].text();
            host.take(more.len(), at)?;
            host.change(&a[0], &mut |text| {
                if let Data::Str(text) = &mut text.data {
                    Rc::make_mut(text).push_str(&more);
                }
            });
            Ok(Value::default())
        };
    }
};
