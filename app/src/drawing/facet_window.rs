//! The window with the line drawing of the stone that the panel edits.

use brilliance_renderer::drawing::{Sheet, facet_diagram};
use brilliance_renderer::scene::{Object, Shape};
use eframe::egui::{Context, RichText, Ui, Window, vec2};

use super::sheet_files::SaveSheet;
use super::sheet_view::SheetView;
use crate::theme;

/// Room under the drawing for the buttons, in points.
const FOOTER: f32 = 36.0;

/// The window, its drawing and what the drawing was made from.
#[derive(Default)]
pub struct FacetWindow {
    open: bool,
    view: SheetView,
    drawn: Option<Drawn>,
}

/// A drawing and all that it depends on.
struct Drawn {
    name: String,
    shape: Shape,
    scale: f32,
    sheet: Result<Sheet, String>,
}

impl FacetWindow {
    /// Opens the window, or closes it.
    pub fn toggle(&mut self) {
        self.open = !self.open;
    }

    /// Closes the window; true if it was open.
    pub fn close(&mut self) -> bool {
        std::mem::take(&mut self.open)
    }

    /// The drawing that is shown.
    pub fn sheet(&self) -> Option<&Sheet> {
        self.drawn.as_ref().filter(|_| self.open).and_then(|drawn| drawn.sheet.as_ref().ok())
    }

    /// Shows the drawing of `object` as it is now.
    pub fn show(&mut self, ctx: &Context, object: Option<&Object>) -> Option<SaveSheet> {
        if !self.open {
            return None;
        }
        self.update(object);
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

    /// Draws anew if what is drawn has changed.
    fn update(&mut self, object: Option<&Object>) {
        let Some(object) = object else {
            self.drawn = None;
            return;
        };
        if self.drawn.as_ref().is_some_and(|drawn| drawn.shows(object)) {
            return;
        }
        let sheet = facet_diagram(object).map_err(|fault| fault.to_string());
        let (name, shape) = (object.name.clone(), object.shape.clone());
        self.drawn = Some(Drawn { name, shape, scale: object.transform.scale, sheet });
    }

    fn contents_ui(&mut self, ui: &mut Ui) -> Option<SaveSheet> {
        match self.drawn.as_ref().map(|drawn| &drawn.sheet) {
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
            None => {
                ui.label("The scene has no object to draw.");
                None
            }
        }
    }
}

impl Drawn {
    fn shows(&self, object: &Object) -> bool {
        self.name == object.name
            && self.scale == object.transform.scale
            && self.shape == object.shape
    }
}
