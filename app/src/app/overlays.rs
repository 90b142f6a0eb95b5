//! What lies above the picture and the panel: dialogs, messages, the export window.

use std::path::Path;
use std::sync::Arc;

use brilliance_renderer::session::RenderRequest;
use eframe::egui;

use super::{App, files};
use crate::drawing::{SaveSheet, extension};
use crate::export::{ExportAction, StillJob, StillOrder};
use crate::help;
use crate::path_dialog::{Purpose, Question};
use crate::question;

impl App {
    /// Windows, questions and messages above the rest.
    pub(super) fn overlays_ui(&mut self, ctx: &egui::Context) {
        let action = self.export.show(ctx, self.viewport_size, self.editor.document.trace.bins);
        match action {
            Some(ExportAction::Browse(suggestion)) => {
                let question = Question { purpose: Purpose::ExportStill, suggestion };
                self.paths.open(self.live.waker(), question);
            }
            Some(ExportAction::Start(order)) => self.start_export(order),
            None => {}
        }
        let object = self.editor.document.scene.objects.get(self.panel.object());
        let of_prism = self.prism.show(ctx);
        if let Some(order) = self.facets.show(ctx, object, self.live.waker()).or(of_prism) {
            self.ask_save_sheet(order);
        }
        if let Some(page) = self.help
            && !help::show(ctx, page)
        {
            self.help = None;
        }
        if self.files.is_asking()
            && let Some(decision) = question::show(ctx, self.loss())
        {
            self.decide(decision, ctx);
        }
        if let Some((purpose, path)) = self.paths.show(ctx) {
            self.take_path(purpose, path);
        }
        self.notices.show(ctx);
        files::drop_target_ui(ctx, self.files.opening_name());
    }

    /// Asks where to save a drawing.
    fn ask_save_sheet(&mut self, order: SaveSheet) {
        let format = order.format;
        let suggestion = self.suggested_path(extension(format));
        self.sheets.await_path(order);
        let question = Question { purpose: Purpose::SaveDrawing(format), suggestion };
        self.paths.open(self.live.waker(), question);
    }

    fn start_export(&mut self, order: StillOrder) {
        let mut document = self.document_to_save();
        document.still = order.still;
        let folder = order.path.parent().unwrap_or(Path::new(""));
        let job = StillJob {
            request: RenderRequest {
                scene: Arc::clone(&self.scene),
                camera: self.orbit.camera(),
                size: order.still.size,
                trace: document.trace.clone(),
                pass_limit: order.still.passes,
                noise: order.still.noise,
                backend: self.live.backend(),
            },
            device: self.session().tracing_device(),
            display: document.display.clone(),
            format: order.format,
            scene_toml: document.to_toml(folder),
            path: order.path,
        };
        self.export.start(job, self.live.waker(), &mut self.notices);
    }

    /// True while a question waits above everything else.
    pub(super) fn is_modal(&self) -> bool {
        self.help.is_some() || self.files.is_asking() || self.paths.is_open()
    }
}
