//! Search for a repair: first the function that holds the mistake, by putting the chapter's in
//! its place, and then the likeliest edit inside of it that is as good.

use std::cell::Cell;

use super::edit::Edit;
use super::functions::{Files, Function, with};
use super::goal::{Goal, program};
use super::{chapter, generic};

/// No more texts are tried than can be in two seconds.
const TRIED: u32 = 500;
/// Two edits are tried where the one that is found is less likely than this.
const LIKELY: u32 = 14;
/// Of so many edits each is tried with each other.
const PAIRED: usize = 45;
/// Nobody would recognize the mistake in a less likely edit.
const READABLE: u32 = 16;

/// A function of the reader's with the text that makes the program right.
pub(super) struct Fix<'a> {
    pub(super) yours: &'a Function,
    pub(super) text: String,
    /// The chapter's function, if that takes its place as a whole.
    pub(super) right: Option<&'a Function>,
}

impl<'a> Fix<'a> {
    fn edit((yours, edit): &(&'a Function, Edit)) -> Self {
        Self {
            yours,
            text: edit.applied_to(&yours.text),
            right: None,
        }
    }

    fn whole((yours, right): &Common<'a>) -> Self {
        Self {
            yours,
            text: right[0].text.clone(),
            right: Some(right[0]),
        }
    }
}

/// A reader's program and what it is compared with.
pub(super) struct Search<'a> {
    pub(super) files: &'a Files,
    pub(super) yours: &'a [Function],
    pub(super) chapter: &'a [Function],
    pub(super) goal: &'a Goal,
    pub(super) tried: Cell<u32>,
}

/// A function of the reader's, and those of the same name that are right.
type Common<'a> = (&'a Function, Vec<&'a Function>);

/// Functions with other texts.
type Changes<'a> = Vec<(&'a Function, String)>;

impl<'a> Search<'a> {
    /// What makes the program right, if something does.
    pub(super) fn find(&self) -> Option<Vec<Fix<'a>>> {
        let common = self.common();
        let swapped = |(yours, right): &Common<'a>| {
            let is_right = |it: &&Function| self.is_right(&vec![(*yours, it.text.clone())]);
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
        let rank = found.as_ref().map_or(u32::MAX, |(_, edit)| edit.rank);
        let pair = || {
            swapped
                .iter()
                .find_map(|common| self.by_two_edits(common, rank))
        };
        let found = if rank > LIKELY {
            pair().or(found)
        } else {
            found
        };
        match found.filter(|(_, edit)| edit.rank <= READABLE) {
            Some(edit) => Some(vec![Fix::edit(&edit)]),
            None => self.whole(vec![Fix::whole(&swapped[0])]),
        }
    }

    /// The functions that the reader and the chapter have in common.
    fn common(&self) -> Vec<Common<'a>> {
        let common = self.yours.iter().map(|yours| {
            let right = self.chapter.iter().filter(|it| it.name == yours.name);
            (yours, right.collect::<Vec<_>>())
        });
        common.filter(|(_, right)| !right.is_empty()).collect()
    }

    /// Whether the program is right with these texts, as long as one more may be tried.
    fn is_right(&self, changes: &Changes) -> bool {
        self.tried.set(self.tried.get() + 1);
        self.tried.get() <= TRIED && self.meets_the_goal(changes)
    }

    fn meets_the_goal(&self, changes: &Changes) -> bool {
        program(&self.changed(changes)).is_some_and(|it| self.goal.is_met_by(&it))
    }

    /// The same for every pixel.
    fn is_whole(&self, changes: &Changes) -> bool {
        program(&self.changed(changes)).is_some_and(|it| self.goal.is_drawn_by(&it))
    }

    fn changed(&self, changes: &Changes) -> Files {
        let changes: Vec<_> = changes
            .iter()
            .map(|(it, text)| (*it, text.as_str()))
            .collect();
        with(self.files, &changes)
    }

    /// The likeliest edit that makes the program right, in this function or in what it calls.
    fn repair(&self, common: &Common<'a>, others: &Changes<'a>) -> Option<(&'a Function, Edit)> {
        let mut edits = self.edits(common);
        let is_called = |it: &&Function| {
            let is_common = self.chapter.iter().any(|other| other.name == it.name);
            !is_common && common.0.text.contains(it.short_name())
        };
        for helper in self.yours.iter().filter(is_called) {
            let all = generic::edits(helper, None);
            edits.extend(all.into_iter().map(|edit| (helper, edit)));
        }
        self.first(edits, others)
    }

    /// The edits of a function.
    fn edits(&self, (yours, right): &Common<'a>) -> Vec<(&'a Function, Edit)> {
        let theirs = right.iter().flat_map(|right| chapter::edits(yours, right));
        let generic = generic::edits(yours, right.first().copied());
        theirs.chain(generic).map(|edit| (*yours, edit)).collect()
    }

    /// The likeliest of the edits that make the program right.
    fn first(
        &self,
        mut edits: Vec<(&'a Function, Edit)>,
        others: &Changes<'a>,
    ) -> Option<(&'a Function, Edit)> {
        edits.sort_by_key(|(_, edit)| edit.rank);
        let mut seen: Vec<(&str, String)> = Vec::new();
        edits.into_iter().find(|(function, edit)| {
            if self.tried.get() > TRIED {
                return false;
            }
            let text = edit.applied_to(&function.text);
            let key = (function.name.as_str(), text.clone());
            if text == function.text || seen.contains(&key) {
                return false;
            }
            seen.push(key);
            let changes = [others.clone(), vec![(*function, text)]].concat();
            self.is_right(&changes) && self.is_whole(&changes)
        })
    }

    /// Two edits of the chapter's that make the program right together.
    fn by_two_edits(
        &self,
        (yours, right): &Common<'a>,
        below: u32,
    ) -> Option<(&'a Function, Edit)> {
        let mut edits: Vec<Edit> = right
            .iter()
            .flat_map(|it| chapter::edits(yours, it))
            .collect();
        edits.sort_by_key(|edit| edit.rank);
        edits.dedup_by(|one, other| one.parts == other.parts);
        edits.truncate(PAIRED);
        let pairs = edits.iter().enumerate().flat_map(|(n, edit)| {
            let others = edits[..n].iter();
            others.filter_map(|other| edit.and(other))
        });
        let likely = pairs.filter(|edit| edit.rank + 4 < below.min(2 * READABLE));
        // What two mistakes cost together is no more than each may.
        let halved = likely.map(|edit| Edit {
            rank: edit.rank / 2,
            ..edit
        });
        self.first(halved.map(|edit| (*yours, edit)).collect(), &Vec::new())
    }

    /// Mistakes in two functions: each is repaired while the other is the chapter's.
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
            let fixes = self.whole(vec![Fix::edit(&other), Fix::edit(&one)]);
            if fixes.is_some() {
                return fixes;
            }
        }
        self.whole(vec![Fix::whole(&common[m]), Fix::whole(&common[n])])
    }

    /// The fixes, if the program is right with all of them together.
    fn whole(&self, fixes: Vec<Fix<'a>>) -> Option<Vec<Fix<'a>>> {
        let changes = fixes.iter().map(|it| (it.yours, it.text.clone())).collect();
        (self.meets_the_goal(&changes) && self.is_whole(&changes)).then_some(fixes)
    }

    /// A mistake in what the chapter does not have, or where its functions don't fit.
    fn in_any(&self, common: &[Common<'a>]) -> Option<Vec<Fix<'a>>> {
        let of_common = common.iter().flat_map(|it| self.edits(it));
        let is_own = |it: &&Function| common.iter().all(|(other, _)| other.name != it.name);
        let helpers = self.yours.iter().filter(is_own);
        let of_helpers = helpers.flat_map(|helper| {
            let edits = generic::edits(helper, None).into_iter();
            edits.map(move |edit| (helper, edit))
        });
        let found = self.first(of_common.chain(of_helpers).collect(), &Vec::new())?;
        (found.1.rank <= READABLE).then(|| vec![Fix::edit(&found)])
    }
}
