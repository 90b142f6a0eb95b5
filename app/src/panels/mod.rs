//! The side panel: the sections that edit the document.

mod curve;
mod display;
mod lights;
mod material;
mod stone;
mod tracing;

pub(crate) use tracing::{MAX_PASSES, noise_ui};

use brilliance_renderer::scene_file::Document;
use eframe::egui::{CollapsingHeader, Frame, Margin, Panel, RichText, ScrollArea, Ui};

use crate::theme;

/// What the panel remembers that is not part of the document.
#[derive(Debug, Default)]
pub struct PanelState {
    /// Which object the stone and the material section edit.
    object: usize,
    /// What is typed above the list of materials.
    material_filter: String,
}

impl PanelState {
    /// The index of the object that the panel edits.
    pub(crate) fn object(&self) -> usize {
        self.object
    }
}

/// Shows the panel at the right edge. `opened` is the document as it was opened, where the lights
/// go back to.
pub fn show(
    ui: &mut Ui,
    editable: bool,
    document: &mut Document,
    opened: &Document,
    state: &mut PanelState,
) {
    let frame = Frame::new().fill(theme::PANEL).inner_margin(Margin { left: 14, ..Margin::ZERO });
    Panel::right("panel").frame(frame).default_size(352.0).size_range(300.0..=520.0).show(
        ui,
        |ui| {
            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                Frame::new().inner_margin(Margin { right: 14, top: 6, bottom: 14, left: 0 }).show(
                    ui,
                    |ui| {
                        ui.add_enabled_ui(editable, |ui| {
                            sections_ui(ui, document, opened, state);
                        });
                    },
                );
            });
        },
    );
}

fn sections_ui(ui: &mut Ui, document: &mut Document, opened: &Document, state: &mut PanelState) {
    state.object = state.object.min(document.scene.objects.len().saturating_sub(1));
    if document.scene.objects.len() > 1 {
        ui.add_space(6.0);
        stone::object_ui(ui, &document.scene.objects, &mut state.object);
    }
    if let Some(object) = document.scene.objects.get_mut(state.object) {
        section(ui, "Stone", |ui| stone::show(ui, object));
        section(ui, "Material", |ui| {
            material::show(ui, &mut object.material, &mut state.material_filter);
        });
    }
    section(ui, "Light", |ui| {
        lights::show(ui, &mut document.scene.lights, &opened.scene.lights);
    });
    section(ui, "Display", |ui| display::show(ui, &mut document.display));
    section(ui, "Tracing", |ui| {
        tracing::show(ui, &mut document.trace, &mut document.still);
    });
}

/// A section that folds away under its title.
fn section(ui: &mut Ui, title: &str, contents: impl FnOnce(&mut Ui)) {
    CollapsingHeader::new(RichText::new(title).strong())
        .id_salt(title)
        .default_open(true)
        .show_unindented(ui, |ui| {
            contents(ui);
            ui.add_space(4.0);
        });
    ui.separator();
}
