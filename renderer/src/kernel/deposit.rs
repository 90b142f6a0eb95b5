//! Light that has found the eye: deposits on the pixel's bins.

use crate::kernel::ray::Ray;
use crate::kernel::trace::Walk;
use crate::packed::{NONE, PackedScene};
use crate::spectrum::LAMBDA_MIN_NM;

/// Calls `visit` with every bin that the interval meets, and how much of that bin it covers, in
/// 0..=1.
#[inline]
fn for_each_bin(scene: &PackedScene, low_nm: f32, high_nm: f32, mut visit: impl FnMut(usize, f32)) {
    let per_nm = 1.0 / scene.bins.width_nm();
    let low = (low_nm - LAMBDA_MIN_NM) * per_nm;
    let high = (high_nm - LAMBDA_MIN_NM) * per_nm;
    let last = scene.bins.count() - 1;
    let first = (low.max(0.0) as usize).min(last);
    for bin in first..=last {
        let overlap = high.min((bin + 1) as f32) - low.max(bin as f32);
        if overlap <= 0.0 && bin > first {
            break;
        }
        visit(bin, overlap.max(0.0));
    }
}

/// Transmittance e^(−α·d) of the path that the ray has still to pay for, in one bin.
#[inline]
fn transmittance(scene: &PackedScene, ray: &Ray, bin: usize) -> f32 {
    let row = scene.materials[ray.absorber as usize].absorption;
    (-scene.spectrum(row)[bin] * ray.path_mm).exp()
}

/// Mean of the path's transmittance over the ray's interval; 1 where nothing absorbs.
#[inline]
pub fn mean_transmittance(scene: &PackedScene, ray: &Ray) -> f32 {
    if ray.absorber == NONE {
        return 1.0;
    }
    let (mut sum, mut width) = (0.0, 0.0);
    for_each_bin(scene, ray.lambda_low_nm, ray.lambda_high_nm, |bin, overlap| {
        sum += overlap * transmittance(scene, ray, bin);
        width += overlap;
    });
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

/// Adds radiance of row `radiance`, reflected by row `reflectance` unless that is [`NONE`], scaled
/// by `scale`, evenly over the ray's interval.
#[inline]
pub fn deposit(walk: &mut Walk<'_>, ray: &Ray, radiance: u32, reflectance: u32, scale: f32) {
    let scene = walk.scene;
    let values = scene.spectrum(radiance);
    let weight = ray.significance * scale;
    for_each_bin(scene, ray.lambda_low_nm, ray.lambda_high_nm, |bin, overlap| {
        let mut value = weight * overlap * values[bin];
        if reflectance != NONE {
            value *= scene.spectrum(reflectance)[bin];
        }
        if ray.absorber != NONE {
            value *= transmittance(scene, ray, bin);
        }
        walk.pixel[bin] += value;
    });
}
