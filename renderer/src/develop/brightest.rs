//! The colours of light regardless of its brightness, for diagrams.

use std::sync::LazyLock;

use glam::{DMat3, DVec3, Vec3};

use super::development::Development;
use crate::color;
use crate::settings::{DisplaySettings, ToneCurve, WhitePoint};
use crate::spectrum::{Bins, LAMBDA_MAX_NM, LAMBDA_MIN_NM, Observer};

/// A luminance at which the display has every chromaticity of its gamut: Rec. 709 blue has 0.07.
const DIM: f64 = 0.01;
/// Intervals of wavelengths are shown as if they had at least this width, in nm.
const NARROWEST_NM: f64 = 2.0;

static DEVELOPMENT: LazyLock<Development> = LazyLock::new(|| {
    let settings = DisplaySettings {
        exposure_ev: 0.0,
        white_point: WhitePoint::D65,
        tone_curve: ToneCurve::Linear,
        gamut_mapping: true,
    };
    // The white is seen through as many bins, so that it is D65 to the last digit that counts.
    Development::new(&settings, Bins::new(350))
});

/// sRGB codes of the brightest colour that the display has of the chromaticity of `xyz`, moved into
/// the gamut as pixels are. Black is black.
///
/// For diagrams: what single wavelengths look like, say. The white is D65.
pub fn brightest_srgb8(xyz: DVec3) -> [u8; 3] {
    let dim = (xyz * (DIM / xyz.y)).as_vec3();
    let shown = Vec3::from(DEVELOPMENT.stages_of(dim.to_array()).shown);
    let brightest = shown / shown.max_element().max(f32::MIN_POSITIVE);
    let encode = |channel: f32| (255.0 * color::srgb_encode(channel.into())).round() as u8;
    brightest.to_array().map(encode)
}

/// The brightest colour, as [`brightest_srgb8`] gives it, of an even spectrum between two
/// wavelengths in nm. All of the spectrum is white.
pub fn interval_srgb8([low_nm, high_nm]: [f64; 2]) -> [u8; 3] {
    static WHITE_FROM_EVEN: LazyLock<DMat3> = LazyLock::new(|| {
        let even = Observer::xyz_between(LAMBDA_MIN_NM.into(), LAMBDA_MAX_NM.into());
        color::adaptation(even, color::d65_white())
    });
    let half_width_nm = (0.5 * (high_nm - low_nm)).max(0.5 * NARROWEST_NM);
    let middle_nm = (0.5 * (low_nm + high_nm))
        .clamp(f64::from(LAMBDA_MIN_NM) + half_width_nm, f64::from(LAMBDA_MAX_NM) - half_width_nm);
    let xyz = Observer::xyz_between(middle_nm - half_width_nm, middle_nm + half_width_nm);
    brightest_srgb8(*WHITE_FROM_EVEN * xyz)
}
