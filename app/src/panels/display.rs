//! How the film is shown; nothing here traces a ray.

use brilliance_renderer::settings::{DisplaySettings, ToneCurve, WhitePoint};
use eframe::egui::Ui;

use crate::row::{SliderRow, choice, switch, wide};

/// The kinds of white point, without the temperature.
#[derive(Clone, Copy, PartialEq)]
enum White {
    EqualEnergy,
    D65,
    D50,
    A,
    Temperature,
}

const WHITES: [(White, &str); 5] = [
    (White::D65, "Daylight D65, 6504 K"),
    (White::D50, "Daylight D50, 5003 K"),
    (White::A, "Incandescent A, 2856 K"),
    (White::EqualEnergy, "Equal energy"),
    (White::Temperature, "Colour temperature"),
];

const TONE_CURVES: [(ToneCurve, &str); 3] = [
    (ToneCurve::Filmic, "Filmic"),
    (ToneCurve::Reinhard, "Reinhard"),
    (ToneCurve::Linear, "Linear"),
];

const NEUTRAL_KELVIN: f32 = 6500.0;

/// Shows the section.
pub(super) fn show(ui: &mut Ui, display: &mut DisplaySettings) {
    SliderRow::new(
        "Exposure",
        "Brightens the picture; each stop doubles it.",
        wide(&DisplaySettings::EXPOSURE_EV),
        DisplaySettings::default().exposure_ev,
    )
    .unit(" EV")
    .show_f32(ui, &mut display.exposure_ev);
    white_point_ui(ui, &mut display.white_point);
    choice(
        ui,
        "Tone curve",
        "How light brighter than the screen's white is brought into range.",
        &mut display.tone_curve,
        &TONE_CURVES,
    );
    switch(
        ui,
        "Gamut mapping",
        "Moves colours the screen can't show towards the white of equal brightness instead of \
         clipping them.",
        &mut display.gamut_mapping,
    );
}

fn white_point_ui(ui: &mut Ui, white_point: &mut WhitePoint) {
    let mut white = match white_point {
        WhitePoint::EqualEnergy => White::EqualEnergy,
        WhitePoint::D65 => White::D65,
        WhitePoint::D50 => White::D50,
        WhitePoint::A => White::A,
        WhitePoint::Temperature(_) => White::Temperature,
    };
    if choice(ui, "White point", "The light that is shown as neutral.", &mut white, &WHITES) {
        *white_point = match white {
            White::EqualEnergy => WhitePoint::EqualEnergy,
            White::D65 => WhitePoint::D65,
            White::D50 => WhitePoint::D50,
            White::A => WhitePoint::A,
            White::Temperature => WhitePoint::Temperature(NEUTRAL_KELVIN),
        };
    }
    if let WhitePoint::Temperature(kelvin) = white_point {
        SliderRow::new(
            "Temperature",
            "The black body that is shown as neutral: lower makes the picture bluer.",
            wide(&DisplaySettings::TEMPERATURE_KELVIN),
            NEUTRAL_KELVIN,
        )
        .unit(" K")
        .decimals(0)
        .show_f32(ui, kelvin);
    }
}
