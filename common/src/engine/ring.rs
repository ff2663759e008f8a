//! A ring of buffers for each thread: made in parallel, taken in order.
//!
//! One would use this where pieces of a stream can be made independently but
//! must leave in order, and memory must not grow with the stream.

use std::io;
use std::sync::mpsc::channel;
use std::thread;

/// Makes the pieces 0 to `count` − 1 on several threads at once, and hands them
/// to `take` one after the other, in order.
///
/// The first thread makes pieces 0, n, 2n …, the second one 1, n + 1 …, and so
/// on. Each has two buffers that go back and forth between it and `take`, so it
/// can make a piece while its last one is taken, but never gets further ahead:
/// however many pieces there are, few exist at a time.
///
/// # Errors
/// The first one of `take`; nothing is taken after it.
pub(super) fn in_order(
    count: usize,
    threads: usize,
    make: impl Fn(usize, &mut Vec<u8>) + Sync,
    mut take: impl FnMut(&[u8]) -> io::Result<()>,
) -> io::Result<()> {
    debug_assert!(threads > 0, "nobody to do it");
    if threads == 1 {
        // Nothing is started, which also lets it run where threads don't exist.
        let mut piece = Vec::new();
        return (0..count).try_for_each(|n| {
            piece.clear();
            make(n, &mut piece);
            take(&piece)
        });
    }
    thread::scope(|scope| {
        let make = &make;
        let makers: Vec<_> = (0..threads)
            .map(|first| {
                let (full, made) = channel();
                let (taken, empty) = channel();
                for _ in 0..2 {
                    taken.send(Vec::new()).expect("`empty` is right here");
                }
                scope.spawn(move || {
                    for n in (first..count).step_by(threads) {
                        let Ok(mut piece) = empty.recv() else { return };
                        piece.clear();
                        make(n, &mut piece);
                        if full.send(piece).is_err() {
                            // Nobody takes any more.
                            return;
                        }
                    }
                });
                (made, taken)
            })
            .collect();
        for (made, taken) in makers.iter().cycle().take(count) {
            // Nothing comes from a thread that panicked; the scope passes the
            // panic on.
            let Ok(piece) = made.recv() else { break };
            take(&piece)?;
            // It fails for the last pieces: their maker is done.
            let _ = taken.send(piece);
        }
        Ok(())
    })
}
