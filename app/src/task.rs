//! Work on a named thread, so that the window never waits.

use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};

use crate::waker::Waker;

/// A job that runs on its own thread and gives one value.
#[derive(Debug)]
pub struct Task<T> {
    receiver: Receiver<T>,
}

/// Where a task stands.
#[derive(Debug)]
pub enum TaskState<T> {
    /// Not finished.
    Running,
    /// Finished, with its value.
    Finished(T),
    /// It ended without a value: its thread panicked.
    Broken,
}

impl<T: Send + 'static> Task<T> {
    /// Runs `job` on a thread called `name` and wakes the window when it has finished.
    ///
    /// # Errors
    /// The system gives no thread.
    pub fn spawn(
        name: &str,
        waker: &Waker,
        job: impl FnOnce() -> T + Send + 'static,
    ) -> std::io::Result<Self> {
        let (sender, receiver) = channel();
        let reply = Reply { sender, _wake: WakeOnDrop(waker.clone()) };
        std::thread::Builder::new().name(name.to_owned()).spawn(move || reply.give(job))?;
        Ok(Self { receiver })
    }

    /// Looks for the value without waiting.
    pub fn poll(&self) -> TaskState<T> {
        match self.receiver.try_recv() {
            Ok(value) => TaskState::Finished(value),
            Err(TryRecvError::Empty) => TaskState::Running,
            Err(TryRecvError::Disconnected) => TaskState::Broken,
        }
    }
}

/// The way back to the window. Fields drop in order: the channel closes, then the window wakes.
struct Reply<T> {
    sender: Sender<T>,
    _wake: WakeOnDrop,
}

impl<T> Reply<T> {
    fn give(self, job: impl FnOnce() -> T) {
        // The window may have lost interest; then nobody needs the value.
        let _ = self.sender.send(job());
    }
}

/// Wakes even when the job panics, so that the window notices.
struct WakeOnDrop(Waker);

impl Drop for WakeOnDrop {
    fn drop(&mut self) {
        self.0.request_repaint();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wait<T: Send + 'static>(task: &Task<T>) -> TaskState<T> {
        for _ in 0..500 {
            match task.poll() {
                TaskState::Running => std::thread::sleep(std::time::Duration::from_millis(2)),
                state => return state,
            }
        }
        TaskState::Running
    }

    #[test]
    fn a_task_gives_its_value() {
        let task = Task::spawn("sum", &Waker::default(), || 2 + 2).unwrap();
        assert!(matches!(wait(&task), TaskState::Finished(4)));
    }

    #[test]
    fn a_panic_is_noticed() {
        let task: Task<u32> =
            Task::spawn("broken", &Waker::default(), || panic!("as the test wants")).unwrap();
        assert!(matches!(wait(&task), TaskState::Broken));
    }
}
