//! CIE XYZ of a film.

use glam::{DVec3, Vec3};
use rayon::prelude::*;

use super::development::Development;
use super::{DisplayImage, PIXELS_PER_TASK};
use crate::color;
use crate::film::Film;
use crate::settings::DisplaySettings;
use crate::spectrum::{Bins, Observer};

/// CIE XYZ per pixel as the observer sees the film: radiance 1 at every wavelength is Y = 1.
#[derive(Clone, Debug)]
pub struct XyzImage {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// The film's division of the spectrum, which white lights are seen through too.
    pub bins: Bins,
    /// X, Y and Z, row by row from the top.
    pub xyz: Vec<[f32; 3]>,
}

impl XyzImage {
    /// Integrates the mean over each pixel's camera rays. A pixel that holds a NaN or an infinity is
    /// black.
    pub fn from_film(film: &Film) -> Self {
        let weights = Observer::bin_weights(film.bins());
        let pixels = film.sums().par_chunks_exact(weights.len()).zip(film.counts());
        let xyz = pixels.with_min_len(PIXELS_PER_TASK).map(|(sums, counts)| {
            let sum: DVec3 = weights.iter().zip(sums).map(|(w, &sum)| *w * f64::from(sum)).sum();
            let xyz = (sum * f64::from(counts.scale())).as_vec3();
            if xyz.is_finite() { xyz.to_array() } else { [0.0; 3] }
        });
        let xyz = xyz.collect();
        Self { size: film.size(), bins: film.bins(), xyz }
    }

    /// The image as a display shows it.
    pub fn develop(&self, settings: &DisplaySettings) -> DisplayImage {
        let development = Development::new(settings, self.bins);
        let mut rgb = vec![[0.0; 3]; self.xyz.len()];
        rgb.par_chunks_mut(PIXELS_PER_TASK)
            .zip(self.xyz.par_chunks(PIXELS_PER_TASK))
            .for_each(|(rgb, xyz)| development.rgb(xyz, rgb));
        DisplayImage { size: self.size, rgb }
    }

    /// The same as [`develop`](Self::develop) and then [`DisplayImage::to_rgba8_srgb`], code for
    /// code, in one pass: for the live viewport.
    pub fn develop_rgba8(&self, settings: &DisplaySettings) -> Vec<u8> {
        let development = Development::new(settings, self.bins);
        let mut rgba8 = vec![0; 4 * self.xyz.len()];
        rgba8
            .par_chunks_mut(4 * PIXELS_PER_TASK)
            .zip(self.xyz.par_chunks(PIXELS_PER_TASK))
            .for_each(|(rgba8, xyz)| development.rgba8(xyz, rgba8));
        rgba8
    }

    /// Scene-linear Rec. 709 RGB: no exposure, no adaptation, no tone curve, channels unbounded.
    pub fn linear_rgb(&self) -> Vec<[f32; 3]> {
        let rgb_from_xyz = color::rec709_from_xyz().as_mat3();
        self.xyz.iter().map(|&xyz| (rgb_from_xyz * Vec3::from(xyz)).to_array()).collect()
    }
}
