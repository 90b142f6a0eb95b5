//! Which rays are shown.

use brilliance_renderer::inspect::RayKind;
use eframe::egui::{RichText, Ui};

use super::legend;
use super::traced::Traced;
use crate::ray_words;
use crate::row::{SliderRow, labelled, switch};
use crate::theme;

/// Least significance that can be asked for.
const FAINTEST: f32 = 1e-6;

/// The kinds that can be hidden; the camera ray always is there.
const KINDS: [RayKind; 3] = [RayKind::Refracted, RayKind::TotallyReflected, RayKind::Reflected];

/// Which rays of a tree are shown, in the table and in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Filter {
    /// Fewest interfaces before the ray.
    from_depth: u32,
    /// Most interfaces before the ray.
    to_depth: u32,
    least_significance: f32,
    /// Which of [`KINDS`] are shown.
    kinds: [bool; 3],
    lamps_only: bool,
}

impl Default for Filter {
    /// All rays.
    fn default() -> Self {
        Self {
            from_depth: 0,
            to_depth: u32::MAX,
            least_significance: FAINTEST,
            kinds: [true; 3],
            lamps_only: false,
        }
    }
}

impl Filter {
    /// Whether the ray `id` is shown.
    pub(super) fn admits(&self, traced: &Traced, id: u32) -> bool {
        let ray = traced.ray(id);
        let is_hidden = |(kind, is_shown): (&RayKind, &bool)| *kind == ray.kind && !is_shown;
        !KINDS.iter().zip(&self.kinds).any(is_hidden)
            && (self.from_depth..=self.to_depth).contains(&ray.depth)
            && (ray.significance >= self.least_significance || self.least_significance == FAINTEST)
            && (!self.lamps_only || traced.reaches_lamp(id))
    }

    /// Where rays are hidden, says that `shown` of `all` are not, and offers to show all.
    pub(super) fn hint_ui(&mut self, ui: &mut Ui, shown: usize, all: usize) {
        if *self == Self::default() {
            return;
        }
        ui.horizontal(|ui| {
            let words = format!("{shown} of {} shown", ray_words::rays(all as u64));
            ui.label(RichText::new(words).color(theme::WARNING));
            if ui.small_button("Show all").clicked() {
                *self = Self::default();
            }
        });
    }

    /// The controls.
    pub(super) fn show(&mut self, ui: &mut Ui, deepest: u32) {
        let depths = 0.0..=f64::from(deepest.max(1));
        let mut to_depth = self.to_depth.min(deepest);
        SliderRow::new(
            "From depth",
            "Hides rays before this many interfaces.",
            depths.clone(),
            0.0,
        )
        .show_u32(ui, &mut self.from_depth);
        let tooltip = "Hides rays behind more interfaces than this.";
        if SliderRow::new("To depth", tooltip, depths, deepest).show_u32(ui, &mut to_depth) {
            // At the end of its rail it shows deeper trees whole too.
            self.to_depth = if to_depth >= deepest { u32::MAX } else { to_depth };
        }
        SliderRow::new(
            "Significance",
            "Hides rays that count less than this in the pixel.",
            f64::from(FAINTEST)..=1.0,
            FAINTEST,
        )
        .percent()
        .decimals(2)
        .logarithmic()
        .show_f32(ui, &mut self.least_significance);
        labelled(ui, "Kinds", "Shows rays of these kinds.", |ui, _| {
            for (kind, is_shown) in KINDS.into_iter().zip(&mut self.kinds) {
                ui.toggle_value(is_shown, RichText::new(legend::name(kind)).small())
                    .on_hover_text(legend::explanation(kind));
            }
        });
        let tooltip = "Shows only the ways that end in a lamp.";
        switch(ui, "Only to lamps", tooltip, &mut self.lamps_only);
    }
}
