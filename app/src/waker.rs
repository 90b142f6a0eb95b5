//! Waking the window from other threads.

use std::sync::{Arc, Mutex, PoisonError};

use eframe::egui;

/// Repaints whichever window there is, from any thread. Cloning shares it.
#[derive(Clone, Default)]
pub struct Waker {
    window: Arc<Mutex<Option<egui::Context>>>,
}

impl Waker {
    /// Wakes the window of `ctx` from now on. Gives the context of the window before it.
    pub fn attach(&self, ctx: &egui::Context) -> Option<egui::Context> {
        self.window.lock().unwrap_or_else(PoisonError::into_inner).replace(ctx.clone())
    }

    /// The context of the window, once there is one.
    pub fn window(&self) -> Option<egui::Context> {
        self.window.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Repaints the window; the first frame of a window needs no waking.
    pub fn request_repaint(&self) {
        if let Some(ctx) = self.window() {
            ctx.request_repaint();
        }
    }
}
