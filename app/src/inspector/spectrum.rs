//! The spectrum of what is picked.

use eframe::egui::Ui;

use super::Pick;

/// Shows the tab.
pub(super) fn show(ui: &mut Ui, pick: &Pick) {
    ui.label(format!("{}", pick.pixels));
}
