//! The colour of light regardless of its brightness.

use glam::{DVec3, Vec3};

use super::ColorPath;
use crate::color;
use crate::settings::{DisplaySettings, ToneCurve, WhitePoint};
use crate::spectrum::Bins;

/// A luminance at which the display has every chromaticity of its gamut: Rec. 709 blue has 0.07.
const DIM: f64 = 0.01;

/// sRGB codes of the brightest colour that the display has of the chromaticity of `xyz`, moved into
/// the gamut as pixels are. Black is black.
///
/// For diagrams: what single wavelengths look like, say. The white is D65.
pub fn brightest_srgb8(xyz: DVec3) -> [u8; 3] {
    let settings = DisplaySettings {
        exposure_ev: 0.0,
        white_point: WhitePoint::D65,
        tone_curve: ToneCurve::Linear,
        gamut_mapping: true,
    };
    // The white is seen through as many bins, so that it is D65 to the last digit that counts.
    let shown = Vec3::from(ColorPath::new(xyz * (DIM / xyz.y), Bins::new(350), &settings).shown);
    let brightest = shown / shown.max_element().max(f32::MIN_POSITIVE);
    let encode = |channel: f32| (255.0 * color::srgb_encode(channel.into())).round() as u8;
    brightest.to_array().map(encode)
}
