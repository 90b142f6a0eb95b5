//! The spectrum of what is picked, as the session reads it from the film.

mod axis;
mod diagram;
mod numbers;
mod plot;

use std::sync::Arc;

use brilliance_renderer::film::Region;
use brilliance_renderer::session::Reading;
use brilliance_renderer::settings::DisplaySettings;
use eframe::egui::{RichText, Ui};

use crate::spectrum_csv::{Column, spectrum_csv};
use crate::theme;
use numbers::Seen;

/// The state of the tab.
#[derive(Debug, Default)]
pub(super) struct SpectrumTab {
    is_logarithmic: bool,
    /// What the newest reading is compared with.
    kept: Option<Arc<Reading>>,
}

impl SpectrumTab {
    /// Shows the newest reading, which should be of `region`, by the display settings.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        region: Region,
        reading: Option<&Arc<Reading>>,
        display: &DisplaySettings,
    ) {
        let Some(reading) = reading else {
            caption_ui(ui, "The spectrum comes with the next pass\u{2026}");
            return;
        };
        origin_ui(ui, reading, region);
        plot::plot_ui(ui, reading, self.kept.as_deref(), self.is_logarithmic);
        caption_ui(
            ui,
            "Mean spectral radiance (1 throughout: luminance 1). Curves: CIE 1931 colour matching, \
             to their own scale.",
        );
        self.actions_ui(ui, reading, display);
        ui.add_space(6.0);

        let seen = Seen::new(reading, display);
        let kept = self.kept.as_ref().map(|kept| Seen::new(kept, display));
        numbers::swatches_ui(ui, &seen);
        let (verdict, is_moved) = seen.verdict();
        let color = if is_moved { theme::WARNING } else { theme::TEXT };
        ui.label(RichText::new(verdict).color(color));
        ui.add_space(6.0);
        diagram::diagram_ui(ui, &seen.path, kept.as_ref().map(|kept| &kept.path));
        caption_ui(
            ui,
            "Ring: the light in the scene. Dashes: white balance. Arrow: gamut mapping. Dot: what \
             the screen shows.",
        );
        ui.add_space(6.0);
        numbers::numbers_ui(ui, &seen, kept.as_ref());
        ui.add_space(8.0);
    }

    fn actions_ui(&mut self, ui: &mut Ui, reading: &Arc<Reading>, display: &DisplaySettings) {
        ui.horizontal(|ui| {
            ui.checkbox(&mut self.is_logarithmic, "Logarithmic")
                .on_hover_text("Four powers of ten from the top of the axis down.");
            let keep = ui.button("Keep");
            if keep.on_hover_text("Draws this spectrum over those picked next.").clicked() {
                self.kept = Some(Arc::clone(reading));
            }
            if self.kept.is_some() && ui.button("Forget").clicked() {
                self.kept = None;
            }
            let copy = ui.button("Copy as CSV");
            if copy.on_hover_text("Copies the numbers of the plot, for a spreadsheet.").clicked() {
                ui.ctx().copy_text(self.csv(reading, display));
            }
        });
    }

    /// The numbers of the plot, with notes on where they come from.
    fn csv(&self, reading: &Reading, display: &DisplaySettings) -> String {
        let named = [("picked", Some(reading)), ("kept", self.kept.as_deref())];
        let named = named.into_iter().filter_map(|(name, reading)| Some((name, reading?)));
        let note = |(name, reading): (&str, &Reading)| {
            let xyz = Seen::new(reading, display).path.scene_xyz;
            format!("{name}: mean of {}; {}", origin(reading), numbers::xyz_text(xyz))
        };
        let notes: Vec<_> = named.clone().map(note).collect();
        let columns: Vec<_> = named
            .map(|(name, reading)| Column { name, bins: reading.bins, spectrum: &reading.spectrum })
            .collect();
        spectrum_csv(&notes, &columns)
    }
}

/// Says what was read, and how far it is to be trusted.
fn origin_ui(ui: &mut Ui, reading: &Reading, region: Region) {
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(origin(reading)).color(theme::TEXT_WEAK));
        if reading.region != region {
            ui.label(
                RichText::new("as picked before; the next pass brings the new one")
                    .color(theme::WARNING),
            );
        } else if reading.is_draft {
            ui.label(RichText::new("draft").color(theme::WARNING));
        }
    });
}

fn caption_ui(ui: &mut Ui, text: &str) {
    ui.label(RichText::new(text).small().color(theme::TEXT_WEAK));
}

fn origin(reading: &Reading) -> String {
    let [film_width, film_height] = reading.film_size;
    let passes = if reading.passes == 1 { "pass" } else { "passes" };
    format!("{} of {film_width} \u{d7} {film_height}, {} {passes}", reading.pixels, reading.passes)
}
