//! What develops pixels, eight side by side: one function behind both the still and the viewport.

use bytemuck::NoUninit;
use glam::{DMat3, Vec3};
use wide::f32x8;

use super::gamut;
use super::srgb8::Srgb8;
use crate::color;
use crate::settings::{DisplaySettings, ToneCurve, WhitePoint};
use crate::spectrum::{Bins, Illuminant, Observer, Spectrum};

/// Pixels developed side by side.
const LANES: usize = 8;

/// Display settings made ready for pixels, as shaders read them too.
///
/// Each row makes one channel, exposed and adapted, from scene XYZ.
#[derive(Clone, Copy, Debug, NoUninit)]
#[repr(C)]
pub(super) struct Development {
    /// Linear Rec. 709 red.
    red_from_xyz: Vec3,
    tone_curve: ToneCurve,
    /// Linear Rec. 709 green.
    green_from_xyz: Vec3,
    /// 1 moves colours into the gamut, 0 clips them.
    gamut_mapping: u32,
    /// Linear Rec. 709 blue.
    blue_from_xyz: Vec3,
    padding_0: u32,
    luminance_from_xyz: Vec3,
    padding_1: u32,
}

/// Linear Rec. 709 RGB on its way to the display.
pub(super) struct Stages<T> {
    /// Adapted and exposed.
    pub(super) exposed: T,
    /// After the tone curve.
    pub(super) toned: T,
    /// Moved into 0..=1; black where there is no colour.
    pub(super) shown: T,
}

impl Development {
    /// Bradford-adapts the white point, as a film of these bins records it, to the display's white.
    pub(super) fn new(settings: &DisplaySettings, bins: Bins) -> Self {
        let white = Observer::binned_xyz(&settings.white_point.spectrum(), bins);
        let exposure = f64::from(settings.exposure_ev).exp2();
        let adapted_from_xyz = color::adaptation(white, color::d65_white()) * exposure;
        let rgb_from_xyz: DMat3 = color::rec709_from_xyz() * adapted_from_xyz;
        Self {
            red_from_xyz: rgb_from_xyz.row(0).as_vec3(),
            tone_curve: settings.tone_curve,
            green_from_xyz: rgb_from_xyz.row(1).as_vec3(),
            gamut_mapping: settings.gamut_mapping.into(),
            blue_from_xyz: rgb_from_xyz.row(2).as_vec3(),
            padding_0: 0,
            luminance_from_xyz: adapted_from_xyz.row(1).as_vec3(),
            padding_1: 0,
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

    /// The stages of one colour.
    pub(super) fn stages_of(&self, xyz: [f32; 3]) -> Stages<[f32; 3]> {
        let Stages { exposed, toned, shown } = self.stages(xyz.map(f32x8::splat));
        let first = |rgb: [f32x8; 3]| rgb.map(|channel| channel.to_array()[0]);
        Stages { exposed: first(exposed), toned: first(toned), shown: first(shown) }
    }

    /// Linear display RGB in 0..=1. What is not a finite colour of positive luminance is black.
    fn develop(&self, xyz: [f32x8; 3]) -> [f32x8; 3] {
        self.stages(xyz).shown
    }

    #[inline]
    fn stages(&self, xyz: [f32x8; 3]) -> Stages<[f32x8; 3]> {
        let y = dot(self.luminance_from_xyz, xyz);
        let rows = [self.red_from_xyz, self.green_from_xyz, self.blue_from_xyz];
        let exposed = rows.map(|row| dot(row, xyz));
        let is_color = y.simd_gt(f32x8::ZERO) & (exposed[0] + exposed[1] + exposed[2]).is_finite();
        let gain = self.tone_curve.gain(y);
        let toned = exposed.map(|channel| channel * gain);
        let shown = if self.gamut_mapping == 1 {
            gamut::desaturate(toned, y * gain)
        } else {
            gamut::clip(toned)
        };
        Stages { exposed, toned, shown: shown.map(|channel| channel & is_color) }
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

fn dot(row: Vec3, xyz: [f32x8; 3]) -> f32x8 {
    row.x * xyz[0] + row.y * xyz[1] + row.z * xyz[2]
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

#[cfg(test)]
mod tests {
    use super::super::gpu::source;
    use super::Development;
    use crate::shaders::DEVELOP;
    use crate::shaders::layout::{assert_twins, parse};

    #[test]
    fn the_shader_reads_a_development_as_it_is_written() {
        let module = parse(&source(DEVELOP));
        assert_twins!(
            &module,
            Development {
                red_from_xyz,
                tone_curve,
                green_from_xyz,
                gamut_mapping,
                blue_from_xyz,
                padding_0,
                luminance_from_xyz,
                padding_1,
            }
        );
    }
}
