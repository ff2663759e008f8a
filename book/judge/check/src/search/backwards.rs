//! Fault localization and program repair: finds the function with the mistake, by putting the
//! chapter's in its place, and then the likeliest edit of it that makes the program right.

use std::cell::Cell;
use std::collections::HashSet;

use super::edit::{RankedEdit, words};
use interpreter::Program;

use super::functions::RustFn;
use super::goal::Goal;
use super::{mutation, nearer};

/// The most bytes of functions that the search may read, which takes two seconds at most.
const READ: usize = 1 << 20;
/// The greatest [rank](RankedEdit::rank) of an edit that is shown: in one of a greater rank a
/// reader would not recognize the mistake.
const READABLE: u32 = 16;

/// A function of a reader and its repaired text.
pub(super) struct Fix<'a> {
    /// The function as it is.
    pub(super) yours: &'a RustFn,
    /// The text that repairs the program.
    pub(super) text: String,
}

impl<'a> Fix<'a> {
    /// Makes the fix of an edit of a function.
    fn edit((yours, edit): &(&'a RustFn, RankedEdit)) -> Self {
        Self {
            yours,
            text: edit.applied_to(&yours.text),
        }
    }
}

/// The search for the edit that makes a reader's program right.
pub(super) struct RepairSearch<'a> {
    /// The program as it is.
    pub(super) program: &'a Program,
    /// The functions of the program.
    pub(super) yours: &'a [RustFn],
    /// The functions of the chapter's program.
    pub(super) chapter: &'a [RustFn],
    /// The test that a right program passes.
    pub(super) goal: &'a Goal,
    /// The bytes of functions that have been read; beyond [`READ`] no more edits are tried.
    pub(super) read: Cell<usize>,
}

/// A function of the reader, and those of the same name in the chapter; never empty.
type Common<'a> = (&'a RustFn, Vec<&'a RustFn>);

/// Makes the edits that undo what people often mistype.
fn generic(function: &RustFn) -> Vec<RankedEdit> {
    let all = mutation::mutations(function).into_iter();
    all.map(|it| it.edit(&function.text)).collect()
}

/// Functions of the reader, each with another text to try.
type Patches<'a> = Vec<(&'a RustFn, String)>;

impl<'a> RepairSearch<'a> {
    /// Finds the functions whose repair makes the program right, one or two; `None` if no edit does
    /// within the limits.
    pub(super) fn find(&self) -> Option<Vec<Fix<'a>>> {
        let common = self.common();
        let swapped = |(yours, right): &Common<'a>| {
            let is_right = |it: &&RustFn| self.is_right(&vec![(*yours, it.text.clone())]);
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
            .filter_map(|common| self.first(self.edits(common), &Vec::new()));
        let found = found.min_by_key(|(_, edit)| edit.rank);
        let found = found.filter(|(_, edit)| edit.rank <= READABLE);
        found.map(|edit| vec![Fix::edit(&edit)])
    }

    /// Pairs the reader's functions with those of the same name in the chapter.
    fn common(&self) -> Vec<Common<'a>> {
        let common = self.yours.iter().map(|yours| {
            let right = self.chapter.iter().filter(|it| it.name == yours.name);
            (yours, right.collect::<Vec<_>>())
        });
        common.filter(|(_, right)| !right.is_empty()).collect()
    }

    /// Returns true if the program with these patches meets the goal; false once [`READ`] is
    /// exceeded.
    fn is_right(&self, changes: &Patches) -> bool {
        let bytes: usize = changes.iter().map(|(_, text)| text.len()).sum();
        self.read.set(self.read.get() + bytes);
        self.may_try() && self.meets_the_goal(changes)
    }

    /// Returns true if the search may go on.
    fn may_try(&self) -> bool {
        self.read.get() <= READ
    }

    /// Returns true if the program with these patches is read and meets the goal.
    fn meets_the_goal(&self, changes: &Patches) -> bool {
        let mut changes = changes.iter();
        let program = changes.try_fold(self.program.clone(), |program, (it, text)| {
            program.patched(&it.name, text).ok()
        });
        program.is_some_and(|it| self.goal.is_met_by(&it))
    }

    /// Lists the edits of a function and of the helpers that it calls, to try them.
    fn edits(&self, (yours, right): &Common<'a>) -> Vec<(&'a RustFn, RankedEdit)> {
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

    /// Drops the edits that remove a call of a helper, since they would hide a mistake in the
    /// helper.
    fn keeping_calls(&self, yours: &RustFn, mut edits: Vec<RankedEdit>) -> Vec<RankedEdit> {
        for helper in self.helpers(yours) {
            edits.retain(|it| !it.removes_call(helper.short_name(), &yours.text));
        }
        edits
    }

    /// Lists the edits that bring a function nearer to the chapter's, or to a function that the
    /// chapter's calls and the reader does not have.
    fn of_chapter(&self, yours: &RustFn, right: &[&RustFn]) -> Vec<RankedEdit> {
        let is_missing = |it: &&RustFn| self.yours.iter().all(|own| own.name != it.name);
        let is_called = |it: &&RustFn| {
            let mut callers = right.iter();
            callers.any(|right| words(&right.text).contains(&it.name.as_str()))
        };
        let called = self.chapter.iter().filter(is_called).filter(is_missing);
        let all = right.iter().copied().chain(called);
        let edits = all.flat_map(|right| nearer::edits(yours, right));
        self.keeping_calls(yours, edits.collect())
    }

    /// Finds the function of the chapter whose body is most like that of this one.
    fn likest(&self, own: &RustFn) -> Option<&'a RustFn> {
        let like = |it: &&RustFn| it.body.likeness(&own.body);
        let all = self.chapter.iter();
        all.max_by(|one, other| like(one).total_cmp(&like(other)))
    }

    /// Lists the edits of a function that the chapter does not have: those that bring it nearer to
    /// the chapter's most similar one, and those of what people mistype.
    fn of_likest(&self, own: &RustFn) -> Vec<RankedEdit> {
        let right = self.likest(own);
        let theirs = right.map_or(Vec::new(), |right| nearer::edits(own, right));
        let theirs = self.keeping_calls(own, theirs);
        [theirs, generic(own)].concat()
    }

    /// Lists the functions that only the reader has and that this one calls, directly or through
    /// others.
    fn helpers(&self, caller: &RustFn) -> Vec<&'a RustFn> {
        let is_own = |it: &&RustFn| self.chapter.iter().all(|other| other.name != it.name);
        let mut called: Vec<&RustFn> = Vec::new();
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

    /// Finds the edit of the lowest rank that makes the program right together with the other
    /// patches.
    fn first(
        &self,
        mut edits: Vec<(&'a RustFn, RankedEdit)>,
        others: &Patches<'a>,
    ) -> Option<(&'a RustFn, RankedEdit)> {
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

    /// Finds mistakes in two functions, by repairing each while the other is the chapter's.
    fn in_two(&self, common: &[Common<'a>]) -> Option<Vec<Fix<'a>>> {
        let pairs = (0..common.len()).flat_map(|n| (0..n).map(move |m| [n, m]));
        let swap = |n: usize| (common[n].0, common[n].1[0].text.clone());
        let are_right = |[n, m]: &[usize; 2]| self.is_right(&vec![swap(*n), swap(*m)]);
        let [n, m] = pairs.into_iter().find(are_right)?;
        let edits = [(n, m), (m, n)];
        let edits =
            edits.map(|(own, other)| self.first(self.edits(&common[own]), &vec![swap(other)]));
        if let [Some(one), Some(other)] = edits
            && [&one, &other].iter().all(|(_, edit)| edit.rank <= READABLE)
        {
            let fixes = vec![Fix::edit(&other), Fix::edit(&one)];
            let changes = fixes.iter().map(|it| (it.yours, it.text.clone())).collect();
            return self.meets_the_goal(&changes).then_some(fixes);
        }
        None
    }

    /// Finds a mistake where no function of the chapter can replace the reader's, by trying the
    /// edits of all functions.
    fn in_any(&self, common: &[Common<'a>]) -> Option<Vec<Fix<'a>>> {
        let of_common = common.iter().flat_map(|it| self.edits(it));
        let is_own = |it: &&RustFn| common.iter().all(|(other, _)| other.name != it.name);
        let of_own = self.yours.iter().filter(is_own).flat_map(|own| {
            let edits = self.of_likest(own).into_iter();
            edits.map(move |edit| (own, edit))
        });
        let found = self.first(of_common.chain(of_own).collect(), &Vec::new())?;
        (found.1.rank <= READABLE).then(|| vec![Fix::edit(&found)])
    }
}
