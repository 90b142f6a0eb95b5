//! The graphics device: offered, failed, lost.

use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::session::GraphicsState;
use brilliance_renderer::tracer::{Backend, TracerName};

use super::App;
use crate::tracers::Tracers;

const FAILED: &str = "The graphics device failed";
const REFUSED: &str = "Too much for the graphics device";
const LOST: &str = "The graphics device was lost";

impl App {
    /// Lets the session trace on the device of the window.
    pub fn offer_graphics(&mut self, graphics: Graphics) {
        self.live.offer_graphics(graphics);
    }

    /// Takes over that the device of the window is gone, as `reason` says. Since tracing may be
    /// what it did not survive, the processor traces until it is told otherwise.
    pub fn graphics_lost(&mut self, reason: &str) {
        self.live.set_backend(Backend::Cpu);
        self.update_request();
        let text = format!(
            "The window had to be opened again; nothing that you edited is lost. The processor \
             traces now; View \u{203a} Trace with goes back to the graphics device.\n\
             Reason: {reason}."
        );
        self.notices.error(LOST, text);
        // What the session may have said of it is said with that.
        self.failure_told = self.session().graphics_failure().map_or(0, |failure| failure.serial);
        self.notices.withdraw(FAILED);
    }

    /// What the menu and the status line say of the tracers.
    pub(super) fn tracers(&self) -> Tracers {
        let session = self.session();
        let device = session.graphics().map(|graphics| TracerName::Gpu {
            device: graphics.name().to_owned(),
            is_software: graphics.is_software(),
        });
        Tracers {
            chosen: self.live.backend(),
            processor: TracerName::Cpu { threads: session.threads() },
            device,
            state: session.graphics_state(),
            refusal: session.graphics_failure().map(|failure| failure.reason),
            in_use: session.progress().tracer,
        }
    }

    /// Says once why the processor took over from the graphics device.
    pub(super) fn poll_graphics(&mut self) {
        let Some(failure) = self.session().graphics_failure() else { return };
        if failure.serial == self.failure_told {
            return;
        }
        self.failure_told = failure.serial;
        let title = match self.session().graphics_state() {
            GraphicsState::Failed(_) => FAILED,
            _ => REFUSED,
        };
        let text = format!(
            "The processor goes on tracing. View \u{203a} Trace with \u{203a} Try again gives the \
             device another chance.\nReason: {}.",
            failure.reason
        );
        self.notices.error(title, text);
    }

    /// Gives a graphics device that failed another chance.
    pub(super) fn retry_graphics(&mut self) {
        self.notices.withdraw(FAILED);
        self.notices.withdraw(REFUSED);
        self.live.retry_graphics();
    }
}
