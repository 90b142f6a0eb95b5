//! The tree of a pixel's rays.

use eframe::egui::Ui;

use super::Pick;

/// Shows the tab.
pub(super) fn show(ui: &mut Ui, pick: &Pick) {
    ui.label(format!("{:?}", pick.pixels.middle()));
}
