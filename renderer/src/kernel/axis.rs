//! The dispersion axis, along which wavelengths are spaced by what refraction makes of them.

use glam::Vec3A;

use crate::packed::{AXIS_LEN, INDEX_TABLE_LEN, NONE, PackedScene};
use crate::spectrum::LAMBDA_MIN_NM;

/// The value of a table of `len` numbers at `place`, in 0..=1 from its first to its last.
#[inline]
pub fn table_at(scene: &PackedScene, first: u32, len: usize, place: f32) -> f32 {
    let step = place.clamp(0.0, 1.0) * (len - 1) as f32;
    let i = (step as usize).min(len - 2);
    let at = first as usize + i;
    let (low, high) = (scene.spectra[at], scene.spectra[at + 1]);
    low + (high - low) * (step - i as f32)
}

/// The wavelength at a position on the axis, in nm.
#[inline]
pub fn wavelength_at(scene: &PackedScene, axis_position: f32) -> f32 {
    table_at(scene, scene.axis, AXIS_LEN, axis_position)
}

/// How fast the wavelength changes at a position on the axis: nm from one number of the table to the
/// next.
#[inline]
pub fn wavelength_slope_at(scene: &PackedScene, axis_position: f32) -> f32 {
    let step = axis_position.clamp(0.0, 1.0) * (AXIS_LEN - 1) as f32;
    let at = scene.axis as usize + (step as usize).min(AXIS_LEN - 2);
    scene.spectra[at + 1] - scene.spectra[at]
}

/// The position of a wavelength on the axis.
#[inline]
pub fn axis_position_of(scene: &PackedScene, lambda_nm: f32) -> f32 {
    let place = (lambda_nm - LAMBDA_MIN_NM) * (1.0 / (INDEX_TABLE_LEN - 1) as f32);
    table_at(scene, scene.axis + AXIS_LEN as u32, INDEX_TABLE_LEN, place)
}

/// The mean over a bin's wavelengths of their position on the axis, and its variance.
#[inline]
pub fn axis_moments(scene: &PackedScene, bin: u32) -> [f32; 2] {
    let first = scene.axis as usize + AXIS_LEN + INDEX_TABLE_LEN + bin as usize;
    [scene.spectra[first], scene.spectra[first + scene.bins.count()]]
}

/// The moments of all bins: the means and the variances.
#[inline]
pub fn all_axis_moments(scene: &PackedScene) -> [&[f32]; 2] {
    let first = scene.axis as usize + AXIS_LEN + INDEX_TABLE_LEN;
    let count = scene.bins.count();
    let (means, variances) = scene.spectra[first..first + 2 * count].split_at(count);
    [means, variances]
}

/// Indices of refraction of a medium at the nodes, which lie at these positions on the axis; 1 for
/// air.
#[inline]
pub fn indices_at(scene: &PackedScene, medium: u32, axis_positions: Vec3A) -> Vec3A {
    if medium == NONE {
        return Vec3A::ONE;
    }
    let first = medium + INDEX_TABLE_LEN as u32;
    Vec3A::new(
        table_at(scene, first, AXIS_LEN, axis_positions.x),
        table_at(scene, first, AXIS_LEN, axis_positions.y),
        table_at(scene, first, AXIS_LEN, axis_positions.z),
    )
}
