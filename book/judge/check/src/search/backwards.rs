//! Search for a repair: first the function that holds the mistake, by putting the chapter's in
//! its place, and then the likeliest edit inside of it that is as good.

use std::cell::Cell;
use std::collections::HashSet;

use super::edit::{RankedEdit, words};
use interpreter::Program;

use super::functions::ParsedFunction;
use super::goal::Goal;
use super::{mutation, nearer};

/// So many bytes of functions are read, which takes two seconds at most.
const READ: usize = 1 << 20;
/// Nobody would recognize the mistake in a less likely edit.
const READABLE: u32 = 16;

/// A function of the reader's with the text that makes the program right.
pub(super) struct Fix<'a> {
    pub(super) yours: &'a ParsedFunction,
    pub(super) text: String,
}

impl<'a> Fix<'a> {
    fn edit((yours, edit): &(&'a ParsedFunction, RankedEdit)) -> Self {
        Self {
            yours,
            text: edit.applied_to(&yours.text),
        }
    }
}

/// A reader's program and what it is compared with.
pub(super) struct RepairSearch<'a> {
    pub(super) program: &'a Program,
    pub(super) yours: &'a [ParsedFunction],
    pub(super) chapter: &'a [ParsedFunction],
    pub(super) goal: &'a Goal,
    /// How many bytes of functions have been read.
    pub(super) read: Cell<usize>,
}

/// A function of the reader's, and those of the same name that are right.
type Common<'a> = (&'a ParsedFunction, Vec<&'a ParsedFunction>);

/// Undoes what is often mistyped.
fn generic(function: &ParsedFunction) -> Vec<RankedEdit> {
    let all = mutation::mutations(function).into_iter();
    all.map(|it| it.edit(&function.text)).collect()
}

/// Functions with other texts.
type Patches<'a> = Vec<(&'a ParsedFunction, String)>;

impl<'a> RepairSearch<'a> {
    /// Finds what makes the program right, if something does.
    pub(super) fn find(&self) -> Option<Vec<Fix<'a>>> {
        let common = self.common();
        let swapped = |(yours, right): &Common<'a>| {
            let is_right = |it: &&ParsedFunction| self.is_right(&vec![(*yours, it.text.clone())]);
            let at = right.iter().position(is_right)?;
            let mut right = right.clone();
            right.swap(0, at);
            Some((*yours, right))
        };
        let swapped: Vec<Common> = common.iter().filter_map(swapped).collect();
        if swapped.is_empty() {
            return self.in_two(&common).or_else(|| self.in_any(&common));
        }
        let found = swapped
            .iter()
            .filter_map(|common| self.repair(common, &Vec::new()));
        let found = found.min_by_key(|(_, edit)| edit.rank);
        let found = found.filter(|(_, edit)| edit.rank <= READABLE);
        found.map(|edit| vec![Fix::edit(&edit)])
    }

    /// Finds the functions that the reader and the chapter have in common.
    fn common(&self) -> Vec<Common<'a>> {
        let common = self.yours.iter().map(|yours| {
            let right = self.chapter.iter().filter(|it| it.name == yours.name);
            (yours, right.collect::<Vec<_>>())
        });
        common.filter(|(_, right)| !right.is_empty()).collect()
    }

    /// Returns true if the program is right with these texts, as long as one more may be tried.
    fn is_right(&self, changes: &Patches) -> bool {
        let bytes: usize = changes.iter().map(|(_, text)| text.len()).sum();
        self.read.set(self.read.get() + bytes);
        self.may_try() && self.meets_the_goal(changes)
    }

    fn may_try(&self) -> bool {
        self.read.get() <= READ
    }

    fn meets_the_goal(&self, changes: &Patches) -> bool {
        let mut changes = changes.iter();
        let first = changes
            .next()
            .map(|(it, text)| self.program.patched(&it.name, text));
        let patched = first.and_then(Result::ok);
        let program = changes.fold(patched, |program, (it, text)| {
            program?.patched(&it.name, text).ok()
        });
        program.is_some_and(|it| self.goal.is_met_by(&it))
    }

    /// Finds the likeliest edit that makes the program right, in this function or in what it calls.
    fn repair(
        &self,
        common: &Common<'a>,
        others: &Patches<'a>,
    ) -> Option<(&'a ParsedFunction, RankedEdit)> {
        self.first(self.edits(common), others)
    }

    /// Makes the edits of a function and of the helpers that it calls.
    fn edits(&self, (yours, right): &Common<'a>) -> Vec<(&'a ParsedFunction, RankedEdit)> {
        let mutations = generic(yours);
        let own = self.of_chapter(yours, right).into_iter().chain(mutations);
        let mut edits: Vec<_> = own.map(|edit| (*yours, edit)).collect();
        let helpers = self.helpers(yours);
        let likest: Vec<_> = helpers.iter().map(|it| (*it, self.likest(it))).collect();
        let mut callers: Vec<_> = likest.iter().flat_map(|it| Some((it.0, it.1?))).collect();
        callers.extend(right.iter().map(|right| (*yours, *right)));
        for (helper, _) in &likest {
            let others = callers.iter().filter(|(it, _)| it.name != helper.name);
            let theirs = others.flat_map(|(it, right)| nearer::edits_of_helper(helper, it, right));
            let all = self.keeping_calls(helper, theirs.collect());
            let all = all.into_iter().chain(self.of_likest(helper));
            edits.extend(all.map(|edit| (*helper, edit)));
        }
        edits
    }

    /// Drops those that write a call of a helper out: that would hide a mistake of the helper.
    fn keeping_calls(&self, yours: &ParsedFunction, mut edits: Vec<RankedEdit>) -> Vec<RankedEdit> {
        for helper in self.helpers(yours) {
            edits.retain(|it| !it.writes_out(helper.short_name(), &yours.text));
        }
        edits
    }

    /// The edits by which a function comes nearer to the chapter's, and to what that calls and the
    /// reader does not have.
    fn of_chapter(&self, yours: &ParsedFunction, right: &[&ParsedFunction]) -> Vec<RankedEdit> {
        let is_missing = |it: &&ParsedFunction| self.yours.iter().all(|own| own.name != it.name);
        let is_called = |it: &&ParsedFunction| {
            let mut callers = right.iter();
            callers.any(|right| words(&right.text).contains(&it.name.as_str()))
        };
        let called = self.chapter.iter().filter(is_called).filter(is_missing);
        let all = right.iter().copied().chain(called);
        let edits = all.flat_map(|right| nearer::edits(yours, right));
        self.keeping_calls(yours, edits.collect())
    }

    /// Finds the chapter's function that is most like this one.
    fn likest(&self, own: &ParsedFunction) -> Option<&'a ParsedFunction> {
        let like = |it: &&ParsedFunction| it.body.likeness(&own.body);
        let all = self.chapter.iter();
        all.max_by(|one, other| like(one).total_cmp(&like(other)))
    }

    /// The edits of a function that the chapter does not have, by what is most like it there.
    fn of_likest(&self, own: &ParsedFunction) -> Vec<RankedEdit> {
        let right = self.likest(own);
        let theirs = right.map_or(Vec::new(), |right| nearer::edits(own, right));
        let theirs = self.keeping_calls(own, theirs);
        [theirs, generic(own)].concat()
    }

    /// The reader's own functions that this one calls, and those that they call.
    fn helpers(&self, caller: &ParsedFunction) -> Vec<&'a ParsedFunction> {
        let is_own = |it: &&ParsedFunction| self.chapter.iter().all(|other| other.name != it.name);
        let mut called: Vec<&ParsedFunction> = Vec::new();
        let mut texts = vec![caller.text.as_str()];
        while let Some(text) = texts.pop() {
            let words = words(text);
            for helper in self.yours.iter().filter(is_own) {
                let is_new = called.iter().all(|it| !std::ptr::eq(*it, helper));
                if is_new && helper.name != caller.name && words.contains(&helper.short_name()) {
                    called.push(helper);
                    texts.push(&helper.text);
                }
            }
        }
        called
    }

    /// Finds the likeliest of the edits that make the program right.
    fn first(
        &self,
        mut edits: Vec<(&'a ParsedFunction, RankedEdit)>,
        others: &Patches<'a>,
    ) -> Option<(&'a ParsedFunction, RankedEdit)> {
        edits.sort_by_key(|(_, edit)| edit.rank);
        let mut seen = HashSet::new();
        edits.into_iter().find(|(function, edit)| {
            let text = edit.applied_to(&function.text);
            let is_new = text != function.text && seen.insert((&function.name, text.clone()));
            if !is_new || !self.may_try() {
                return false;
            }
            let changes = [others.clone(), vec![(*function, text)]].concat();
            self.is_right(&changes)
        })
    }

    /// Finds mistakes in two functions: each is repaired while the other is the chapter's.
    fn in_two(&self, common: &[Common<'a>]) -> Option<Vec<Fix<'a>>> {
        let pairs = (0..common.len()).flat_map(|n| (0..n).map(move |m| [n, m]));
        let swap = |n: usize| (common[n].0, common[n].1[0].text.clone());
        let are_right = |[n, m]: &[usize; 2]| self.is_right(&vec![swap(*n), swap(*m)]);
        let [n, m] = pairs.into_iter().find(are_right)?;
        let edits = [(n, m), (m, n)];
        let edits = edits.map(|(own, other)| self.repair(&common[own], &vec![swap(other)]));
        if let [Some(one), Some(other)] = edits
            && [&one, &other].iter().all(|(_, edit)| edit.rank <= READABLE)
        {
            return self.whole(vec![Fix::edit(&other), Fix::edit(&one)]);
        }
        None
    }

    /// Returns the fixes, if the program is right with all of them together.
    fn whole(&self, fixes: Vec<Fix<'a>>) -> Option<Vec<Fix<'a>>> {
        let changes = fixes.iter().map(|it| (it.yours, it.text.clone())).collect();
        self.meets_the_goal(&changes).then_some(fixes)
    }

    /// Finds a mistake in what the chapter does not have, or where its functions don't fit.
    fn in_any(&self, common: &[Common<'a>]) -> Option<Vec<Fix<'a>>> {
        let of_common = common.iter().flat_map(|it| self.edits(it));
        let is_own = |it: &&ParsedFunction| common.iter().all(|(other, _)| other.name != it.name);
        let of_own = self.yours.iter().filter(is_own).flat_map(|own| {
            let edits = self.of_likest(own).into_iter();
            edits.map(move |edit| (own, edit))
        });
        let found = self.first(of_common.chain(of_own).collect(), &Vec::new())?;
        (found.1.rank <= READABLE).then(|| vec![Fix::edit(&found)])
    }
}
