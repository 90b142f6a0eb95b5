//! Light that has found the eye: deposits on the pixel's bins.

use crate::kernel::absorption::{bin_overlap, bin_range, transmittance};
use crate::kernel::ray::Ray;
use crate::kernel::walk::Walk;
use crate::packed::NONE;

/// Adds radiance of row `radiance_row`, reflected by row `reflectance` unless that is [`NONE`], scaled
/// by `scale`, evenly over the ray's interval.
#[inline]
pub fn deposit(walk: &mut Walk<'_>, ray: &Ray, radiance_row: u32, reflectance: u32, scale: f32) {
    let scene = walk.scene;
    let weight = ray.significance * scale;
    let range = bin_range(scene, ray.lambda_low_nm, ray.lambda_high_nm);
    for bin in range.first..=range.last {
        let mut value = weight * bin_overlap(&range, bin) * scene.spectrum_value(radiance_row, bin);
        if reflectance != NONE {
            value *= scene.spectrum_value(reflectance, bin);
        }
        if ray.absorber != NONE {
            value *= transmittance(scene, ray, bin);
        }
        walk.radiance[bin as usize] += value;
    }
}
