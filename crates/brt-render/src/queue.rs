//! Work that is done side by side, and taken in its order.

use std::collections::BTreeMap;
use std::iter::Enumerate;
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::error::RenderError;

/// Parts of a work: which is next, which are done, and what takes them one after the other.
pub(crate) struct Queue<G: Iterator, D, T> {
    parts: Mutex<Enumerate<G>>,
    done: Mutex<Done<D>>,
    taker: Mutex<T>,
}

/// What is done and not taken.
struct Done<D> {
    waiting: BTreeMap<usize, D>,
    /// The part that is to be taken next.
    next: usize,
    failure: Option<RenderError>,
}

impl<G, D, T> Queue<G, D, T>
where
    G: Iterator,
    T: FnMut(D) -> Result<(), RenderError>,
{
    pub(crate) fn new(parts: G, taker: T) -> Self {
        let done = Done { waiting: BTreeMap::new(), next: 0, failure: None };
        Self { parts: Mutex::new(parts.enumerate()), done: Mutex::new(done), taker: Mutex::new(taker) }
    }

    /// The next part to be done and its place; none after a failure.
    pub(crate) fn next(&self) -> Option<(usize, G::Item)> {
        if lock(&self.done).failure.is_some() {
            return None;
        }
        lock(&self.parts).next()
    }

    /// Hands over what was done; takes it, and what waits behind it, unless another thread is taking, which will. Before a
    /// part is taken, `start` may begin another.
    pub(crate) fn hand_over(&self, place: usize, result: Result<D, RenderError>, start: impl Fn()) {
        match result {
            Ok(part) => _ = lock(&self.done).waiting.insert(place, part),
            Err(error) => lock(&self.done).fail(error),
        }
        // Not waited for: while it takes, a thread may do other parts of the work, and come here again.
        while lock(&self.done).is_next_waiting()
            && let Ok(mut taker) = self.taker.try_lock()
        {
            while let Some(part) = { lock(&self.done).pop() } {
                start();
                if let Err(error) = taker(part) {
                    lock(&self.done).fail(error);
                }
            }
        }
    }

    /// # Errors
    /// The first failure.
    pub(crate) fn finish(self) -> Result<(), RenderError> {
        let done = self.done.into_inner().unwrap_or_else(PoisonError::into_inner);
        done.failure.map_or(Ok(()), Err)
    }
}

impl<D> Done<D> {
    fn is_next_waiting(&self) -> bool {
        self.failure.is_none() && self.waiting.contains_key(&self.next)
    }

    fn pop(&mut self) -> Option<D> {
        let part = self.waiting.remove(&self.next).filter(|_| self.failure.is_none())?;
        self.next += 1;
        Some(part)
    }

    fn fail(&mut self, error: RenderError) {
        self.failure.get_or_insert(error);
    }
}

/// A panic elsewhere is passed on when its thread is waited for.
fn lock<L>(mutex: &Mutex<L>) -> MutexGuard<'_, L> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_taken_in_their_order_whenever_they_are_done() {
        let mut taken = Vec::new();
        let queue = Queue::new(10..14, |part: u32| {
            taken.push(part);
            Ok(())
        });
        let parts: Vec<_> = std::iter::from_fn(|| queue.next()).collect();
        let started = std::cell::Cell::new(0);
        let counts = [2, 0, 1, 3].map(|i| {
            queue.hand_over(parts[i].0, Ok(parts[i].1), || started.set(started.get() + 1));
            started.get()
        });
        assert_eq!(counts, [0, 1, 3, 4]);
        assert!(queue.finish().is_ok());
        assert_eq!(taken, [10, 11, 12, 13]);
    }

    #[test]
    fn nothing_is_begun_or_taken_after_a_failure() {
        let mut taken = 0;
        let queue = Queue::new(0..9, |_: u32| {
            taken += 1;
            Err(RenderError::Cancelled)
        });
        let (first, second) = (queue.next().unwrap(), queue.next().unwrap());
        queue.hand_over(first.0, Ok(0), || ());
        queue.hand_over(second.0, Ok(0), || ());
        assert!(queue.next().is_none());
        assert!(matches!(queue.finish(), Err(RenderError::Cancelled)));
        assert_eq!(taken, 1);
    }
}
