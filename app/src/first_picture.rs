//! How long the user waited for the first picture.

use std::time::Instant;

use eframe::egui;

/// Logs, once, the time from the start of the process to the first traced picture on the screen.
#[derive(Debug)]
pub struct FirstPicture {
    /// When the process started; none once the time is logged.
    since: Option<Instant>,
    painted: bool,
}

impl FirstPicture {
    /// Counts from `since`.
    pub fn new(since: Instant) -> Self {
        Self { since: Some(since), painted: false }
    }

    /// Called before a frame is drawn: a picture painted in an earlier one is now on the screen.
    pub fn begin_frame(&mut self) {
        if self.painted
            && let Some(since) = self.since.take()
        {
            let seconds = since.elapsed().as_secs_f64();
            log::info!(target: "brilliance", "first picture after {seconds:.2} s");
        }
    }

    /// Called when a frame with a picture was drawn.
    pub fn painted(&mut self, ctx: &egui::Context) {
        if !self.painted {
            self.painted = true;
            ctx.request_repaint();
        }
    }
}
