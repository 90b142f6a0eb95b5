//! What develops pixels, eight side by side: one function behind both the still and the viewport.

use glam::{DMat3, DVec3};
use wide::f32x8;

use super::gamut;
use super::srgb8::Srgb8;
use crate::color;
use crate::settings::{DisplaySettings, ToneCurve, WhitePoint};
use crate::spectrum::{Bins, Illuminant, Observer, Spectrum};

/// Pixels developed side by side.
const LANES: usize = 8;

/// Display settings made ready for pixels.
pub(super) struct Development {
    /// Exposed and adapted linear Rec. 709 from scene XYZ, row by row.
    rgb_from_xyz: [[f32x8; 3]; 3],
    /// Exposed and adapted luminance from scene XYZ.
    luminance_from_xyz: [f32x8; 3],
    tone_curve: ToneCurve,
    gamut_mapping: bool,
}

impl Development {
    /// Bradford-adapts the white point, as a film of these bins records it, to the display's white.
    pub(super) fn new(settings: &DisplaySettings, bins: Bins) -> Self {
        let white = Observer::binned_xyz(&settings.white_point.spectrum(), bins);
        let exposure = f64::from(settings.exposure_ev).exp2();
        let adapted_from_xyz = color::adaptation(white, color::d65_white()) * exposure;
        let rgb_from_xyz: DMat3 = color::rec709_from_xyz() * adapted_from_xyz;
        let splat = |row: DVec3| row.as_vec3().to_array().map(f32x8::splat);
        Self {
            rgb_from_xyz: [0, 1, 2].map(|channel| splat(rgb_from_xyz.row(channel))),
            luminance_from_xyz: splat(adapted_from_xyz.row(1)),
            tone_curve: settings.tone_curve,
            gamut_mapping: settings.gamut_mapping,
        }
    }

    /// Linear display RGB in 0..=1 of each pixel of `xyz`.
    pub(super) fn rgb(&self, xyz: &[[f32; 3]], rgb: &mut [[f32; 3]]) {
        for (rgb, xyz) in rgb.chunks_mut(LANES).zip(xyz.chunks(LANES)) {
            let [r, g, b] = self.develop(from_pixels(xyz)).map(f32x8::to_array);
            for (lane, pixel) in rgb.iter_mut().enumerate() {
                *pixel = [r[lane], g[lane], b[lane]];
            }
        }
    }

    /// sRGB codes of each pixel of `xyz`, with an opaque alpha.
    pub(super) fn rgba8(&self, xyz: &[[f32; 3]], rgba8: &mut [u8]) {
        let srgb8 = Srgb8::get();
        for (rgba8, xyz) in rgba8.chunks_mut(4 * LANES).zip(xyz.chunks(LANES)) {
            let [r, g, b] = self.develop(from_pixels(xyz)).map(|channel| srgb8.encode(channel));
            for (lane, pixel) in rgba8.chunks_exact_mut(4).enumerate() {
                pixel.copy_from_slice(&[r[lane], g[lane], b[lane], 255]);
            }
        }
    }

    /// Linear display RGB in 0..=1. What is not a finite colour of positive luminance is black.
    fn develop(&self, xyz: [f32x8; 3]) -> [f32x8; 3] {
        let y = dot(self.luminance_from_xyz, xyz);
        let rgb = self.rgb_from_xyz.map(|row| dot(row, xyz));
        let is_color = y.simd_gt(f32x8::ZERO) & (rgb[0] + rgb[1] + rgb[2]).is_finite();
        let gain = self.tone_curve.gain(y);
        let rgb = rgb.map(|channel| channel * gain);
        let shown =
            if self.gamut_mapping { gamut::desaturate(rgb, y * gain) } else { gamut::clip(rgb) };
        shown.map(|channel| channel & is_color)
    }
}

impl WhitePoint {
    /// The light that is shown as neutral.
    pub fn spectrum(self) -> Spectrum {
        match self {
            Self::EqualEnergy => Spectrum::Flat(1.0),
            Self::D65 => Spectrum::Illuminant(Illuminant::D65),
            Self::D50 => Spectrum::Illuminant(Illuminant::D50),
            Self::A => Spectrum::Illuminant(Illuminant::A),
            Self::Temperature(kelvin) => Spectrum::BlackBody { kelvin },
        }
    }
}

fn dot(a: [f32x8; 3], b: [f32x8; 3]) -> f32x8 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Up to eight pixels, one channel per vector; missing ones are black.
fn from_pixels(pixels: &[[f32; 3]]) -> [f32x8; 3] {
    let mut channels = [[0.0; LANES]; 3];
    for (lane, pixel) in pixels.iter().take(LANES).enumerate() {
        for (channel, &value) in channels.iter_mut().zip(pixel) {
            channel[lane] = value;
        }
    }
    channels.map(f32x8::from)
}
