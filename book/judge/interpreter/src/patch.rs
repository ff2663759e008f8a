//! Incremental reading: a program with another text of one function, of which only that is read.

use std::sync::Arc;

use crate::lower;
use crate::machine::Code;
use crate::names::collect::Inside;
use crate::program::Program;
use crate::refusal::{Fault, FaultKind, Refusal};
use crate::written::Written;

impl Program {
    /// The functions by their names, `hit_sphere` or `Sphere::hit`, with their texts.
    pub fn functions(&self) -> impl Iterator<Item = (&str, &str)> {
        let written = self.code.written.iter().flatten();
        written.map(|it| (&*it.name, &*it.text))
    }

    /// The same program with another text of one function. Its parameters and its result are
    /// those that were declared.
    ///
    /// # Errors
    /// What the compiler would refuse and reading shows.
    pub fn patched(&self, function: &str, text: &str) -> Result<Self, Fault> {
        // Places of an earlier text are not needed any more.
        proc_macro2::extra::invalidate_current_thread_spans();
        let code = &*self.code;
        let is_it = |it: &Option<Written>| it.as_ref().is_some_and(|it| &*it.name == function);
        let found = code.written.iter().position(is_it);
        let n = found.ok_or_else(|| missing(&format!("function `{function}`")))?;
        let refused = |it: Refusal| it.fault(&[]);
        let item: syn::ImplItemFn =
            syn::parse_str(text).map_err(|error| missing(&error.to_string()))?;
        let signature = &code.names.functions[n];
        if item.sig.inputs.len() != signature.parameters.len() {
            return Err(missing("change of the parameters"));
        }
        let inside = Inside::Function(&item.sig, &item.block);
        let lowered = lower::lower(&code.names, text, signature, Some(inside)).map_err(refused)?;
        let mut code = Code::clone(code);
        code.functions[n] = Arc::new(lowered);
        if let Some(it) = &mut code.written[n] {
            it.text = text.into();
        }
        Ok(self.running(code))
    }

    /// The same program in which that one of the mutants runs that are written into its text:
    /// `mutants!(7, right, one, other)` has the mutants 7 and 8. All mutants are read at once so
    /// (mutant schemata: Untch, Offutt and Harrold, 1993).
    pub fn with_mutant(&self, number: u32) -> Self {
        self.running(Code {
            mutant: number,
            ..Code::clone(&self.code)
        })
    }

    /// The same program as floats of single precision have it: with every result of an
    /// operation, and every number in the text, rounded to 24 bits. What is done by functions of
    /// the library should be [in the text](Self::instead_of_the_library), too.
    pub fn in_single_precision(&self) -> Self {
        self.running(Code {
            is_single: true,
            ..Code::clone(&self.code)
        })
    }

    /// The same program with those functions of its text in place of the methods of vectors and
    /// rays that have their names.
    pub fn instead_of_the_library(&self, functions: &[&'static str]) -> Self {
        let code = &*self.code;
        let numbered = |&name: &&'static str| {
            let is_it = |it: &Option<Written>| it.as_ref().is_some_and(|it| &*it.name == name);
            Some((name, code.written.iter().position(is_it)?))
        };
        self.running(Code {
            instead: functions.iter().filter_map(numbered).collect(),
            ..Code::clone(code)
        })
    }

    fn running(&self, code: Code) -> Self {
        Self {
            code: Arc::new(code),
            ..self.clone()
        }
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
