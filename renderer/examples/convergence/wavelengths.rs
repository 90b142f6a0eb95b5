//! Which wavelength a path has, and what it counts.

use brilliance_renderer::color;
use brilliance_renderer::spectrum::{LAMBDA_MAX_NM, LAMBDA_MIN_NM, Observer};
use glam::{DVec3, Vec3};

/// Ranges of wavelengths that are equally probable.
const STRATA: usize = 4096;
/// Steps of the sums over the spectrum.
const STEPS: usize = 70_000;

/// Wavelengths with a density in proportion to the length of their linear RGB: of all densities the
/// one with the least variance of RGB under a flat spectrum.
pub(crate) struct Wavelengths {
    /// Where each stratum begins, and the last ends.
    edges_nm: Vec<f32>,
    /// CIE XYZ of radiance 1, over the density, in the mean over each stratum.
    xyz: Vec<Vec3>,
}

impl Wavelengths {
    /// Sums up the colour matching functions.
    pub(crate) fn new() -> Self {
        let step_nm = f64::from(LAMBDA_MAX_NM - LAMBDA_MIN_NM) / STEPS as f64;
        let lambda_nm = |position: f64| f64::from(LAMBDA_MIN_NM) + step_nm * position;
        let color_matching: Vec<DVec3> =
            (0..STEPS).map(|i| Observer::color_matching_at(lambda_nm(i as f64 + 0.5))).collect();
        let rgb_from_xyz = color::rec709_from_xyz();
        let density = |xyz: &DVec3| (rgb_from_xyz * *xyz).length();
        let whole: f64 = color_matching.iter().map(density).sum();
        let (mut edges_nm, mut xyz) = (vec![LAMBDA_MIN_NM], vec![Vec3::ZERO; STRATA]);
        let mut sum = 0.0;
        for (i, color) in color_matching.iter().enumerate() {
            // A step may reach over the end of a stratum, or of several.
            let before = sum / whole * STRATA as f64;
            sum += density(color);
            let after = (sum / whole * STRATA as f64).min(STRATA as f64);
            for stratum in before as usize..(after.ceil() as usize).max(before as usize + 1) {
                let (low, high) = (before.max(stratum as f64), after.min(stratum as f64 + 1.0));
                let share = (high - low).max(0.0) / (after - before);
                if let Some(xyz) = xyz.get_mut(stratum) {
                    *xyz += (*color * (share * step_nm * STRATA as f64)).as_vec3();
                }
                if after >= stratum as f64 + 1.0 {
                    let part = (stratum as f64 + 1.0 - before) / (after - before);
                    edges_nm.push(lambda_nm(i as f64 + part) as f32);
                }
            }
        }
        edges_nm.resize(STRATA + 1, LAMBDA_MAX_NM);
        Self { edges_nm, xyz }
    }

    /// The wavelength in nm of a number in 0..1, and the CIE XYZ that radiance 1 of it counts.
    pub(crate) fn at(&self, number: f32) -> (f32, Vec3) {
        let position = number * STRATA as f32;
        let stratum = (position as usize).min(STRATA - 1);
        let (low, high) = (self.edges_nm[stratum], self.edges_nm[stratum + 1]);
        (low + (high - low) * (position - stratum as f32), self.xyz[stratum])
    }
}
