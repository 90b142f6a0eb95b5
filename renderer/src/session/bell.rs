//! A bell that wakes a thread. What is new lies elsewhere, and is read by the thread it woke.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};

use super::shared::lock;

pub(super) struct Bell {
    state: Mutex<State>,
    news: Condvar,
    /// Count what is urgent; changed under the lock, read without it by work in progress.
    wishes: AtomicU64,
    commands: AtomicU64,
}

/// How urgent it is that work in progress is dropped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Urgency {
    /// The work is what was asked for.
    None,
    /// Something newer was asked for; the work still makes a picture worth showing.
    Wish,
    /// The work is of no use any more.
    Command,
}

/// What was urgent when work began.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Generation {
    wishes: u64,
    commands: u64,
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
            wishes: AtomicU64::new(0),
            commands: AtomicU64::new(0),
        }
    }

    /// Rings for something that can wait until the work in progress is done, or that it should be
    /// dropped for.
    pub(super) fn ring(&self, urgency: Urgency) {
        let mut state = lock(&self.state);
        state.has_rung = true;
        match urgency {
            Urgency::None => {}
            Urgency::Wish => _ = self.wishes.fetch_add(1, Ordering::Release),
            Urgency::Command => _ = self.commands.fetch_add(1, Ordering::Release),
        }
        self.news.notify_all();
    }

    /// Ends all work and all waiting.
    pub(super) fn close(&self) {
        lock(&self.state).is_closed = true;
        self.commands.fetch_add(1, Ordering::Release);
        self.news.notify_all();
    }

    /// The most urgent of what has come since [`wait`](Self::wait) gave `generation`.
    pub(super) fn urgency_since(&self, generation: Generation) -> Urgency {
        let now = self.generation();
        if now.commands != generation.commands {
            Urgency::Command
        } else if now.wishes != generation.wishes {
            Urgency::Wish
        } else {
            Urgency::None
        }
    }

    fn generation(&self) -> Generation {
        Generation {
            wishes: self.wishes.load(Ordering::Acquire),
            commands: self.commands.load(Ordering::Acquire),
        }
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
    pub(super) fn wait(&self) -> Option<Generation> {
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
        bell.ring(Urgency::Wish);
        bell.ring(Urgency::Command);
        let generation = bell.wait().expect("it has rung");
        assert_eq!(bell.urgency_since(generation), Urgency::None);
        assert!(!bell.has_rung());
    }

    #[test]
    fn only_urgent_rings_and_closing_interrupt() {
        let bell = Bell::new();
        bell.ring(Urgency::Command);
        let generation = bell.wait().expect("it has rung");
        for urgency in [Urgency::None, Urgency::Wish, Urgency::Command] {
            bell.ring(urgency);
            assert_eq!(bell.urgency_since(generation), urgency);
        }
        bell.ring(Urgency::Wish);
        assert_eq!(bell.urgency_since(generation), Urgency::Command, "the most urgent counts");
        assert!(bell.has_rung() && !bell.is_closed());

        let generation = bell.wait().expect("it has rung");
        bell.close();
        assert_eq!(bell.urgency_since(generation), Urgency::Command);
        assert_eq!(bell.wait(), None);
    }
}
