//! Mutant schemata: writes a text with all of its edits, each as an alternative that is chosen by
//! its number when the program runs (Untch, Offutt and Harrold, 1993).
//!
//! An alternative is the text of the edit's [`Host`] with the edit made, so it holds no choice
//! itself; what is right in a host holds those of all hosts inside of it.

use std::cmp::Reverse;
use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

use crate::{ConstantUse, Edit, Form, Host};

/// The language in which a choice is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// A `match` over the number that [`CHOICE`] reads, for rustc.
    ///
    /// The arms are arguments of one generic method. In a plain `match`, rustc reports one wrong
    /// arm, gives the whole the type of an error, and is silent about all that uses it; as
    /// arguments, all wrong arms are reported at once, and the type stays known.
    Match,
    /// The interpreter's `mutants!(number, right, alternatives…)`.
    Mutants,
}

/// The items that a crate needs at its root for [`Notation::Match`]: they read the number from the
/// environment variable [`VARIABLE`]; without it, no alternative is chosen.
pub const CHOICE: &str = r#"
#[doc(hidden)]
pub fn rtrace_mutant() -> u32 {
    static NUMBER: ::std::sync::OnceLock<u32> = ::std::sync::OnceLock::new();
    *NUMBER.get_or_init(|| {
        let number = ::std::env::var("RTRACE_MUTANT").ok();
        number.and_then(|it| it.parse().ok()).unwrap_or(u32::MAX)
    })
}
#[doc(hidden)]
pub struct RtraceArms<T>(::std::marker::PhantomData<T>);
impl<T> RtraceArms<T> {
    pub const fn new() -> Self {
        Self(::std::marker::PhantomData)
    }
    #[inline(always)]
    pub fn is(&self, value: T) -> T {
        value
    }
}
"#;

/// The environment variable with the number of the edit that a program with [`CHOICE`] makes.
pub const VARIABLE: &str = "RTRACE_MUTANT";

/// A text with its edits, and where they are in it.
#[derive(Clone, Debug, Default)]
pub struct Written {
    /// The text.
    pub text: String,
    /// The bytes of each alternative, with the index of its edit.
    pub alternatives: Vec<(Range<usize>, usize)>,
    /// The bytes of each choice, with the indices of its edits.
    pub choices: Vec<(Range<usize>, Vec<usize>)>,
    /// What is copied: where it begins here, and its bytes there.
    copied: Vec<(usize, Range<usize>)>,
}

impl Written {
    /// Puts a text before all that is written.
    pub fn prepend(&mut self, text: &str) {
        let length = text.len();
        let shifted = |at: &Range<usize>| at.start + length..at.end + length;
        self.text.insert_str(0, text);
        self.alternatives
            .iter_mut()
            .for_each(|it| it.0 = shifted(&it.0));
        self.choices.iter_mut().for_each(|it| it.0 = shifted(&it.0));
        self.copied.iter_mut().for_each(|it| it.0 += length);
    }

    /// Returns the byte of the first text from which a byte of this one comes.
    pub fn origin(&self, byte: usize) -> usize {
        let part = self.copied.iter().rev().find(|it| it.0 <= byte);
        part.map_or(0, |(start, from)| from.end.min(from.start + byte - start))
    }
}

/// Writes one function with all of its edits for the interpreter, numbered from `first`. Returns
/// the text, and the number of each edit, in the order of `edits`.
pub fn mutants(text: &str, edits: &[Edit], first: u32) -> (String, Vec<u32>) {
    let chosen: Vec<usize> = (0..edits.len()).collect();
    let numbers: HashMap<usize, u32> = numbered(edits, &chosen, first);
    let schema = Schema {
        edits,
        uses: &[],
        numbers: &numbers,
    };
    let written = schema.write(0, &[text], Notation::Mutants);
    (written.text, chosen.iter().map(|it| numbers[it]).collect())
}

/// Numbers the chosen edits from `first` on, those of one host one after the other.
pub fn numbered(edits: &[Edit], chosen: &[usize], first: u32) -> HashMap<usize, u32> {
    let mut chosen = chosen.to_vec();
    chosen.sort_by_key(|it| (edits[*it].file, place_of(&edits[*it].host)));
    (first..)
        .zip(chosen)
        .map(|(number, it)| (it, number))
        .collect()
}

/// The order in which hosts are written: from the top, an outer one before those in it, and the
/// place before a statement before that.
fn place_of(host: &Host) -> (usize, bool, Reverse<usize>, Form) {
    let Range { start, end } = host.at;
    (start, start < end, Reverse(end), host.form)
}

/// What is written into the texts of a program.
#[derive(Clone, Copy, Debug)]
pub struct Schema<'a> {
    /// All edits.
    pub edits: &'a [Edit],
    /// The uses of constants.
    pub uses: &'a [ConstantUse],
    /// The numbers of the edits to write, by their indices; from [`numbered`].
    pub numbers: &'a HashMap<usize, u32>,
}

/// A choice to write: the host, and of each alternative the edit, its number and its text.
struct Choice {
    host: Host,
    alternatives: Vec<(usize, u32, String)>,
}

impl Schema<'_> {
    /// Writes the text with the index `file` with its edits.
    pub fn write(&self, file: usize, texts: &[&str], notation: Notation) -> Written {
        let choices = self.choices(file, texts);
        let mut writer = Writer {
            text: texts[file],
            choices: &choices,
            notation,
            next: 0,
        };
        let mut written = Written::default();
        writer.part(0..texts[file].len(), &mut written);
        written
    }

    /// Lists the choices of one text in the order in which they are written.
    fn choices(&self, file: usize, texts: &[&str]) -> Vec<Choice> {
        let mut choices: BTreeMap<_, Choice> = BTreeMap::new();
        let mut add = |host: &Host, alternative| {
            let (host, alternatives) = (host.clone(), Vec::new());
            let choice = choices.entry(place_of(&host));
            let choice = choice.or_insert_with(|| Choice { host, alternatives });
            choice.alternatives.push(alternative);
        };
        let mut chosen: Vec<(usize, u32)> = self.numbers.iter().map(|it| (*it.0, *it.1)).collect();
        chosen.sort_by_key(|it| it.1);
        for (n, number) in chosen {
            let edit = &self.edits[n];
            let text = texts[edit.file];
            let name = constant_name(&edit.host, text);
            if edit.file == file {
                let new = edit.hosted(text);
                let new = match name {
                    Some(name) => new.replacen(name, &format!("{name}__{number}"), 1),
                    None => new,
                };
                add(&edit.host, (n, number, new));
            }
            for used in self.uses.iter().filter(|it| it.file == file) {
                let path = &texts[file][used.at.clone()];
                if name.is_some() && path.rsplit("::").next().map(str::trim) == name {
                    let host = Host {
                        at: used.at.clone(),
                        form: Form::Expression,
                    };
                    add(&host, (n, number, format!("{path}__{number}")));
                }
            }
        }
        choices.into_values().collect()
    }
}

/// Returns the name of a constant that is a host; `None` for other hosts.
fn constant_name<'t>(host: &Host, text: &'t str) -> Option<&'t str> {
    let after = text[host.at.clone()].split_once("const ")?.1;
    let name = after.split(':').next()?.trim();
    (host.form == Form::Constant).then_some(name)
}

/// Writes one text.
struct Writer<'a> {
    text: &'a str,
    choices: &'a [Choice],
    notation: Notation,
    /// The index of the next choice to write.
    next: usize,
}

impl Writer<'_> {
    /// Writes a part of the text, with all choices in it.
    fn part(&mut self, at: Range<usize>, to: &mut Written) {
        let mut done = at.start;
        while let Some(choice) = self.choices.get(self.next)
            && choice.host.at.end <= at.end
            && choice.host.at.start < at.end
        {
            self.next += 1;
            self.copy(done..choice.host.at.start, to);
            done = choice.host.at.end;
            self.choice(choice, to);
        }
        self.copy(done..at.end, to);
    }

    fn copy(&self, at: Range<usize>, to: &mut Written) {
        to.copied.push((to.text.len(), at.clone()));
        to.text += &self.text[at];
    }

    fn choice(&mut self, choice: &Choice, to: &mut Written) {
        let start = to.text.len();
        let (host, all) = (&choice.host, &choice.alternatives);
        let numbers: Vec<u32> = all.iter().map(|it| it.1).collect();
        let [open, before, after, close] = match self.notation {
            Notation::Match => in_match(host.form, &numbers),
            Notation::Mutants => in_mutants(host.form, numbers[0]),
        };
        to.text += &open;
        self.part(host.at.clone(), to);
        to.text += &after;
        for (edit, number, text) in all {
            to.text += &before.replace('#', &number.to_string());
            let start = to.text.len();
            to.text += text;
            to.alternatives.push((start..to.text.len(), *edit));
            to.text += &after;
        }
        to.text += &close;
        let edits = all.iter().map(|it| it.0).collect();
        to.choices.push((start..to.text.len(), edits));
    }
}

/// Returns what stands before the right text of a choice, before each alternative with `#` for its
/// number, behind each of these, and at the end.
fn in_match(form: Form, numbers: &[u32]) -> [String; 4] {
    let head = format!("match crate::rtrace_mutant() {{ {} => ", all_but(numbers));
    let arms = "let rtrace = crate::RtraceArms::new(); ";
    match form {
        Form::Constant => ["", "\n", "", ""].map(str::to_owned),
        Form::Statement => [&*(head + "{ "), "# => { ", " } ", "}"].map(str::to_owned),
        Form::Block => {
            let open = format!("{{ {arms}{head}rtrace.is(");
            [&*open, "# => rtrace.is(", "), ", "} }"].map(str::to_owned)
        }
        Form::Expression => {
            let open = format!("({{ {arms}{head}rtrace.is(");
            [&*open, "# => rtrace.is(", "), ", "} })"].map(str::to_owned)
        }
    }
}

/// As [`in_match`], for the interpreter.
fn in_mutants(form: Form, first: u32) -> [String; 4] {
    let head = format!("mutants!({first}, ");
    match form {
        Form::Constant => ["", "\n", "", ""].map(str::to_owned),
        Form::Statement => [&*(head + "{ "), ", { ", " }", ");"].map(str::to_owned),
        Form::Block => [&*format!("{{ {head}"), ", ", "", ") }"].map(str::to_owned),
        Form::Expression => [&*format!("({head}"), ", ", "", "))"].map(str::to_owned),
    }
}

/// Writes the pattern of all numbers but these, which are sorted.
fn all_but(numbers: &[u32]) -> String {
    let mut parts = Vec::new();
    let mut from = 0;
    for number in numbers {
        if *number > from {
            parts.push(format!("{from}..{number}"));
        }
        from = number + 1;
    }
    parts.push(format!("{from}.."));
    parts.join(" | ")
}
