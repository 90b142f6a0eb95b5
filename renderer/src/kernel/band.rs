//! The light of a fan, bin by bin: what a part of its interval deposits, and what energy it carries.

use crate::kernel::absorption::{BinRange, bin_overlap, bin_range};
use crate::kernel::axis::{axis_moments, axis_position_of, wavelength_at};
use crate::kernel::fan::{Fan, axis_position_in};
use crate::kernel::parabola::{Parabola, parabola_at, parabola_through};
use crate::kernel::walk::Walk;
use crate::packed::{NONE, PackedScene};
use crate::spectrum::LAMBDA_MIN_NM;

/// A part of a fan's interval, made ready to be spread over the bins.
#[derive(Clone, Copy, Debug)]
pub struct Band {
    /// The bins that it meets.
    pub range: BinRange,
    /// Position on the axis of the fan's middle.
    pub middle: f32,
    /// One over half of the fan's width on the axis.
    pub per_half_width: f32,
    /// The fan's weight along its positions.
    pub weight: Parabola,
    /// The length of its path along them, in mm.
    pub path_mm: Parabola,
}

/// A bin's part of a band.
#[derive(Clone, Copy, Debug)]
pub struct BinPart {
    /// How much of the bin the band covers, in 0..=1.
    pub overlap: f32,
    /// Mean position in the fan over the covered wavelengths.
    pub position: f32,
    /// Mean of the squared position.
    pub position_squared: f32,
}

/// The part of the fan's interval between two positions in it.
#[inline]
pub fn band_of(scene: &PackedScene, fan: &Fan, low: f32, high: f32) -> Band {
    let low_nm = wavelength_at(scene, axis_position_in(fan, low));
    let high_nm = wavelength_at(scene, axis_position_in(fan, high));
    let half_width = 0.5 * (fan.high - fan.low);
    Band {
        range: bin_range(scene, low_nm, high_nm),
        middle: 0.5 * (fan.low + fan.high),
        per_half_width: if half_width > 0.0 { 1.0 / half_width } else { 0.0 },
        weight: parabola_through(fan.weight),
        path_mm: parabola_through(fan.path_mm),
    }
}

/// What a band has of one of its bins.
#[inline]
pub fn bin_part(scene: &PackedScene, band: &Band, bin: u32) -> BinPart {
    let overlap = bin_overlap(&band.range, bin);
    let mut position;
    let mut position_squared;
    if overlap >= 1.0 {
        let [mean, mean_square] = axis_moments(scene, bin);
        position = mean - band.middle;
        position_squared = position * position + (mean_square - mean * mean).max(0.0);
    } else {
        // Simpson's rule over what is covered.
        let low = band.range.low.max(bin as f32);
        let high = band.range.high.min((bin + 1) as f32);
        let first = axis_position_of_bins(scene, low) - band.middle;
        let second = axis_position_of_bins(scene, 0.5 * (low + high)) - band.middle;
        let third = axis_position_of_bins(scene, high) - band.middle;
        position = (first + 4.0 * second + third) * (1.0 / 6.0);
        position_squared = (first * first + 4.0 * second * second + third * third) * (1.0 / 6.0);
    }
    position *= band.per_half_width;
    position_squared *= band.per_half_width * band.per_half_width;
    BinPart { overlap, position, position_squared }
}

/// The position on the axis of a wavelength that is counted in bins.
#[inline]
pub fn axis_position_of_bins(scene: &PackedScene, bins: f32) -> f32 {
    axis_position_of(scene, LAMBDA_MIN_NM + bins * scene.bins.width_nm())
}

/// The fan's light in one bin: the mean of its weight over the covered wavelengths, times how much
/// of the bin they are.
#[inline]
pub fn bin_weight(band: &Band, part: &BinPart) -> f32 {
    let weight = &band.weight;
    let mean = weight.a * part.position_squared + 2.0 * weight.b * part.position + weight.c;
    part.overlap * mean.max(0.0)
}

/// Transmittance e^(−α·d) of the path that the fan has still to pay for, in one bin.
#[inline]
pub fn fan_transmittance(
    scene: &PackedScene,
    fan: &Fan,
    band: &Band,
    part: &BinPart,
    bin: u32,
) -> f32 {
    let row = scene.materials[fan.absorber as usize].absorption;
    let path_mm = parabola_at(&band.path_mm, part.position).max(0.0);
    (-scene.spectrum_value(row, bin) * path_mm).exp()
}

/// Adds radiance of row `radiance_row` over the part of the fan's interval between two positions in
/// it.
#[inline]
pub fn deposit_band<R: Copy>(
    walk: &mut Walk<'_, R>,
    fan: &Fan,
    low: f32,
    high: f32,
    radiance_row: u32,
) {
    let scene = walk.scene;
    let band = band_of(scene, fan, low, high);
    for bin in band.range.first..=band.range.last {
        let part = bin_part(scene, &band, bin);
        let mut value = bin_weight(&band, &part) * scene.spectrum_value(radiance_row, bin);
        if fan.absorber != NONE {
            value *= fan_transmittance(scene, fan, &band, &part, bin);
        }
        walk.radiance[bin as usize] += value;
    }
}

/// The energy of a fan, in units of the camera ray's, before the absorption that its path has still
/// to pay for.
#[inline]
pub fn fan_energy(scene: &PackedScene, fan: &Fan) -> f32 {
    let band = band_of(scene, fan, -1.0, 1.0);
    let mut energy = 0.0;
    for bin in band.range.first..=band.range.last {
        energy += bin_weight(&band, &bin_part(scene, &band, bin));
    }
    energy / scene.bins.count() as f32
}

/// The energy that a fan still carries at its end, after its path's absorption is booked.
#[inline]
pub fn retire_fan<R: Copy>(walk: &mut Walk<'_, R>, fan: &Fan) -> f32 {
    let scene = walk.scene;
    if fan.absorber == NONE {
        return fan_energy(scene, fan);
    }
    let band = band_of(scene, fan, -1.0, 1.0);
    let mut energy = 0.0;
    let mut absorbed = 0.0;
    for bin in band.range.first..=band.range.last {
        let part = bin_part(scene, &band, bin);
        let weight = bin_weight(&band, &part);
        let kept = fan_transmittance(scene, fan, &band, &part, bin);
        energy += weight * kept;
        absorbed += weight * (1.0 - kept);
    }
    let per_bin = 1.0 / scene.bins.count() as f32;
    walk.tally.absorbed += absorbed * per_bin;
    energy * per_bin
}
