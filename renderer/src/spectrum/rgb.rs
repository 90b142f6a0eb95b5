//! Smooth reflectances from colours.

use std::sync::LazyLock;

use super::polyline::Polyline;

/// The reflectances of the linear sRGB colours red, green and blue under the equal-energy white:
/// smooth, in 0..=1, and 1 together at every wavelength.
///
/// I. Mallett and C. Yuksel, "Spectral Primary Decomposition for Rendering with sRGB Reflectance",
/// Eurographics Symposium on Rendering 2019; solved anew for this observer and this range
/// (`assets/spectra/README.md`).
static PRIMARIES: LazyLock<[Polyline; 3]> = LazyLock::new(|| {
    Polyline::from_csv(include_str!("../../../assets/spectra/srgb_primaries.csv"))
});

/// The reflectance of a linear sRGB colour, moved into 0..=1 per channel: its red, green and blue
/// parts of the [`PRIMARIES`].
///
/// It is linear in the colour, so that a mixture of colours has the mixture of their reflectances.
pub(super) fn reflectance(rgb: [f32; 3]) -> Polyline {
    Polyline::mixture(&PRIMARIES, rgb.map(|channel| f64::from(channel.clamp(0.0, 1.0))))
}
