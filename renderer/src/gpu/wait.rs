//! Waiting for a graphics device, but not for ever.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, TryRecvError};
use std::thread;
use std::time::{Duration, Instant};

use super::Graphics;
use crate::error::RendererError;

/// Time between two looks at the device.
const LOOK_INTERVAL: Duration = Duration::from_micros(200);
/// What a device is given takes some milliseconds, so that one which takes longer is hung, or all
/// too busy for others. Where it is hung, its driver finds that out after 2 s (Windows) to 10 s.
const PATIENCE: Duration = Duration::from_secs(5);
/// Software compiles a kernel when it first runs it, and shares the processor with everyone.
const SOFTWARE_PATIENCE: Duration = Duration::from_mins(5);

impl Graphics {
    /// Waits for what a callback of the device will send. None where the device drops the callback
    /// uncalled, as wgpu does with those of finished work when a surface can't be configured.
    ///
    /// wgpu's own wait would hold a lock all the while that presenting a window needs; looking
    /// now and then holds it for a moment.
    ///
    /// # Errors
    /// The device is lost, or doesn't answer in time, which is no proof of its loss.
    pub(crate) fn wait<T>(&self, answer: &Receiver<T>) -> Result<Option<T>, RendererError> {
        self.wait_for(answer, if self.is_software() { SOFTWARE_PATIENCE } else { PATIENCE })
    }

    fn wait_for<T>(
        &self,
        answer: &Receiver<T>,
        patience: Duration,
    ) -> Result<Option<T>, RendererError> {
        let start = Instant::now();
        loop {
            self.poll();
            match answer.try_recv() {
                Ok(value) => return Ok(Some(value)),
                Err(TryRecvError::Disconnected) => return self.check_loss().map(|()| None),
                Err(TryRecvError::Empty) => self.check_loss()?,
            }
            if start.elapsed() > patience {
                return Err(RendererError::Graphics(format!(
                    "the graphics device {} has not answered for {} s; close other programs that \
                     keep it busy, or trace on the CPU",
                    self.name(),
                    patience.as_secs()
                )));
            }
            thread::sleep(LOOK_INTERVAL);
        }
    }

    /// Lets the device call back about what it has finished.
    pub(super) fn poll(&self) {
        // wgpu panics in here where the driver reports a lost device, after all its locks are
        // free and the loss has been told.
        let polled = catch_unwind(AssertUnwindSafe(|| self.device().poll(wgpu::PollType::Poll)));
        if polled.is_err() {
            self.lose("its driver failed");
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc::channel;

    use super::*;

    #[test]
    fn a_busy_device_is_not_taken_for_a_lost_one() {
        let graphics = Graphics::open(true).expect("there is a device, be it software");
        let (sender, answer) = channel::<()>();
        let text = graphics.wait_for(&answer, Duration::ZERO).unwrap_err().to_string();
        assert!(text.contains("has not answered"), "{text}");
        assert_eq!(graphics.loss(), None);
        drop(sender);
        assert!(graphics.wait_for(&answer, Duration::ZERO).unwrap().is_none());
    }
}
