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
        ui.label(format!("{name} has changes that are in no file yet."));
        ui.add_space(8.0);
        let mut decision = None;
        ui.horizontal(|ui| {
            for (button, choice) in [
                (theme::main_button("Save"), Decision::Save),
                (theme::dialog_button("Discard"), Decision::Discard),
                (theme::dialog_button("Cancel"), Decision::Cancel),
            ] {
                if ui.add(button).clicked() {
                    decision = Some(choice);
                }
            }
        });
        decision
    });
    modal.inner.or_else(|| modal.should_close().then_some(Decision::Cancel))
}
