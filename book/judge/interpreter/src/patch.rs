//! Incremental reading: a program with another text of one function, of which only that is read.

use std::sync::{Arc, PoisonError};

use crate::lower;
use crate::machine::{Code, CompiledFunction};
use crate::names::collect::ItemBody;
use crate::program::Program;
use crate::refusal::{Fault, FaultKind};

/// So many texts of functions are kept: more than there are edits of a chapter.
const MOST: usize = 10_000;

impl Program {
    /// Lists the functions by their names, `hit_sphere` or `Sphere::hit`, with their texts.
    pub fn functions(&self) -> impl Iterator<Item = (&str, &str)> {
        let written = self.code.functions.iter().flat_map(|it| &it.written);
        written.map(|it| (&*it.name, &*it.text))
    }

    /// Returns the program with another text of one function. Its parameters and its result are
    /// those that were declared. A text that was read before is not read again.
    ///
    /// # Errors
    /// If the compiler would refuse it and reading shows that.
    pub fn patched(&self, function: &str, text: &str) -> Result<Self, Fault> {
        let found = self.code.number_of(function);
        let n = found.ok_or_else(|| missing(&format!("function `{function}`")))?;
        let mut code = Code::clone(&self.code);
        code.functions[n] = code.read_anew(n, text)?;
        Ok(self.running(code))
    }

    /// Returns the program in which one of the mutants runs that are written into its text:
    /// `mutants!(7, right, one, other)` has the mutants 7 and 8. All mutants are read at once so
    /// (mutant schemata: Untch, Offutt and Harrold, 1993).
    pub fn with_mutant(&self, number: u32) -> Self {
        self.running(Code {
            mutant: number,
            ..Code::clone(&self.code)
        })
    }

    /// Returns the program as floats of single precision have it: with every result of an
    /// operation, and every number in the text, rounded to 24 bits. What is done by functions of
    /// the library should be [in the text](Self::instead_of_the_library), too.
    pub fn in_single_precision(&self) -> Self {
        self.running(Code {
            is_single: true,
            ..Code::clone(&self.code)
        })
    }

    /// Returns the program with those functions of its text in place of the methods of vectors and
    /// rays that have their names.
    pub fn instead_of_the_library(&self, functions: &[&'static str]) -> Self {
        let code = &*self.code;
        let numbered = |&name: &&'static str| Some((name, code.number_of(name)?));
        self.running(Code {
            instead: functions.iter().filter_map(numbered).collect(),
            ..Code::clone(code)
        })
    }

    /// Returns the program with the other's functions where these are not those of a program from
    /// which both were made; `None` if both have changed the same one. Nothing is read.
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

    fn running(&self, code: Code) -> Self {
        Self {
            code: Arc::new(code),
            refused: Arc::default(),
        }
    }
}

impl Code {
    /// Returns the number of the function of that name.
    pub(crate) fn number_of(&self, function: &str) -> Option<usize> {
        let is_it =
            |it: &Arc<CompiledFunction>| it.written.as_ref().is_some_and(|it| it.name == function);
        self.functions.iter().position(is_it)
    }

    /// Reads a function from another text.
    fn read_anew(&self, n: usize, text: &str) -> Result<Arc<CompiledFunction>, Fault> {
        let mut read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        let key = (n, text.to_owned());
        if let Some(known) = read.get(&key) {
            return Ok(Arc::clone(known));
        }
        // Places of an earlier text are not needed any more.
        proc_macro2::extra::invalidate_current_thread_spans();
        let item: syn::ImplItemFn =
            syn::parse_str(text).map_err(|error| missing(&error.to_string()))?;
        let signature = &self.names.functions[n];
        if item.sig.inputs.len() != signature.parameters.len() {
            return Err(missing("change of the parameters"));
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

fn missing(what: &str) -> Fault {
    Fault {
        place: None,
        message: format!("there is no {what}"),
        label: String::new(),
        help: String::new(),
        kind: FaultKind::Refused,
    }
}
