//! What became of the camera ray in all.

use brilliance_renderer::inspect::RayTree;
use eframe::egui::{Align, Button, Color32, Layout, Rect, RichText, Sense, Ui, pos2, vec2};

use super::traced::Traced;
use crate::ray_words;
use crate::theme;

/// Most rays that are copied to the clipboard: some megabytes of text, written within a frame or two.
const MOST_COPIED: usize = 4000;
const BAR_HEIGHT: f32 = 6.0;

/// An account of the energy.
struct Account {
    name: &'static str,
    part: f64,
    color: Color32,
}

/// Counts, and a bar of where the energy went.
pub(super) fn show(ui: &mut Ui, traced: &Traced) {
    let (tree, counts) = (&traced.tree, &traced.counts);
    ui.horizontal(|ui| {
        ui.label(ray_words::rays(counts.total()));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| copy_ui(ui, tree));
    });
    ui.label(RichText::new(ray_words::counts(counts)).small().color(theme::TEXT_WEAK));
    if tree.is_truncated {
        let words = format!("{} of them are too many to be listed.", tree.unrecorded_rays);
        ui.label(RichText::new(words).color(theme::WARNING));
    }
    let accounts = accounts(tree);
    bar_ui(ui, &accounts);
    ui.horizontal_wrapped(|ui| {
        for account in &accounts {
            // Where nothing is cut off or lost there is nothing to tell.
            if account.part > 0.0 || account.name == "pruned" {
                let words = format!("{} {}", ray_words::percent(account.part as f32), account.name);
                let (square, _) = ui.allocate_exact_size(vec2(8.0, 8.0), Sense::hover());
                ui.painter().rect_filled(square, 1.0, account.color);
                ui.label(RichText::new(words).small().color(theme::TEXT_WEAK));
            }
        }
    });
}

/// The tree as data.
fn copy_ui(ui: &mut Ui, tree: &RayTree) {
    let can_copy = tree.rays.len() <= MOST_COPIED;
    let button = ui
        .add_enabled(can_copy, Button::new("Copy as JSON").small())
        .on_hover_text("Puts the whole tree on the clipboard, as brilliance inspect --json does.")
        .on_disabled_hover_text("Too many rays for the clipboard: use brilliance inspect --json.");
    if button.clicked()
        && let Ok(json) = serde_json::to_string(tree)
    {
        ui.copy_text(json);
    }
}

fn accounts(tree: &RayTree) -> [Account; 5] {
    let ledger = &tree.ledger;
    [
        ("returned", ledger.returned, theme::ACCENT),
        ("absorbed", ledger.absorbed, Color32::from_rgb(150, 92, 160)),
        ("pruned", ledger.pruned, theme::TEXT_WEAK),
        ("cut off", ledger.cut_off, theme::WARNING),
        ("lost", ledger.lost, theme::ERROR),
    ]
    .map(|(name, part, color)| Account { name, part, color })
}

fn bar_ui(ui: &mut Ui, accounts: &[Account]) {
    let (bar, _) = ui.allocate_exact_size(vec2(ui.available_width(), BAR_HEIGHT), Sense::hover());
    ui.painter().rect_filled(bar, 2.0, theme::FIELD);
    let mut left = bar.left();
    for account in accounts {
        let width = bar.width() * account.part.clamp(0.0, 1.0) as f32;
        let part = Rect::from_min_size(pos2(left, bar.top()), vec2(width, BAR_HEIGHT));
        ui.painter().rect_filled(part.intersect(bar), 2.0, account.color);
        left += width;
    }
}
