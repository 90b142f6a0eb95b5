//! What has become of a window.

use std::cell::{Cell, OnceCell};

use brilliance_renderer::gpu::Graphics;

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

    /// Whether the device was lost while the window was open.
    pub(super) fn is_lost(&self) -> bool {
        !self.is_closed.get() && self.graphics.get().is_some_and(|it| it.loss().is_some())
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
