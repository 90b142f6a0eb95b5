//! How the picture is traced.

use brilliance_renderer::scene_file::StillSettings;
use brilliance_renderer::settings::{NoiseGoal, Splitting, TraceSettings};
use eframe::egui::Ui;

use crate::row::{SliderRow, choice, switch, whole, wide};

/// Most passes that can be asked for.
pub(crate) const MAX_PASSES: u32 = 4096;

/// How dispersed rays can be divided.
const SPLITTINGS: [(Splitting, &str); 2] =
    [(Splitting::Exact, "Exact"), (Splitting::Paper, "Paper (Thomas 1986)")];

/// Why rows of the paper's splitting are idle.
const PAPER_ONLY: &str = "Belongs to the paper's splitting. Exact splitting divides rays where their \
                          ways part, and loses no light of weak ones.";

/// Why those of the exact one are.
const EXACT_ONLY: &str =
    "Belongs to exact splitting. The paper ends rays by their significance, never by chance.";

/// Shows the section.
pub(super) fn show(ui: &mut Ui, trace: &mut TraceSettings, still: &mut StillSettings) {
    let default = TraceSettings::default();
    choice(
        ui,
        "Splitting",
        "How dispersed rays are divided. Exact: where their wavelengths meet different facets, total \
         reflection or lights. Paper: into sub-rays of equal width, as Thomas 1986 does.",
        &mut trace.splitting,
        &SPLITTINGS,
    );
    paper_ui(ui, trace);
    exact_ui(ui, trace);
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
    let default = StillSettings::default();
    SliderRow::new(
        "Passes",
        "After how many rays per pixel the picture is finished; more make its edges smoother.",
        1.0..=f64::from(MAX_PASSES),
        default.passes,
    )
    .logarithmic()
    .show_u32(ui, &mut still.passes);
    noise_ui(ui, &mut still.noise);
}

/// Rows that count for the paper's splitting only.
fn paper_ui(ui: &mut Ui, trace: &mut TraceSettings) {
    let default = TraceSettings::default();
    let is_used = trace.splitting == Splitting::Paper;
    let tooltip = |words| if is_used { words } else { PAPER_ONLY };
    ui.add_enabled_ui(is_used, |ui| {
        SliderRow::new(
            "Split count",
            tooltip(
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
            tooltip(
                "Spreads the sub-rays over the incident fan; without it they clump, as in Fig. 3 of \
                 the paper.",
            ),
            &mut trace.perturb,
        );
        SliderRow::new(
            "Significance",
            tooltip(
                "Rays weaker than this part of the camera ray end here and are counted as pruned.",
            ),
            wide(&TraceSettings::SIGNIFICANCE_THRESHOLD),
            default.significance_threshold,
        )
        .logarithmic()
        .percent()
        .show_f32(ui, &mut trace.significance_threshold);
    });
}

/// Rows that count for exact splitting only.
fn exact_ui(ui: &mut Ui, trace: &mut TraceSettings) {
    let is_used = trace.splitting == Splitting::Exact;
    let tooltip = |words| if is_used { words } else { EXACT_ONLY };
    ui.add_enabled_ui(is_used, |ui| {
        SliderRow::new(
            "Roulette",
            tooltip(
                "Rays that carry less of the camera ray's energy than this live on by chance, and then \
                 carry more, so that in the mean nothing is lost: less makes passes slower and smoother.",
            ),
            wide(&TraceSettings::ROULETTE_THRESHOLD),
            TraceSettings::default().roulette_threshold,
        )
        .logarithmic()
        .percent()
        .show_f32(ui, &mut trace.roulette_threshold);
    });
}

/// Rows for when a picture is good enough before all its passes are done.
pub(crate) fn noise_ui(ui: &mut Ui, noise: &mut NoiseGoal) {
    let default = NoiseGoal::default();
    SliderRow::new(
        "Noise target",
        "The picture is finished before its last pass when 98 of 100 pixels have no more noise than \
         this part of their light; 0 asks for all passes.",
        wide(&NoiseGoal::TARGET),
        default.target,
    )
    .percent()
    .show_f32(ui, &mut noise.target);
    switch(
        ui,
        "Adaptive",
        "Later passes leave out the pixels that have reached the noise target, and so go to those \
         that differ from their neighbours.",
        &mut noise.is_adaptive,
    );
}
