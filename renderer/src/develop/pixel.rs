//! What develops one pixel: the one function behind both the picture and the viewport.

use glam::{DVec3, Mat3, Vec3};

use super::gamut;
use super::srgb8::Srgb8;
use crate::color;
use crate::settings::{DisplaySettings, ToneCurve, WhitePoint};
use crate::spectrum::{Bins, Illuminant, Observer, Spectrum};

/// Display settings made ready for pixels.
pub(super) struct Development {
    /// Exposed and adapted linear Rec. 709 from scene XYZ.
    rgb_from_xyz: Mat3,
    /// Exposed and adapted luminance from scene XYZ.
    luminance_from_xyz: Vec3,
    tone_curve: ToneCurve,
    gamut_mapping: bool,
}

impl Development {
    /// Bradford-adapts the white point, as a film of these bins records it, to the display's white.
    pub(super) fn new(settings: &DisplaySettings, bins: Bins) -> Self {
        let white = Observer::binned_xyz(&settings.white_point.spectrum(), bins);
        let exposure = f64::from(settings.exposure_ev).exp2();
        let adapted_from_xyz = color::adaptation(white, color::d65_white()) * exposure;
        Self {
            rgb_from_xyz: (color::rec709_from_xyz() * adapted_from_xyz).as_mat3(),
            luminance_from_xyz: (adapted_from_xyz.transpose() * DVec3::Y).as_vec3(),
            tone_curve: settings.tone_curve,
            gamut_mapping: settings.gamut_mapping,
        }
    }

    /// Linear display RGB in 0..=1. What is not a finite colour of positive luminance is black.
    pub(super) fn rgb(&self, xyz: [f32; 3]) -> [f32; 3] {
        let xyz = Vec3::from(xyz);
        let y = self.luminance_from_xyz.dot(xyz);
        let rgb = self.rgb_from_xyz * xyz;
        if !(y > 0.0 && (rgb.x + rgb.y + rgb.z).is_finite()) {
            return [0.0; 3];
        }
        let gain = self.tone_curve.gain(y);
        let rgb = (rgb * gain).to_array();
        if self.gamut_mapping { gamut::desaturate(rgb, y * gain) } else { gamut::clip(rgb) }
    }

    /// sRGB codes of the pixels `xyz`, into the red, green and blue of `rgba8`.
    pub(super) fn rgba8(&self, xyz: &[[f32; 3]], rgba8: &mut [u8]) {
        let srgb8 = Srgb8::get();
        for (pixel, &xyz) in rgba8.chunks_exact_mut(4).zip(xyz) {
            let rgb = self.rgb(xyz);
            for (code, channel) in pixel.iter_mut().zip(rgb) {
                *code = srgb8.encode(channel);
            }
        }
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
