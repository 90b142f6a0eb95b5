//! Undo and redo: the states of a value, one step per gesture.

use std::collections::VecDeque;

/// Steps kept; older ones are forgotten.
const LIMIT: usize = 200;
/// Changes that follow each other sooner than this, in seconds, belong to one step.
const REST_SECONDS: f64 = 0.6;

/// The past and the future of a value.
///
/// A drag is one step however often it changes the value, and so is a run of key presses.
#[derive(Debug)]
pub struct History<T> {
    past: VecDeque<T>,
    present: T,
    future: Vec<T>,
    last_change: f64,
    in_gesture: bool,
}

impl<T: Clone + PartialEq> History<T> {
    /// A history that begins with `present`.
    pub fn new(present: T) -> Self {
        Self {
            past: VecDeque::new(),
            present,
            future: Vec::new(),
            last_change: f64::NEG_INFINITY,
            in_gesture: false,
        }
    }

    /// Notes the value as it is at `seconds`; `pointer_down` says that a drag is under way.
    pub fn record(&mut self, value: &T, seconds: f64, pointer_down: bool) {
        if *value != self.present {
            let rested = seconds - self.last_change > REST_SECONDS;
            if rested && !self.in_gesture {
                self.past.push_back(self.present.clone());
                if self.past.len() > LIMIT {
                    self.past.pop_front();
                }
            }
            self.present = value.clone();
            self.future.clear();
            self.last_change = seconds;
            self.in_gesture = pointer_down;
        }
        self.in_gesture &= pointer_down;
    }

    /// The state before the last step.
    pub fn undo(&mut self) -> Option<T> {
        let mut state = self.past.pop_back()?;
        // A step that ended where it began is no step.
        while state == self.present {
            state = self.past.pop_back()?;
        }
        self.future.push(std::mem::replace(&mut self.present, state.clone()));
        self.end_gesture();
        Some(state)
    }

    /// The state before the last undo.
    pub fn redo(&mut self) -> Option<T> {
        let state = self.future.pop()?;
        self.past.push_back(std::mem::replace(&mut self.present, state.clone()));
        self.end_gesture();
        Some(state)
    }

    /// True if there is a step to undo.
    pub fn has_past(&self) -> bool {
        !self.past.is_empty()
    }

    /// True if there is a step to redo.
    pub fn has_future(&self) -> bool {
        !self.future.is_empty()
    }

    fn end_gesture(&mut self) {
        self.last_change = f64::NEG_INFINITY;
        self.in_gesture = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drag_is_one_step_even_when_it_pauses() {
        let mut history = History::new(0);
        for (value, seconds) in [(1, 1.0), (2, 1.1), (3, 9.0)] {
            history.record(&value, seconds, true);
        }
        history.record(&3, 9.1, false);
        assert_eq!(history.undo(), Some(0));
        assert_eq!(history.undo(), None);
        assert_eq!(history.redo(), Some(3));
    }

    #[test]
    fn separate_gestures_are_separate_steps_and_a_change_forgets_the_future() {
        let mut history = History::new(0);
        history.record(&1, 1.0, true);
        history.record(&1, 1.2, false);
        history.record(&2, 5.0, false);
        assert_eq!(history.undo(), Some(1));
        history.record(&7, 5.1, false);
        assert_eq!(history.redo(), None);
        assert_eq!(history.undo(), Some(1));
        assert_eq!(history.undo(), Some(0));
    }

    #[test]
    fn a_step_that_ends_where_it_began_is_skipped() {
        let mut history = History::new(0);
        history.record(&1, 1.0, false);
        history.record(&5, 5.0, false);
        history.record(&1, 5.1, false);
        assert_eq!(history.undo(), Some(0));
    }

    #[test]
    fn the_past_is_bounded() {
        let mut history = History::new(0);
        for step in 1..1000 {
            history.record(&step, f64::from(step) * 10.0, false);
        }
        let steps = std::iter::from_fn(|| history.undo()).count();
        assert_eq!(steps, LIMIT);
    }
}
