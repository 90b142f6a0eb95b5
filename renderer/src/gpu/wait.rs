//! Waiting for a graphics device, but not for ever.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, TryRecvError};
use std::thread;
use std::time::{Duration, Instant};

use super::Graphics;
use crate::error::RendererError;

/// Time between two looks at the device.
const LOOK_INTERVAL: Duration = Duration::from_micros(200);
/// A device that takes longer is hung; what it is given takes some milliseconds. Windows allows
/// drivers the same.
const PATIENCE: Duration = Duration::from_secs(2);
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
    /// The device is lost, or doesn't answer and is taken for lost.
    pub(crate) fn wait<T>(&self, answer: &Receiver<T>) -> Result<Option<T>, RendererError> {
        let start = Instant::now();
        let patience = if self.is_software() { SOFTWARE_PATIENCE } else { PATIENCE };
        loop {
            self.poll();
            match answer.try_recv() {
                Ok(value) => return Ok(Some(value)),
                Err(TryRecvError::Disconnected) => return self.check_loss().map(|()| None),
                Err(TryRecvError::Empty) => self.check_loss()?,
            }
            if start.elapsed() > patience {
                return Err(self.lose(&format!("no answer for {} s", patience.as_secs())));
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
