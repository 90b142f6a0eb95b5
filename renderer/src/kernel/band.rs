//! The light of a fan, bin by bin: what a part of its interval deposits, and what energy it carries.

use std::ops::Range;

use crate::kernel::absorption::{BinRange, bin_overlap, bin_range};
use crate::kernel::axis::{
    all_axis_moments, axis_moments, axis_position_of, wavelength_at, wavelength_slope_at,
};
use crate::kernel::fan::{Fan, axis_position_in};
use crate::kernel::parabola::{
    Parabola, half_slope_at, parabola_at, parabola_through, position_where,
};
use crate::kernel::walk::Walk;
use crate::packed::{NONE, PackedScene};
use crate::spectrum::LAMBDA_MIN_NM;

/// A part of a fan's interval, made ready to be spread over the bins.
#[derive(Clone, Copy, Debug)]
pub struct Band {
    /// The bins that it meets.
    pub range: BinRange,
    /// Its ends, as positions in the fan.
    pub ends: [f32; 2],
    /// The position on the dispersion axis along the positions in the fan.
    pub axis: Parabola,
    /// The weight along them.
    pub weight: Parabola,
    /// The length of the path along them, in mm.
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

/// Half of the distance between the two points of Gauss's rule, over the width of the interval.
pub const GAUSS_POINT: f32 = 0.288_675_14;

/// Bend of the axis along a fan, over its slope, up to which positions go with it.
pub const STRAIGHT: f32 = 1e-4;

/// The part of the fan's interval between two positions in it.
#[inline]
pub fn band_of(scene: &PackedScene, fan: &Fan, low: f32, high: f32) -> Band {
    let low_nm = wavelength_at(scene, axis_position_in(fan, low));
    let high_nm = wavelength_at(scene, axis_position_in(fan, high));
    Band {
        range: bin_range(scene, low_nm, high_nm),
        ends: [low, high],
        axis: parabola_through(fan.axis),
        weight: parabola_through(fan.weight),
        path_mm: parabola_through(fan.path_mm),
    }
}

/// What a band has of one of its bins.
#[inline]
pub fn bin_part(scene: &PackedScene, band: &Band, bin: u32) -> BinPart {
    let overlap = bin_overlap(&band.range, bin);
    if overlap >= 1.0 && band.axis.a.abs() <= STRAIGHT * band.axis.b {
        let [mean, variance] = axis_moments(scene, bin);
        let per_position = 0.5 / band.axis.b;
        let position = (mean - band.axis.c) * per_position;
        let position_squared = position * position + variance * per_position * per_position;
        return BinPart { overlap, position, position_squared };
    }
    // Gauss's rule with two points over the positions that are covered, weighed by the wavelengths
    // that fall to each.
    let mut low = band.ends[0];
    let mut high = band.ends[1];
    if band.range.low < bin as f32 {
        low = position_where(&band.axis, axis_position_of_bins(scene, bin as f32));
    }
    if band.range.high > (bin + 1) as f32 {
        high = position_where(&band.axis, axis_position_of_bins(scene, (bin + 1) as f32));
    }
    let middle = 0.5 * (low + high);
    let offset = GAUSS_POINT * (high - low);
    let [first, second] = [middle - offset, middle + offset];
    let first_nm = wavelengths_per_position(scene, band, first);
    let second_nm = wavelengths_per_position(scene, band, second);
    let share = second_nm / (first_nm + second_nm).max(1e-12);
    let position = first + (second - first) * share;
    let position_squared = first * first + (second * second - first * first) * share;
    BinPart { overlap, position, position_squared }
}

/// How fast the wavelength changes with the position in the fan, up to a factor.
#[inline]
pub fn wavelengths_per_position(scene: &PackedScene, band: &Band, position: f32) -> f32 {
    let axis_slope = half_slope_at(&band.axis, position).max(0.0);
    axis_slope * wavelength_slope_at(scene, parabola_at(&band.axis, position))
}

/// The position on the axis of a wavelength that is counted in bins.
#[inline]
pub fn axis_position_of_bins(scene: &PackedScene, bins: f32) -> f32 {
    axis_position_of(scene, LAMBDA_MIN_NM + bins * scene.bins.width_nm())
}

/// The fan's light in one bin: the mean of its weight over the covered wavelengths, times how much
/// of the bin they are. Where a parabola dips below 0, others are as much too high.
#[inline]
pub fn bin_weight(band: &Band, part: &BinPart) -> f32 {
    let weight = &band.weight;
    let mean = weight.a * part.position_squared + 2.0 * weight.b * part.position + weight.c;
    part.overlap * mean
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

/// The mean weights of a fan in bins that a band of it covers whole, of which `means` and `variances`
/// are the moments.
#[inline]
fn weights_of_bins<'a>(
    band: &Band,
    means: &'a [f32],
    variances: &'a [f32],
) -> impl Iterator<Item = f32> + use<'a> {
    let Parabola { a, b, c } = band.weight;
    let at_middle = band.axis.c;
    let per_axis = 0.5 / band.axis.b;
    let (slope, bend) = (2.0 * b, a * per_axis * per_axis);
    means.iter().zip(variances).map(move |(mean, variance)| {
        let position = (mean - at_middle) * per_axis;
        (a * position + slope) * position + (c + bend * variance)
    })
}

/// The bins that a band covers whole, where their light can be summed up by their moments.
#[inline]
fn whole_bins(band: &Band) -> Range<usize> {
    if band.axis.a.abs() > STRAIGHT * band.axis.b {
        return 0..0;
    }
    let start = band.range.low.ceil().max(0.0) as usize;
    let end = band.range.high.max(0.0) as usize;
    start..end.max(start)
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
    let whole = if fan.absorber == NONE { whole_bins(&band) } else { 0..0 };
    for bin in band.range.first..=band.range.last {
        if whole.contains(&(bin as usize)) {
            continue;
        }
        let part = bin_part(scene, &band, bin);
        let mut value = bin_weight(&band, &part) * scene.spectrum_value(radiance_row, bin);
        if fan.absorber != NONE {
            value *= fan_transmittance(scene, fan, &band, &part, bin);
        }
        walk.radiance[bin as usize] += value;
    }
    if !whole.is_empty() {
        let [means, variances] = all_axis_moments(scene).map(|it| &it[whole.clone()]);
        let weights = weights_of_bins(&band, means, variances);
        let lights = &scene.spectrum_row(radiance_row)[whole.clone()];
        let radiance = &mut walk.radiance[whole];
        for ((radiance, weight), light) in radiance.iter_mut().zip(weights).zip(lights) {
            *radiance += weight * light;
        }
    }
}

/// The energy of a fan, in units of the camera ray's, before the absorption that its path has still
/// to pay for.
#[inline]
pub fn fan_energy(scene: &PackedScene, fan: &Fan) -> f32 {
    let band = band_of(scene, fan, -1.0, 1.0);
    let whole = whole_bins(&band);
    let mut energy = 0.0;
    for bin in band.range.first..=band.range.last {
        if !whole.contains(&(bin as usize)) {
            energy += bin_weight(&band, &bin_part(scene, &band, bin));
        }
    }
    if !whole.is_empty() {
        let [means, variances] = all_axis_moments(scene).map(|it| &it[whole.clone()]);
        energy += weights_of_bins(&band, means, variances).sum::<f32>();
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
