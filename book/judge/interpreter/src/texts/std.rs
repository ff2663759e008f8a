//! The part of the standard library that is written in the interpreter's own language. Types that
//! are left out are `_`; an iterator is the list of what it gives.

pub struct DVec3 { x: f64, y: f64, z: f64 }
pub enum Option<T> { None, Some(T) }
pub enum Ordering { Less, Equal, Greater }
pub struct Range { start: _, end: _, is_closed: bool }
pub struct Picture { width: u32, height: u32, color_at: _ }

impl Picture {
    fn paint(width: u32, height: u32, color_at: _) -> Self { Self { width, height, color_at } }
}

impl Ordering {
    fn reverse(self) -> _ { match self { Self::Less => Self::Greater, Self::Greater => Self::Less, equal => equal } }
    fn is_lt(self) -> bool { self == Self::Less }
    fn is_gt(self) -> bool { self == Self::Greater }
    fn is_eq(self) -> bool { self == Self::Equal }
}

impl integer {
    fn max(self, other: _) -> _ { if other >= self { other } else { self } }
    fn min(self, other: _) -> _ { if other < self { other } else { self } }
    fn clamp(self, least: _, most: _) -> _ { self.max(least).min(most) }
    fn abs(self) -> _ { if self < 0 { -self } else { self } }
    fn signum(self) -> _ { if self < 0 { -1 } else if self > 0 { 1 } else { 0 } }
    fn pow(self, power: u32) -> _ { let mut product = 1; for _ in 0..power { product *= self; } product }
    fn rem_euclid(self, other: _) -> _ { let rest = self % other; if rest < 0 { rest + other.abs() } else { rest } }
    fn nothing(self) -> _ { self - self }
    fn cmp(self, other: _) -> Ordering {
        if self < other { Ordering::Less } else if self > other { Ordering::Greater } else { Ordering::Equal }
    }
}

// With what a sum begins: glam's at zero, the others at a zero that adds nothing.
impl f64 { fn nothing(self) -> f64 { -0.0 } }
impl DVec3 { fn nothing(self) -> Self { Self::ZERO } }

impl bool {
    fn then(self, f: _) -> _ { if self { Some(f()) } else { None } }
    fn then_some(self, it: _) -> _ { if self { Some(it) } else { None } }
}

impl Range {
    fn contains(self, it: _) -> bool {
        self.start <= it && (it < self.end || self.is_closed && it == self.end)
    }
}

impl<T> Option<T> {
    fn is_some(self) -> bool { if let Some(_) = self { true } else { false } }
    fn is_none(self) -> bool { !self.is_some() }
    fn is_some_and(self, f: _) -> bool { match self { Some(it) => f(it), None => false } }
    fn is_none_or(self, f: _) -> bool { match self { Some(it) => f(it), None => true } }
    fn unwrap(self) -> _ { match self { Some(it) => it, None => panic!("unwrap of a None") } }
    fn expect(self, _message: _) -> _ { self.unwrap() }
    fn unwrap_or(self, other: _) -> _ { match self { Some(it) => it, None => other } }
    fn unwrap_or_else(self, f: _) -> _ { match self { Some(it) => it, None => f() } }
    fn map(self, f: _) -> _ { match self { Some(it) => Some(f(it)), None => None } }
    fn map_or(self, other: _, f: _) -> _ { match self { Some(it) => f(it), None => other } }
    fn map_or_else(self, other: _, f: _) -> _ { match self { Some(it) => f(it), None => other() } }
    fn and_then(self, f: _) -> _ { match self { Some(it) => f(it), None => None } }
    fn or(self, other: _) -> _ { match self { None => other, some => some } }
    fn zip(self, other: _) -> _ { match (self, other) { (Some(a), Some(b)) => Some((a, b)), _ => None } }
    fn xor(self, other: _) -> _ { match (self, other) { (Some(a), None) => Some(a), (None, b) => b, _ => None } }
    fn or_else(self, f: _) -> _ { match self { None => f(), some => some } }
    fn filter(self, f: _) -> _ { match self { Some(it) if f(it) => self, _ => None } }
    fn take(&mut self) -> _ { std::mem::replace(self, None) }
    fn replace(&mut self, it: _) -> _ { std::mem::replace(self, Some(it)) }
}

impl<T> Vec<T> {
    fn is_empty(self) -> bool { self.len() == 0 }
    fn get(self, n: usize) -> _ { if n < self.len() { Some(self[n]) } else { None } }
    fn first(self) -> _ { self.get(0) }
    fn last(self) -> _ { if self.is_empty() { None } else { Some(self[self.len() - 1]) } }
    fn pop(&mut self) -> _ { if self.is_empty() { None } else { Some(self.remove(self.len() - 1)) } }
    fn next(&mut self) -> _ { if self.is_empty() { None } else { Some(self.remove(0)) } }
    fn swap(&mut self, a: usize, b: usize) {
        let it = self[a];
        self[a] = self[b];
        self[b] = it;
    }
    fn extend(&mut self, more: _) { for it in more { self.push(it); } }
    fn chain(mut self, more: _) -> _ { self.extend(more); self }
    fn map(self, f: _) -> _ { let mut all = vec![]; for it in self { all.push(f(it)); } all }
    fn filter(self, f: _) -> _ { self.filter_map(|it| if f(it) { Some(it) } else { None }) }
    fn filter_map(self, f: _) -> _ {
        let mut all = vec![];
        for it in self { if let Some(it) = f(it) { all.push(it); } }
        all
    }
    fn enumerate(self) -> _ { (0..self.len()).zip(self) }
    fn zip(self, others: _) -> _ {
        let mut all = vec![];
        for it in self { match others.get(all.len()) { Some(other) => all.push((it, other)), None => break } }
        all
    }
    fn rev(mut self) -> _ { self.reverse(); self }
    fn reverse(&mut self) { for n in 0..self.len() / 2 { self.swap(n, self.len() - 1 - n); } }
    fn skip(self, count: usize) -> _ {
        let mut all = vec![];
        for n in count..self.len() { all.push(self[n]); }
        all
    }
    fn take(self, count: usize) -> _ { (0..count.min(self.len())).map(|n| self[n]) }
    fn step_by(self, step: usize) -> _ {
        let mut all = vec![];
        for (n, it) in self.enumerate() { if n % step == 0 { all.push(it); } }
        all
    }
    fn fold(self, start: _, f: _) -> _ { let mut sum = start; for it in self { sum = f(sum, it); } sum }
    fn reduce(self, f: _) -> _ { match self.first() { Some(it) => Some(self.skip(1).fold(it, f)), None => None } }
    fn sum(self) -> _ { match self.first() { Some(it) => self.fold(it.nothing(), |a, b| a + b), None => -0.0 } }
    fn product(self) -> _ { self.reduce(|a, b| a * b).unwrap() }
    fn count(self) -> usize { self.len() }
    fn nth(self, n: usize) -> _ { self.get(n) }
    fn flatten(self) -> _ { let mut all = vec![]; for it in self { all.extend(it); } all }
    fn flat_map(self, f: _) -> _ { self.map(f).flatten() }
    fn take_while(self, f: _) -> _ {
        let mut all = vec![];
        for it in self { if f(it) { all.push(it); } else { break; } }
        all
    }
    fn for_each(self, f: _) { for it in self { f(it); } }
    fn find(self, f: _) -> _ { for it in self { if f(it) { return Some(it); } } None }
    fn find_map(self, f: _) -> _ { for it in self { if let Some(it) = f(it) { return Some(it); } } None }
    fn position(self, f: _) -> _ { for n in 0..self.len() { if f(self[n]) { return Some(n); } } None }
    fn any(self, f: _) -> bool { self.find(f).is_some() }
    fn all(self, f: _) -> bool { self.find(|it| !f(it)).is_none() }
    fn contains(self, one: _) -> bool { self.any(|it| it == one) }
    fn max(self) -> _ { self.reduce(|a, b| if b >= a { b } else { a }) }
    fn min(self) -> _ { self.reduce(|a, b| if b < a { b } else { a }) }
    fn max_by(self, f: _) -> _ { self.reduce(|a, b| if f(b, a).is_lt() { a } else { b }) }
    fn min_by(self, f: _) -> _ { self.reduce(|a, b| if f(b, a).is_lt() { b } else { a }) }
    fn sort_by(&mut self, f: _) {
        for n in 1..self.len() {
            let mut k = n;
            while k > 0 && f(self[k - 1], self[k]).is_gt() { self.swap(k - 1, k); k -= 1; }
        }
    }
}
