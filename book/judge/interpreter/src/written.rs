//! Functions as they are written.

use std::ops::Range;
use std::sync::Arc;

use crate::names::collect::Inside;
use crate::names::{Names, Signature};
use crate::types::Head;

/// A function as it is written: from its first word to its closing bracket.
#[derive(Clone, Debug)]
pub(crate) struct Written {
    /// Its name, behind that of its type if it has one: `Sphere::hit`.
    pub(crate) name: Arc<str>,
    pub(crate) text: Arc<str>,
}

impl Written {
    /// The function as it stands in a file, unless it is a constant or only promised.
    pub(crate) fn of(
        names: &Names,
        signature: &Signature,
        body: Option<Inside>,
        texts: &[String],
    ) -> Option<Self> {
        let Some(Inside::Function(syntax, block)) = body else {
            return None;
        };
        let of = match signature.of.as_ref().map(|it| it.0) {
            Some(Head::Own(kind)) => format!("{}::", names.kinds[kind as usize].name),
            _ => String::new(),
        };
        let start = syntax.fn_token.span.byte_range().start;
        let at: Range<usize> = start..block.brace_token.span.close().byte_range().end;
        let text = texts[names.modules[signature.module].file as usize].get(at)?;
        Some(Self {
            name: format!("{of}{}", signature.name).into(),
            text: text.into(),
        })
    }
}
