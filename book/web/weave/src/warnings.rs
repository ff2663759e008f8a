//! Log capture: a warning of mdBook fails the build.

use std::fmt::{Debug, Write};
use std::sync::{Arc, Mutex, PoisonError};

use tracing::field::{Field, Visit};
use tracing::span::{Attributes, Id, Record};
use tracing::{Event, Level, Metadata, Subscriber, subscriber};

/// Does the `work`, and returns all warnings that were logged meanwhile.
///
/// # Errors
/// The error of `work`.
pub(crate) fn collect<E>(work: impl FnOnce() -> Result<(), E>) -> Result<Vec<String>, E> {
    let warnings = Warnings::default();
    subscriber::with_default(warnings.clone(), work)?;
    let mut warnings = warnings.0.lock().unwrap_or_else(PoisonError::into_inner);
    Ok(std::mem::take(&mut *warnings))
}

#[derive(Clone, Default)]
struct Warnings(Arc<Mutex<Vec<String>>>);

impl Subscriber for Warnings {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        *metadata.level() <= Level::WARN
    }

    fn event(&self, event: &Event<'_>) {
        let mut message = Message::default();
        event.record(&mut message);
        let mut warnings = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        warnings.push(message.0);
    }

    // Warnings count wherever they come from, so no span needs to be known.
    fn new_span(&self, _: &Attributes<'_>) -> Id {
        Id::from_u64(1)
    }

    fn record(&self, _: &Id, _: &Record<'_>) {}

    fn record_follows_from(&self, _: &Id, _: &Id) {}

    fn enter(&self, _: &Id) {}

    fn exit(&self, _: &Id) {}
}

/// The text of a logged event.
#[derive(Default)]
struct Message(String);

impl Visit for Message {
    fn record_debug(&mut self, field: &Field, value: &dyn Debug) {
        if field.name() == "message" {
            // A string takes whatever is written to it.
            let _ = write!(self.0, "{value:?}");
        }
    }
}
