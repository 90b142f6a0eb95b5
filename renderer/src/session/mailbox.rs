//! A mailbox of one letter: a newer one replaces what was not yet taken.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};

use super::lock;

pub(super) struct Mailbox<T> {
    slot: Mutex<Slot<T>>,
    news: Condvar,
    /// Counts what is urgent; changed under the lock, read without it by work in progress.
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
            news: Condvar::new(),
            generation: AtomicU64::new(0),
        }
    }

    /// Leaves a letter that work in progress should be dropped for.
    pub(super) fn post_urgent(&self, letter: T) {
        let mut slot = lock(&self.slot);
        slot.letter = Some(letter);
        self.generation.fetch_add(1, Ordering::Release);
        self.news.notify_all();
    }

    /// Leaves a letter for when the work in progress is done.
    pub(super) fn post(&self, letter: T) {
        lock(&self.slot).letter = Some(letter);
        self.news.notify_all();
    }

    /// Ends all work and all waiting.
    pub(super) fn close(&self) {
        lock(&self.slot).is_closed = true;
        self.generation.fetch_add(1, Ordering::Release);
        self.news.notify_all();
    }

    /// Differs from the generation of a letter once that letter's work should be dropped.
    pub(super) fn generation(&self) -> u64 {
        self.generation.load(Ordering::Acquire)
    }

    /// Whether [`wait`](Self::wait) would return at once.
    pub(super) fn has_news(&self) -> bool {
        let slot = lock(&self.slot);
        slot.letter.is_some() || slot.is_closed
    }

    /// Waits for the next letter and gives it with its generation; `None` once closed.
    pub(super) fn wait(&self) -> Option<(T, u64)> {
        let mut slot = self
            .news
            .wait_while(lock(&self.slot), |slot| slot.letter.is_none() && !slot.is_closed)
            .unwrap_or_else(PoisonError::into_inner);
        if slot.is_closed {
            return None;
        }
        slot.letter.take().map(|letter| (letter, self.generation()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_newer_letter_replaces_the_older() {
        let mailbox = Mailbox::new();
        mailbox.post_urgent(1);
        mailbox.post_urgent(2);
        assert_eq!(mailbox.wait(), Some((2, 2)));
        assert!(!mailbox.has_news());
    }

    #[test]
    fn only_urgent_letters_and_closing_interrupt() {
        let mailbox = Mailbox::new();
        mailbox.post_urgent('a');
        let (_, generation) = mailbox.wait().expect("a letter");
        mailbox.post('b');
        assert_eq!(mailbox.generation(), generation);
        assert!(mailbox.has_news());
        mailbox.close();
        assert_ne!(mailbox.generation(), generation);
        assert_eq!(mailbox.wait(), None);
    }
}
