//! The window as the event loop sees it, which ends when the graphics device is lost.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::rc::Rc;
use std::sync::atomic::Ordering;

use eframe::{EframeWinitApplication, UserEvent};
use winit::application::ApplicationHandler;
use winit::event::{DeviceEvent, DeviceId, StartCause, WindowEvent};
use winit::event_loop::ActiveEventLoop;
use winit::window::WindowId;

use super::fate::Fate;

/// Hands events on to a window while its device works.
pub(super) struct Watched<'a> {
    window: EframeWinitApplication<'a>,
    fate: Rc<Fate>,
}

impl<'a> Watched<'a> {
    pub(super) fn new(window: EframeWinitApplication<'a>, fate: Rc<Fate>) -> Self {
        Self { window, fate }
    }

    /// Lets the window do something and ends the event loop if the device is lost. A device that
    /// another thread finds lost in the middle of a frame makes egui-wgpu panic; that ends the
    /// frame and the window, but not the app.
    fn hand_on(
        &mut self,
        event_loop: &ActiveEventLoop,
        event: impl FnOnce(&mut EframeWinitApplication<'a>),
    ) {
        if !self.fate.is_lost() {
            let fate = Rc::clone(&self.fate);
            let _pause = fate.pause_renderer();
            self.attempt(event);
        }
        if self.fate.is_lost() {
            event_loop.exit();
        }
    }

    fn attempt(&mut self, event: impl FnOnce(&mut EframeWinitApplication<'a>)) {
        let attempted = catch_unwind(AssertUnwindSafe(|| event(&mut self.window)));
        if let Err(panic) = attempted
            && !self.fate.turns_out_lost()
        {
            resume_unwind(panic);
        }
    }
}

impl ApplicationHandler<UserEvent> for Watched<'_> {
    fn new_events(&mut self, event_loop: &ActiveEventLoop, cause: StartCause) {
        self.hand_on(event_loop, |window| window.new_events(event_loop, cause));
    }

    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        self.hand_on(event_loop, |window| window.resumed(event_loop));
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, event: UserEvent) {
        self.hand_on(event_loop, |window| window.user_event(event_loop, event));
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, id: WindowId, event: WindowEvent) {
        if matches!(event, WindowEvent::Resized(_) | WindowEvent::ScaleFactorChanged { .. }) {
            self.fate.surface_moved().store(true, Ordering::Relaxed);
        }
        self.hand_on(event_loop, |window| window.window_event(event_loop, id, event));
    }

    fn device_event(&mut self, event_loop: &ActiveEventLoop, id: DeviceId, event: DeviceEvent) {
        self.hand_on(event_loop, |window| window.device_event(event_loop, id, event));
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        self.hand_on(event_loop, |window| window.about_to_wait(event_loop));
    }

    fn suspended(&mut self, event_loop: &ActiveEventLoop) {
        self.hand_on(event_loop, |window| window.suspended(event_loop));
    }

    fn memory_warning(&mut self, event_loop: &ActiveEventLoop) {
        self.hand_on(event_loop, |window| window.memory_warning(event_loop));
    }

    fn exiting(&mut self, event_loop: &ActiveEventLoop) {
        // A window has to go before its event loop does, whatever its device.
        self.attempt(|window| window.exiting(event_loop));
    }
}
