//! What the viewport shows of the film: the choice, and the names of what there is.

use brilliance_renderer::develop::{HeatMap, Shown};
use eframe::egui::{Button, Ui};

use crate::command::Command;

/// Everything that can be shown, in the order of the menu and of its key.
const CHOICES: [Shown; 4] = [
    Shown::Color,
    Shown::Heat(HeatMap::Rays),
    Shown::Heat(HeatMap::Depth),
    Shown::Heat(HeatMap::Pruned),
];

/// What comes after `shown`, and after the last the first.
pub fn next(shown: Shown) -> Shown {
    let place = CHOICES.iter().position(|&choice| choice == shown).unwrap_or_default();
    CHOICES[(place + 1) % CHOICES.len()]
}

/// What the user knows it by.
pub fn name(shown: Shown) -> &'static str {
    match shown {
        Shown::Color => "Picture",
        Shown::Heat(HeatMap::Rays) => "Rays per pixel",
        Shown::Heat(HeatMap::Depth) => "Depth",
        Shown::Heat(HeatMap::Pruned) => "Pruned light",
    }
}

/// What it is, in a few words.
pub fn description(shown: Shown) -> &'static str {
    match shown {
        Shown::Color => "the stone in its colours",
        Shown::Heat(HeatMap::Rays) => "ray segments traced for one camera ray",
        Shown::Heat(HeatMap::Depth) => "most interfaces that a traced ray had met",
        Shown::Heat(HeatMap::Pruned) => "light below the significance threshold",
    }
}

/// The choice, as a menu.
pub fn menu_ui(ui: &mut Ui, shown: Shown, chosen: &mut Option<Command>) {
    for choice in CHOICES {
        let button = ui.radio(choice == shown, name(choice));
        if button.on_hover_text(description(choice)).clicked() {
            *chosen = Some(Command::Show(choice));
        }
    }
    ui.separator();
    let shortcut = Command::ShowNext.shortcut_text(ui.ctx()).unwrap_or_default();
    if ui.add(Button::new("Next").shortcut_text(shortcut)).clicked() {
        *chosen = Some(Command::ShowNext);
    }
}
