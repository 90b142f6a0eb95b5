//! The standard observer.

use std::sync::LazyLock;

use glam::DVec3;

use super::polyline::Polyline;
use super::{Bins, LAMBDA_MAX_NM, LAMBDA_MIN_NM, Spectrum};

/// The CIE 1931 2° standard observer, looking at 380–730 nm.
///
/// Tristimulus values are scaled so that the equal-energy spectrum of radiance 1 has Y = 1 exactly;
/// X and Z are scaled by the same factor. Colour-matching functions every nanometre from
/// ISO/CIE 11664-1:2019 (`assets/spectra/README.md`), joined by straight lines.
#[derive(Clone, Copy, Debug)]
pub struct Observer;

static COLOUR_MATCHING: LazyLock<[Polyline; 3]> = LazyLock::new(|| {
    let table = include_str!("../../../assets/spectra/cie1931_2deg_1nm.csv");
    let functions = Polyline::from_csv::<3>(table);
    let scale = 1.0 / functions[1].integral(LAMBDA_MIN_NM.into(), LAMBDA_MAX_NM.into());
    functions.map(|function| function.scaled(scale))
});

/// What each whole nanometre of a spectrum of straight lines adds to X, Y and Z.
///
/// The integral of the product of two polylines with knots at h = 1 nm is the sum of
/// h/6·(f₋₁ + 4·f + f₊₁) over the knots, with half of it at the two ends.
static KNOTS: LazyLock<Vec<(f64, DVec3)>> = LazyLock::new(|| {
    let (low, high) = (LAMBDA_MIN_NM as u32, LAMBDA_MAX_NM as u32);
    let functions = |lambda_nm: u32| Observer::color_matching_at(f64::from(lambda_nm));
    let weight = |lambda_nm: u32| {
        let side = |inside: bool, neighbour: u32| {
            if inside {
                (2.0 * functions(lambda_nm) + functions(neighbour)) / 6.0
            } else {
                DVec3::ZERO
            }
        };
        side(lambda_nm > low, lambda_nm - 1) + side(lambda_nm < high, lambda_nm + 1)
    };
    (low..=high).map(|lambda_nm| (f64::from(lambda_nm), weight(lambda_nm))).collect()
});

impl Observer {
    /// X, Y and Z of radiance 1 in each bin: the colour-matching functions integrated over the
    /// bin.
    pub fn color_matching(bins: Bins) -> Vec<[f32; 3]> {
        Self::bin_weights(bins).into_iter().map(|weight| weight.as_vec3().to_array()).collect()
    }

    /// The colour-matching functions x̄, ȳ, z̄ at a wavelength in nm, per nm and so scaled that the
    /// integral of ȳ is 1.
    pub fn color_matching_at(lambda_nm: f64) -> DVec3 {
        DVec3::from_array(COLOUR_MATCHING.each_ref().map(|function| function.at(lambda_nm)))
    }

    /// X, Y and Z of mean radiances, one per bin.
    pub fn xyz_of_means(means: &[f32], bins: Bins) -> DVec3 {
        let weights = Self::bin_weights(bins).into_iter();
        weights.zip(means).map(|(weight, &mean)| weight * f64::from(mean)).sum()
    }

    /// X, Y and Z of a spectrum, integrated over every nanometre rather than over bins.
    pub fn xyz(spectrum: &Spectrum) -> DVec3 {
        let curve = spectrum.curve();
        Self::xyz_of(|lambda_nm| curve.at(lambda_nm))
    }

    /// X, Y and Z of a spectrum as a film of these bins records it.
    pub fn binned_xyz(spectrum: &Spectrum, bins: Bins) -> DVec3 {
        Self::xyz_of_means(&spectrum.bin_means(bins), bins)
    }

    /// [`color_matching`](Self::color_matching) before rounding.
    pub(crate) fn bin_weights(bins: Bins) -> Vec<DVec3> {
        bins.ranges_nm().map(|(low, high)| Self::xyz_between(low, high)).collect()
    }

    /// X, Y and Z of radiance 1 between two wavelengths in nm and none elsewhere.
    pub(crate) fn xyz_between(low_nm: f64, high_nm: f64) -> DVec3 {
        DVec3::from_array(COLOUR_MATCHING.each_ref().map(|f| f.integral(low_nm, high_nm)))
    }

    /// X, Y and Z of a function of wavelength in nm.
    pub(super) fn xyz_of(radiance: impl Fn(f64) -> f64) -> DVec3 {
        Self::knots().iter().map(|&(lambda_nm, weight)| weight * radiance(lambda_nm)).sum()
    }

    /// Each whole nanometre and its X, Y and Z per unit of radiance.
    pub(super) fn knots() -> &'static [(f64, DVec3)] {
        &KNOTS
    }
}
