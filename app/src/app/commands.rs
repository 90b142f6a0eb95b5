//! What each command does.

use eframe::egui::{self, ViewportCommand};

use super::App;
use crate::command::Command;
use crate::help::Help;
use crate::orbit::Orbit;
use crate::shown;

impl App {
    /// Does what a menu or a key asked for.
    pub(super) fn run(&mut self, command: Command, ctx: &egui::Context) {
        match command {
            Command::Open => self.ask_open(),
            Command::OpenScene(index) => self.open_scene(index),
            Command::Save => self.save(),
            Command::SaveAs => self.ask_save(),
            Command::ExportStill => {
                let suggestion = self.suggested_path("png");
                self.export.open(self.editor.document.still, &suggestion);
            }
            Command::Quit => ctx.send_viewport_cmd(ViewportCommand::Close),
            Command::Undo => self.editor.undo(),
            Command::Redo => self.editor.redo(),
            Command::Reset => self.editor.reset(),
            Command::Look(view) => self.orbit.look(view, &self.bounds),
            Command::ResetCamera => self.orbit = Orbit::from_camera(&self.scene.camera),
            Command::Turn(delta) => self.orbit.rotate(delta, &self.bounds),
            Command::Zoom(factor) => self.orbit.zoom(factor, [0.0, 0.0], &self.bounds),
            Command::Show(shown) => self.live.show(shown),
            Command::ShowNext => self.live.show(shown::next(self.session().shown())),
            Command::TraceWith(backend) => self.live.set_backend(backend),
            Command::RetryGraphics => self.retry_graphics(),
            Command::ToggleDrawing => self.facets.toggle(),
            Command::TogglePrism => self.prism.toggle(),
            Command::ToggleInspector => self.inspector.toggle(),
            Command::TogglePanel => self.panel_shown = !self.panel_shown,
            Command::ShowKeys => self.help = Some(Help::Keys),
            Command::Dismiss => {
                let closed = self.export.close()
                    || self.prism.close()
                    || self.facets.close()
                    || self.inspector.deselect();
                if !closed {
                    self.notices.dismiss();
                }
            }
            Command::ShowAbout => self.help = Some(Help::About),
        }
    }
}
