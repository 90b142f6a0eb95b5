//! From film to display: CIE XYZ, white point, exposure, tone curve, gamut, encoding.
//!
//! ```text
//! Film → XyzImage → DisplayImage → sRGB codes
//!                 ↘ linear Rec. 709 (OpenEXR)
//! ```
//!
//! Everything that depends on [`DisplaySettings`] happens after [`XyzImage`], so that a finished
//! film develops again without being traced again.

mod gamut;
mod gpu;
mod pixels;
mod srgb8;
mod tone_curve;

use glam::{DVec3, Vec3};
use rayon::prelude::*;

use crate::color;
use crate::error::RendererError;
use crate::film::Film;
use crate::settings::DisplaySettings;
use crate::spectrum::{Bins, Observer};
pub use gpu::GpuXyzImage;
use pixels::Development;

/// Pixels that a thread takes at a time: enough to be worth the asking.
const PIXELS_PER_TASK: usize = 2048;

/// An exposed film as the observer sees it, not yet developed, where the film is.
#[derive(Clone, Debug)]
pub enum LatentImage {
    /// In the processor's memory.
    Memory(XyzImage),
    /// In the memory of a graphics device.
    Graphics(GpuXyzImage),
}

/// The pixels of a developed image, where the film is.
#[derive(Clone, Debug)]
pub enum Pixels {
    /// sRGB-encoded RGBA in the processor's memory, row by row from the top.
    Rgba8(Vec<u8>),
    /// sRGB-encoded RGBA, as an `Rgba8Unorm` texture that can also be viewed as `Rgba8UnormSrgb`.
    Texture(wgpu::Texture),
}

impl LatentImage {
    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        match self {
            Self::Memory(image) => image.size,
            Self::Graphics(image) => image.size(),
        }
    }

    /// The image as a display shows it.
    ///
    /// # Errors
    /// The graphics device fails.
    pub fn develop(&self, settings: &DisplaySettings) -> Result<Pixels, RendererError> {
        match self {
            Self::Memory(image) => Ok(Pixels::Rgba8(image.develop_rgba8(settings))),
            Self::Graphics(image) => image.develop(settings).map(Pixels::Texture),
        }
    }
}

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
    /// Integrates the mean over the film's passes. A pixel that holds a NaN or an infinity is
    /// black.
    pub fn from_film(film: &Film) -> Self {
        let weights = Observer::bin_weights(film.bins());
        let scale = 1.0 / f64::from(film.passes().max(1));
        let pixels = film.sums().par_chunks_exact(weights.len()).with_min_len(PIXELS_PER_TASK);
        let xyz = pixels.map(|sums| {
            let sum: DVec3 = weights.iter().zip(sums).map(|(w, &sum)| *w * f64::from(sum)).sum();
            let xyz = (sum * scale).as_vec3();
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

/// Linear Rec. 709 RGB ready for a display.
#[derive(Clone, Debug)]
pub struct DisplayImage {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Red, green and blue in 0..=1, row by row from the top.
    pub rgb: Vec<[f32; 3]>,
}

impl DisplayImage {
    /// sRGB-encoded, 8 bits per channel, with an opaque alpha.
    pub fn to_rgba8_srgb(&self) -> Vec<u8> {
        let encode = |channel: f32| (255.0 * color::srgb_encode(channel.into())).round() as u8;
        let pixels = self.rgb.par_iter().with_min_len(PIXELS_PER_TASK);
        pixels.flat_map_iter(|rgb| rgb.map(encode).into_iter().chain([255])).collect()
    }

    /// sRGB-encoded, 16 bits per channel, red, green, blue.
    pub fn to_rgb16_srgb(&self) -> Vec<u16> {
        let encode = |channel: f32| (65535.0 * color::srgb_encode(channel.into())).round() as u16;
        self.rgb
            .par_iter()
            .with_min_len(PIXELS_PER_TASK)
            .flat_map_iter(|rgb| rgb.map(encode))
            .collect()
    }
}
