//! The question before work would be lost.

use eframe::egui::{Context, Ui};

use crate::theme;

/// What the user decides about work that would be lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decision {
    /// Save, then go on.
    Save,
    /// Go on without saving.
    Discard,
    /// Don't go on.
    Cancel,
}

/// What would be lost.
#[derive(Clone, Copy, Debug)]
pub struct Loss<'a> {
    /// The name of the document that has unsaved changes.
    pub changed: Option<&'a str>,
    /// A still that is being rendered.
    pub export: bool,
}

/// Asks about what would be lost.
pub fn show(ctx: &Context, loss: Loss<'_>) -> Option<Decision> {
    let modal = theme::dialog(ctx, "unsaved changes").show(ctx, |ui| {
        ui.set_width(360.0);
        let heading =
            if loss.changed.is_some() { "Save your changes?" } else { "Stop the export?" };
        ui.heading(heading);
        if let Some(name) = loss.changed {
            ui.label(format!("{name} has changes that are in no file yet."));
        }
        if loss.export {
            ui.label("A still is being rendered; it would not be written.");
        }
        ui.add_space(8.0);
        buttons_ui(ui, loss)
    });
    modal.inner.or_else(|| modal.should_close().then_some(Decision::Cancel))
}

fn buttons_ui(ui: &mut Ui, loss: Loss<'_>) -> Option<Decision> {
    let mut decision = None;
    ui.horizontal(|ui| {
        if loss.changed.is_some() && ui.add(theme::main_button("Save")).clicked() {
            decision = Some(Decision::Save);
        }
        let discard = if loss.changed.is_some() { "Discard" } else { "Stop and quit" };
        if ui.add(theme::dialog_button(discard)).clicked() {
            decision = Some(Decision::Discard);
        }
        if ui.add(theme::dialog_button("Cancel")).clicked() {
            decision = Some(Decision::Cancel);
        }
    });
    decision
}
