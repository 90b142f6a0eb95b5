//! What coloured bodies leave of a ray: Beer–Lambert over the path and the bins of the interval.

use crate::kernel::ray::Ray;
use crate::packed::{NONE, PackedScene};
use crate::spectrum::LAMBDA_MIN_NM;

/// The bins that an interval of wavelengths meets.
#[derive(Clone, Copy, Debug)]
pub struct BinRange {
    /// Short end of the interval, in bins.
    pub low: f32,
    /// Long end of the interval, in bins.
    pub high: f32,
    /// First bin met.
    pub first: u32,
    /// Last bin met.
    pub last: u32,
}

/// The bins between two wavelengths; at least one, which an interval without width covers by 0.
#[inline]
pub fn bin_range(scene: &PackedScene, low_nm: f32, high_nm: f32) -> BinRange {
    let per_nm = 1.0 / scene.bins.width_nm();
    let low = (low_nm - LAMBDA_MIN_NM) * per_nm;
    let high = (high_nm - LAMBDA_MIN_NM) * per_nm;
    let highest = (scene.bins.count() - 1) as f32;
    let first = low.floor().clamp(0.0, highest);
    let last = (high.ceil() - 1.0).clamp(first, highest);
    BinRange { low, high, first: first as u32, last: last as u32 }
}

/// How much of `bin` the interval covers, in 0..=1.
#[inline]
pub fn bin_overlap(range: &BinRange, bin: u32) -> f32 {
    let overlap = range.high.min((bin + 1) as f32) - range.low.max(bin as f32);
    overlap.max(0.0)
}

/// Transmittance e^(−α·d) of the path that the ray has still to pay for, in one bin.
#[inline]
pub fn transmittance(scene: &PackedScene, ray: &Ray, bin: u32) -> f32 {
    let row = scene.materials[ray.absorber as usize].absorption;
    (-scene.spectrum_value(row, bin) * ray.path_mm).exp()
}

/// Mean of the path's transmittance over the ray's interval; 1 where nothing absorbs.
#[inline]
pub fn mean_transmittance(scene: &PackedScene, ray: &Ray) -> f32 {
    if ray.absorber == NONE {
        return 1.0;
    }
    let range = bin_range(scene, ray.lambda_low_nm, ray.lambda_high_nm);
    let mut sum = 0.0;
    let mut width = 0.0;
    for bin in range.first..=range.last {
        let overlap = bin_overlap(&range, bin);
        sum += overlap * transmittance(scene, ray, bin);
        width += overlap;
    }
    if width > 0.0 { sum / width } else { 1.0 }
}

/// An upper bound of the path's transmittance, for the price of one exponential.
#[inline]
pub fn transmittance_bound(scene: &PackedScene, ray: &Ray) -> f32 {
    if ray.absorber == NONE {
        return 1.0;
    }
    (-scene.materials[ray.absorber as usize].least_absorption * ray.path_mm).exp()
}
