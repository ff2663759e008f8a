//! Sizes of values: their bytes, and the depth of their nesting.

use crate::limits::{MAX_VALUE_DEPTH, MAX_VISITS};
use crate::machine::value::{Data, Value};

impl Value {
    /// Returns how many bytes the value and its direct parts take, without the elements of a list.
    pub(crate) fn size(&self) -> usize {
        let parts = match &self.data {
            Data::Own(_, all) | Data::Tuple(all) => all.len(),
            Data::Some(_) | Data::Box(_) => 1,
            _ => 0,
        };
        (1 + parts) * size_of::<Self>()
    }

    /// Returns how deep the value is nested, counted up to just above the limit. In a list, the
    /// first and the last element are visited.
    pub(crate) fn depth(&self) -> usize {
        self.depth_within(MAX_VALUE_DEPTH + 1, &mut { MAX_VISITS })
    }

    fn depth_within(&self, most: usize, visits: &mut usize) -> usize {
        *visits = visits.saturating_sub(1);
        if most == 0 || *visits == 0 {
            return MAX_VALUE_DEPTH + 1;
        }
        let mut deepest = |all: &mut dyn Iterator<Item = &Self>| {
            all.map(|it| it.depth_within(most - 1, visits)).max()
        };
        let inside = match &self.data {
            Data::Own(_, all) | Data::Tuple(all) => deepest(&mut all.iter()),
            Data::Some(it) | Data::Box(it) => deepest(&mut std::iter::once(&**it)),
            Data::List(list) => deepest(&mut list.all.first().into_iter().chain(list.all.last())),
            _ => return 0,
        };
        1 + inside.unwrap_or(0)
    }
}
