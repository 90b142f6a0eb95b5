//! A mailbox of one letter: a newer one replaces what was not yet taken.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Condvar, Mutex};

use super::lock;

pub(super) struct Mailbox<T> {
    slot: Mutex<Slot<T>>,
    posted: Condvar,
    /// Counts the letters posted, and the closing; read without the lock to notice news.
    generation: AtomicU64,
}

struct Slot<T> {
    letter: Option<T>,
    is_closed: bool,
}

impl<T> Mailbox<T> {
    pub(super) fn new() -> Self {
        Self {
            slot: Mutex::new(Slot { letter: None, is_closed: false }),
            posted: Condvar::new(),
            generation: AtomicU64::new(0),
        }
    }

    pub(super) fn post(&self, letter: T) {
        lock(&self.slot).letter = Some(letter);
        self.announce();
    }

    /// Wakes the reader for the last time.
    pub(super) fn close(&self) {
        lock(&self.slot).is_closed = true;
        self.announce();
    }

    fn announce(&self) {
        self.generation.fetch_add(1, Ordering::Release);
        self.posted.notify_all();
    }

    /// Changes whenever there is news.
    pub(super) fn generation(&self) -> u64 {
        self.generation.load(Ordering::Acquire)
    }

    /// The newest letter, if there is one, and the generation it belongs to; `None` once closed.
    pub(super) fn take(&self) -> Option<(Option<T>, u64)> {
        let mut slot = lock(&self.slot);
        (!slot.is_closed).then(|| (slot.letter.take(), self.generation()))
    }

    /// Waits for the next letter; `None` once closed.
    pub(super) fn wait(&self) -> Option<T> {
        let mut slot = self
            .posted
            .wait_while(lock(&self.slot), |slot| slot.letter.is_none() && !slot.is_closed)
            .unwrap_or_else(std::sync::PoisonError::into_inner);
        if slot.is_closed { None } else { slot.letter.take() }
    }
}
