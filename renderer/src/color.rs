//! Colour spaces: CIE XYZ, linear Rec. 709 RGB, sRGB encoding, chromatic adaptation, CIELAB.

mod cielab;

use std::sync::LazyLock;

use glam::{DMat3, DVec2, DVec3};

pub use cielab::Lab;

/// Chromaticities x, y of the red, green and blue of Rec. 709 and sRGB.
///
/// ITU-R BT.709-6; IEC 61966-2-1:1999.
pub const REC709_PRIMARIES_XY: [DVec2; 3] =
    [DVec2::new(0.64, 0.33), DVec2::new(0.30, 0.60), DVec2::new(0.15, 0.06)];

/// Chromaticity x, y of the white of Rec. 709 and sRGB.
pub const D65_XY: DVec2 = DVec2::new(0.3127, 0.3290);

/// CIE XYZ of linear Rec. 709 RGB; white (1, 1, 1) is D65 with Y = 1.
///
/// Derived from the chromaticities as in SMPTE RP 177-1993: the primaries are scaled so that they
/// add up to the white.
static XYZ_FROM_REC709: LazyLock<DMat3> = LazyLock::new(|| {
    let [red, green, blue] = REC709_PRIMARIES_XY.map(|xy| xyz_from_xy(xy, 1.0));
    let primaries = DMat3::from_cols(red, green, blue);
    primaries * DMat3::from_diagonal(primaries.inverse() * d65_white())
});

static REC709_FROM_XYZ: LazyLock<DMat3> = LazyLock::new(|| XYZ_FROM_REC709.inverse());

/// The matrix from linear Rec. 709 RGB to CIE XYZ; white (1, 1, 1) is D65 with Y = 1.
pub fn xyz_from_rec709() -> DMat3 {
    *XYZ_FROM_REC709
}

/// The matrix from CIE XYZ to linear Rec. 709 RGB; D65 with Y = 1 is (1, 1, 1).
pub fn rec709_from_xyz() -> DMat3 {
    *REC709_FROM_XYZ
}

/// Luminance Y of a linear Rec. 709 colour.
pub fn luminance(rgb: DVec3) -> f64 {
    XYZ_FROM_REC709.row(1).dot(rgb)
}

/// CIE XYZ of the display's white, D65 with Y = 1.
pub fn d65_white() -> DVec3 {
    xyz_from_xy(D65_XY, 1.0)
}

/// CIE XYZ of a chromaticity and a luminance; `xy.y` must not be 0.
pub fn xyz_from_xy(xy: DVec2, luminance: f64) -> DVec3 {
    DVec3::new(xy.x, xy.y, 1.0 - xy.x - xy.y) * (luminance / xy.y)
}

/// Chromaticity x, y (CIE 15:2004, 7.3); NaN for black.
pub fn xy(xyz: DVec3) -> DVec2 {
    xyz.truncate() / xyz.element_sum()
}

/// Chromaticity u′, v′ of the CIE 1976 uniform diagram (CIE 15:2004, 8.1); NaN for black.
pub fn uv_prime(xyz: DVec3) -> DVec2 {
    DVec2::new(4.0 * xyz.x, 9.0 * xyz.y) / (xyz.x + 15.0 * xyz.y + 3.0 * xyz.z)
}

/// The matrix that turns XYZ seen in the white `from` into XYZ of the same look in the white `to`.
/// Only the chromaticities of the whites count; luminance is kept.
///
/// The linearised Bradford transform: K. M. Lam, *Metamerism and Colour Constancy*,
/// University of Bradford, 1985; as in ICC.1:2022, annex E.
pub fn adaptation(from: DVec3, to: DVec3) -> DMat3 {
    let cone_response = DMat3::from_cols(
        DVec3::new(0.8951, -0.7502, 0.0389),
        DVec3::new(0.2664, 1.7135, -0.0685),
        DVec3::new(-0.1614, 0.0367, 1.0296),
    );
    let (from, to) = (cone_response * (from / from.y), cone_response * (to / to.y));
    cone_response.inverse() * DMat3::from_diagonal(to / from) * cone_response
}

/// Encodes a linear channel in 0..=1 for an sRGB display, to 0..=1 (IEC 61966-2-1:1999).
pub fn srgb_encode(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

/// The linear channel of an sRGB-encoded one, both in 0..=1 (IEC 61966-2-1:1999).
pub fn srgb_decode(encoded: f64) -> f64 {
    if encoded <= 0.040_45 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}
