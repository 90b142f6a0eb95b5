//! The colours of intervals of wavelengths on the screen.

use std::sync::LazyLock;

use brilliance_renderer::develop::interval_srgb8;
use brilliance_renderer::spectrum::{LAMBDA_MAX_NM, LAMBDA_MIN_NM};
use eframe::egui::Color32;

/// Steps between wavelengths with colours of their own, in nm.
const STEP_NM: f32 = 1.0;

/// The power of a ray's part of the spectrum that its brightness goes with: 1 would be that of light,
/// and leave a ray of a hundredth of the spectrum invisible.
const SHARE_POWER: f32 = 0.35;

/// The colours of single wavelengths, one per step: fans ask for thousands in a frame.
static WAVELENGTHS: LazyLock<Vec<Color32>> = LazyLock::new(|| {
    let steps = ((LAMBDA_MAX_NM - LAMBDA_MIN_NM) / STEP_NM) as u32;
    (0..=steps).map(|step| color([LAMBDA_MIN_NM + step as f32 * STEP_NM; 2])).collect()
});

/// The colour of one wavelength in nm.
pub(super) fn color_at(lambda_nm: f32) -> Color32 {
    let position = ((lambda_nm - LAMBDA_MIN_NM) / STEP_NM).round().max(0.0) as usize;
    WAVELENGTHS[position.min(WAVELENGTHS.len() - 1)]
}

/// The colour of an even spectrum between two wavelengths in nm, as bright as the screen allows.
pub(super) fn color(interval_nm: [f32; 2]) -> Color32 {
    let [r, g, b] = interval_srgb8(interval_nm.map(f64::from));
    Color32::from_rgb(r, g, b)
}

/// How bright a ray of an interval, in nm, is drawn beside one of the whole spectrum, 0..=1. Its part
/// of the light, by a power that lets narrow rays be seen.
pub(super) fn share(interval_nm: [f32; 2]) -> f32 {
    let part = (interval_nm[1] - interval_nm[0]) / (LAMBDA_MAX_NM - LAMBDA_MIN_NM);
    part.clamp(0.0, 1.0).powf(SHARE_POWER)
}
