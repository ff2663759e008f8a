//! Programs: how their files are read, patched and mutated, and how their functions are called.

use std::fmt;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

use crate::collect::{Source, collect};
use crate::fault::{Fault, FaultKind, PRELUDE, Span};
use crate::lower::lower;
use crate::machine::{Compiled, Machine};
use crate::names::{Item, Names, Scope};
use crate::natives;
use crate::syntax::parse;
use crate::value::{Target, Value};

/// The texts that every program has: the standard library's types, and the lesson's prelude.
const TEXTS: [&str; 2] = [include_str!("texts/std.rs"), PRELUDE_TEXT];

/// The text of the lesson's prelude: vectors, rays, camera and sky.
pub const PRELUDE_TEXT: &str = include_str!("texts/prelude.rs");

/// A file of a program as its author typed it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceFile {
    /// The path from the folder of the program, with `/`, such as `src/lib.rs`.
    pub name: String,
    /// The whole text.
    pub text: String,
}

impl SourceFile {
    /// Makes a file from its path, such as `src/lib.rs`, and its whole text. Nothing is read from
    /// the disk.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            text: text.into(),
        }
    }
}

/// A program that was read without a fault and can be run. Its parts are shared with the programs
/// that are made of it.
#[derive(Clone)]
pub struct Program {
    pub(crate) code: Arc<Compiled>,
    refused: Arc<OnceLock<Fault>>,
}

impl fmt::Debug for Program {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let functions: Vec<&str> = self.functions().map(|it| it.0).collect();
        f.debug_tuple("Program").field(&functions).finish()
    }
}

/// Reads the files of a program. Nothing runs yet.
///
/// Spans of a text that was read earlier on this thread become invalid.
///
/// # Errors
/// The first fault that shows without running: in the syntax, then in declarations, then in bodies.
pub fn read(files: &[SourceFile]) -> Result<Program, Fault> {
    static PRELUDE_CODE: OnceLock<Compiled> = OnceLock::new();
    let texts: Vec<&str> = files.iter().map(|file| &*file.text).collect();
    Ok(Program {
        code: Arc::new(added(PRELUDE_CODE.get_or_init(prelude), 0, &texts)?),
        refused: Arc::default(),
    })
}

/// Reads the texts that every program has.
fn prelude() -> Compiled {
    let empty = Compiled {
        names: Arc::new(Names::new()),
        functions: Vec::new(),
        mutant: 0,
        is_single: false,
        is_edited: false,
    };
    added(&empty, PRELUDE, &TEXTS).unwrap_or_else(|fault| panic!("{fault:?}"))
}

/// Adds texts to a program. Their files have the numbers from `file` on.
fn added(to: &Compiled, file: u16, texts: &[&str]) -> Result<Compiled, Fault> {
    // Places of an earlier text are not needed any more.
    proc_macro2::extra::invalidate_current_thread_spans();
    let trees = (file..).zip(texts);
    let trees = trees.map(|(n, text)| Ok((n, parse::<syn::File>(n, text)?)));
    let trees = trees.collect::<Result<Vec<_>, Fault>>()?;
    let mut names = Names::clone(&to.names);
    let sources = collect(&mut names, trees.iter().map(|(n, tree)| (*n, tree)))?;
    let mut functions = to.functions.clone();
    for source in sources {
        let n = functions.len();
        let mut function = lower(&names, n, source)?;
        if file >= PRELUDE {
            function.double = natives::double(&names.signatures[n].name);
        }
        functions.push(Arc::new(function));
    }
    let names = Arc::new(names);
    Ok(Compiled {
        names,
        functions,
        ..*to
    })
}

/// Changes of a program: each makes a new one, which shares with the first what did not change.
impl Program {
    /// Lists the functions of the program's files, in the order of their declarations: first the
    /// name, `hit_sphere` or `Sphere::hit`, then the text from `fn` to the closing bracket.
    pub fn functions(&self) -> impl Iterator<Item = (&str, &str)> {
        self.functions_of(0..PRELUDE)
    }

    /// Lists the functions of the lesson's prelude, such as `DVec3::dot` and `Ray::at`, with their
    /// texts. The operators of vectors are among them: `DVec3::sub`, `DVec3::neg`, and `f64::mul`
    /// for a number times a vector.
    pub fn prelude_functions(&self) -> impl Iterator<Item = (&str, &str)> {
        self.functions_of(PRELUDE + 1..u16::MAX)
    }

    fn functions_of(&self, files: Range<u16>) -> impl Iterator<Item = (&str, &str)> {
        let all = self.code.names.signatures.iter().zip(&self.code.functions);
        let own = all.filter(move |(it, _)| files.contains(&it.scope.file) && !it.is_constant);
        own.map(|(signature, function)| (&*signature.name, &*function.text))
    }

    /// Returns the program with another text for the function with the name `function`, such as
    /// `hit_sphere` or `Sphere::hit`, or `Camera::ray` of the prelude; `text` goes from `fn` to the
    /// closing bracket. Only that is read. Types and count of the parameters stay as declared.
    ///
    /// # Errors
    /// If there is no such function, if the text is no function or takes another number of
    /// parameters, or has a fault that shows without running.
    pub fn patched(&self, function: &str, text: &str) -> Result<Self, Fault> {
        proc_macro2::extra::invalidate_current_thread_spans();
        let n = self.number_of(function)?;
        let item = parse::<syn::ImplItemFn>(PRELUDE, text)?;
        if item.sig.inputs.len() != self.code.names.signatures[n].parameters.len() {
            return Err(Fault::refused(
                Span::default(),
                "the parameters have changed",
            ));
        }
        let source = Source::Function(&item.sig, &item.block);
        let lowered = Arc::new(lower(&self.code.names, n, source)?);
        let is_of_prelude = self.code.names.signatures[n].scope.file >= PRELUDE;
        let is_in_doubles = is_of_prelude && natives::is_in_doubles(function);
        Ok(self.with(|code| {
            code.functions[n] = lowered;
            code.is_edited |= is_in_doubles;
        }))
    }

    /// Returns the program in which one mutant runs, a variant of an expression:
    /// `mutants!(7, right, one, other)` in the program's text is `one` if `number` is 7, `other` if
    /// it is 8, and else `right`.
    ///
    /// All mutants are read at once (mutant schemata: Untch, Offutt and Harrold, 1993).
    pub fn with_mutant(&self, number: u32) -> Self {
        self.with(|code| code.mutant = number)
    }

    /// Returns the program with every number in its text and every result of `+ - * / %`, and every
    /// number that the library returns, rounded to an `f32`.
    pub fn in_single_precision(&self) -> Self {
        self.with(|code| code.is_single = true)
    }

    /// Returns the program with the patches of both `self` and `other`, which were patched from the
    /// program `from`; `None` if both have patched the same function. Nothing is read again. The
    /// result computes in `f32` if either does.
    pub fn merged_with(&self, other: &Self, from: &Self) -> Option<Self> {
        let [own, other, from] = [self, other, from].map(|program| &program.code);
        let mut functions = own.functions.clone();
        for (n, function) in other.functions.iter().enumerate() {
            if Arc::ptr_eq(function, &from.functions[n]) {
                continue;
            }
            if !Arc::ptr_eq(&own.functions[n], &from.functions[n]) {
                return None;
            }
            functions[n] = Arc::clone(function);
        }
        Some(self.with(|code| {
            code.functions = functions;
            code.is_single |= other.is_single;
            code.is_edited |= other.is_edited;
        }))
    }

    /// Returns the program with changed code, without any refusal yet.
    fn with(&self, change: impl FnOnce(&mut Compiled)) -> Self {
        let mut code = Compiled::clone(&self.code);
        change(&mut code);
        Self {
            code: Arc::new(code),
            refused: Arc::default(),
        }
    }
}

/// Calls of functions.
impl Program {
    /// Calls a function, `f` or `Type::f`, with values; `Type::default` needs no text. What it
    /// changes by a `&mut` is changed in `given`.
    ///
    /// # Errors
    /// If there is no such function, or the program stops.
    pub fn call(&self, function: &str, given: &mut [Value]) -> Result<Value, Fault> {
        let path: Vec<String> = function.split("::").map(str::to_owned).collect();
        let target = match self.code.names.find(&path, &Scope::default()) {
            Some(Item::Default(kind)) => Target::Default(kind),
            _ => Target::Own(self.number_of(function)?),
        };
        let callee = Value::Function(target);
        let result = Machine::new(&self.code, Vec::new()).ask(&callee, given);
        if let Err(fault) = &result
            && fault.kind == FaultKind::Refused
        {
            let _ = self.refused.set(fault.clone());
        }
        result
    }

    /// Returns how many parameters a function has, `f` or `Type::f`, with `self`; `None` if there is
    /// no such function.
    pub fn parameters(&self, function: &str) -> Option<usize> {
        let n = self.number_of(function).ok()?;
        Some(self.code.names.signatures[n].parameters.len())
    }

    /// Returns the first fault that the compiler would refuse and that showed in a
    /// [call](Self::call). `None` if there was none so far.
    pub fn first_refusal(&self) -> Option<&Fault> {
        self.refused.get()
    }

    /// Returns a field of a struct; `None` if it has none of that name.
    pub fn field(&self, value: &Value, name: &str) -> Option<Value> {
        let def = self.code.names.kinds.get(usize::from(value.kind()))?;
        value.part(def.variants.first()?.field(name)?)
    }

    fn number_of(&self, function: &str) -> Result<usize, Fault> {
        let mut signatures = self.code.names.signatures.iter();
        let n = signatures.rposition(|signature| signature.name == function);
        let message = || format!("there is no function `{function}`");
        n.ok_or_else(|| Fault::refused(Span::default(), message()))
    }
}
