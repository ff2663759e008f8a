//! Tree comparison: the statements of a reader's, in any language, beside those of a chapter.

use std::collections::BTreeMap;
use std::rc::Rc;

use language::{Language, Op, Pattern, Role, Tree, canonical, normal, plain};

use super::{LineStatus, SourceLine, TypedStatement, is_same_name, read};

/// So many lines are tried in one place, if they have this much in common with what is there.
const TRIED: usize = 3;
const ALIKE: f64 = 0.4;
/// A line that is so much like one of the chapter's is that line, with a mistake in it.
const MISTAKEN: f64 = 0.75;

/// The lines of a reader's beside the functions of a chapter.
pub(crate) struct LineComparison<'a> {
    places: Vec<ChapterStatement>,
    typed: &'a [TypedStatement],
}

/// A statement of the chapter's.
#[derive(Clone)]
struct ChapterStatement {
    /// The name and the text of its function.
    function: (Rc<str>, Rc<str>),
    role: Role,
    value: Tree,
    pattern: Pattern,
}

/// What one text of a function has and another has not.
pub(crate) struct StatementDiff {
    lost: Vec<ChapterStatement>,
    added: Vec<ChapterStatement>,
}

/// A line of a reader's in the place of the chapter's.
pub(crate) struct Transplant {
    /// The function, and its text with the line in Rust.
    pub(crate) function: Rc<str>,
    pub(crate) text: String,
    pub(crate) yours: CorrectedLine,
    /// True if it is there for what the chapter's is there for.
    pub(crate) has_same_role: bool,
}

/// A line of a reader's, and what should be there in the reader's spelling.
#[derive(Clone, Debug)]
pub(crate) struct CorrectedLine {
    pub(crate) line: SourceLine,
    pub(crate) right: String,
}

impl<'a> LineComparison<'a> {
    /// Compares the functions with what was typed.
    pub(crate) fn new<'f>(
        functions: impl Iterator<Item = (&'f str, &'f str)>,
        typed: &'a [TypedStatement],
    ) -> Self {
        Self {
            places: functions
                .flat_map(|(name, text)| places(name, text))
                .collect(),
            typed,
        }
    }

    /// Returns true if no line is known.
    pub(crate) fn is_empty(&self) -> bool {
        self.typed.is_empty()
    }

    /// Counts the chapter's statements that the reader has.
    pub(crate) fn count(&self) -> usize {
        self.places.iter().filter(|it| self.typed(it) > 0).count()
    }

    /// Tells what the lines say of a change: a line is wrong if it stands there more often than in
    /// the chapter, and right if it stands there as often.
    pub(crate) fn say(&self, change: &StatementDiff) -> LineStatus {
        let stands = |it: &ChapterStatement| {
            self.places
                .iter()
                .filter(|own| it.stands_in(&own.role, own.pattern.tree(), self))
                .count()
        };
        let is_right = |it: &ChapterStatement| self.typed(it) > 0 && self.typed(it) >= stands(it);
        // What is left out has nothing in its place that is like it.
        let is_mistaken = |it: &ChapterStatement| {
            change.added.is_empty() && self.likest(it).is_some_and(|like| like > MISTAKEN)
        };
        if change.lost.iter().any(|it| is_right(it) || is_mistaken(it)) {
            LineStatus::Right
        } else if change.added.iter().any(|it| self.typed(it) > stands(it)) {
            LineStatus::Wrong
        } else {
            LineStatus::NotFound
        }
    }

    /// Finds the reader's line that has what a change puts there.
    pub(crate) fn found(&self, change: &StatementDiff) -> Option<CorrectedLine> {
        let mut added = change.added.iter();
        added.find_map(|place| {
            let typed = self
                .typed
                .iter()
                .find(|it| place.stands_in(&it.role, &it.normal, self))?;
            let right = change.lost.iter().find(|it| it.role == place.role);
            let right = right.or(change.lost.first());
            Some(CorrectedLine {
                line: typed.line.clone(),
                right: right.map_or(String::new(), |it| it.in_the_spelling_of(place, typed)),
            })
        })
    }

    fn typed(&self, place: &ChapterStatement) -> usize {
        let has = |it: &&TypedStatement| {
            place.stands_in(&it.role, &it.normal, self) && !self.is_computed(place, it)
        };
        self.typed.iter().filter(has).count()
    }

    /// Returns true if what stands there for a name of the chapter's is computed before: then the
    /// line is not all of what the chapter's is.
    fn is_computed(&self, place: &ChapterStatement, typed: &TypedStatement) -> bool {
        let Some(found) = place.pattern.find(&typed.normal) else {
            return false;
        };
        let is_sum = |it: &&Tree| matches!(it.op, Op::Sign(_)) || it.is_call("sqrt");
        let computes = |name: &str| {
            let is_it = |it: &&TypedStatement| {
                matches!(&it.role, Role::Given(own) if canonical(own) == name)
                    && it.line.file == typed.line.file
            };
            let mut given = self.typed.iter().filter(is_it);
            given.any(|it| it.normal.nodes().iter().any(is_sum))
        };
        let is_given = |name: &str| {
            self.places
                .iter()
                .any(|it| matches!(&it.role, Role::Given(own) if canonical(own) == name))
        };
        let mut others = found.names.iter().filter(|(one, other)| one != other);
        others.any(|(one, other)| !is_given(one) && computes(other))
    }

    /// Finds how much like the place that line is which is most like it and no other place's.
    fn likest(&self, place: &ChapterStatement) -> Option<f64> {
        let wrong = self.wrong().into_iter();
        let like = wrong.map(|it| likeness(&it.normal, place.pattern.tree()));
        like.max_by(f64::total_cmp)
    }

    /// Lists the reader's lines that the chapter does not have.
    fn wrong(&self) -> Vec<&'a TypedStatement> {
        let is_right = |it: &TypedStatement| {
            self.places
                .iter()
                .any(|place| place.stands_in(&it.role, &it.normal, self))
        };
        self.typed.iter().filter(|it| !is_right(it)).collect()
    }

    /// Puts lines that the chapter does not have in the place of those that the reader does not
    /// have.
    pub(crate) fn transplants(&self) -> Vec<Transplant> {
        let wrong = self.wrong();
        let missing = self.places.iter().filter(|it| self.typed(it) == 0);
        missing
            .flat_map(|place| place.transplants(&wrong))
            .collect()
    }
}

impl StatementDiff {
    /// Compares texts of functions, each with another one of it.
    pub(crate) fn of<'f>(pairs: impl Iterator<Item = (&'f str, &'f str, &'f str)>) -> Self {
        let (mut lost, mut added) = (Vec::new(), Vec::new());
        for (name, right, wrong) in pairs {
            let (right, wrong) = (places(name, right), places(name, wrong));
            let only =
                |one: &[ChapterStatement], other: &[ChapterStatement]| -> Vec<ChapterStatement> {
                    let has = |it: &&ChapterStatement| !other.iter().any(|other| it.is_same(other));
                    one.iter().filter(has).cloned().collect()
                };
            lost.extend(only(&right, &wrong));
            added.extend(only(&wrong, &right));
        }
        Self { lost, added }
    }

    /// Returns true if these functions have what it puts there.
    pub(crate) fn is_in<'f>(&self, functions: impl Iterator<Item = (&'f str, &'f str)>) -> bool {
        let all: Vec<ChapterStatement> = functions
            .flat_map(|(name, text)| places(name, text))
            .collect();
        let mut added = self.added.iter();
        !self.added.is_empty() && added.all(|it| all.iter().any(|other| it.is_same(other)))
    }
}

/// Finds the statements of a function that say something.
fn places(name: &str, text: &str) -> Vec<ChapterStatement> {
    let function: (Rc<str>, Rc<str>) = (name.into(), text.into());
    let all = read(text, Language::Rust);
    let names = all.iter().flat_map(|it| {
        let given = match &it.role {
            Role::Given(name) | Role::Each(name) => Some(canonical(name)),
            _ => None,
        };
        names(&normal(&it.value)).into_iter().chain(given)
    });
    let known: Rc<[String]> = names.collect();
    let says = |it: &&Tree| !it.parts.is_empty() || matches!(it.op, Op::Number(..));
    let places = all.iter().filter_map(|it| {
        // Of what is put into `Some` only that.
        let value = match &it.value.parts[..] {
            [some] if it.value.is_call("Some") => some,
            _ => &it.value,
        };
        says(&value).then(|| ChapterStatement {
            function: function.clone(),
            role: it.role.clone(),
            pattern: Pattern::new(value, Rc::clone(&known)),
            value: value.clone(),
        })
    });
    places.collect()
}

impl ChapterStatement {
    fn is_same(&self, other: &Self) -> bool {
        self.role == other.role && self.pattern.tree().is_same(other.pattern.tree())
    }

    /// Returns true if a statement says it: by another name of its own, or as a part of it.
    fn stands_in(&self, role: &Role, value: &Tree, lines: &LineComparison) -> bool {
        match (&self.role, role) {
            (Role::Given(name), Role::Given(own)) if !is_same_name(name, own) => {
                // It is given to something else that the chapter has.
                let is_it = |it: &ChapterStatement| matches!(&it.role, Role::Given(other) if is_same_name(other, own));
                if self.pattern.is_small() || lines.places.iter().any(is_it) {
                    return self
                        .pattern
                        .find(value)
                        .is_some_and(|it| !std::ptr::eq(it.tree, value))
                        && !self.pattern.is_small();
                }
            }
            (Role::Given(_), Role::Given(_)) => {}
            _ if self.pattern.is_small() && self.role != *role => return false,
            _ => {}
        }
        self.pattern.find(value).is_some()
    }

    /// Returns true if the statement can stand there: a condition for one, a value for a value.
    fn takes(&self, typed: &TypedStatement) -> bool {
        let kind = |role: &Role| match role {
            Role::Condition => 0,
            Role::Done => 1,
            Role::Each(_) => 2,
            Role::Given(_) | Role::Result => 3,
        };
        kind(&self.role) == kind(&typed.role)
    }

    /// Pairs the reader's names that the chapter's function does not have with those that the
    /// reader's line does not have, in the order in which they come.
    fn renames(&self, typed: &TypedStatement) -> Vec<(String, String)> {
        let (own, theirs) = (names(&typed.normal), names(self.pattern.tree()));
        let new = own.iter().filter(|name| !self.pattern.knows(name));
        let free = theirs.iter().filter(|name| !own.contains(name));
        new.cloned().zip(free.cloned()).collect()
    }

    fn transplants(&self, wrong: &[&TypedStatement]) -> Vec<Transplant> {
        let scored = wrong.iter().filter(|it| self.takes(it)).map(|it| {
            let renames = self.renames(it);
            let value = renamed(&it.normal, &renames);
            let named = if self.has_role_of(it) { 0.4 } else { 0.0 };
            (likeness(&value, self.pattern.tree()) + named, renames, *it)
        });
        let mut likest: Vec<_> = scored.filter(|(score, ..)| *score > ALIKE).collect();
        likest.sort_by(|one, other| other.0.total_cmp(&one.0));
        let likest = likest.into_iter().take(TRIED);
        let transplants = likest.filter_map(|(_, renames, typed)| {
            Some(Transplant {
                function: Rc::clone(&self.function.0),
                text: self.with(&self.in_rust(typed, &renames)?),
                has_same_role: self.has_role_of(typed),
                yours: CorrectedLine {
                    line: typed.line.clone(),
                    right: self.printed(typed, &turned(renames)),
                },
            })
        });
        transplants.collect()
    }

    /// Returns the function with another expression in this place.
    fn with(&self, new: &str) -> String {
        let mut text = self.function.1.to_string();
        text.replace_range(self.value.at.clone(), new);
        text
    }

    fn has_role_of(&self, typed: &TypedStatement) -> bool {
        match (&self.role, &typed.role) {
            (Role::Given(one), Role::Given(other)) => is_same_name(one, other),
            (one, other) => one == other,
        }
    }

    /// Prints a reader's line as Rust, with the chapter's names.
    fn in_rust(&self, typed: &TypedStatement, renames: &[(String, String)]) -> Option<String> {
        let spelled = spelled_names(&self.function.1);
        let name = |it: &Tree| {
            let name = it.name()?;
            let name = renames
                .iter()
                .find(|(own, _)| own == name)
                .map_or(name, |(_, theirs)| theirs);
            let spelled = spelled.get(name)?;
            Some(Tree::new(Op::Name(spelled.clone()), Vec::new()))
        };
        Language::Rust.print(&plain(&typed.value).mapped(&name))
    }

    /// Prints the place as the reader would, whose line has the wrong one's value.
    fn in_the_spelling_of(&self, wrong: &Self, typed: &TypedStatement) -> String {
        let found = wrong.pattern.find(&typed.normal);
        self.printed(typed, &found.map_or(Vec::new(), |it| it.names))
    }

    /// Prints the place in the language of a line, with these names for its own.
    fn printed(&self, typed: &TypedStatement, names: &[(String, String)]) -> String {
        let spelled: BTreeMap<String, &str> = typed
            .value
            .nodes()
            .into_iter()
            .filter_map(|it| Some((canonical(it.name()?), it.name()?)))
            .collect();
        let name = |it: &Tree| {
            let own = canonical(it.name()?);
            let own = names
                .iter()
                .find(|(theirs, _)| *theirs == own)
                .map_or(own, |(_, own)| own.clone());
            Some(Tree::new(
                Op::Name((*spelled.get(&own)?).to_owned()),
                Vec::new(),
            ))
        };
        let value = self.value.mapped(&name);
        let text = typed.language.print(&value);
        let text = text.unwrap_or_else(|| self.function.1[self.value.at.clone()].to_owned());
        match &typed.role {
            Role::Given(name) => format!("{name} = {text}"),
            _ => text,
        }
    }
}

fn turned(names: Vec<(String, String)>) -> Vec<(String, String)> {
    names.into_iter().map(|(one, other)| (other, one)).collect()
}

/// Finds how a function of Rust spells its names: as a field, and as a real number where it is made
/// one.
fn spelled_names(text: &str) -> BTreeMap<String, String> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let words = text.split(|c| !is_word(c)).filter(|it| !it.is_empty());
    let spelled = words.map(|word| {
        let field = format!("self.{word}");
        let name = if text.contains(&field) {
            field
        } else {
            word.to_owned()
        };
        let real = format!("f64::from({name})");
        (
            canonical(word),
            if text.contains(&real) { real } else { name },
        )
    });
    spelled.collect()
}

/// Lists names, in the order in which they first stand.
fn names(tree: &Tree) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for name in tree.nodes().into_iter().filter_map(Tree::name) {
        if !all.iter().any(|it| it == name) {
            all.push(name.to_owned());
        }
    }
    all
}

fn renamed(tree: &Tree, renames: &[(String, String)]) -> Tree {
    tree.mapped(&|it| {
        let name = it.name()?;
        let (_, other) = renames.iter().find(|(own, _)| own == name)?;
        Some(Tree::new(Op::Name(other.clone()), Vec::new()))
    })
}

/// Measures how many nodes two trees have in common, from 0 to 1 (Dice, 1945).
fn likeness(one: &Tree, other: &Tree) -> f64 {
    let ops = |tree: &Tree| -> Vec<Op> { tree.nodes().iter().map(|it| it.op.clone()).collect() };
    let (one, mut left) = (ops(one), ops(other));
    let all = one.len() + left.len();
    let is_taken = |it: &&Op| {
        let at = left.iter().position(|other| other == *it);
        at.map(|at| left.swap_remove(at)).is_some()
    };
    2.0 * one.iter().filter(is_taken).count() as f64 / all as f64
}
