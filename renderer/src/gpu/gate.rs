//! Turns in handing work to a device that draws a window too.

use std::sync::{MutexGuard, PoisonError};

use super::Graphics;

impl Graphics {
    /// Keeps the renderer from handing work to the device until the guard is dropped. Waits for a
    /// handover in progress, which takes a moment, but not for the work.
    ///
    /// wgpu configures the surface of a window only while nobody hands work to the device:
    /// otherwise that fails, and callbacks of what was finished by then are lost.
    pub fn pause(&self) -> MutexGuard<'_, ()> {
        self.shared.gate.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Hands work to the device, unless the renderer is paused: then as soon as it is not.
    pub(crate) fn hand_over(&self, commands: wgpu::CommandBuffer) {
        let _gate = self.pause();
        self.queue().submit([commands]);
    }
}
