//! Incremental reading: a program with another text of one function, of which only that is read.

use std::sync::{Arc, PoisonError};

use crate::lower;
use crate::machine::{Code, CompiledFunction};
use crate::names::collect::ItemBody;
use crate::program::Program;
use crate::refusal::{Fault, FaultKind};

/// How many texts of functions are kept: more than there are edits of a chapter.
const MOST: usize = 10_000;

impl Program {
    /// Lists all functions with a body, in the order of their declarations: first the name,
    /// `hit_sphere` or `Sphere::hit`, then the source text from `fn` to the closing bracket.
    pub fn functions(&self) -> impl Iterator<Item = (&str, &str)> {
        let written = self.code.functions.iter().flat_map(|it| &it.written);
        written.map(|it| (&*it.name, &*it.text))
    }

    /// Returns the program with another source text for the function with the name `function`, such
    /// as `hit_sphere` or `Sphere::hit`; `text` goes from `fn` to the closing bracket. Types and
    /// count of the parameters stay as declared. A text that was patched in before is not read
    /// again.
    ///
    /// # Errors
    /// If there is no such function, if the text is no function or takes another number of
    /// parameters, or if the compiler would refuse it, as far as that shows without running.
    pub fn patched(&self, function: &str, text: &str) -> Result<Self, Fault> {
        let found = self.code.number_of(function);
        let n = found.ok_or_else(|| refused(format!("there is no function `{function}`")))?;
        let mut code = Code::clone(&self.code);
        code.functions[n] = code.read_anew(n, text)?;
        Ok(self.running(code))
    }

    /// Returns the program in which one mutant runs, a variant of an expression:
    /// `mutants!(7, right, one, other)` in the program's text is `one` if `number` is 7, `other` if
    /// it is 8, and else `right`.
    ///
    /// All mutants are read at once (mutant schemata: Untch, Offutt and Harrold, 1993).
    pub fn with_mutant(&self, number: u32) -> Self {
        self.running(Code {
            mutant: number,
            ..Code::clone(&self.code)
        })
    }

    /// Returns the program with every number in its text and every result of `+ - * / %` rounded to
    /// an `f32`. Functions of the library still compute in 53 bits: let [functions of the
    /// text](Self::instead_of_the_library) take their places.
    pub fn in_single_precision(&self) -> Self {
        self.running(Code {
            is_single: true,
            ..Code::clone(&self.code)
        })
    }

    /// Returns the program in which the named functions of its own text run in place of the
    /// library's methods of vectors and rays with these names, such as `dot`. A name without a
    /// function in the text changes nothing.
    pub fn instead_of_the_library(&self, functions: &[&'static str]) -> Self {
        let code = &*self.code;
        let numbered = |&name: &&'static str| Some((name, code.number_of(name)?));
        self.running(Code {
            instead: functions.iter().filter_map(numbered).collect(),
            ..Code::clone(code)
        })
    }

    /// Returns the program with the patches of both `self` and `other`, which were patched from the
    /// program `from`; `None` if both have patched the same function. Nothing is read again. The
    /// result computes in `f32` if either does.
    pub fn merged_with(&self, other: &Self, from: &Self) -> Option<Self> {
        let [own, other, from] = [self, other, from].map(|it| &it.code);
        let mut code = Code::clone(own);
        for (n, function) in other.functions.iter().enumerate() {
            if Arc::ptr_eq(function, &from.functions[n]) {
                continue;
            }
            if !Arc::ptr_eq(&own.functions[n], &from.functions[n]) {
                return None;
            }
            code.functions[n] = Arc::clone(function);
        }
        code.is_single |= other.is_single;
        if code.instead.is_empty() {
            code.instead.clone_from(&other.instead);
        }
        Some(self.running(code))
    }

    /// Makes the program that runs the code, without any refusal yet.
    fn running(&self, code: Code) -> Self {
        Self {
            code: Arc::new(code),
            refused: Arc::default(),
        }
    }
}

impl Code {
    /// Returns the number of the function of that name, `hit_sphere` or `Sphere::hit`.
    pub(crate) fn number_of(&self, function: &str) -> Option<usize> {
        let is_it =
            |it: &Arc<CompiledFunction>| it.written.as_ref().is_some_and(|it| it.name == function);
        self.functions.iter().position(is_it)
    }

    /// Reads the text of function `n` and lowers it, unless the text is in the cache.
    fn read_anew(&self, n: usize, text: &str) -> Result<Arc<CompiledFunction>, Fault> {
        let mut read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        let key = (n, text.to_owned());
        if let Some(known) = read.get(&key) {
            return Ok(Arc::clone(known));
        }
        // Places of an earlier text are not needed any more.
        proc_macro2::extra::invalidate_current_thread_spans();
        let item: syn::ImplItemFn =
            syn::parse_str(text).map_err(|error| refused(error.to_string()))?;
        let signature = &self.names.functions[n];
        if item.sig.inputs.len() != signature.parameters.len() {
            return Err(refused("the parameters have changed".to_owned()));
        }
        let inside = ItemBody::Function(&item.sig, &item.block);
        let lowered = lower::lower(&self.names, text, signature, Some(inside));
        let lowered = Arc::new(lowered.map_err(|it| it.fault(&[]))?);
        if read.len() > MOST {
            read.clear();
        }
        read.insert(key, Arc::clone(&lowered));
        Ok(lowered)
    }
}

/// Makes the fault of a patch that does not fit the program.
fn refused(message: String) -> Fault {
    Fault::without_place(FaultKind::Refused, message)
}
