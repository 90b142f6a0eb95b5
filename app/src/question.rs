//! The question before unsaved changes would be lost.

use eframe::egui::Context;

use crate::theme;

/// What the user decides about unsaved changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decision {
    /// Save, then go on.
    Save,
    /// Go on without saving.
    Discard,
    /// Don't go on.
    Cancel,
}

/// Asks about the changes to the document called `name`.
pub fn show(ctx: &Context, name: &str) -> Option<Decision> {
    let modal = theme::dialog(ctx, "unsaved changes").show(ctx, |ui| {
        ui.set_width(360.0);
        ui.heading("Save your changes?");
        ui.label(format!("{name} has been changed since it was opened or saved."));
        ui.add_space(4.0);
        let mut decision = None;
        ui.horizontal(|ui| {
            for (text, choice) in [
                ("Save", Decision::Save),
                ("Discard", Decision::Discard),
                ("Cancel", Decision::Cancel),
            ] {
                if ui.button(text).clicked() {
                    decision = Some(choice);
                }
            }
        });
        decision
    });
    modal.inner.or_else(|| modal.should_close().then_some(Decision::Cancel))
}
