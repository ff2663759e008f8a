//! A ring of buffers for each thread: made in parallel, taken in order.
//!
//! One would use this where pieces of a stream can be made independently but
//! must leave in order, and memory must not grow with the stream.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::{self, Scope};

/// Makes the pieces 0 to `count` − 1 on several threads at once, and hands them
/// to `take` one after the other, in order.
///
/// The first thread makes pieces 0, n, 2n …, the second one 1, n + 1 …, and so
/// on. Each has two buffers that go back and forth between it and `take`, so it
/// can make a piece while its last one is taken, but never gets further ahead:
/// however many pieces there are, few exist at a time.
///
/// The pieces of a thread that the system refuses to start are made here, each
/// when its turn comes.
///
/// # Errors
/// The first one of `take`; nothing is taken after it.
pub(super) fn in_order<E>(
    count: usize,
    threads: usize,
    make: impl Fn(usize, &mut Vec<u8>) + Sync,
    mut take: impl FnMut(&[u8]) -> Result<(), E>,
) -> Result<(), E> {
    debug_assert!(threads > 0, "nobody to do it");
    // One thread is this one. Nothing is started for it, which also lets it run
    // where threads don't exist.
    let started = if threads == 1 { 0 } else { threads };
    thread::scope(|scope| {
        let mut makers: Vec<_> = (0..started)
            .map(|first| Maker::start(scope, (first..count).step_by(threads), &make))
            .collect();
        makers.resize_with(threads, || None);
        let mut own = Vec::new();
        for (n, maker) in (0..count).zip(makers.iter().cycle()) {
            if let Some(maker) = maker {
                // Nothing comes from a thread that panicked; the scope passes the
                // panic on.
                let Ok(piece) = maker.made.recv() else { break };
                take(&piece)?;
                // It fails for the last pieces: their maker is done.
                let _ = maker.taken.send(piece);
            } else {
                own.clear();
                make(n, &mut own);
                take(&own)?;
            }
        }
        Ok(())
    })
}

/// A thread that makes pieces, as the thread that takes them sees it.
struct Maker {
    made: Receiver<Vec<u8>>,
    taken: Sender<Vec<u8>>,
}

impl Maker {
    /// Starts a thread that makes `pieces`; returns `None` if the system refuses it.
    fn start<'scope>(
        scope: &'scope Scope<'scope, '_>,
        pieces: impl Iterator<Item = usize> + Send + 'scope,
        make: &'scope (impl Fn(usize, &mut Vec<u8>) + Sync),
    ) -> Option<Self> {
        let (full, made) = channel();
        let (taken, empty) = channel();
        for _ in 0..2 {
            taken.send(Vec::new()).expect("`empty` is right here");
        }
        let work = move || {
            for n in pieces {
                let Ok(mut piece) = empty.recv() else { return };
                piece.clear();
                make(n, &mut piece);
                if full.send(piece).is_err() {
                    // Nobody takes any more.
                    return;
                }
            }
        };
        let started = thread::Builder::new().spawn_scoped(scope, work);
        started.is_ok().then_some(Self { made, taken })
    }
}
