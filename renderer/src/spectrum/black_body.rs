//! Thermal radiation.

use super::observer::Observer;

/// A black body scaled to luminance 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlackBody {
    kelvin: f64,
    scale: f64,
}

/// The second radiation constant h·c/k in nm·K (CODATA 2018, exact in the SI of 2019).
const C2_NM_KELVIN: f64 = 1.438_776_877e7;

/// Where the radiance is 1 before it is scaled, in nm.
const REFERENCE_NM: f64 = 560.0;

impl BlackBody {
    /// Temperatures that can be evaluated, in kelvin: below, nothing is left of the visible range;
    /// above, the spectrum no longer changes.
    pub(super) const KELVIN: std::ops::RangeInclusive<f32> = 500.0..=1e6;

    /// The black body of this temperature, moved into [`KELVIN`](Self::KELVIN).
    pub(super) fn new(kelvin: f32) -> Self {
        let kelvin = f64::from(kelvin.clamp(*Self::KELVIN.start(), *Self::KELVIN.end()));
        let relative = Self { kelvin, scale: 1.0 };
        Self { kelvin, scale: 1.0 / Observer::xyz_of(|lambda_nm| relative.at(lambda_nm)).y }
    }

    /// Spectral radiance at a wavelength in nm: Planck's law relative to its value at 560 nm.
    pub(super) fn at(self, lambda_nm: f64) -> f64 {
        let boltzmann = |lambda_nm: f64| (C2_NM_KELVIN / (lambda_nm * self.kelvin)).exp_m1();
        let falloff = (REFERENCE_NM / lambda_nm).powi(5);
        self.scale * falloff * boltzmann(REFERENCE_NM) / boltzmann(lambda_nm)
    }
}
