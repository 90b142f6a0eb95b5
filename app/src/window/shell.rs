//! What belongs to one window: its graphics and its clock. The app may have had another before.

use std::cell::RefCell;
use std::rc::Rc;

use brilliance_renderer::gpu::Graphics;
use eframe::egui::{self, RawInput, Ui, Visuals};

use super::fate::Fate;
use crate::app::App;
use crate::picture_painter;

/// An app in a window.
pub(super) struct Shell {
    app: Rc<RefCell<App>>,
    fate: Rc<Fate>,
    /// Seconds that passed in the windows before, by which the app's clock goes on.
    begun_at: f64,
}

impl Shell {
    /// Moves `app` into the window and lets it trace on the window's device.
    ///
    /// # Errors
    /// The window has no device.
    pub(super) fn open(
        creation: &eframe::CreationContext<'_>,
        app: Rc<RefCell<App>>,
        fate: Rc<Fate>,
    ) -> Result<Self, &'static str> {
        let state = creation.wgpu_render_state.as_ref().ok_or("the window has no device")?;
        let graphics = Graphics::share(&state.device, &state.queue, state.adapter.get_info());
        picture_painter::install(state);
        let before = app.borrow().window();
        let begun_at = before.map_or(0.0, |before| before.time());
        app.borrow_mut().enter(&creation.egui_ctx);
        app.borrow_mut().offer_graphics(graphics.clone());
        fate.open(graphics);
        Ok(Self { app, fate, begun_at })
    }
}

impl eframe::App for Shell {
    fn raw_input_hook(&mut self, _ctx: &egui::Context, input: &mut RawInput) {
        if let Some(time) = &mut input.time {
            *time += self.begun_at;
        }
    }

    fn logic(&mut self, ctx: &egui::Context, frame: &mut eframe::Frame) {
        self.app.borrow_mut().logic(ctx, frame);
    }

    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        // What would be drawn on a device that is lost makes egui-wgpu panic.
        if !self.fate.is_lost() {
            self.app.borrow_mut().ui(ui, frame);
        }
    }

    fn clear_color(&self, visuals: &Visuals) -> [f32; 4] {
        self.app.borrow().clear_color(visuals)
    }

    fn on_exit(&mut self) {
        // The app lives on where only the window ends.
        if !self.fate.is_lost() {
            self.fate.close();
            self.app.borrow_mut().on_exit();
        }
    }
}
