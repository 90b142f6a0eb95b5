//! How the picture is traced.

use brilliance_renderer::settings::{Splitting, TraceSettings};
use eframe::egui::Ui;

use crate::row::{SliderRow, choice, switch, whole, wide};

/// Most passes that can be asked for.
pub(crate) const MAX_PASSES: u32 = 4096;

/// How dispersed rays can be divided.
const SPLITTINGS: [(Splitting, &str); 2] =
    [(Splitting::Exact, "Exact"), (Splitting::Paper, "Paper (Thomas 1986)")];

/// Why rows of the paper's splitting are idle.
const PAPER_ONLY: &str =
    "Belongs to the paper's splitting. Exact splitting divides rays where their ways part.";

/// Shows the section.
pub(super) fn show(ui: &mut Ui, trace: &mut TraceSettings, passes: &mut u32) {
    let default = TraceSettings::default();
    choice(
        ui,
        "Splitting",
        "How dispersed rays are divided. Exact: where their wavelengths meet different facets, total \
         reflection or lights. Paper: into sub-rays of equal width, as Thomas 1986 does.",
        &mut trace.splitting,
        &SPLITTINGS,
    );
    let is_paper = trace.splitting == Splitting::Paper;
    let of_paper = |tooltip| if is_paper { tooltip } else { PAPER_ONLY };
    ui.add_enabled_ui(is_paper, |ui| {
        SliderRow::new(
            "Split count",
            of_paper(
                "How many sub-rays a dispersed ray sends per width of the smallest light: more make \
                 smoother colours and cost time.",
            ),
            wide(&TraceSettings::SPLIT_COUNT),
            default.split_count,
        )
        .decimals(1)
        .show_f32(ui, &mut trace.split_count);
        switch(
            ui,
            "Perturb sub-rays",
            of_paper(
                "Spreads the sub-rays over the incident fan; without it they clump, as in Fig. 3 of \
                 the paper.",
            ),
            &mut trace.perturb,
        );
    });
    SliderRow::new(
        "Significance",
        "Rays weaker than this part of the camera ray end here and are counted as pruned.",
        wide(&TraceSettings::SIGNIFICANCE_THRESHOLD),
        default.significance_threshold,
    )
    .logarithmic()
    .percent()
    .show_f32(ui, &mut trace.significance_threshold);
    SliderRow::new(
        "Maximum depth",
        "How many facets a ray may meet before it is cut off.",
        whole(&TraceSettings::MAX_DEPTH),
        default.max_depth,
    )
    .unit(" facets")
    .show_u32(ui, &mut trace.max_depth);
    SliderRow::new(
        "Spectral bins",
        "Into how many bands of wavelength the film divides 380\u{2013}730 nm.",
        whole(&TraceSettings::BINS),
        default.bins,
    )
    .unit(" bands")
    .show_u32(ui, &mut trace.bins);
    SliderRow::new(
        "Passes",
        "After how many rays per pixel the picture is finished; more make its edges smoother.",
        1.0..=f64::from(MAX_PASSES),
        64.0,
    )
    .logarithmic()
    .show_u32(ui, passes);
}
