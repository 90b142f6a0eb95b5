//! A bell that wakes a thread. What is new lies elsewhere, and is read by the thread it woke.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};

use super::shared::lock;

pub(super) struct Bell {
    state: Mutex<State>,
    news: Condvar,
    /// Counts what is urgent; changed under the lock, read without it by work in progress.
    generation: AtomicU64,
}

struct State {
    has_rung: bool,
    is_closed: bool,
}

impl Bell {
    pub(super) fn new() -> Self {
        Self {
            state: Mutex::new(State { has_rung: false, is_closed: false }),
            news: Condvar::new(),
            generation: AtomicU64::new(0),
        }
    }

    /// Rings for something that work in progress should be dropped for.
    pub(super) fn ring_urgently(&self) {
        let mut state = lock(&self.state);
        state.has_rung = true;
        self.generation.fetch_add(1, Ordering::Release);
        self.news.notify_all();
    }

    /// Rings for something that can wait until the work in progress is done.
    pub(super) fn ring(&self) {
        lock(&self.state).has_rung = true;
        self.news.notify_all();
    }

    /// Ends all work and all waiting.
    pub(super) fn close(&self) {
        lock(&self.state).is_closed = true;
        self.generation.fetch_add(1, Ordering::Release);
        self.news.notify_all();
    }

    /// Differs from what [`wait`](Self::wait) gave once the work begun then should be dropped.
    pub(super) fn generation(&self) -> u64 {
        self.generation.load(Ordering::Acquire)
    }

    /// Whether [`wait`](Self::wait) would return at once.
    pub(super) fn has_rung(&self) -> bool {
        let state = lock(&self.state);
        state.has_rung || state.is_closed
    }

    /// Whether nobody will ring again.
    pub(super) fn is_closed(&self) -> bool {
        lock(&self.state).is_closed
    }

    /// Waits until the bell rings and gives the generation; `None` once closed.
    pub(super) fn wait(&self) -> Option<u64> {
        let mut state = self
            .news
            .wait_while(lock(&self.state), |state| !state.has_rung && !state.is_closed)
            .unwrap_or_else(PoisonError::into_inner);
        state.has_rung = false;
        (!state.is_closed).then(|| self.generation())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_was_rung_for_twice_wakes_once() {
        let bell = Bell::new();
        bell.ring_urgently();
        bell.ring_urgently();
        assert_eq!(bell.wait(), Some(2));
        assert!(!bell.has_rung());
    }

    #[test]
    fn only_urgent_rings_and_closing_interrupt() {
        let bell = Bell::new();
        bell.ring_urgently();
        let generation = bell.wait().expect("it has rung");
        bell.ring();
        assert_eq!(bell.generation(), generation);
        assert!(bell.has_rung() && !bell.is_closed());
        bell.close();
        assert_ne!(bell.generation(), generation);
        assert_eq!(bell.wait(), None);
    }
}
