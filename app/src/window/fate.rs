//! What has become of a window.

use std::cell::{Cell, OnceCell};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, MutexGuard};
use std::time::{Duration, Instant};

use brilliance_renderer::gpu::Graphics;

/// Longest wait for a device that may be lost.
const PATIENCE: Duration = Duration::from_secs(1);

/// How long a surface may have to be configured after something happened to it.
const SETTLING_TIME: Duration = Duration::from_millis(300);

/// How a window ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Ending {
    /// It never opened.
    NotOpened,
    /// The user closed it.
    Closed,
    /// Its graphics device was lost, as the text says.
    DeviceLost(String),
}

/// What the content of a window and the event loop tell each other.
#[derive(Default)]
pub(super) struct Fate {
    graphics: OnceCell<Graphics>,
    is_closed: Cell<bool>,
    /// Something happened to the surface that it is drawn on.
    surface_moved: Arc<AtomicBool>,
    settling_since: Cell<Option<Instant>>,
}

impl Fate {
    /// The window has opened and is drawn by `graphics`.
    pub(super) fn open(&self, graphics: Graphics) {
        // A window opens once.
        let _ = self.graphics.set(graphics);
    }

    /// The window is closed by the user; its device may go.
    pub(super) fn close(&self) {
        self.is_closed.set(true);
    }

    /// What is set when something happens to the surface.
    pub(super) fn surface_moved(&self) -> &Arc<AtomicBool> {
        &self.surface_moved
    }

    /// Keeps the renderer from the device while the surface may have to be configured, which wgpu
    /// does not do at the same time.
    pub(super) fn pause_renderer(&self) -> Option<MutexGuard<'_, ()>> {
        if self.surface_moved.swap(false, Ordering::Relaxed) {
            self.settling_since.set(Some(Instant::now()));
        }
        let since = self.settling_since.get()?;
        let graphics = self.graphics.get()?;
        (since.elapsed() < SETTLING_TIME).then(|| graphics.pause())
    }

    /// Whether the device was lost while the window was open.
    pub(super) fn is_lost(&self) -> bool {
        !self.is_closed.get() && self.graphics.get().is_some_and(|it| it.loss().is_some())
    }

    /// As [`is_lost`](Self::is_lost), also where the device has not said so yet: it does that when
    /// its work is waited for.
    pub(super) fn turns_out_lost(&self) -> bool {
        if let Some(graphics) = self.graphics.get() {
            let wait = wgpu::PollType::Wait { submission_index: None, timeout: Some(PATIENCE) };
            // wgpu panics where the driver reports the loss. What goes wrong here is the loss, or
            // nothing to act upon.
            let _ = catch_unwind(AssertUnwindSafe(|| graphics.device().poll(wait)));
        }
        self.is_lost()
    }

    /// How it ended, once the event loop has.
    pub(super) fn ending(&self) -> Ending {
        match self.graphics.get().map(Graphics::loss) {
            None => Ending::NotOpened,
            Some(Some(reason)) if self.is_lost() => Ending::DeviceLost(reason.to_owned()),
            Some(_) => Ending::Closed,
        }
    }
}
