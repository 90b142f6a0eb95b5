//! The graphics device: offered, failed, lost.

use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::session::GraphicsState;
use brilliance_renderer::tracer::{Backend, TracerName};

use super::App;
use crate::tracers::Tracers;

const FAILED: &str = "The graphics device failed";
const LOST: &str = "The graphics device was lost";

impl App {
    /// Lets the session trace on the device of the window.
    pub fn offer_graphics(&mut self, graphics: Graphics) {
        self.live.offer_graphics(graphics);
        self.graphics_state = self.session().graphics_state();
    }

    /// Takes over that the device of the window before this one is gone, as `reason` says. Since
    /// tracing may have been what it did not survive, the processor traces until it is told
    /// otherwise.
    pub fn graphics_lost(&mut self, reason: &str) {
        self.live.set_backend(Backend::Cpu);
        self.notices.error(
            LOST,
            format!(
                "The window had to be opened again; nothing that you edited is lost. The processor \
                 traces now. View \u{203a} Trace with goes back to the graphics device.\n{reason}"
            ),
        );
    }

    /// What the menu and the status line say of the tracers.
    pub(super) fn tracers(&self) -> Tracers {
        let session = self.session();
        Tracers {
            chosen: self.live.backend(),
            processor: TracerName::Cpu { threads: session.threads() },
            device: session.graphics().map(|graphics| TracerName::Gpu {
                device: graphics.name().to_owned(),
                is_software: graphics.is_software(),
            }),
            state: session.graphics_state(),
            in_use: session.progress().tracer,
        }
    }

    /// Says once when the graphics device fails, and takes it back when it does no longer.
    pub(super) fn poll_graphics(&mut self) {
        let state = self.session().graphics_state();
        if state == self.graphics_state {
            return;
        }
        if let GraphicsState::Failed(reason) = &state {
            self.notices.error(
                FAILED,
                format!(
                    "The processor goes on tracing. View \u{203a} Trace with \u{203a} Try again \
                     gives the device another chance.\n{reason}"
                ),
            );
        } else {
            self.notices.withdraw(FAILED);
        }
        self.graphics_state = state;
    }
}
