//! The window with the line drawing of the stone that the panel edits.

use brilliance_renderer::drawing::Sheet;
use brilliance_renderer::scene::Object;
use eframe::egui::{Context, RichText, Ui, Window, vec2};

use super::draughting::Draughting;
use super::sheet_files::SaveSheet;
use super::sheet_view::SheetView;
use crate::theme;
use crate::waker::Waker;

/// Room under the drawing for the buttons, in points.
const FOOTER: f32 = 36.0;

/// The window and its drawing.
#[derive(Default)]
pub struct FacetWindow {
    open: bool,
    view: SheetView,
    draughting: Draughting,
}

impl FacetWindow {
    /// Opens the window, or closes it.
    pub fn toggle(&mut self) {
        self.open = !self.open;
        self.view = SheetView::default();
    }

    /// Closes the window; true if it was open.
    pub fn close(&mut self) -> bool {
        std::mem::take(&mut self.open)
    }

    /// The drawing that is shown.
    pub fn sheet(&self) -> Option<&Sheet> {
        self.draughting.newest().filter(|_| self.open).and_then(|sheet| sheet.as_ref().ok())
    }

    /// Shows the drawing of `object` as it is now, or the one before it until that is made.
    pub fn show(
        &mut self,
        ctx: &Context,
        object: Option<&Object>,
        waker: &Waker,
    ) -> Option<SaveSheet> {
        if !self.open {
            return None;
        }
        self.draughting.update(object, waker);
        let mut open = true;
        let shown = Window::new("Line drawing")
            .open(&mut open)
            .collapsible(false)
            .default_size([960.0, 730.0])
            .min_size([320.0, 260.0])
            .default_pos(ctx.content_rect().left_top() + vec2(16.0, 44.0))
            .show(ctx, |ui| self.contents_ui(ui));
        self.open = open;
        shown.and_then(|window| window.inner).flatten()
    }

    fn contents_ui(&mut self, ui: &mut Ui) -> Option<SaveSheet> {
        match self.draughting.newest() {
            Some(Ok(sheet)) => {
                let size = ui.available_size() - vec2(0.0, FOOTER);
                self.view.show(ui, sheet, size);
                ui.add_space(6.0);
                ui.horizontal(|ui| {
                    let order = SaveSheet::buttons_ui(ui, sheet);
                    let hint = "Wheel: magnify. Drag: move. Double click: all of it.";
                    ui.label(RichText::new(hint).color(theme::TEXT_WEAK));
                    order
                })
                .inner
            }
            Some(Err(fault)) => {
                ui.label(RichText::new("This can't be drawn").strong().color(theme::WARNING));
                ui.label(fault);
                None
            }
            None if self.draughting.is_running() => {
                ui.horizontal(|ui| {
                    ui.spinner();
                    ui.label("Drawing\u{2026}");
                });
                None
            }
            None => {
                ui.label("The scene has no object to draw.");
                None
            }
        }
    }
}
