//! Edits of lists: two elements swapped, one element twice, and one mistake on all three axes.

use std::ops::Range;

use syn::{Expr, Pat};

use crate::hosts::bytes;
use crate::maker::Maker;
use crate::mistaken;

/// The greatest rank of the edits that are made on all axes at once.
const MOST_ON_AXES: u32 = 5;

impl Maker<'_> {
    /// Swaps any two expressions of a list, or writes one of them twice.
    pub(crate) fn list(&mut self, all: &[&Expr], rank: u32) {
        self.swapped(
            &all.iter().map(|it| bytes(*it)).collect::<Vec<_>>(),
            rank,
            false,
        );
        for one in all {
            for other in all {
                self.put_part(one, other, 7);
            }
        }
    }

    fn swapped(&mut self, all: &[Range<usize>], rank: u32, is_wide: bool) {
        for (n, one) in all.iter().enumerate() {
            for other in &all[n + 1..] {
                let [a, b] = [one, other].map(|it| &self.text[it.clone()]);
                let new = [b, &self.text[one.end..other.start], a].concat();
                match is_wide {
                    true => self.replace_widely(one.start..other.end, new, rank),
                    false => self.replace(one.start..other.end, new, rank),
                }
            }
        }
    }

    /// Swaps names in a pattern, or takes them from other fields.
    pub(crate) fn pattern(&mut self, it: &Pat) {
        let parts: Vec<&Pat> = match it {
            Pat::Tuple(it) => it.elems.iter().collect(),
            Pat::Slice(it) => it.elems.iter().collect(),
            Pat::TupleStruct(it) => it.elems.iter().collect(),
            _ => Vec::new(),
        };
        self.swapped(&parts.into_iter().map(bytes).collect::<Vec<_>>(), 5, true);
        if let Pat::Struct(it) = it {
            let defined = self.defined;
            for field in it.fields.iter().filter(|it| it.colon_token.is_some()) {
                for new in defined.fields_beside(self.source(&field.member)) {
                    self.replace(bytes(&field.member), new, 5);
                }
            }
        }
    }

    /// Makes the edits from number `first` on that are in one component of a vector in all three.
    pub(crate) fn on_all_axes(&mut self, it: &Expr, first: usize) {
        let Some([x, y, z]) = components(it) else {
            return;
        };
        let source = |at: &Range<usize>| &self.text[at.clone()];
        let is_like = |at, axis| blank(&on_axis(source(&x), axis)) == blank(source(at));
        if !is_like(&y, 1) || !is_like(&z, 2) || source(&x) == source(&y) {
            return;
        }
        let of_x = self.edits[first..].iter().filter(|edit| {
            x.start <= edit.at.start && edit.at.end <= x.end && edit.rank <= MOST_ON_AXES
        });
        let made = |at: &Range<usize>, new: &str| {
            let (before, after) = (x.start..at.start, at.end..x.end);
            [&self.text[before], new, &self.text[after]].concat()
        };
        let all = of_x.map(|edit| (made(&edit.at, &edit.new), edit.rank));
        let (one, other) = (x.end..y.start, y.end..z.start);
        for (new, rank) in all.collect::<Vec<_>>() {
            let [b, c] = [1, 2].map(|axis| on_axis(&new, axis));
            let between = [&self.text[one.clone()], &self.text[other.clone()]];
            let all = [&*new, between[0], &b, between[1], &c].concat();
            self.replace(x.start..z.end, all, rank);
        }
    }
}

/// Finds the three parts of an expression that may be the components of a vector.
fn components(it: &Expr) -> Option<[Range<usize>; 3]> {
    let parts: Vec<&Expr> = match it {
        Expr::Call(it) => it.args.iter().collect(),
        Expr::Array(it) => it.elems.iter().collect(),
        Expr::Tuple(it) => it.elems.iter().collect(),
        Expr::Struct(it) => it.fields.iter().map(|it| &it.expr).collect(),
        Expr::Binary(outer) => match &*outer.left {
            Expr::Binary(inner) => vec![&inner.left, &inner.right, &outer.right],
            _ => return None,
        },
        _ => return None,
    };
    let places: Vec<Range<usize>> = parts.into_iter().map(bytes).collect();
    places.try_into().ok()
}

/// Returns a text with y, for axis 1, or z, for axis 2, for each field or index x.
fn on_axis(text: &str, axis: usize) -> String {
    let is_word = |it: char| it.is_alphanumeric() || it == '_';
    let mut new = String::new();
    let mut rest = text;
    while let Some(start) = rest.find(is_word) {
        let word = &rest[start..];
        let word = &word[..word.find(|it| !is_word(it)).unwrap_or(word.len())];
        new += &rest[..start];
        let before = new.trim_end();
        let is_part = before.ends_with('[') || before.strip_suffix('.').is_some_and(is_object);
        let other = mistaken::on_axis(word, axis).filter(|_| is_part);
        new += other.unwrap_or(word);
        rest = &rest[start + word.len()..];
    }
    new + rest
}

/// Returns true if what stands before a dot is no number.
fn is_object(text: &str) -> bool {
    let is_word = |it: char| it.is_alphanumeric() || it == '_';
    let word = text.rsplit(|it| !is_word(it)).next().unwrap_or_default();
    !word.starts_with(|it: char| it.is_ascii_digit())
}

fn blank(text: &str) -> String {
    text.split_whitespace().collect()
}
