//! Light that has found the eye: deposits on the pixel's bins.

use glam::Vec3;

use crate::kernel::absorption::{bin_overlap, bin_range, transmittance};
use crate::kernel::ray::Ray;
use crate::kernel::walk::Walk;
use crate::packed::{NONE, PackedScene};

/// What is left of light that a matte surface sends back.
#[derive(Clone, Copy, Debug)]
pub struct Reflectance {
    /// Row of the surface's own reflectance, or [`NONE`] where no light is lost to it.
    pub row: u32,
    /// Row of the reflectance of red, with those of green and blue behind it, or [`NONE`] where
    /// nothing is printed.
    pub primaries: u32,
    /// How much of red, green and blue the print reflects.
    pub weights: Vec3,
}

impl Reflectance {
    /// Of light that meets no surface: all of it.
    pub const WHOLE: Self = Self { row: NONE, primaries: NONE, weights: Vec3::ZERO };

    /// Of a surface with nothing printed on it.
    #[inline]
    pub fn bare(row: u32) -> Self {
        Self { row, ..Self::WHOLE }
    }
}

/// The mean over `bin` of what a print reflects.
#[inline]
pub fn print_value(scene: &PackedScene, reflectance: &Reflectance, bin: u32) -> f32 {
    let red = scene.spectrum_value(reflectance.primaries, bin);
    let green = scene.spectrum_value(reflectance.primaries + 1, bin);
    let blue = scene.spectrum_value(reflectance.primaries + 2, bin);
    reflectance.weights.dot(Vec3::new(red, green, blue))
}

/// Adds radiance of row `radiance_row` as it is reflected, scaled by `scale`, evenly over the ray's
/// interval.
#[inline]
pub fn deposit<R: Copy>(
    walk: &mut Walk<'_, R>,
    ray: &Ray,
    radiance_row: u32,
    reflectance: &Reflectance,
    scale: f32,
) {
    let scene = walk.scene;
    let weight = ray.significance * scale;
    let range = bin_range(scene, ray.lambda_low_nm, ray.lambda_high_nm);
    for bin in range.first..=range.last {
        let mut value = weight * bin_overlap(&range, bin) * scene.spectrum_value(radiance_row, bin);
        if reflectance.row != NONE {
            value *= scene.spectrum_value(reflectance.row, bin);
        }
        if reflectance.primaries != NONE {
            value *= print_value(scene, reflectance, bin);
        }
        if ray.absorber != NONE {
            value *= transmittance(scene, ray, bin);
        }
        walk.radiance[bin as usize] += value;
    }
}
