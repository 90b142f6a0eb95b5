//! What the mouse and the keys do, and what this program is.

use eframe::egui::{Context, Grid, RichText, Ui};

use crate::theme;

/// A page of help.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Help {
    /// The mouse and the keys.
    Keys,
    /// The program.
    About,
}

const KEYS: [(&str, &str); 19] = [
    ("Drag", "turn the stone"),
    ("Middle drag, Shift + drag", "move it"),
    ("Wheel, pinch", "come nearer to what is under the cursor"),
    ("R, double click while the inspector is closed", "reset the camera"),
    ("1 or F", "face-up"),
    ("3 or S", "side"),
    ("7 or P", "pavilion-up"),
    ("H", "picture, rays per pixel, depth, pruned light"),
    ("L", "the line drawing with names and angles"),
    ("I", "show or hide the inspector"),
    ("Click, Ctrl + drag", "pick a pixel or a region for the inspector"),
    ("Arrow keys, + and \u{2212}", "turn and zoom"),
    ("Double click on a slider", "back to its default"),
    ("Ctrl + O, Ctrl + S", "open, save"),
    ("Ctrl + E", "export a still"),
    ("Ctrl + Z, Ctrl + Shift + Z", "undo, redo"),
    ("Escape", "close the export window, the diagram, the drawing; deselect a ray; close messages"),
    ("F9", "show or hide the panel"),
    ("Ctrl + Q", "quit"),
];

/// Shows a page; false once it is closed.
pub fn show(ctx: &Context, page: Help) -> bool {
    let modal = theme::dialog(ctx, "help").show(ctx, |ui| {
        ui.set_width(430.0);
        match page {
            Help::Keys => keys_ui(ui),
            Help::About => about_ui(ui),
        }
        ui.add_space(8.0);
        ui.horizontal(|ui| ui.add(theme::dialog_button("Close")).clicked()).inner
    });
    !(modal.inner || modal.should_close())
}

fn keys_ui(ui: &mut Ui) {
    ui.heading("Mouse and keys");
    ui.add_space(4.0);
    Grid::new("keys").num_columns(2).spacing([24.0, 6.0]).show(ui, |ui| {
        for (keys, effect) in KEYS {
            ui.label(RichText::new(keys).color(theme::TEXT_STRONG));
            ui.label(effect);
            ui.end_row();
        }
    });
}

fn about_ui(ui: &mut Ui) {
    ui.heading("Brilliance");
    ui.label(format!("Version {}", env!("CARGO_PKG_VERSION")));
    ui.add_space(4.0);
    ui.label(
        "A viewer of gemstones that traces the whole spectrum of every ray, after Spencer W. \
         Thomas, \u{201c}Dispersive refraction in ray tracing\u{201d}, The Visual Computer 2, 1986.",
    );
    ui.add_space(4.0);
    ui.label(RichText::new("MIT or Apache-2.0, as you like.").color(theme::TEXT_WEAK));
}
