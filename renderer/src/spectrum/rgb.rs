//! Smooth reflectances from colours.

use std::sync::LazyLock;

use glam::{DMat3, DVec3};

use super::observer::Observer;
use super::{LAMBDA_MAX_NM, LAMBDA_MIN_NM};
use crate::color;

/// A smooth reflectance in 0..=1 that has a given colour under the equal-energy white.
///
/// A sigmoid of a quadratic, S(c₀ + c₁·t + c₂·t²) with S(x) = ½ + x/(2·√(1 + x²)): W. Jakob and
/// J. Hanika, "A Low-Dimensional Function Space for Efficient Spectral Upsampling", Computer
/// Graphics Forum 38(2), 2019. They tabulate the coefficients; here each colour is solved on its
/// own.
#[derive(Clone, Copy, Debug)]
pub(super) enum Reflectance {
    /// A grey reflects every wavelength alike; black and white have no finite coefficients.
    Grey(f64),
    /// The coefficients c₀, c₁, c₂.
    Coloured(DVec3),
}

/// Where the largest channel error counts as none.
const TOLERANCE: f64 = 1e-9;
/// Bounds the work for a colour that no reflectance reaches.
const MAX_ITERATIONS: u32 = 200;

/// For each whole nanometre, the powers 1, t, t² and the linear sRGB of reflectance 1 there.
static RESPONSE: LazyLock<Vec<(DVec3, DVec3)>> = LazyLock::new(|| {
    let white = Observer::knots().iter().map(|&(_, xyz)| xyz).sum();
    let rgb_from_xyz = color::rec709_from_xyz() * color::adaptation(white, color::d65_white());
    Observer::knots().iter().map(|&(nm, xyz)| (powers(nm), rgb_from_xyz * xyz)).collect()
});

impl Reflectance {
    /// The reflectance of a linear sRGB colour, moved into 0..=1 per channel.
    pub(super) fn from_rgb(rgb: [f32; 3]) -> Self {
        let target = DVec3::from_array(rgb.map(f64::from)).clamp(DVec3::ZERO, DVec3::ONE);
        if target.max_element() - target.min_element() <= TOLERANCE {
            return Self::Grey(target.x);
        }
        Self::Coloured(solve(target))
    }

    /// The reflectance at a wavelength in nm.
    pub(super) fn at(self, lambda_nm: f64) -> f64 {
        match self {
            Self::Grey(value) => value,
            Self::Coloured(coefficients) => sigmoid(coefficients.dot(powers(lambda_nm))).0,
        }
    }
}

/// 1, t and t² for t from −1 to 1 over the traced range: well conditioned where λ is not.
fn powers(lambda_nm: f64) -> DVec3 {
    let (low, high) = (f64::from(LAMBDA_MIN_NM), f64::from(LAMBDA_MAX_NM));
    let t = (2.0 * lambda_nm - low - high) / (high - low);
    DVec3::new(1.0, t, t * t)
}

/// The sigmoid and its slope.
fn sigmoid(x: f64) -> (f64, f64) {
    let cosine = 1.0 / (1.0 + x * x).sqrt();
    (0.5 + 0.5 * x * cosine, 0.5 * cosine.powi(3))
}

/// The coefficients whose reflectance has the linear sRGB colour `target`, or comes closest to it:
/// Gauss–Newton steps, damped after Marquardt (1963) where a full step would not bring the colour
/// nearer, from the grey of equal luminance.
fn solve(target: DVec3) -> DVec3 {
    let gray = 2.0 * color::luminance(target).clamp(1e-4, 1.0 - 1e-4) - 1.0;
    let mut coefficients = DVec3::new(gray / (1.0 - gray * gray).sqrt(), 0.0, 0.0);
    let (mut error, mut jacobian) = residual(coefficients, target);
    let mut damping = 1e-3;
    for _ in 0..MAX_ITERATIONS {
        if error.abs().max_element() <= TOLERANCE {
            break;
        }
        let normal = jacobian.transpose() * jacobian;
        let diagonal = DVec3::new(normal.x_axis.x, normal.y_axis.y, normal.z_axis.z);
        let damped = normal + DMat3::from_diagonal(diagonal * damping);
        let next = coefficients - damped.inverse() * (jacobian.transpose() * error);
        let (next_error, next_jacobian) = residual(next, target);
        if next_error.length_squared() < error.length_squared() {
            (coefficients, error, jacobian) = (next, next_error, next_jacobian);
            damping = (0.1 * damping).max(1e-15);
        } else if damping < 1e9 {
            damping *= 8.0;
        } else {
            break;
        }
    }
    coefficients
}

/// The colour of the coefficients minus `target`, and its derivative by the coefficients.
fn residual(coefficients: DVec3, target: DVec3) -> (DVec3, DMat3) {
    let mut error = -target;
    let mut jacobian = DMat3::ZERO;
    for &(powers, rgb) in RESPONSE.iter() {
        let (value, slope) = sigmoid(coefficients.dot(powers));
        error += rgb * value;
        let [one, t, t2] = (powers * slope).to_array();
        jacobian += DMat3::from_cols(rgb * one, rgb * t, rgb * t2);
    }
    (error, jacobian)
}
