//! From film to display: CIE XYZ, white point, exposure, tone curve, gamut, encoding.
//!
//! ```text
//! Film → XyzImage → DisplayImage → sRGB codes
//!                 ↘ linear Rec. 709 (OpenEXR)
//!      → CountImage → sRGB codes of a heat map
//!
//! GpuFilm → GpuXyzImage → texture of sRGB codes, on a graphics device by the same rules
//!         → GpuCountImage → texture of sRGB codes of a heat map
//! ```
//!
//! Everything that depends on [`DisplaySettings`] or on what is [`Shown`] happens after the second
//! step, so that a finished film develops again without being traced again.

mod brightest;
mod color_path;
mod count_image;
mod development;
mod gamut;
mod gpu;
mod heat;
mod srgb8;
mod tone_curve;
mod xyz;

use glam::DVec3;
use rayon::prelude::*;

use crate::color::{self, Lab};
use crate::error::RendererError;
use crate::settings::DisplaySettings;
pub use brightest::{brightest_srgb8, interval_srgb8};
pub use color_path::{ColorPath, GamutFault, GamutShift};
pub use count_image::CountImage;
pub use gpu::{Band, GpuCountImage, GpuDeveloper, GpuXyzImage};
pub use heat::{HeatMap, NOTHING};
pub use xyz::XyzImage;

/// Pixels that a thread takes at a time: enough to be worth the asking.
const PIXELS_PER_TASK: usize = 2048;

/// What a picture shows of a film.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shown {
    /// The colours that the observer sees.
    #[default]
    Color,
    /// What it took to trace each pixel, or what was left out.
    Heat(HeatMap),
}

/// An exposed film, not yet developed, where the film is.
#[derive(Clone, Debug)]
pub enum LatentImage {
    /// In the processor's memory.
    Memory {
        /// As the observer sees it.
        light: XyzImage,
        /// What its pixels took to trace.
        counts: CountImage,
    },
    /// In the memory of a graphics device.
    Graphics {
        /// As the observer sees it.
        light: GpuXyzImage,
        /// What its pixels took to trace.
        counts: GpuCountImage,
    },
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
            Self::Memory { light, .. } => light.size,
            Self::Graphics { light, .. } => light.size(),
        }
    }

    /// The image as a display shows it. Heat maps have scales of their own, which the settings do
    /// not change.
    ///
    /// # Errors
    /// The graphics device fails.
    pub fn develop(
        &self,
        settings: &DisplaySettings,
        shown: Shown,
    ) -> Result<Pixels, RendererError> {
        match (self, shown) {
            (Self::Memory { light, .. }, Shown::Color) => {
                Ok(Pixels::Rgba8(light.develop_rgba8(settings)))
            }
            (Self::Memory { counts, .. }, Shown::Heat(map)) => {
                Ok(Pixels::Rgba8(counts.develop_rgba8(map)))
            }
            (Self::Graphics { light, .. }, Shown::Color) => {
                light.develop(settings).map(Pixels::Texture)
            }
            (Self::Graphics { counts, .. }, Shown::Heat(map)) => {
                counts.develop(map).map(Pixels::Texture)
            }
        }
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

    /// The colours as they are seen beside the display's white, row by row from the top.
    pub fn labs(&self) -> impl Iterator<Item = Lab> {
        let (xyz_from_rgb, white) = (color::xyz_from_rec709(), color::d65_white());
        let rgb = self.rgb.iter().map(|rgb| DVec3::from_array(rgb.map(f64::from)));
        rgb.map(move |rgb| Lab::from_xyz(xyz_from_rgb * rgb, white))
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
